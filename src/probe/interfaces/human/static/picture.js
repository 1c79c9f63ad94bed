// The picture, what was told with it, and the point that a click sets.

import { make, part, pictureAddress, said } from "./talk.js";

const PIXELS = 1024;
const MOVING = new Set(["grasp_and_remove", "push"]);
const MOVES = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
const image = part("picture");
const ring = part("ring");
let state = null;
let chosen = 0; // 0 is the start, n the n-th call
let shown = "";
let point = null;
let whenPointed = () => {};

export function onPoint(listener) {
  whenPointed = listener;
}

export function currentPoint() {
  return point;
}

/** Set the point, or take it away. */
export function setPoint(value) {
  point = value;
  ring.hidden = !point;
  if (point) {
    ring.style.left = `${(100 * point[0]) / PIXELS}%`;
    ring.style.top = `${(100 * point[1]) / PIXELS}%`;
  }
  whenPointed(point);
}

/** Show a state; the newest step is chosen unless nothing is new. */
export function showSteps(next) {
  const same = state && state.number === next.number && state.entries.length === next.entries.length;
  const other = !state || state.number !== next.number;
  state = next;
  // A point is of the picture that it was set in; where the table has moved it may mean another thing.
  if (other || (!same && MOVING.has(state.entries.at(-1)?.tool))) setPoint(null);
  if (!same) choose(state.entries.length);
}

function choose(step) {
  chosen = step;
  const entry = state.entries[step - 1];
  const address = pictureAddress(state.number, entry ? entry.picture : 0);
  if (address !== shown) image.src = shown = address;
  image.alt = `The table from above, ${entry ? `after step ${step}` : "at the start"}. Click to point; arrow keys move the point.`;
  part("told").textContent = entry ? entry.text : "";
  part("told").hidden = !entry;
  part("told").scrollTop = 0;
  part("told-label").replaceChildren(...labelOf(entry));
  part("steps").replaceChildren(...[null, ...state.entries].map(button));
  const current = part("steps").querySelector("[aria-current]");
  part("steps").scrollTop = current.offsetTop - part("steps").offsetTop;
}

function labelOf(entry) {
  if (!entry) return ["The first picture, as it comes with the question."];
  const sent = Object.entries(entry.arguments).map(([key, value]) => `${key}=${value}`).join(", ");
  const older = chosen < state.entries.length ? " An earlier step: the table may have changed since." : "";
  return [make("code", {}, said(`${entry.tool}(${sent})`)), older];
}

function button(entry, number) {
  const moving = entry && MOVING.has(entry.tool) ? "moving" : "";
  const amiss = entry && entry.status !== "done" ? "amiss" : "";
  return make("li", {}, make("button", { type: "button", class: `${moving} ${amiss}`,
    "aria-current": number === chosen ? "step" : null, click: () => choose(number) },
  entry ? `${number} ${entry.tool}` : "start"));
}

const within = (value) => Math.max(0, Math.min(PIXELS - 1, Math.floor(value)));

image.addEventListener("click", (event) => {
  const box = image.getBoundingClientRect();
  const u = (PIXELS * (event.clientX - box.left)) / box.width;
  const v = (PIXELS * (event.clientY - box.top)) / box.height;
  setPoint([within(u), within(v)]);
});

image.addEventListener("keydown", (event) => {
  const move = MOVES[event.key];
  if (!move) return;
  event.preventDefault();
  const step = event.shiftKey ? 1 : 8;
  const [u, v] = point ?? [PIXELS / 2, PIXELS / 2];
  setPoint([within(u + step * move[0]), within(v + step * move[1])]);
});
