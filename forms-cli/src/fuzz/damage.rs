//! Damage: pieces of a text are removed, duplicated and exchanged, or replaced by foreign pieces,
//! unclosed brackets, numbers at the limits of every type, and bytes that are not text.

use super::Random;

/// Pieces that are inserted.
const PIECES: [&str; 40] = [
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ";",
    ",",
    "=",
    "==",
    ":",
    "->",
    "**",
    "^",
    "@",
    "///",
    "\"",
    "'",
    "<",
    ">",
    "&",
    "$",
    "#",
    "0",
    "1e308",
    "1e-400",
    "5e-324",
    "-1",
    "nan",
    "inf",
    "99999999999999999999",
    "18446744073709551616",
    "1e999999999",
    "1/0",
    "\0",
    "\u{202e}",
    "α",
    "where",
    "prove",
    "_",
];

/// Splits a text into words and the characters between them.
fn pieces(text: &str) -> Vec<&str> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
    let mut pieces = Vec::new();
    let mut start = 0;
    let mut before = None;
    for (place, c) in text.char_indices() {
        if place > start && (before != Some(true) || !is_word(c)) {
            pieces.push(&text[start..place]);
            start = place;
        }
        before = Some(is_word(c));
    }
    pieces.push(&text[start..]);
    pieces
}

/// Returns the text with one to four damaged places, sometimes also with a random byte.
pub(super) fn damaged(text: &str, random: &mut Random) -> Vec<u8> {
    let mut all = pieces(text);
    let own = all.clone();
    let mut deep = String::new();
    for _ in 0..=random.below(4) {
        let (one, other) = (random.below(all.len()), random.below(all.len()));
        match random.below(10) {
            0 if all.len() > 1 => drop(all.remove(one)),
            1 => all.insert(one, all[other]),
            2 => all.swap(one, other),
            3 => all.truncate(one + 1),
            4 | 5 => all[one] = own[random.below(own.len())],
            6 if deep.is_empty() => {
                let piece = PIECES[random.below(PIECES.len())];
                deep = piece.repeat(1 << random.below(14));
            }
            _ => all[one] = PIECES[random.below(PIECES.len())],
        }
    }
    let place = random.below(all.len());
    let mut bytes = all[..place].concat().into_bytes();
    bytes.extend(deep.as_bytes());
    bytes.extend(all[place..].concat().into_bytes());
    if random.one_in(8) {
        let place = random.below(bytes.len());
        if let Some(byte) = bytes.get_mut(place) {
            *byte = random.below(256) as u8;
        }
    }
    bytes
}
