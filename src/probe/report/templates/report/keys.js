// The keyboard, and the beginning.

function typing(target) {
  return target.matches("input:not([type=range]), select, textarea");
}

function stepKey(key) {
  const at = farthest();
  const to = { ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: Infinity }[key];
  if (to !== undefined) {
    pause();
    showAll(to);
  }
  return to !== undefined;
}

function replayKey(key) {
  if (key === "j") go(1);
  else if (key === "k") go(-1);
  else if (key === "c") compareNext();
  else if (key === " ") togglePlaying();
  else return stepKey(key);
  return true;
}

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || typing(event.target) || large.open) return;
  if (event.key === " " && event.target.matches("button, summary")) return;
  if (dialog.open ? replayKey(event.key) : event.key === "/") {
    event.preventDefault();
    if (!dialog.open) filters.elements.text.focus();
  }
});

filter();
openFromAddress();
addEventListener("hashchange", openFromAddress);
