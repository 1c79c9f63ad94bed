// What a person at the robot presses. What the server says is only ever set as text.

const part = (id) => document.getElementById(id);
let shown = null;

async function ask(path, said = null) {
  const options = said === null ? {} : {
    method: "POST",
    headers: { "content-type": "application/json" },
    body: JSON.stringify(said),
  };
  let reply;
  try {
    reply = await fetch(path, options);
  } catch {
    throw new Error("The program that runs the robot can't be reached. Use the robot's own emergency stop.");
  }
  const told = await reply.json().catch(() => ({}));
  if (!reply.ok) throw new Error(told.error ?? `The program replied with ${reply.status}.`);
  return told;
}

function show(state) {
  part("said").textContent = "";
  part("stopped").hidden = state.stopped === null;
  part("stopped-words").textContent = state.stopped === null ? "" : `The robot was stopped by ${state.stopped}. It stays where it is.`;
  const waits = state.waiting;
  part("motion").hidden = waits === null || state.stopped !== null;
  document.title = waits === null ? "PROBE: robot" : "May the robot move? PROBE";
  if (waits !== null && waits.id !== shown) {
    part("words").textContent = `Motion ${waits.number}. ${waits.words}`;
    part("plan").src = `/motion.jpg?${waits.id}`;
  }
  shown = waits === null ? null : waits.id;
}

function act(path, said) {
  ask(path, said).then(show).catch((error) => { part("said").textContent = error.message; });
}

part("stop").addEventListener("click", () => act("/stop", {}));
part("release").addEventListener("click", () => act("/release", {}));
part("yes").addEventListener("click", () => act("/answer", { motion: shown, yes: true }));
part("no").addEventListener("click", () => act("/answer", { motion: shown, yes: false }));

const live = part("live");
let look = 0;
function again(seen) {
  part("blind").hidden = seen;
  live.hidden = !seen;
  setTimeout(() => { live.src = `/live.jpg?${look += 1}`; }, 700);
}
live.addEventListener("load", () => again(true));
live.addEventListener("error", () => again(false));
live.src = "/live.jpg";

async function watch() {
  try {
    show(await ask("/state"));
  } catch (error) {
    part("said").textContent = error.message;
  }
  setTimeout(watch, 300);
}
watch();
