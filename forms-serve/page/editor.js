// The editor: a text area over a layer that shows the same text in colours, with marks and line numbers.

import { byId, make } from "./elements.js";
import { tokens } from "./highlight.js";

export class Editor {
  #area = byId("text");
  #layer = byId("layer");
  #gutter = byId("gutter");
  #tip = byId("tip");
  #words;
  #marks = [];
  #signs = new Map();

  /** `changed` is called with the text after each change. */
  constructor(words, changed) {
    this.#words = words;
    this.#area.addEventListener("input", () => {
      this.#move();
      this.#draw();
      changed(this.text);
    });
    this.#area.addEventListener("mousemove", (event) => this.#point(event.clientX, event.clientY));
    this.#area.addEventListener("mouseleave", () => { this.#tip.hidden = true; });
    this.#area.addEventListener("keydown", (event) => {
      if (event.key === "F8") {
        event.preventDefault();
        this.#next();
      }
    });
  }

  get text() { return this.#area.value; }

  set text(text) {
    this.#area.value = text;
    this.#marks = [];
    this.#signs = new Map();
    this.#draw();
    byId("editor").scrollTo(0, 0);
    this.#area.setSelectionRange(0, 0);
  }

  /** Marks ranges, each with a message and a kind; and lines, each with a sign and a kind. */
  mark(marks, signs) {
    const offsets = this.#offsets();
    this.#marks = marks.map((mark) => ({ ...mark, ...rangeOf(mark, offsets, this.text) }));
    this.#marks.sort((one, other) => one.start - other.start);
    this.#signs = new Map(signs.map((sign) => [sign.line, sign]));
    this.#draw();
  }

  /** Selects a place and shows it. */
  select(place) {
    const { start, end } = rangeOf(place, this.#offsets(), this.text);
    this.#area.focus({ preventScroll: true });
    this.#area.setSelectionRange(start, end);
    this.#gutter.children[place.line - 1]?.scrollIntoView({ block: "nearest" });
  }

  /** The marks move with the text until the next answer; those that were typed into go. */
  #move() {
    const before = this.#layer.dataset.text ?? "";
    const after = this.text;
    let same = 0;
    while (same < before.length && same < after.length && before[same] === after[same]) same++;
    let tail = 0;
    const most = Math.min(before.length, after.length) - same;
    while (tail < most && before[before.length - 1 - tail] === after[after.length - 1 - tail]) tail++;
    const [edge, shift] = [before.length - tail, after.length - before.length];
    this.#marks = this.#marks.flatMap((mark) => {
      if (mark.end <= same) return [mark];
      return mark.start >= edge ? [{ ...mark, start: mark.start + shift, end: mark.end + shift }] : [];
    });
    if (before.split("\n").length !== after.split("\n").length) this.#signs = new Map();
  }

  #draw() {
    const text = this.text;
    this.#layer.dataset.text = text;
    // a last line without characters has to have a height
    this.#layer.replaceChildren(...pieces(text, tokens(text, this.#words), this.#marks), "\n ");
    const lines = text.split("\n").map((_, index) => {
      const sign = this.#signs.get(index + 1);
      return make("span", {}, sign ? make("i", { className: sign.kind }, sign.sign) : "", String(index + 1));
    });
    this.#gutter.replaceChildren(...lines);
  }

  #point(x, y) {
    const inside = (box) => x >= box.left && x <= box.right && y >= box.top && y <= box.bottom;
    const spans = [...this.#layer.querySelectorAll(".mark")];
    const span = spans.find((element) => [...element.getClientRects()].some(inside));
    this.#tip.hidden = !span;
    if (!span) return;
    this.#tip.textContent = span.dataset.message;
    const left = Math.min(x + 8, innerWidth - this.#tip.offsetWidth - 8);
    this.#tip.style.left = `${Math.max(8, left)}px`;
    this.#tip.style.top = `${Math.min(y + 18, innerHeight - this.#tip.offsetHeight - 8)}px`;
  }

  /** To the next mark behind the caret, or the first. */
  #next() {
    const caret = this.#area.selectionStart;
    const mark = this.#marks.find((one) => one.start > caret) ?? this.#marks[0];
    if (mark) this.select(mark);
  }

  /** The offset at which each line begins. */
  #offsets() {
    const offsets = [0];
    for (let at = this.text.indexOf("\n"); at >= 0; at = this.text.indexOf("\n", at + 1)) offsets.push(at + 1);
    return offsets;
  }
}

/** Columns and lengths count characters, offsets of JavaScript count the halves of some of them. */
function rangeOf({ line, column, length }, offsets, text) {
  const along = (from, count) => {
    let at = from;
    for (let left = count; left > 0 && at < text.length; left--) at += text.codePointAt(at) > 0xffff ? 2 : 1;
    return at;
  };
  const start = along(offsets[line - 1] ?? text.length, column - 1);
  return { start, end: Math.max(along(start, length), start) };
}

/** The text in pieces of one colour and one mark each; a mark of nothing is one character wide. */
function pieces(text, colours, marks) {
  const wide = marks.map((mark) => {
    if (mark.end > mark.start) return mark;
    const end = Math.min(mark.start + 1, text.length);
    return { ...mark, start: Math.max(0, end - 1), end };
  });
  const cuts = new Set([0, text.length]);
  for (const range of [...colours, ...wide]) cuts.add(range.start).add(range.end);
  const places = [...cuts].sort((one, other) => one - other);
  let [colour, first] = [0, 0];
  return places.slice(0, -1).map((start, index) => {
    const end = places[index + 1];
    while (colour < colours.length && colours[colour].end <= start) colour++;
    while (first < wide.length && wide[first].end <= start) first++;
    const mark = wide.slice(first, first + 8).find((one) => one.start <= start && one.end >= end);
    const inside = colours[colour] && colours[colour].start <= start ? `t-${colours[colour].kind}` : "";
    if (!inside && !mark) return text.slice(start, end);
    const span = make("span", { className: [inside, mark ? `mark ${mark.kind}` : ""].join(" ").trim() }, text.slice(start, end));
    if (mark) span.dataset.message = mark.message;
    return span;
  });
}
