// A picture in its full size, with what was drawn on it.

const large = document.getElementById("large");

/** Let a click on a picture, or Enter, show it in full size. */
function enlarging(picture) {
  // On a small screen it begins with the place that was clicked.
  const show = (across, down) => {
    large.replaceChildren(picture.cloneNode(true));
    large.showModal();
    large.scrollTo((large.scrollWidth - large.clientWidth) * across, (large.scrollHeight - large.clientHeight) * down);
  };
  picture.addEventListener("click", (event) => show(event.offsetX / picture.clientWidth, event.offsetY / picture.clientHeight));
  picture.addEventListener("keydown", (event) => { if (event.key === "Enter") show(0.5, 0.5); });
  return picture;
}

large.addEventListener("click", () => large.close());
for (const image of document.querySelectorAll(".shots img")) enlarging(image);
