// SPDX-License-Identifier: MIT
// A point of a surface that a pixel shows.

struct PixelPoint {
    uint triangle;
    uint pixel;  // number of the pixel, row by row
    vec2 at;     // position from the pixel's centre, in pixels
};

// Returns a point's place in three indices of vertices for each triangle. Points between the runs of a list
// may have any triangle.
uint first_corner(PixelPoint point, int corners) {
    return min(3u * point.triangle, uint(corners) - 3u);
}
