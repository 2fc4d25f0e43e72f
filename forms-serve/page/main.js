// The page: what is typed is checked, and what comes of it is shown.

import { Latest, start } from "./api.js";
import { Editor } from "./editor.js";
import { byId, copy, make } from "./elements.js";
import { Kernels } from "./kernels.js";
import { hashOf, textOf } from "./share.js";
import { Verdicts, joined, objection, signOf } from "./verdicts.js";

/** The time from the last key to the check. */
const PAUSE = 250;

const beginning = await start();
const checks = new Latest();
const editor = new Editor(beginning.words, () => later());
const verdicts = new Verdicts((place) => editor.select(place));
const kernels = new Kernels((errors) => report(last.errors.concat(errors), last.statements));
let last = { errors: [], statements: [] };
let timer = 0;
let clock = 0;

function later() {
  clearTimeout(timer);
  timer = setTimeout(check, PAUSE);
}

async function check() {
  const text = editor.text;
  hashOf(text).then((hash) => { if (text === editor.text) history.replaceState(null, "", hash); });
  const began = performance.now();
  clearInterval(clock);
  clock = setInterval(() => verdicts.wait(Math.floor((performance.now() - began) / 1000)), 500);
  let answer;
  try {
    answer = await checks.ask("check", { text });
  } catch (error) {
    // a newer check has its own clock
    if (error.name === "AbortError") return;
    clearInterval(clock);
    return verdicts.fail(error.message);
  }
  clearInterval(clock);
  if (text === editor.text) show(text, answer);
}

function show(text, answer) {
  last = { errors: answer.diagnostics ?? [], statements: joined(answer) };
  report(last.errors, last.statements);
  verdicts.show(text, last.statements, last.errors, answer.stopped);
  // what a text with errors computes is not known: what was known before stands back
  if (answer.kernels) kernels.show(text, answer.kernels);
  else kernels.wait();
}

/** Marks errors and statements that are not as stated in the text, and lists the errors. */
function report(errors, statements) {
  const off = statements.filter((statement) => !statement.ok);
  const marks = errors.map((error) => ({ ...error, message: [error.message, error.help].filter(Boolean).join("\n"), kind: "" }));
  const claims = off.map((statement) => ({ ...statement, message: objection(statement), kind: statement.state === "open" ? "open" : "" }));
  const signs = statements.map(({ line, state }) => ({ line, sign: signOf(state), kind: state }));
  editor.mark([...marks, ...claims], [...signs, ...errors.map(({ line }) => ({ line, sign: "✗", kind: "bad" }))]);
  byId("problems").replaceChildren(...errors.map(problem));
}

function problem(error) {
  const help = error.help ? make("span", { className: "help" }, error.help) : "";
  const button = make("button", { type: "button" },
    make("span", { className: "place" }, `${error.line}:${error.column}`), make("span", {}, error.message, help));
  button.addEventListener("click", () => editor.select(error));
  return make("li", {}, button);
}

function load(text) {
  editor.text = text;
  check();
}

const examples = byId("examples");
examples.append(...beginning.examples.map(({ name, title }) => make("option", { value: name }, title)));
examples.addEventListener("change", () => {
  const example = beginning.examples.find(({ name }) => name === examples.value);
  if (example) load(example.text);
});
byId("text").addEventListener("input", () => { examples.value = ""; });
byId("text").addEventListener("keydown", (event) => {
  if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) check();
});
const share = byId("share");
share.addEventListener("click", async () => copy(new URL(await hashOf(editor.text), location.href).href, share));
addEventListener("hashchange", async () => {
  const text = await textOf(location.hash);
  if (text !== null && text !== editor.text) load(text);
});

const given = await textOf(location.hash);
const [first] = beginning.examples;
if (given === null && !beginning.opened) examples.value = first.name;
if (beginning.opened) document.title = `${beginning.opened.name} · Forms`;
load(given ?? beginning.opened?.text ?? first.text);
