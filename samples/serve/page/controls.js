// SPDX-License-Identifier: MIT
// Actions of the pointer and the keys. Each calls change() with the differences, or move() for the camera and light.

const clamp = (value, least, most) => Math.max(least, Math.min(most, value));
// Wraps an angle into -180 to 180, so that it never exceeds limits of the service.
const rotated = (angle) => ((((angle + 180) % 360) + 360) % 360) - 180;

export function orbit(state, dx, dy) {
  return { azimuth: rotated(state.azimuth + dx), elevation: clamp(state.elevation + dy, -89, 89) };
}
export function rotateLight(state, dx, dy) {
  return { light: rotated(state.light + dx), light_tilt: clamp(state.light_tilt + dy, -180, 180) };
}
export function zoom(state, factor) {
  return { distance: clamp(state.distance * factor, state.nearest, state.farthest) };
}

// Handles drags on the image; `hover` gets pixel coordinates.
export function listenToImage(canvas, { state, move, hover }) {
  const fingers = new Map();
  let spread = 0;
  const pixel = (event) => {
    const box = canvas.getBoundingClientRect(), fit = Math.min(box.width / canvas.width, box.height / canvas.height);
    const x = (event.clientX - box.left - (box.width - canvas.width * fit) / 2) / fit;
    const y = (event.clientY - box.top - (box.height - canvas.height * fit) / 2) / fit;
    return [clamp(Math.floor(x), 0, canvas.width - 1), clamp(Math.floor(y), 0, canvas.height - 1)];
  };
  const distance = () => {
    const [a, b] = [...fingers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (fingers.size === 2) spread = distance();
    hover(...pixel(event));
  });
  canvas.addEventListener("pointermove", (event) => {
    const last = fingers.get(event.pointerId);
    if (!last) return hover(...pixel(event));
    const dx = (event.clientX - last.x) / fingers.size, dy = (event.clientY - last.y) / fingers.size;
    last.x = event.clientX;
    last.y = event.clientY;
    const light = event.shiftKey || fingers.size > 1 || state.dragLight;
    move(light ? rotateLight(state, dx / 2, dy / 2) : orbit(state, dx / -2, dy / 2), true);
    if (fingers.size === 2) {
      move(zoom(state, spread / distance()), true);
      spread = distance();
    }
  });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, (event) => {
      fingers.delete(event.pointerId);
      if (fingers.size === 0) move({}, false);
    });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    move(zoom(state, 1.0015 ** event.deltaY), false);
  }, { passive: false });
}

export function listenToDial(dial, { state, change }) {
  const rotate = (event) => {
    const box = dial.getBoundingClientRect();
    const y = box.top + box.height / 2 - event.clientY, x = event.clientX - box.left - box.width / 2;
    change({ polarizer: Math.round((Math.atan2(y, x) * 180) / Math.PI) });
  };
  dial.addEventListener("pointerdown", (event) => {
    dial.setPointerCapture(event.pointerId);
    rotate(event);
  });
  dial.addEventListener("pointermove", (event) => event.buttons && rotate(event));
  dial.addEventListener("keydown", (event) => {
    const step = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[event.key];
    if (!step && event.key !== "Home") return;
    event.preventDefault();
    event.stopPropagation();
    change({ polarizer: step ? state.polarizer + step : 0 });
  });
}

export function listenToKeys(canvas, { state, move, change, nudge, views, reset }) {
  canvas.addEventListener("keydown", (event) => {
    const arrow = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5] }[event.key];
    if (!arrow) return;
    event.preventDefault();
    const [dx, dy] = arrow;
    move(event.shiftKey ? rotateLight(state, dx, dy) : orbit(state, dx, dy), false);
  });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("select")) return;
    const probe = { i: [0, -1], k: [0, 1], j: [-1, 0], l: [1, 0] }[event.key.toLowerCase()];
    if (probe) nudge(...probe.map((step) => step * (event.shiftKey ? 10 : 1)));
    else if (event.key === "+" || event.key === "=") move(zoom(state, 0.9), false);
    else if (event.key === "-") move(zoom(state, 1 / 0.9), false);
    else if (event.key === "[" || event.key === "]") change({ polarizer: state.polarizer + (event.key === "[" ? -5 : 5) });
    else if (event.key === "0") reset();
    else if (views[event.key - 1]) change({ view: views[event.key - 1] });
  });
}
