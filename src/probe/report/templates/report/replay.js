// The dialog: one episode, or two at the same task side by side.

const dialog = document.getElementById("replay");
const stage = document.getElementById("stage");
const beside = document.getElementById("beside");
let current = null;
let panels = [];
let openings = 0;

/** Other episodes at the same task; those of other entrants first. */
function others(episode) {
  const all = index.episodes.filter((each) => each.task === episode.task && each !== episode);
  return [...all.filter((each) => each.entrant !== episode.entrant), ...all.filter((each) => each.entrant === episode.entrant)];
}

async function panelOf(episode) {
  try {
    return new Panel(episode, await detailOf(episode.key));
  } catch (error) {
    return { episode, element: make("p", { class: "notice" }, error.message), show() {}, slider: null, at: 0 };
  }
}

/** Open an episode; its address stays in the address bar. */
async function openEpisode(key, other = "") {
  const episode = byKey.get(key);
  if (!episode) return;
  const second = byKey.get(other);
  const opening = ++openings;
  current = episode;
  const made = await Promise.all([episode, second].filter(Boolean).map(panelOf));
  if (opening !== openings) return;
  panels = made;
  stage.className = second ? "two" : "";
  stage.replaceChildren(...panels.map((panel) => panel.element));
  ask(episode);
  listOthers(episode, other);
  showPlace();
  if (!dialog.open) dialog.showModal();
  panels[0].slider?.focus({ preventScroll: true });
  dialog.scrollTop = 0;
  history.replaceState(null, "", `#episode=${key}${second ? `+${other}` : ""}`);
}

function ask(episode) {
  const task = index.tasks[episode.task];
  document.getElementById("replay-kind").textContent = `${task.kind} · ${task.id}`;
  document.getElementById("replay-question").replaceChildren(said(task.question));
  document.getElementById("replay-options").replaceChildren(
    ...task.options.map(([letter, text]) => {
      const right = letter === task.truth;
      const by = panels.filter((panel) => panel.episode.answer === letter);
      const notes = [right ? "truth" : "", ...by.map((panel) => (panels.length > 1 ? nameOf(panel.episode) : "answered"))];
      const words = notes.filter(Boolean).join(" · ");
      return make("li", { class: `${right ? "truth" : ""} ${by.length ? "chosen" : ""}` }, make("b", {}, letter), said(text),
        words ? make("small", {}, ` ${right ? "✓" : "✗"} ${words}`) : null);
    }),
  );
}

function listOthers(episode, other) {
  const choices = others(episode).map((each) =>
    make("option", { value: each.key, selected: each.key === other }, `${nameOf(each)} ${SIGNS[each.verdict]}`));
  beside.replaceChildren(make("option", { value: "" }, "nothing"), ...choices);
  beside.disabled = !choices.length;
}

function showPlace() {
  const place = shown.indexOf(current);
  document.getElementById("place").textContent = place < 0 ? "" : `${place + 1} of ${shown.length}`;
  document.getElementById("previous").disabled = place === 0;
  document.getElementById("next").disabled = place === shown.length - 1;
}

/** Go to another of the episodes that the filters leave. */
function go(by) {
  const next = shown[Math.max(0, shown.indexOf(current) + by)];
  if (next && next !== current) openEpisode(next.key);
}

/** Put the next other episode at this task beside, and at last none. */
function compareNext() {
  const keys = ["", ...others(current).map((each) => each.key)];
  openEpisode(current.key, keys[(keys.indexOf(beside.value) + 1) % keys.length]);
}

/** The panel that has the focus, else the first. */
function panelInUse() {
  return panels.find((panel) => panel.element.contains(document.activeElement)) ?? panels[0];
}

function openFromAddress() {
  const [key, other] = (location.hash.match(/^#episode=(.*)$/)?.[1] ?? "").split("+");
  if (key) openEpisode(key, other);
}

beside.addEventListener("change", () => openEpisode(current.key, beside.value));
document.getElementById("previous").addEventListener("click", () => go(-1));
document.getElementById("next").addEventListener("click", () => go(1));
document.getElementById("close").addEventListener("click", () => dialog.close());
dialog.addEventListener("close", () => {
  openings += 1;
  history.replaceState(null, "", "#");
});
