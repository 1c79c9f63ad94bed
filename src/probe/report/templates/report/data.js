"use strict";
// What the page was given. Words of models are only ever set as text, never as HTML.

const index = JSON.parse(document.getElementById("index-data").textContent);
const inlined = Object.entries(JSON.parse(document.getElementById("detail-data").textContent));
const MOVING = new Set(["grasp_and_remove", "push"]);
const SIGNS = { right: "✓", wrong: "✗", missing: "–" };

const byKey = new Map(index.episodes.map((episode) => [episode.key, episode]));

/** Make an element; attributes that are functions listen, strings among the children are text. */
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== null && value !== undefined && value !== false) element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

/** Text of strangers, kept from turning its surroundings from right to left. */
function said(text) {
  return make("bdi", {}, String(text));
}

const details = new Map(inlined.map(([key, detail]) => [key, Promise.resolve(detail)]));
const arrivals = new Map();

/** Called by the file of an episode. */
globalThis.probeEpisode = (key, detail) => arrivals.get(key)?.(detail);

/** What happened in an episode; a page from disk may load scripts, but no data. */
function detailOf(key) {
  if (!details.has(key)) details.set(key, new Promise((resolve, reject) => {
    arrivals.set(key, resolve);
    const fail = () => reject(new Error(`episodes/${key}.js is missing. Write the report again.`));
    document.head.append(make("script", { src: `episodes/${key}.js`, error: fail }));
  }));
  return details.get(key);
}

function nameOf(episode) {
  return `${index.entrants[episode.entrant]}, run ${episode.run}`;
}
