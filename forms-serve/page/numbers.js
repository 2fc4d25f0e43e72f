// Numbers as people type them, with multiples of pi.

const NUMBER = /^([+-]?)(\d*\.?\d*(?:[eE][+-]?\d+)?)\s*\*?\s*(pi|π)?\s*(?:\/\s*(\d+(?:\.\d+)?))?$/;

/** The number that a text stands for, such as `-0.5`, `2*pi` or `pi/2`; NaN for another text. */
export function numberOf(text) {
  const [, sign, digits, pi, below] = text.trim().match(NUMBER) ?? [];
  if (digits === undefined || (digits === "" && !pi)) return NaN;
  const value = (digits === "" ? 1 : Number(digits)) * (pi ? Math.PI : 1) / (below ? Number(below) : 1);
  return Number.isFinite(value) ? (sign === "-" ? -value : value) : NaN;
}

/** A short text for a number; small parts of pi by their name. */
export function textOf(value) {
  for (const below of [1, 2, 3, 4, 6]) {
    const above = (value * below) / Math.PI;
    if (above !== 0 && Math.abs(above) < 13 && Math.abs(above - Math.round(above)) < 1e-12) {
      const count = Math.round(above);
      const front = count === 1 ? "pi" : count === -1 ? "-pi" : `${count}*pi`;
      return below === 1 ? front : `${front}/${below}`;
    }
  }
  return String(Number(value.toPrecision(6)));
}
