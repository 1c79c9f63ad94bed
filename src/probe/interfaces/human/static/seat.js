// Keeps the page as the server says it is: asks while something is going on, then rests.

import { showSteps } from "./picture.js";
import { evidenceAddress, look, part, post, practice } from "./talk.js";
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
  part("place").textContent = state.number ? `${practice ? "Practice question" : "Question"} ${state.number} of ${state.total}` : `${state.done} of ${state.total} done`;
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
  part("between-words").textContent = state.doing ? `${state.doing} …` : endWords(all) || "Ready when you are.";
  part("between-told").textContent = state.doing ? "" : toldInTheEnd();
  showEvidence();
  placeRemark(part("between"), null, state.number > 0 && !state.doing);
  part("next").hidden = Boolean(state.doing) || (all && !state.trouble);
  part("next").textContent = state.trouble ? "Go on" : practice ? "Next practice question" : "Next question";
  if (!part("next").hidden) part("next").focus();
}

function endWords(all) {
  const last = state.entries.at(-1);
  const answered = last?.tool === "answer_question" && last.status === "done";
  const ended = !state.number ? "" : answered ? "Your answer is written down." : "This question has ended without an answer.";
  const told = state.feedback?.verdict ?? ended;
  if (!all) return told;
  const thanks = practice ? "That was all there is to practise on." : `You are through with all ${state.total} questions. Thank you.`;
  return `${told} ${thanks}`.trim();
}

/** What the page says below: the reason, or the tool's own words if it was they that ended it. */
function toldInTheEnd() {
  if (state.feedback) return state.feedback.reason;
  const last = state.entries.at(-1);
  const byTool = state.number > 0 && last && !state.stopped && last.tool !== "answer_question";
  return byTool ? last.text : "";
}

function showEvidence() {
  const told = state.doing ? null : state.feedback;
  part("evidence").hidden = !told;
  for (let number = 0; told && number < told.pictures; number += 1) {
    const image = part(`evidence-${number}`);
    const address = evidenceAddress(state.number, number);
    if (image.getAttribute("src") !== address) image.src = address;
  }
}

/** The remark belongs to a question as long as it is the last one, answered or not. */
function placeRemark(parent, before, visible) {
  const form = part("remark-form");
  if (practice) return; // there is none
  if (form.parentElement !== parent) parent.insertBefore(form, before);
  form.hidden = !visible;
}

function showDoing() {
  const seconds = Math.round((performance.now() - since) / 1000);
  part("doing").hidden = !state.doing;
  if (state.doing) part("doing").textContent = `${state.doing} … ${seconds > 1 ? `${seconds} s` : ""}`;
}

function showRemark() {
  if (practice) return;
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
async function keepRemark() {
  const said = { number: state.number, ambiguous: part("ambiguous").checked, note: part("note").value };
  try {
    state = { ...state, remark: (await post("remark", said)).remark };
    part("kept").textContent = "Kept.";
  } catch (error) {
    tell(error.message);
  }
}

if (!practice) {
  part("ambiguous").addEventListener("change", () => {
    part("note-part").hidden = !part("ambiguous").checked;
    keepRemark();
  });
  part("remark-form").addEventListener("submit", (event) => {
    event.preventDefault();
    keepRemark();
  });
}
attempt(post("enter"));
