// The steps of an episode as one line: high where something was moved, orange where it failed.

const STEPS = {
  start: "the start",
  look: "looked or searched",
  move: "grasped or pushed",
  answer: "answered",
  amiss: "failed",
};

function kindOf(step) {
  if (!step) return "start";
  return MOVING.has(step.tool) ? "move" : step.tool === "answer_question" ? "answer" : "look";
}

function markOf(step) {
  return make("span", { class: `mark-of ${kindOf(step)} ${step && step.status !== "done" ? "amiss" : ""}` });
}

class Timeline {
  /** Calls `show` with the number of the step that somebody chose. */
  constructor(name, steps, show) {
    this.last = steps.length;
    this.marks = [null, ...steps].map(markOf);
    this.slider = make("input", { type: "range", min: 0, max: this.last, value: 0, step: 1,
      "aria-label": `Step of ${name}`, input: () => show(Number(this.slider.value)) });
    // A thumb as wide as a mark lies over it at every stop.
    this.slider.style.setProperty("--stops", this.last + 1);
    this.count = make("output");
    this.element = make("div", { class: "timeline" },
      make("div", { class: "track" }, ...this.marks, this.slider), this.count);
  }

  put(number, words) {
    this.slider.value = number;
    this.slider.setAttribute("aria-valuetext", words);
    this.count.textContent = `${number} / ${this.last}`;
    this.marks.forEach((mark, place) => {
      mark.classList.toggle("now", place === number);
      mark.classList.toggle("past", place < number);
    });
  }
}

/** Marks and rings in words, of those that these panels have. */
function legendOf(panels) {
  const kinds = new Set(panels.flatMap(({ detail }) => ["start", ...detail.steps.flatMap((step) =>
    [kindOf(step), step.status === "done" ? "" : "amiss"])]));
  const rings = new Set(panels.flatMap((panel) => [...overlayKinds(panel)]));
  const line = (name, words, sign) => make("li", { "data-kind": name }, sign, words);
  return [
    ...Object.entries(STEPS).filter(([kind]) => kinds.has(kind))
      .map(([kind, words]) => line(kind, words, make("span", { class: `mark-of ${kind === "amiss" ? "move amiss" : kind}` }))),
    ...Object.entries(OVERLAYS).filter(([kind]) => rings.has(kind))
      .map(([kind, words]) => line(kind, words, make("span", { class: `ring ${kind}` }))),
  ];
}
