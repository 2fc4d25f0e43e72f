// What a plot shows: two arguments along the axes, with their ranges, and values of all others.

import { make } from "./elements.js";
import { numberOf, textOf } from "./numbers.js";

/** How far the range of an argument goes that its domain does not bound. */
const REACH = 4;

/** The range that an argument is drawn over at first. */
function rangeOf({ from, to }) {
  if (from !== null && to !== null) return [from, to];
  if (from !== null) return [from, from + REACH];
  return to === null ? [-REACH / 2, REACH / 2] : [to - REACH, to];
}

/** A value of an argument to begin with: the middle of its range, or 1 where zero is in it, which is often singular. */
function middleOf(argument) {
  const [from, to] = rangeOf(argument);
  return argument.from === null && argument.to === null ? 1 : (from + to) / 2;
}

export class Axes {
  #form;
  #changed;
  #kernel = null;
  #known = new Map();

  /** `changed` is called when another plot is wanted. */
  constructor(form, changed) {
    this.#form = form;
    this.#changed = changed;
    form.addEventListener("submit", (event) => event.preventDefault());
  }

  /** Shows the choices for a kernel; those that were made for it before are kept. */
  show(kernel) {
    const same = JSON.stringify(kernel.arguments) === JSON.stringify(this.#kernel?.arguments)
      && kernel.name === this.#kernel?.name && kernel.outputs === this.#kernel?.outputs;
    this.#kernel = kernel;
    if (!same) this.#build();
  }

  /** What is chosen for the kernel that is shown. */
  get #chosen() {
    const { name, arguments: all } = this.#kernel;
    const names = all.map((argument) => argument.name);
    const key = `${name}(${names.join(",")})`;
    if (!this.#known.has(key)) {
      const texts = all.map((argument) => [argument.name, rangeOf(argument).map(textOf)]);
      const values = all.map((argument) => [argument.name, textOf(middleOf(argument))]);
      const ranges = Object.fromEntries(texts);
      this.#known.set(key, { across: names[0], up: names[1], output: 0, ranges, values: Object.fromEntries(values) });
    }
    return this.#known.get(key);
  }

  /** The request for the plot; null while something is not a number. */
  get request() {
    const { across, up, output, ranges, values } = this.#chosen;
    const axis = (name) => (name ? { name, from: numberOf(ranges[name][0]), to: numberOf(ranges[name][1]) } : null);
    const fixed = {};
    for (const { name } of this.#kernel.arguments) if (name !== across && name !== up) fixed[name] = numberOf(values[name]);
    const request = { kernel: this.#kernel.name, output, across: axis(across), up: axis(up), fixed };
    const axes = [request.across, request.up].filter(Boolean);
    const fine = axes.every(({ from, to }) => from < to) && Object.values(fixed).every((value) => !Number.isNaN(value));
    return fine ? request : null;
  }

  #build() {
    const { arguments: all, outputs } = this.#kernel;
    const chosen = this.#chosen;
    const parts = [];
    if (outputs > 1) parts.push(this.#outputs(outputs));
    parts.push(this.#axis("Across", "across", all));
    if (all.length > 1) parts.push(this.#axis("Up", "up", all));
    const rest = all.filter(({ name }) => name !== chosen.across && name !== chosen.up);
    if (rest.length) parts.push(make("fieldset", {}, make("legend", {}, "Held fixed"), rest.map((one) => this.#fixed(one))));
    this.#form.replaceChildren(...parts);
  }

  #outputs(count) {
    const options = Array.from({ length: count }, (_, value) => make("option", { value: String(value) }, String(value)));
    const select = make("select", {}, options);
    select.value = String(this.#chosen.output);
    select.addEventListener("change", () => { this.#chosen.output = Number(select.value); this.#changed(); });
    return make("label", { className: "row" }, "Value", select);
  }

  #axis(title, which, all) {
    const chosen = this.#chosen;
    const select = make("select", { "aria-label": `${title}: argument` }, all.map(({ name }) => make("option", { value: name }, name)));
    select.value = chosen[which];
    select.addEventListener("change", () => {
      // the two axes have two arguments: the other one takes what this one leaves
      const other = which === "across" ? "up" : "across";
      if (chosen[other] === select.value) chosen[other] = chosen[which];
      chosen[which] = select.value;
      this.#build();
      this.#form.querySelectorAll("fieldset")[which === "across" ? 0 : 1]?.querySelector("select").focus();
      this.#changed();
    });
    const end = (label, index) => {
      const range = chosen.ranges[chosen[which]];
      const input = make("input", { value: range[index], inputMode: "text", autocomplete: "off", spellcheck: false });
      input.addEventListener("input", () => {
        range[index] = input.value;
        input.setAttribute("aria-invalid", String(Number.isNaN(numberOf(input.value))));
        this.#changed();
      });
      return make("label", {}, label, input);
    };
    const unit = all.find(({ name }) => name === chosen[which])?.unit;
    const legend = make("legend", {}, unit && unit !== "1" ? `${title}, in ${unit}` : title);
    return make("fieldset", {}, legend, make("label", { className: "row" }, select), end("from", 0), end("to", 1));
  }

  #fixed(argument) {
    const values = this.#chosen.values;
    const { name, unit } = argument;
    const [from, to] = rangeOf(argument);
    const value = () => numberOf(values[name]);
    const slider = make("input", { type: "range", min: String(from), max: String(to), step: String((to - from) / 200), "aria-label": `${name}, slider` });
    const input = make("input", { value: values[name], autocomplete: "off", spellcheck: false, "aria-label": name });
    slider.value = String(value());
    slider.addEventListener("input", () => { input.value = values[name] = textOf(Number(slider.value)); this.#changed(); });
    input.addEventListener("input", () => {
      values[name] = input.value;
      input.setAttribute("aria-invalid", String(Number.isNaN(value())));
      slider.value = String(value());
      this.#changed();
    });
    const title = unit && unit !== "1" ? `${name} [${unit}]` : name;
    return make("div", { className: "fixed" }, make("span", {}, title), slider, input);
  }
}
