// SPDX-License-Identifier: MIT
// The page: state, requests for images, and display of numbers.
import { listenToDial, listenToKeys, listenToImage } from "/controls.js";
import { markProbe, showProbe } from "/probe.js";
import { Stokes } from "/stokes.js";
import { addThumbnails } from "/thumbnails.js";
import { VIEWS, View, drawWheel } from "/view.js";

const element = (id) => document.getElementById(id);
const canvas = element("image");

const state = {
  scene: null, azimuth: 0, elevation: 0, distance: 1, nearest: 0.1, farthest: 10, moved: false, light: 0, light_tilt: 0,
  polarizer: 0, view: "polarizer", exposure: 0, split: false, dragLight: false, probe: [0.5, 0.5],
};
// Most samples per pixel that the page asks for. Each step while nothing moves has four times as many as the last.
const most = Number(new URLSearchParams(location.search).get("samples")) || 64;
// detail: "half" the resolution during movement; "rounded" for a scene's first image; else "all".
let view, stokes, limits, scenes, detail = "all", wanted = 0, shown = -1, samples = 1, fetching = false;
let refining = null;  // aborts a request for more samples

function say(text) {
  element("message").textContent = text;
}

// ---------------------------------------------------------------- images

function size() {
  const [width, height] = state.scene.size, pixels = Math.min(devicePixelRatio, 2) * canvas.clientWidth;
  const side = Math.min(768, limits.max_side, Math.max(64, pixels)) / (detail === "half" ? 2 : 1);
  const factor = Math.min(side / Math.max(width, height), Math.sqrt(limits.max_pixels / (width * height)));
  return [width, height].map((length) => Math.max(1, Math.floor(length * factor)));
}

function target([width, height], perPixel) {
  const round = (value) => Math.round(value * 1e4) / 1e4;
  const query = new URLSearchParams({ size: `${width}x${height}` });
  if (state.moved) for (const name of ["azimuth", "elevation", "distance"]) query.set(name, round(state[name]));
  for (const name of ["light", "light_tilt"]) if (state[name] !== 0) query.set(name, round(state[name]));
  if (detail !== "all") query.set("bits", 6);
  if (perPixel > 1) query.set("samples", perPixel);
  return `${state.scene["stokes.planes"]}?${query}`;
}

const pause = (seconds) => new Promise((resolve) => setTimeout(resolve, 1000 * seconds));

// Runs one request at a time. Changes meanwhile are requested next, and intermediate states are never rendered. An
// image that is up to date is requested with more samples, and a change aborts such a request.
async function refresh() {
  if (fetching) return;
  fetching = true;
  while (shown !== wanted || (detail === "all" && samples < most)) {
    const now = wanted, start = performance.now(), pixels = size(), perPixel = shown === now ? Math.min(4 * samples, most) : 1;
    refining = perPixel > 1 ? new AbortController() : null;
    try {
      const response = await fetch(target(pixels, perPixel), { signal: refining?.signal });
      if (response.status === 503) {
        say("The service is busy.");
        await pause(Number(response.headers.get("Retry-After")) || 1);
        continue;
      }
      if (!response.ok) throw new Error((await response.json()).detail);
      stokes = new Stokes(...pixels, Number(response.headers.get("Nicol-Components")), await response.arrayBuffer());
      const fetched = performance.now();
      view.show(stokes);
      draw();
      element("time").textContent =
        `${pixels[0]} × ${pixels[1]}, ${perPixel} a pixel: ${(fetched - start).toFixed(0)} ms to render and fetch, ` +
        `${(performance.now() - fetched).toFixed(0)} ms to show`;
      say("");
    } catch (error) {
      if (error.name === "AbortError") continue;
      say(error.message);
    }
    shown = now;
    samples = perPixel;
    Object.assign(document.body.dataset, { shown, samples });
  }
  fetching = false;
}

function draw() {
  if (!stokes) return;
  view.draw(state);
  const sides = [stokes.width, stokes.height];
  showProbe(stokes, ...state.probe.map((part, i) => Math.min(Math.floor(part * sides[i]), sides[i] - 1)));
  markProbe(canvas, ...state.probe);
}

// ---------------------------------------------------------------- changes

function move(changed, dragging) {
  ask(changed, dragging ? "half" : "all");
}

function ask(changed, howMuch) {
  if (Object.keys(changed).length === 0 && detail === howMuch) return;
  detail = howMuch;
  for (const name of ["azimuth", "elevation", "distance"]) if (name in changed) state.moved = true;
  Object.assign(state, changed);
  ++wanted;
  document.body.dataset.wanted = wanted;
  refining?.abort();
  refresh();
}

function change(changed) {
  Object.assign(state, changed);
  state.polarizer = ((state.polarizer % 180) + 180) % 180;
  element("needle").setAttribute("transform", `rotate(${-state.polarizer})`);
  element("dial").setAttribute("aria-valuenow", state.polarizer);
  element("angle").textContent = `${state.polarizer}°`;
  element("wheel").hidden = state.view !== "AoLP";
  for (const button of element("views").querySelectorAll("input")) button.checked = button.value === state.view;
  draw();
}

function probe(x, y) {
  if (!stokes) return;
  state.probe = [(x + 0.5) / stokes.width, (y + 0.5) / stokes.height];
  draw();
}

function nudge(dx, dy) {
  if (!stokes) return;
  const part = (value) => Math.max(0, Math.min(1, value));
  state.probe = [part(state.probe[0] + dx / stokes.width), part(state.probe[1] + dy / stokes.height)];
  draw();
}

function choose(scene) {
  element("scene").selectedIndex = scenes.indexOf(scene);
  element("scenes").dataset.chosen = scene.id;
  for (const button of element("scenes").children) button.setAttribute("aria-pressed", button.title === scene.id);
  const { azimuth, elevation, distance } = scene;
  // The scene's camera may do things that an orbit cannot, such as roll, so it is used until something moves.
  Object.assign(state, { scene, azimuth, elevation, distance, moved: false });
  ask({ nearest: distance / 10, farthest: distance * 10, light: 0, light_tilt: 0 }, "rounded");
  ask({}, "all");
}

// ---------------------------------------------------------------- start

function build() {
  for (const name of VIEWS) {
    const label = document.createElement("label"), button = document.createElement("input");
    Object.assign(button, { type: "radio", name: "view", value: name });
    button.addEventListener("change", () => change({ view: name }));
    label.append(button, ` ${name}`);
    element("views").append(label);
  }
  for (const scene of scenes) element("scene").add(new Option(scene.id));
  element("scene").addEventListener("change", (event) => choose(scenes[event.target.selectedIndex]));
  element("split").addEventListener("change", (event) => change({ split: event.target.checked }));
  element("light").addEventListener("change", (event) => (state.dragLight = event.target.checked));
  element("exposure").addEventListener("input", (event) => change({ exposure: Number(event.target.value) }));
  drawWheel(element("wheel"));
  new ResizeObserver(() => stokes && markProbe(canvas, ...state.probe)).observe(canvas);
  listenToImage(canvas, { state, move, hover: probe });
  listenToDial(element("dial"), { state, change });
  listenToKeys(canvas, { state, move, change, nudge, views: VIEWS, reset: () => choose(state.scene) });
}

async function start() {
  try {
    view = new View(canvas);
    for (;;) {
      const response = await fetch("/scenes");
      if (response.ok) ({ scenes, ...limits } = await response.json());
      if (scenes?.length || limits?.signed) break;
      say("The scenes are still being prepared.");
      await pause(Number(response.headers.get("Retry-After")) || 1);
    }
    if (limits.signed) return say("This service takes signed requests only.");
    build();
    change({});
    choose(scenes[0]);
    addThumbnails(element("scenes"), scenes, choose);
  } catch (error) {
    say(error.message);
  }
}

start();
