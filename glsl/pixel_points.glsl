// SPDX-License-Identifier: MIT
// A point of a surface that a pixel shows.

struct PixelPoint {
    uint triangle;
    uint pixel;  // number of the pixel, row by row
    vec2 at;     // position from the pixel's centre, in pixels
};
