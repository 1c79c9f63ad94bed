// What is drawn on a picture: where a call aimed, where the answer pointed, where the true thing lies.

const OVERLAYS = {
  found: "found and outlined",
  aimed: "aimed at",
  answer: "the answer points here",
  truth: "the true object, even while hidden",
};

/** A ring; across and down are shares of the picture. */
function ring([across, down], kind) {
  const dot = make("span", { class: `ring ${kind}` });
  dot.style.left = `${100 * across}%`;
  dot.style.top = `${100 * down}%`;
  return dot;
}

/** Kinds and places of all that is drawn after a step; 0 is the start. */
function overlaysOf(episode, detail, number) {
  const step = detail.steps[number - 1];
  const share = (point) => point.map((value) => value / episode.picture_px);
  const found = (episode.true_places[number] ?? []).map((place) => ["truth", place]);
  if (step?.tool === "answer_question" && detail.answer?.point) found.push(["answer", share(detail.answer.point)]);
  else if (step?.point && step.tool !== "find_object") found.push(["aimed", share(step.point)]);
  return found;
}

/** Kinds that an episode's pictures show at any time. */
function overlayKinds({ episode, detail }) {
  const kinds = new Set(detail.steps.flatMap((_, number) => overlaysOf(episode, detail, number + 1).map(([kind]) => kind)));
  overlaysOf(episode, detail, 0).forEach(([kind]) => kinds.add(kind));
  if (detail.steps.some((step) => step.tool === "find_object" && step.status === "done" && step.point)) kinds.add("found");
  return kinds;
}
