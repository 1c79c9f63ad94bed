// Playing: all panels go on together, step by step.

const playButton = document.getElementById("play");
const STEP_MS = 1400;
const FILM_MS = 4000;
let playing = 0;

/** Put every panel on a step; those that have fewer stay at their last. */
function showAll(number) {
  panels.forEach((panel) => panel.show(number));
}

function farthest() {
  return Math.max(...panels.map((panel) => panel.at));
}

function pause() {
  clearTimeout(playing);
  playing = 0;
  playButton.textContent = "▶ Play";
}

function playOn() {
  playing = setTimeout(() => {
    showAll(farthest() + 1);
    if (panels.some((panel) => panel.at < panel.last)) playOn();
    else pause();
  }, panels.some((panel) => panel.filmed) ? FILM_MS : STEP_MS);
}

/** Play from where the panels are, or from the start if all are at their end; or stop. */
function togglePlaying() {
  if (playing) return pause();
  if (panels.every((panel) => panel.at === panel.last)) showAll(0);
  playButton.textContent = "❚❚ Pause";
  playOn();
}

playButton.addEventListener("click", togglePlaying);
