// SPDX-License-Identifier: MIT
// What the application draws itself: a few triangles, and a quad with an image on it.
#pragma once

#include "gl.hpp"

/// Leaves its program, arrays, scissor and blending in place between frames, as applications do.
class Stage {
public:
    static constexpr int width = 640, height = 360;
    static constexpr int quad_x = 352, quad_y = 52, quad_size = 256;  ///< pixels, while it faces the viewer

    explicit Stage(const Gl& gl);

    /// The texture on the quad, RGBA8.
    [[nodiscard]] GLuint image() const { return image_; }
    void draw_triangles(double turn) const;
    /// turn: degrees about the vertical axis.
    void draw_quad(double turn) const;

private:
    const Gl& gl_;
    GLuint triangles_ = 0, quad_ = 0, triangle_vertices_ = 0, quad_vertices_ = 0, image_ = 0;
};
