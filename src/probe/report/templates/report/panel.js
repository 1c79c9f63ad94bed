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

function ring(point, kind = "") {
  const dot = make("span", { class: `ring ${kind}` });
  dot.style.left = `${(100 * point[0]) / index.picture_px}%`;
  dot.style.top = `${(100 * point[1]) / index.picture_px}%`;
  return dot;
}

class Panel {
  constructor(episode, detail) {
    this.episode = episode;
    this.detail = detail;
    this.at = 0;
    this.last = detail.steps.length;
    this.slider = make("input", { type: "range", min: 0, max: this.last, value: 0, step: 1,
      "aria-label": `Step of ${nameOf(episode)}`, input: () => this.show(Number(this.slider.value)) });
    this.count = make("output");
    this.picture = make("div", { class: "picture" });
    this.steps = make("ol", { class: "steps", "aria-label": "Steps" }, ...this.buttons());
    this.call = make("div");
    this.element = make("section", { class: "panel-of", "aria-label": nameOf(episode) },
      this.header(), this.alert(),
      make("div", {}, this.picture, make("div", { class: "slide" }, make("span", { class: "label" }, "Step"), this.slider, this.count)),
      make("div", {}, this.steps, this.call));
    this.show(0);
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

  buttons() {
    const all = [null, ...this.detail.steps];
    return all.map((step, number) => {
      const moving = step && MOVING.has(step.tool) ? "moving" : "";
      const amiss = step && step.status !== "done" ? "amiss" : "";
      const name = step ? `${number} ${step.tool.slice(0, 40)}` : "start";
      return make("li", {}, make("button", { type: "button", class: `${moving} ${amiss}`, click: () => this.show(number) }, name));
    });
  }

  /** Show the table at the start (0) or after a step. */
  show(number) {
    this.at = Math.max(0, Math.min(this.last, number));
    const step = this.detail.steps[this.at - 1];
    const words = step ? `step ${this.at} of ${this.last}, ${step.tool}, ${step.status}` : "start";
    this.slider.value = this.at;
    this.slider.setAttribute("aria-valuetext", words);
    this.count.textContent = `${this.at} / ${this.last}`;
    this.showPicture(step, words);
    this.call.replaceChildren(...(step ? this.said(step) : this.before()));
    [...this.steps.children].forEach((item, place) => {
      if (place === this.at) item.firstChild.setAttribute("aria-current", "step");
      else item.firstChild.removeAttribute("aria-current");
    });
    const next = this.detail.steps[this.at];
    if (next) new Image().src = next.picture;
  }

  showPicture(step, words) {
    const source = step ? step.picture : this.detail.start;
    const rings = [];
    if (step?.point && step.tool !== "find_object") rings.push(ring(step.point));
    if (step?.tool === "answer_question" && this.detail.answer?.point) rings.push(ring(this.detail.answer.point, "answer"));
    this.picture.replaceChildren(make("img", { src: source, width: 512, height: 512, alt: `The table from above: ${words}` }), ...rings);
  }

  said(step) {
    const parts = [make("p", { class: "call" }, make("code", {}, make("b", {}, step.tool), callText(step)))];
    if (step.status !== "done") parts.push(make("p", { class: "status" }, `✗ ${step.status}`));
    if (step.words) parts.push(make("p", { class: "label" }, "What the agent said"), make("p", { class: "words" }, said(step.words)));
    parts.push(make("p", { class: "label" }, "What the tool said"), make("pre", { class: "told", tabindex: 0 }, said(step.text)));
    return parts;
  }
}
