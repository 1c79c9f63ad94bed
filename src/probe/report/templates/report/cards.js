// A card for each task: its first picture, its question, and a button for each episode.

const cards = document.getElementById("cards");

function runButton(episode) {
  const words = `${nameOf(episode)}: ${episode.verdict}, ${episode.outcome}`;
  return make(
    "button",
    { type: "button", class: `run ${episode.verdict}`, "aria-label": words, title: words,
      "data-key": episode.key, click: () => openEpisode(episode.key) },
    SIGNS[episode.verdict],
  );
}

function neverRun(gap) {
  const words = `${nameOf(gap)}: never run`;
  return make("span", { class: "run never missing", title: words, role: "img", "aria-label": words }, "∅");
}

/** The first episode of each agent, of four at most: as many as fit side by side. */
function firstOfEach(episodes) {
  return episodes.filter((each, place) => episodes.findIndex((other) => other.entrant === each.entrant) === place).slice(0, 4);
}

function cardOf(number, episodes, gaps) {
  const task = index.tasks[number];
  const rows = index.entrants.flatMap((name, entrant) => {
    const mine = episodes.filter((episode) => episode.entrant === entrant).map(runButton);
    const lacking = gaps.filter((gap) => gap.entrant === entrant).map(neverRun);
    if (!mine.length && !lacking.length) return [];
    return [make("div", {}, make("dt", {}, said(name)), make("dd", {}, ...mine, ...lacking))];
  });
  const picture = make("img", { loading: "lazy", width: 512, height: 512, src: task.picture, alt: "The table at the start" });
  const [first, ...more] = firstOfEach(episodes);
  return make(
    "article",
    { class: "card" },
    make("button", { type: "button", class: "shot", disabled: !first,
      title: more.length ? "Replay all agents side by side" : "Replay", "aria-label": `Replay: ${task.question}`,
      click: () => openEpisode(first.key, more.map((each) => each.key)) }, picture),
    make("p", { class: "kind" }, make("span", {}, task.kind), make("code", {}, task.id)),
    make("h3", {}, said(task.question)),
    make("dl", {}, ...rows),
  );
}

/** Show the cards of these episodes and of these runs that never were. */
function showCards(episodes, gaps) {
  const numbers = [...new Set([...episodes, ...gaps].map((each) => each.task))].sort((a, b) => a - b);
  cards.replaceChildren(
    ...numbers.map((number) =>
      cardOf(number, episodes.filter((it) => it.task === number), gaps.filter((it) => it.task === number))),
  );
}
