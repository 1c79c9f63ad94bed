// Films of manipulations: each is loaded and played only while it can be seen.

const calm = matchMedia("(prefers-reduced-motion: reduce)");

const watcher = new IntersectionObserver((entries) => {
  for (const { target, isIntersecting } of entries) {
    if (!isIntersecting) target.pause();
    else if (calm.matches) target.controls = true;
    // A browser that plays nothing by itself shows its button.
    else target.play().catch(() => { if (target.isConnected) target.controls = true; });
  }
}, { threshold: 0.25 });

function watched(video) {
  video.muted = true;
  watcher.observe(video);
  return video;
}

/** A film as a page shows it: a video, or a picture that moves. */
function clipOf(address, words) {
  if (/\.webp$|^data:image/.test(address)) return make("img", { class: "clip", loading: "lazy", src: address, alt: words });
  return watched(make("video", { class: "clip", src: address, preload: "none", loop: true, playsinline: true, "aria-label": words }));
}

document.querySelectorAll("video.clip").forEach(watched);
