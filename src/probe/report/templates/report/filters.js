// Which episodes are shown.

const filters = document.getElementById("filters");
let shown = index.episodes;

function searched(each) {
  const task = index.tasks[each.task];
  const options = task.options.map(([letter, text]) => `${letter} ${text}`);
  return [task.id, task.kind, task.question, ...options, nameOf(each), each.outcome, each.fault ?? ""].join("\n").toLowerCase();
}

const haystacks = new Map([...index.episodes, ...index.never].map((each) => [each, searched(each)]));

function addOptions(name, values) {
  const select = filters.elements[name];
  for (const [value, text] of values) select.append(make("option", { value }, text));
}

function fits(each, wanted) {
  return (
    (!wanted.kind || index.tasks[each.task].kind === wanted.kind) &&
    (!wanted.entrant || each.entrant === Number(wanted.entrant)) &&
    (!wanted.verdict || each.verdict === wanted.verdict) &&
    (!wanted.outcome || each.outcome === wanted.outcome) &&
    wanted.words.every((word) => haystacks.get(each).includes(word))
  );
}

function filter() {
  const values = Object.fromEntries(new FormData(filters));
  const words = values.text.toLowerCase().split(/\s+/).filter(Boolean);
  shown = index.episodes.filter((each) => fits(each, { ...values, words }));
  const gaps = index.never.filter((each) => fits(each, { ...values, words }));
  showCards(shown, gaps);
  const lacking = gaps.length ? `, and ${gaps.length} never run` : "";
  document.getElementById("found").textContent = `${shown.length} of ${index.episodes.length} episodes${lacking}`;
}

const distinct = (values) => [...new Set(values)].sort().map((value) => [value, value]);
for (const gap of index.never) Object.assign(gap, { verdict: "missing", outcome: "never run" });
addOptions("kind", distinct(index.tasks.map((task) => task.kind)));
addOptions("entrant", index.entrants.map((name, number) => [number, name]));
addOptions("outcome", distinct([...index.episodes, ...index.never].map((each) => each.outcome)));
filters.addEventListener("input", filter);
filters.addEventListener("submit", (event) => event.preventDefault());
filters.addEventListener("reset", () => setTimeout(filter));
