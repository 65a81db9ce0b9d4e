// SPDX-License-Identifier: MIT
// Numbers and polarization ellipse of one pixel.
import { polarization } from "/stokes.js";

const element = (id) => document.getElementById(id);
const degrees = (radians) => (radians * 180) / Math.PI;

function ellipsePath({ aolp, degree, ellipticity }) {
  if (degree === 0) return "";
  const a = 50 * degree * Math.cos(ellipticity), b = 50 * degree * Math.sin(ellipticity);
  const points = [];
  for (let i = 0; i <= 48; ++i) {
    const phase = (2 * Math.PI * i) / 48, x = a * Math.cos(phase), y = b * Math.sin(phase);
    const c = Math.cos(aolp), s = Math.sin(aolp);
    // SVG's y points down.
    points.push(`${(c * x - s * y).toFixed(2)} ${(-s * x - c * y).toFixed(2)}`);
  }
  return `M${points.join("L")}`;
}

// Puts the crosshair on a place of the image, given in parts of its width and height.
export function markProbe(canvas, x, y) {
  const fit = Math.min(canvas.clientWidth / canvas.width, canvas.clientHeight / canvas.height);
  const place = (start, room, side, part) => `${start + (room - side * fit) / 2 + part * side * fit}px`;
  Object.assign(element("cross").style, {
    left: place(canvas.offsetLeft, canvas.clientWidth, canvas.width, x),
    top: place(canvas.offsetTop, canvas.clientHeight, canvas.height, y),
    visibility: "visible",
  });
}

export function showProbe(stokes, x, y) {
  const vector = stokes.at(x, y), state = polarization(vector);
  element("pixel").textContent = `${x}, ${y}`;
  vector.forEach((value, i) => (element(`s${i}`).textContent = value.toPrecision(4)));
  element("dolp").textContent = `${(100 * state.dolp).toFixed(1)} %`;
  const hand = Math.abs(state.ellipticity) < 0.01 ? "" : state.ellipticity > 0 ? ", right-handed" : ", left-handed";
  element("aolp").textContent = `${degrees(state.aolp).toFixed(1)}°${hand}`;
  element("path").setAttribute("d", ellipsePath(state));
}
