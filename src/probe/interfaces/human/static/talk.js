// Speaks with the server. What it says is only ever set as text, never as HTML.

const name = document.body.dataset.name;
export const practice = "practice" in document.body.dataset;
const who = practice ? { name, practice: "1" } : { name };

/** Ask for something to be done; gives the state that follows. */
export function post(path, said = {}) {
  return reply(fetch(`/seat/${path}`, {
    method: "POST",
    headers: { "content-type": "application/json" },
    body: JSON.stringify({ name, practice, ...said }),
  }));
}

export function look() {
  return reply(fetch(`/seat/state?${new URLSearchParams(who)}`));
}

/** Address of a picture of a question; the number of the question keeps it from being mixed up. */
export function pictureAddress(question, number) {
  return `/seat/picture?${new URLSearchParams({ ...who, question, number })}`;
}

/** Address of a picture of what was right in a practice question. */
export function evidenceAddress(question, number) {
  return `/seat/evidence?${new URLSearchParams({ ...who, question, number })}`;
}

async function reply(asked) {
  let response;
  try {
    response = await asked;
  } catch {
    throw new Error("The server can't be reached. It may have been stopped; what you have done is kept.");
  }
  const said = await response.json().catch(() => ({}));
  if (!response.ok) throw new Error(said.error ?? `The server replied with ${response.status}.`);
  return said;
}

/** Make an element; attributes that are functions listen, strings among the children are text. */
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(key, value);
    else if (value === true) element.setAttribute(key, "");
    else if (value !== null && value !== undefined && value !== false) element.setAttribute(key, value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

/** Text of strangers, kept from turning its surroundings from right to left. */
export function said(text) {
  return make("bdi", {}, String(text));
}

export const part = (id) => document.getElementById(id);
