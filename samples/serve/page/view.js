// SPDX-License-Identifier: MIT
// Drawing of a Stokes image for an observer. Rotating the polarizer draws again without fetching.

export const VIEWS = ["polarizer", "s0", "s1", "s2", "s3", "DoLP", "AoLP"];

const vertex = `#version 300 es
void main() {
  gl_Position = vec4(float(gl_VertexID / 2 * 4) - 1.0, float(gl_VertexID % 2 * 4) - 1.0, 0.0, 1.0);
}`;

const fragment = `#version 300 es
precision highp float;
uniform highp sampler2D red, green, blue;
uniform vec2 size;
uniform vec4 scale;
uniform float angle, exposure;
uniform int view;
uniform bool halved;
out vec4 colour;

vec3 srgb(vec3 v) {
  v = clamp(v, 0.0, 1.0);
  return mix(12.92 * v, 1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, v));
}
vec3 hue(float angle) {
  return clamp(abs(fract(angle + vec3(0.0, 2.0, 1.0) / 3.0) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
}
void main() {
  vec2 place = vec2(gl_FragCoord.x, size.y - gl_FragCoord.y) / size;
  mat3x4 s = mat3x4(texture(red, place), texture(green, place), texture(blue, place));
  vec4 mean = (s[0] + s[1] + s[2]) / 3.0;
  float degree = mean.x > 0.0 ? min(1.0, length(mean.yz) / mean.x) : 0.0;
  int shown = halved && place.x < 0.5 ? 1 : view;
  vec3 result;
  if (shown == 0)
    result = srgb(exposure * 0.5 * (vec4(1.0, cos(2.0 * angle), sin(2.0 * angle), 0.0) * s));
  else if (shown == 1)
    result = srgb(exposure * (vec4(1.0, 0.0, 0.0, 0.0) * s));
  else if (shown < 5) {
    float value = mean[shown - 1] / scale[shown - 1];
    result = vec3(max(-value, 0.0), max(value, 0.0), 0.0);
  } else if (shown == 5)
    result = srgb(vec3(degree));
  else
    result = srgb(vec3(degree)) * hue(0.5 * atan(mean.z, mean.y) / 3.14159265);
  if (halved && abs(gl_FragCoord.x - 0.5 * size.x) < 1.0) result = vec3(0.6, 0.8, 1.0);
  colour = vec4(result, 1.0);
}`;

export class View {
  constructor(canvas) {
    this.canvas = canvas;
    const gl = canvas.getContext("webgl2", { antialias: false, preserveDrawingBuffer: true });
    if (!gl) throw new Error("This page needs WebGL 2.");
    this.gl = gl;
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    this.at = (name) => gl.getUniformLocation(program, name);
    gl.bindVertexArray(gl.createVertexArray());
    ["red", "green", "blue"].forEach((name, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
      for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
      for (const way of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, way, gl.NEAREST);
      gl.uniform1i(this.at(name), unit);
    });
  }

  show(stokes) {
    const gl = this.gl;
    this.canvas.width = stokes.width;
    this.canvas.height = stokes.height;
    stokes.colours().forEach((plane, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA16F, stokes.width, stokes.height, 0, gl.RGBA, gl.HALF_FLOAT, plane);
    });
    gl.uniform4fv(this.at("scale"), stokes.largest());
  }

  draw({ view, polarizer, exposure, split }) {
    const gl = this.gl;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.uniform2f(this.at("size"), this.canvas.width, this.canvas.height);
    gl.uniform1f(this.at("angle"), (polarizer * Math.PI) / 180);
    gl.uniform1f(this.at("exposure"), 2 ** exposure);
    gl.uniform1i(this.at("view"), VIEWS.indexOf(view));
    gl.uniform1i(this.at("halved"), split ? 1 : 0);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}

// Draws the colours of AoLP as a half wheel twice, because angles and angles + 180 degrees are equivalent.
export function drawWheel(canvas) {
  const context = canvas.getContext("2d"), side = canvas.width, image = context.createImageData(side, side);
  for (let y = 0; y < side; ++y)
    for (let x = 0; x < side; ++x) {
      const dx = x + 0.5 - side / 2, dy = side / 2 - y - 0.5, radius = Math.hypot(dx, dy) / (side / 2);
      if (radius > 1) continue;
      const angle = (Math.atan2(dy, dx) / Math.PI + 2) % 1;
      [0, 2, 1].forEach((shift, i) => {
        const part = (angle + shift / 3) % 1;
        image.data[4 * (y * side + x) + i] = 255 * radius * Math.max(0, Math.min(1, Math.abs(part * 6 - 3) - 1));
      });
      image.data[4 * (y * side + x) + 3] = 255;
    }
  context.putImageData(image, 0, 0);
}
