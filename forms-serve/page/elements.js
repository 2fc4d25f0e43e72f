// Elements of the page, made and found.

export const byId = (id) => document.getElementById(id);

/** An element with properties and children; what is missing is left out. */
export function make(name, properties = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key.startsWith("aria-") || key === "for" || key === "list") element.setAttribute(key, value);
    else if (value !== undefined) element[key] = value;
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined && child !== ""));
  return element;
}

/** A formula that the server has set. */
export function formula(mathml, text = "") {
  const holder = make("div", { className: "formula", tabIndex: -1 });
  if (mathml) holder.innerHTML = mathml;
  else if (text) holder.append(make("code", {}, text));
  return holder;
}

/** Copies a text and says so on the button. */
export async function copy(text, button) {
  const before = button.dataset.label ?? button.textContent;
  button.dataset.label = before;
  button.textContent = (await toClipboard(text)) ? "Copied" : "Not copied";
  setTimeout(() => { button.textContent = before; }, 1500);
}

async function toClipboard(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    // without a secure context, as under another address than this machine's, there is the old way only
    const area = make("textarea", { value: text, className: "hidden" });
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}
