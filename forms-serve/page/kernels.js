// Kernels: the formula, a plot and the generated sources of one of them.

import { Latest } from "./api.js";
import { Axes } from "./axes.js";
import { byId, copy, formula, make } from "./elements.js";

const LANGUAGES = { rust: "Rust", c: "C", wgsl: "WGSL" };
/** The time from a change to the request that it asks for. */
const PAUSE = 120;

export class Kernels {
  #select = byId("kernel");
  #drawing = byId("drawing");
  #sources = byId("sources");
  #emit = new Latest();
  #plot = new Latest();
  #axes = new Axes(byId("axes"), () => this.#replot());
  #kernels = [];
  #text = "";
  #timer = 0;
  #told;

  /** `told` is called with the errors that generating a kernel found. */
  constructor(told) {
    this.#told = told;
    this.#select.addEventListener("change", () => this.#choose());
  }

  /** Says that what is shown is of an older text. */
  wait() {
    byId("kernels").classList.add("stale");
  }

  show(text, kernels) {
    byId("kernels").classList.remove("stale");
    this.#text = text;
    this.#kernels = kernels;
    byId("kernels").hidden = !kernels.length;
    if (!kernels.length) {
      this.#emit.stop();
      this.#plot.stop();
      return;
    }
    const before = this.#select.value;
    const names = kernels.map(({ name }) => name);
    this.#select.replaceChildren(...kernels.map((kernel) => make("option", { value: kernel.name }, signature(kernel))));
    this.#select.value = names.includes(before) ? before : names[0];
    this.#choose();
  }

  get #kernel() { return this.#kernels.find(({ name }) => name === this.#select.value); }

  #choose() {
    const kernel = this.#kernel;
    byId("about").replaceChildren(make("p", {}, kernel.docs.join(" ")), kernel.mathml ? formula(kernel.mathml) : "");
    byId("axes").hidden = !kernel.arguments.length;
    this.#draw();
    this.#generate();
  }

  #replot() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#draw(), PAUSE);
  }

  async #draw() {
    const kernel = this.#kernel;
    if (!kernel.arguments.length) return this.#drawing.replaceChildren(note("This kernel has no arguments to plot it over."));
    this.#axes.show(kernel);
    const request = this.#axes.request;
    if (!request) return this.#drawing.replaceChildren(note("Each range must go from a smaller number to a larger one, such as 0 to pi/2.", "bad"));
    this.#drawing.classList.add("stale");
    await answered(this.#plot, "plot", { text: this.#text, ...request }, ({ drawing, ...rest }) => {
      this.#drawing.classList.remove("stale");
      if (!drawing) return this.#drawing.replaceChildren(note(reasonOf(rest), "bad"));
      const svg = new DOMParser().parseFromString(drawing.svg, "image/svg+xml").documentElement;
      const part = drawing.undefined ? note(`Not defined at ${drawing.undefined} of ${drawing.values} points.`) : "";
      this.#drawing.replaceChildren(document.importNode(svg, true), part);
    });
  }

  async #generate() {
    this.#sources.setAttribute("aria-busy", "true");
    await answered(this.#emit, "emit", { text: this.#text, kernel: this.#kernel.name }, (answer) => {
      this.#sources.removeAttribute("aria-busy");
      const { code, diagnostics = [] } = answer;
      this.#told(diagnostics);
      this.#sources.replaceChildren(...(code ? code.map(source) : [note(reasonOf(answer), "bad")]));
    });
  }
}

/** Calls back with the answer, or with a refusal; not with one that was given up. */
async function answered(latest, task, request, then) {
  let answer;
  try {
    answer = await latest.ask(task, request);
  } catch (error) {
    if (error.name === "AbortError") return;
    answer = { refusal: error.message };
  }
  then(answer);
}

function reasonOf({ refusal, stopped, diagnostics = [] }) {
  return refusal ?? stopped ?? (diagnostics.map(({ message }) => message).join("\n") || "There is no answer.");
}

const note = (text, kind = "") => make("p", { className: `note ${kind}` }, text);

function signature({ name, arguments: all }) {
  return `${name}(${all.map((argument) => argument.name).join(", ")})`;
}

function source({ target, precision, text, reason }) {
  const title = make("h3", {}, `${LANGUAGES[target]} `, make("span", { className: "quiet" }, precision));
  const button = make("button", { type: "button", className: "button", disabled: !text, "aria-label": `Copy ${LANGUAGES[target]}` }, "Copy");
  button.addEventListener("click", () => copy(text, button));
  const body = text ? make("pre", { tabIndex: 0 }, coloured(text)) : note(reason);
  const article = make("article", { className: "source" }, make("header", {}, title, button), body);
  article.dataset.target = target;
  return article;
}

/** Comments stand back. */
function coloured(text) {
  return text.split(/(\/\/[^\n]*|\/\*[^]*?\*\/)/).map((part, index) =>
    (index % 2 ? make("span", { className: "t-comment" }, part) : part));
}
