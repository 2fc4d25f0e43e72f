// The verdicts: a card for each statement, with what it rests on and the steps that decide it.

import { byId, formula, make } from "./elements.js";
import { ask } from "./api.js";

/** Statements with their verdicts; one that was not decided has none. */
export function joined({ statements = [], verdicts = [], stopped }) {
  const found = new Map(verdicts.map((verdict) => [verdict.name, verdict]));
  let left = 0;
  return statements.map((statement) => {
    const verdict = found.get(statement.name);
    if (verdict) return { ...statement, ...verdict, state: stateOf(verdict) };
    const reason = left++ === 0 ? stopped ?? "not decided" : "not decided: a statement before it took all the time";
    return { ...statement, verdict: "stopped", ok: false, words: left === 1 ? "stopped" : "not reached", reason, state: "open" };
  });
}

function stateOf({ ok, verdict }) {
  if (ok) return "good";
  return verdict === "unknown" ? "open" : "bad";
}

/** What is said of a statement that is not as stated, in a sentence or two. */
export function objection({ name, reason, witness, words, kind }) {
  if (reason) return `${name}: ${reason}`;
  if (witness) return `${name} ${words}: ${place(witness)}: left = ${witness.left}, right = ${witness.right}`;
  return kind === "refute" ? `${name} is claimed to be false, and holds` : `${name} ${words}`;
}

export class Verdicts {
  #list = byId("verdicts");
  #summary = byId("summary");
  #open = new Set();
  #text = "";
  #select;

  /** `select` is called with the place of a statement whose name was clicked. */
  constructor(select) { this.#select = select; }

  /** Says that a new answer is awaited. */
  wait(seconds) {
    this.#list.classList.add("stale");
    this.#say(seconds ? `Deciding… ${seconds} s` : "Deciding…", "");
  }

  /** Says that there is no answer. */
  fail(message) {
    this.#list.classList.remove("stale");
    this.#list.replaceChildren(make("li", { className: "empty" }, message));
    this.#say("No answer", "bad");
  }

  show(text, statements, errors, stopped) {
    this.#text = text;
    this.#list.classList.remove("stale");
    if (errors.length && !statements.length) {
      this.#list.replaceChildren(make("li", { className: "empty" }, "Nothing is decided while the text has errors. They are marked in it."));
      return this.#say(errors.length === 1 ? "1 error" : `${errors.length} errors`, "bad");
    }
    const cards = statements.map((statement) => this.#card(statement));
    const nothing = stopped ?? "No statement yet. Write one, such as: prove square: (1 + 1)**2 == 4;";
    this.#list.replaceChildren(...(cards.length ? cards : [make("li", { className: "empty" }, nothing)]));
    this.#total(statements, stopped);
  }

  #total(statements, stopped) {
    const off = statements.filter((statement) => !statement.ok);
    const count = statements.length === 1 ? "1 statement" : `${statements.length} statements`;
    if (!statements.length) return this.#say(stopped ? "Stopped" : "", "open");
    if (!off.length) return this.#say(`${count}, ${statements.length === 1 ? "" : "all "}as stated`, "good");
    const kind = off.some((statement) => statement.state === "bad") ? "bad" : "open";
    this.#say(statements.length === 1 ? "1 statement, not as stated" : `${count}, ${off.length} not as stated`, kind);
  }

  #say(text, kind) {
    this.#summary.textContent = text;
    this.#summary.className = `grow summary ${kind}`;
  }

  #card(statement) {
    const { name, state, ok, words, micros, mathml, conditions = [], witness, reason } = statement;
    const title = make("button", { type: "button", className: "name", title: `line ${statement.line}` }, name);
    title.addEventListener("click", () => this.#select(statement));
    const head = make("div", { className: "head" },
      make("span", { className: "mark-of", "aria-hidden": "true" }, signOf(state)), title,
      make("span", { className: "words" }, words),
      micros === undefined ? "" : make("span", { className: "time" }, duration(micros)));
    const shown = conditions.slice(0, 12).join(", ");
    const more = conditions.length > 12 ? `, and ${conditions.length - 12} more` : "";
    const grounds = !witness && conditions.length ? make("p", { className: "grounds" }, `where ${shown}${more}`) : "";
    const why = reason ? make("p", { className: "grounds" }, reason) : "";
    const note = ok || witness || reason ? "" : make("p", { className: "grounds" }, "It is claimed to be false, and holds.");
    const steps = statement.verdict === "stopped" ? "" : this.#steps(name);
    return make("li", { className: `verdict ${state}` },
      head, mathml ? formula(mathml) : "", grounds, witness ? table(witness) : "", why, note, steps);
  }

  /** The steps are asked for when somebody wants to see them. */
  #steps(name) {
    const holder = make("div", {});
    const details = make("details", { className: "steps" }, make("summary", {}, "Steps"), holder);
    const text = this.#text;
    details.addEventListener("toggle", async () => {
      if (!details.open) return this.#open.delete(name);
      this.#open.add(name);
      if (holder.childElementCount) return;
      holder.replaceChildren(make("p", { className: "note" }, "…"));
      try {
        const { steps, stopped, refusal } = await ask("derive", { text, name });
        holder.replaceChildren(steps ? list(steps) : make("p", { className: "note" }, stopped ?? refusal ?? "no steps"));
      } catch (error) {
        holder.replaceChildren(make("p", { className: "note bad" }, error.message));
      }
    });
    if (this.#open.has(name)) details.open = true;
    return details;
  }
}

function list(steps) {
  const line = ({ words, text, mathml }) => (words === undefined ? formula(mathml, text) : make("p", {}, words));
  return make("ol", {}, steps.map((step) => make("li", {}, make("h3", {}, step.title), step.lines.map(line))));
}

function table(witness) {
  const rows = [
    ["at", place(witness)],
    [witness.component ? `left, ${witness.component}` : "left", witness.left],
    [witness.component ? `right, ${witness.component}` : "right", witness.right],
    ["left − right", witness.difference],
    ["note", witness.ratio],
  ];
  const cells = rows.filter(([, value]) => value).flatMap(([key, value]) => [make("dt", {}, key), make("dd", {}, shortened(value))]);
  return make("dl", { className: "witness" }, cells);
}

function place({ point }) {
  const values = Object.entries(point).map(([name, value]) => `${name} = ${value}`);
  return values.length ? values.join(", ") : "every point";
}

const shortened = (text) => (text.length > 400 ? `${text.slice(0, 400)}…` : text);

export const signOf = (state) => ({ good: "✓", bad: "✗", open: "?" })[state];

function duration(micros) {
  if (micros < 1000) return `${micros} µs`;
  return micros < 1e6 ? `${(micros / 1000).toFixed(1)} ms` : `${(micros / 1e6).toFixed(2)} s`;
}
