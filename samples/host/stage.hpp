// SPDX-License-Identifier: MIT
// Drawing by the application: a few triangles, and a textured quad.
#pragma once

#include "gl.hpp"

/// Drawing that leaves its program, arrays, scissor and blending set between frames, as applications do.
class Stage {
public:
    static constexpr int kWidth = 640, kHeight = 360;
    static constexpr int kQuadX = 352, kQuadY = 52, kQuadSize = 256;  ///< pixels, while it faces the viewer

    explicit Stage(const Gl& gl);

    /// Returns the texture on the quad, RGBA8.
    [[nodiscard]] GLuint image() const { return image_; }
    void draw_triangles(double angle) const;
    /// Draws the quad at an angle in degrees about the vertical axis.
    void draw_quad(double angle) const;

private:
    const Gl& gl_;
    GLuint triangles_ = 0, quad_ = 0, triangle_vertices_ = 0, quad_vertices_ = 0, image_ = 0;
};
