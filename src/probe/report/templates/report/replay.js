// The dialog: one episode, or several at the same task side by side.

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
    return new Panel(episode, await detailOf(episode.key), showAll);
  } catch (error) {
    const element = make("p", { class: "notice" }, error.message);
    return { episode, element, detail: { steps: [] }, show() {}, slider: null, at: 0, last: 0, filmed: false };
  }
}

/** Open an episode and others beside it; their address stays in the address bar. */
async function openEpisode(key, more = []) {
  const episode = byKey.get(key);
  if (!episode) return;
  const wanted = [episode, ...more.map((each) => byKey.get(each)).filter(Boolean)];
  const opening = ++openings;
  pause();
  current = episode;
  const made = await Promise.all(wanted.map(panelOf));
  if (opening !== openings) return;
  panels = made;
  stage.className = wanted.length > 1 ? "several" : "";
  stage.replaceChildren(...panels.map((panel) => panel.element));
  document.getElementById("replay-legend").replaceChildren(...legendOf(panels));
  ask(episode);
  listOthers(episode);
  showPlace();
  if (!dialog.open) dialog.showModal();
  panels[0].slider?.focus({ preventScroll: true });
  dialog.scrollTop = 0;
  history.replaceState(null, "", `#episode=${wanted.map((each) => each.key).join("+")}`);
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

function keysBeside() {
  return panels.slice(1).map((panel) => panel.episode.key);
}

/** A button for each other episode at the task, and one for all of them. */
function listOthers(episode) {
  const all = others(episode).map((each) => each.key);
  const there = keysBeside();
  const choices = all.map((key) => {
    const { verdict } = byKey.get(key);
    const left = there.includes(key) ? there.filter((each) => each !== key) : [...there, key];
    return make("button", { type: "button", "aria-pressed": String(there.includes(key)), click: () => openEpisode(current.key, left) },
      said(nameOf(byKey.get(key))), make("span", { class: `verdict ${verdict}` }, ` ${SIGNS[verdict]}`));
  });
  if (all.length > 1 && there.length < all.length)
    choices.push(make("button", { type: "button", click: () => openEpisode(current.key, all) }, "all"));
  beside.replaceChildren(...(all.length ? [make("span", { class: "label" }, "Beside it:"), ...choices] : []));
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

/** Put the next other episode at this task beside; after the last, none. */
function compareNext() {
  const there = keysBeside();
  const next = others(current).find((each) => !there.includes(each.key));
  openEpisode(current.key, next ? [...there, next.key] : []);
}

function openFromAddress() {
  const [key, ...more] = (location.hash.match(/^#episode=(.*)$/)?.[1] ?? "").split("+");
  if (key) openEpisode(key, more);
}

document.getElementById("previous").addEventListener("click", () => go(-1));
document.getElementById("next").addEventListener("click", () => go(1));
document.getElementById("close").addEventListener("click", () => dialog.close());
dialog.addEventListener("close", () => {
  openings += 1;
  pause();
  stage.replaceChildren();
  history.replaceState(null, "", "#");
});
