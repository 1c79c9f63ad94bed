// Keeps the page as the server says it is: asks while something is going on, then rests.

import { showSteps } from "./picture.js";
import { look, part, post } from "./talk.js";
import { onCall, showTools } from "./tools.js";

const PAUSE_MS = 400;
let state = null;
let since = 0;

function tell(words) {
  part("trouble").textContent = words ?? "";
  part("trouble").hidden = !words;
}

function show(next) {
  if (next.doing && !state?.doing) since = performance.now();
  const other = state?.number !== next.number;
  state = next;
  part("place").textContent = state.number ? `Question ${state.number} of ${state.total}` : `${state.done} of ${state.total} done`;
  tell(state.trouble);
  const playing = state.number > 0 && !state.over;
  part("game").hidden = !playing;
  part("between").hidden = playing;
  if (playing) {
    showSteps(state);
    showTools(state);
    placeRemark(part("desk"), part("rules"), true);
    if (other) showRemark();
  } else showBetween();
  showDoing();
  if (state.doing) setTimeout(refresh, PAUSE_MS);
}

function showBetween() {
  const all = state.done === state.total;
  const last = state.entries.at(-1);
  const answered = last?.tool === "answer_question" && last.status === "done";
  const thanks = all ? ` You are through with all ${state.total} questions. Thank you.` : "";
  const ended = !state.number ? "" : answered ? "Your answer is written down." : "This question has ended without an answer.";
  part("between-words").textContent = state.doing ? `${state.doing} …` : `${ended}${thanks}`.trim() || "Ready when you are.";
  part("between-told").textContent = state.number && !answered && last && !state.doing ? last.text : "";
  placeRemark(part("between"), null, state.number > 0 && !state.doing);
  part("next").hidden = Boolean(state.doing) || (all && !state.trouble);
  part("next").textContent = state.trouble ? "Go on" : "Next question";
}

/** The remark belongs to a question as long as it is the last one, answered or not. */
function placeRemark(parent, before, visible) {
  const form = part("remark-form");
  if (form.parentElement !== parent) parent.insertBefore(form, before);
  form.hidden = !visible;
}

function showDoing() {
  const seconds = Math.round((performance.now() - since) / 1000);
  part("doing").hidden = !state.doing;
  if (state.doing) part("doing").textContent = `${state.doing} … ${seconds > 1 ? `${seconds} s` : ""}`;
}

function showRemark() {
  part("ambiguous").checked = state.remark.ambiguous;
  part("note").value = state.remark.note;
  part("note-part").hidden = !state.remark.ambiguous;
  part("kept").textContent = "";
}

async function attempt(asked) {
  try {
    show(await asked);
  } catch (error) {
    await settle();
    tell(error.message);
  }
}

/** After a refusal: what has really happened. */
async function settle() {
  try {
    show(await look());
  } catch {
    // the refusal itself says more
  }
}

async function refresh() {
  try {
    show(await look());
  } catch (error) {
    tell(error.message);
    setTimeout(refresh, 10 * PAUSE_MS);
  }
}

onCall(
  (tool, args) => attempt(post("call", { turn: state.entries.length, tool, arguments: args })),
  () => attempt(post("stop", { turn: state.entries.length })),
);
part("next").addEventListener("click", () => attempt(post("next")));
part("ambiguous").addEventListener("change", () => {
  part("note-part").hidden = !part("ambiguous").checked;
  part("kept").textContent = "";
});
part("remark-form").addEventListener("submit", async (event) => {
  event.preventDefault();
  const said = { number: state.number, ambiguous: part("ambiguous").checked, note: part("note").value };
  try {
    state = { ...state, remark: (await post("remark", said)).remark };
    part("kept").textContent = "Kept.";
  } catch (error) {
    tell(error.message);
  }
});
attempt(post("enter"));
