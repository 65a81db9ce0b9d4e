// SPDX-License-Identifier: MIT
// An image of Stokes vectors, decoded from stokes.planes: [component][channel][byte][row][column], each 16-bit number
// as its difference to its left neighbour.

const numbers = new Float32Array(65536);
for (let bits = 0; bits < 65536; ++bits) {
  const exponent = (bits >> 10) & 31, fraction = bits & 1023;
  const magnitude = exponent === 0 ? fraction * 2 ** -24
    : exponent === 31 ? (fraction ? NaN : Infinity)
    : (1024 + fraction) * 2 ** (exponent - 25);
  numbers[bits] = bits & 0x8000 ? -magnitude : magnitude;
}

export class Stokes {
  constructor(width, height, components, buffer) {
    const bytes = new Uint8Array(buffer), pixels = width * height;
    this.width = width;
    this.height = height;
    this.channels = bytes.length / (2 * components * pixels);
    // Numbers in half precision, [channel][row][column][4].
    this.halves = new Uint16Array(4 * this.channels * pixels);
    let from = 0;
    for (let component = 0; component < components; ++component)
      for (let channel = 0; channel < this.channels; ++channel, from += pixels) {
        let to = 4 * channel * pixels + component;
        for (let y = 0; y < height; ++y)
          for (let x = 0, value = 0; x < width; ++x, ++from, to += 4) {
            value += bytes[from] | (bytes[from + pixels] << 8);
            this.halves[to] = value;
          }
      }
  }

  // Returns the three planes shown as red, green and blue, as halves.
  colours() {
    const size = 4 * this.width * this.height, last = this.channels - 1;
    return [0, Math.floor(last / 2), last].map((c) => this.halves.subarray(c * size, (c + 1) * size));
  }

  // Returns the mean of the channels at a pixel, counted from the top left.
  at(x, y) {
    const size = 4 * this.width * this.height, place = 4 * (y * this.width + x), sum = [0, 0, 0, 0];
    for (let c = 0; c < this.channels; ++c)
      for (let p = 0; p < 4; ++p) sum[p] += numbers[this.halves[c * size + place + p]] / this.channels;
    return sum;
  }

  // Returns the largest magnitude of each component, or 1 if all values are 0.
  largest() {
    const found = [0, 0, 0, 0];
    for (let i = 0; i < this.halves.length; ++i) {
      const value = Math.abs(numbers[this.halves[i]]);
      if (value > found[i & 3] && value < Infinity) found[i & 3] = value;
    }
    return found.map((value) => value || 1);
  }
}

// Returns the degree and angle (radians from the right, counter-clockwise) of linear polarization, the degree of
// polarization, and the ellipticity angle (above 0: right-handed, seen against the light).
export function polarization([s0, s1, s2, s3]) {
  const polarized = Math.hypot(s1, s2, s3);
  return {
    dolp: s0 > 0 ? Math.min(1, Math.hypot(s1, s2) / s0) : 0,
    aolp: 0.5 * Math.atan2(s2, s1),
    degree: s0 > 0 ? Math.min(1, polarized / s0) : 0,
    ellipticity: polarized > 0 ? 0.5 * Math.asin(Math.max(-1, Math.min(1, s3 / polarized))) : 0,
  };
}
