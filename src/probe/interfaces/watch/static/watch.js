// Shows a run as it happens. What the server says is only ever set as text, never as HTML.

const part = (id) => document.getElementById(id);
const shown = new Map(); // of each table: its elements, and what they show
const PAUSE_MS = 500;

function make(tag, className, text = "") {
  const element = document.createElement(tag);
  element.className = className;
  element.textContent = text;
  return element;
}

function show(state) {
  part("who").textContent = `${state.agent} on ${state.suite}`;
  part("far").replaceChildren(make("b", "", state.done), ` of ${state.total} episodes done`);
  part("bar").max = Math.max(1, state.total);
  part("bar").value = state.done;
  part("waiting").hidden = state.tables.length > 0;
  part("tables").className = state.tables.length > 1 ? "several" : "";
  for (const table of state.tables) showTable(table);
}

function showTable(table) {
  const place = shown.get(table.table) ?? addTable(table.table);
  const episode = `${table.task} ${table.run}`;
  if (place.episode !== episode) {
    place.heading.textContent = table.question;
    place.which.textContent = table.run ? `${table.task}, run ${table.run}` : table.task;
    place.options.replaceChildren(...table.options.flatMap(([letter, text]) => [make("b", "", letter), ` ${text}  `]));
  }
  const pictured = `${episode} ${table.pictures}`;
  if (table.pictures && place.pictured !== pictured) {
    place.image.src = `/picture?${new URLSearchParams({ table: table.table, of: pictured })}`;
  }
  const told = JSON.stringify([episode, table.steps]);
  if (place.told !== told) {
    const atEnd = place.steps.scrollTop + place.steps.clientHeight >= place.steps.scrollHeight - 40;
    place.steps.replaceChildren(...table.steps.map(stepOf));
    if (atEnd || place.episode !== episode) place.steps.scrollTop = place.steps.scrollHeight;
  }
  Object.assign(place, { episode, pictured, told });
}

function addTable(number) {
  const place = {
    image: make("img", ""), heading: make("h1", ""), which: make("p", "which"),
    options: make("p", "options"), steps: make("ol", "steps"),
  };
  place.image.alt = "The newest picture of the table";
  const side = make("div", "side");
  side.append(place.heading, place.which, place.options, place.steps);
  const table = make("section", "table");
  table.append(place.image, side);
  part("tables").append(table);
  shown.set(number, place);
  return place;
}

function stepOf(step) {
  const answered = step.tool === "answer_question"; // what is told of that ends the episode
  const status = step.status === null ? (answered ? "" : "under-way") : step.status === "done" ? "" : "amiss";
  const item = make("li", status);
  if (step.words) item.append(make("p", "words", step.words));
  item.append(make("code", "", `${step.tool}(${argumentsOf(step)})`));
  if (step.text) item.append(make("pre", "", step.text));
  return item;
}

/** As in calls of Python; the text itself if it isn't an object. */
function argumentsOf(step) {
  try {
    return Object.entries(JSON.parse(step.arguments)).map(([key, value]) => `${key}=${JSON.stringify(value)}`).join(", ");
  } catch {
    return step.arguments;
  }
}

async function watch() {
  try {
    const reply = await fetch("/state");
    if (!reply.ok) throw new Error(`The program replied with ${reply.status}.`);
    show(await reply.json());
    part("trouble").hidden = true;
  } catch (error) {
    const gone = error instanceof TypeError;
    part("trouble").textContent = gone ? "The run has ended, or was stopped. `probe report` shows its episodes." : error.message;
    part("trouble").hidden = false;
  }
  setTimeout(watch, PAUSE_MS);
}
watch();
