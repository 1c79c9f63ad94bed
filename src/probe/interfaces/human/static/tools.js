// The forms: each sends one call. What the person has chosen stays while states come in.

import { currentPoint, onPoint, setPoint } from "./picture.js";
import { make, part, said } from "./talk.js";

let state = null;
let send = () => {};
let stop = () => {};

/** Say what to do with a call, and with the wish to stop. */
export function onCall(call, end) {
  send = call;
  stop = end;
}

export function showTools(next) {
  const other = !state || state.number !== next.number;
  const found = other || ids(state) !== ids(next);
  const moved = !other && state.manipulationsLeft !== next.manipulationsLeft;
  state = next;
  part("question").textContent = state.question;
  part("manipulations").textContent = state.manipulationsLeft;
  part("turns").textContent = state.turnsLeft;
  part("controls").disabled = state.doing !== null;
  if (other) listOptions();
  if (found) listObjects();
  if (moved) part("description").value = ""; // what was searched for may lie elsewhere now
  part("no-object").hidden = state.objects.length > 0;
  part("movers").hidden = state.objects.length === 0;
  showPoint();
}

function listOptions() {
  part("description").value = "";
  part("options").replaceChildren(...state.options.map(([letter, text]) =>
    make("label", {}, make("input", { type: "radio", name: "option", value: letter, change: showPoint }),
      make("b", {}, letter), said(text))));
}

const ids = (of) => of.objects.map((each) => each.id).join();

/** The newest first. Chosen is what a search has found, or what was, also under a new id, if it can still be moved. */
function listObjects() {
  const list = part("object");
  const newest = [...state.objects].reverse();
  const searched = state.entries.at(-1)?.tool === "find_object";
  const known = [...list.options].map((each) => each.value);
  const renamed = known.length > 0 && newest[0] && !known.includes(newest[0].id) && state.entries.at(-1)?.tool !== "perceive_scene";
  const chosen = searched || renamed ? newest[0]?.id : newest.find((each) => each.id === list.value)?.id;
  list.replaceChildren(
    make("option", { value: "", hidden: true }, "Choose what to move"),
    ...newest.map((each) => make("option", { value: each.id }, `${each.called} (${each.id})`)),
  );
  list.value = chosen ?? "";
}

/** Send a call about the thing that is chosen. */
function sendMove(tool, more) {
  const object_id = part("object").value;
  if (object_id) send(tool, { object_id, ...more });
  else part("object").focus();
}

function letter() {
  return document.querySelector("input[name=option]:checked")?.value ?? null;
}

/** What the answer would be, as far as it is chosen. */
function showPoint() {
  const point = currentPoint();
  part("answer").disabled = !letter();
  part("answer-point").hidden = !state?.asksPoint;
  part("answer-point").textContent = point
    ? `Points at (${point.join(", ")}). Click on the picture to change it.`
    : "Click on the picture to point at it, in the picture as it is now.";
}

function sure(words, yes, act) {
  part("sure-words").textContent = words;
  part("sure-yes").textContent = yes;
  part("sure-yes").onclick = () => { part("sure").close(); act(); };
  part("sure").showModal();
}

onPoint((point) => {
  if (point) part("description").value = `the thing at (${point.join(", ")})`;
  if (state) showPoint();
});

part("sure-no").addEventListener("click", () => part("sure").close());
part("perceive").addEventListener("click", () => send("perceive_scene", {}));
part("find-form").addEventListener("submit", (event) => {
  event.preventDefault();
  const description = part("description").value.trim();
  if (description) send("find_object", { description });
  else part("description").focus();
});
part("grasp").addEventListener("click", () => sendMove("grasp_and_remove", {}));
part("move-form").addEventListener("submit", (event) => {
  event.preventDefault();
  sendMove("push", {
    direction: document.querySelector("input[name=direction]:checked").value,
    distance_cm: Number(part("distance").value),
  });
});
part("answer-form").addEventListener("submit", (event) => {
  event.preventDefault();
  const choice = letter();
  const point = state.asksPoint ? currentPoint() : null;
  const text = state.options.find(([each]) => each === choice)[1];
  const where = point ? `, at (${point.join(", ")})` : state.asksPoint ? ", without a point" : "";
  sure(`Answer ${choice}: ${text}${where}? It can't be taken back.`, "Answer", () => {
    send("answer_question", point ? { choice, point } : { choice });
    setPoint(null);
  });
});
part("stop").addEventListener("click", () =>
  sure("End this question without an answer? It counts as unanswered and can't be taken back.", "End it", () => stop()));
