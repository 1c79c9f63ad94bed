// One episode, step by step.

function callText(step) {
  let values = null;
  try {
    values = JSON.parse(step.arguments);
  } catch {
    return `(${step.arguments})`;
  }
  if (values === null || typeof values !== "object" || Array.isArray(values)) return `(${step.arguments})`;
  return `(${Object.entries(values).map(([name, value]) => `${name}=${JSON.stringify(value)}`).join(", ")})`;
}

function counted(count, noun) {
  return `${count} ${noun}${count === 1 ? "" : "s"}`;
}

class Panel {
  /** `choose` is called with a step that somebody chose here; the panel moves when it is told to. */
  constructor(episode, detail, choose) {
    this.episode = episode;
    this.detail = detail;
    this.at = 0;
    this.last = detail.steps.length;
    this.timeline = new Timeline(nameOf(episode), detail.steps, choose);
    this.picture = enlarging(make("div", { class: "picture", role: "button", tabindex: 0, title: "Show in full size" }));
    this.film = make("div", { class: "film" });
    this.call = make("div");
    this.element = make("section", { class: "panel-of", "aria-label": nameOf(episode) },
      this.header(),
      make("div", { class: "seen" }, this.picture, this.timeline.element),
      make("div", { class: "told-of" }, this.alert(), this.film, this.call));
    this.show(0);
  }

  get slider() {
    return this.timeline.slider;
  }

  before() {
    const words = this.detail.said.map((each) => make("p", { class: "words" }, said(each)));
    const label = words.length ? [make("p", { class: "label" }, "What it said without a call")] : [];
    return [make("p", { class: "words" }, "The table as the agent was first shown it."), ...label, ...words];
  }

  header() {
    const { episode, detail } = this;
    const seconds = detail.seconds.filter((value) => value !== null).reduce((a, b) => a + b, 0);
    const facts = `answer ${episode.answer ?? "none"}; ${counted(episode.turns, "turn")}, ${counted(episode.manipulations, "manipulation")}, ${Math.round(seconds)} s`;
    return make("header", {}, make("h3", {}, said(nameOf(episode))),
      make("span", { class: `verdict ${episode.verdict}` }, `${SIGNS[episode.verdict]} ${episode.outcome}`),
      make("span", {}, facts), episode.counts ? null : make("span", {}, "run again later; doesn't count"));
  }

  alert() {
    const { episode, detail } = this;
    if (episode.fault) return make("p", { class: "alert" }, "Failed on our side: ", said(episode.fault));
    if (detail.end === "answered") return null;
    return make("p", { class: "alert" }, detail.end === "out_of_turns" ? "It ran out of turns." : "It stopped without an answer.");
  }

  /** Show the table at the start (0) or after a step; at the end if there are fewer steps. */
  show(number) {
    this.at = Math.max(0, Math.min(this.last, number));
    const step = this.detail.steps[this.at - 1];
    const words = step ? `step ${this.at} of ${this.last}, ${step.tool}, ${step.status}` : "start";
    this.timeline.put(this.at, words);
    this.showPicture(step, words);
    this.call.replaceChildren(...(step ? this.said(step) : this.before()));
    const next = this.detail.steps[this.at];
    if (next) new Image().src = next.picture;
  }

  /** Whether a film belongs to the step that is shown. */
  get filmed() {
    return this.at in this.episode.clips;
  }

  showPicture(step, words) {
    const rings = overlaysOf(this.episode, this.detail, this.at).map(([kind, place]) => ring(place, kind));
    this.picture.replaceChildren(make("img", { src: step ? step.picture : this.detail.start,
      width: 1024, height: 1024, alt: `The table from above: ${words}` }), ...rings);
    this.film.replaceChildren(...(this.filmed ? [clipOf(this.episode.clips[this.at], `Film of ${words}`)] : []));
  }

  said(step) {
    const parts = [make("p", { class: "call" }, make("code", {}, make("b", {}, step.tool), callText(step)))];
    if (step.status !== "done") parts.push(make("p", { class: "status" }, `✗ ${step.status}`));
    if (step.words) parts.push(make("p", { class: "label" }, "What the agent said"), make("p", { class: "words" }, said(step.words)));
    parts.push(make("p", { class: "label" }, "What the tool said"), make("pre", { class: "told", tabindex: 0 }, said(step.text)));
    return parts;
  }
}
