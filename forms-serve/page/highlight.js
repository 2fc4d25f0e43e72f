// The colours of a text in the forms language.

const TOKEN = /(\/\/[^\n]*)|([\p{L}_][\p{L}\p{N}_]*)|(\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)/gu;
const COORDINATES = /\bchart\s+[\p{L}_][\p{L}\p{N}_]*\s*\(([^)]*)\)/gu;

/** Ranges of the text with their classes, in order; what has none is left out. */
export function tokens(text, words) {
  const found = [];
  const coordinates = coordinatesOf(text);
  for (const match of text.matchAll(TOKEN)) {
    const kind = kindOf(match, words, coordinates);
    if (kind) found.push({ start: match.index, end: match.index + match[0].length, kind });
  }
  return found;
}

function coordinatesOf(text) {
  const names = [...text.matchAll(COORDINATES)].flatMap((chart) => chart[1].split(","));
  return new Set(names.map((name) => name.split(":")[0].trim()));
}

function kindOf([, comment, name, number], words, coordinates) {
  if (comment) return "comment";
  if (number) return "number";
  if (words.items.includes(name) || words.inside.includes(name)) return "word";
  if (name.startsWith("d") && coordinates.has(name.slice(1))) return "differential";
  return words.functions.includes(name) ? "function" : null;
}
