// SPDX-License-Identifier: MIT
// Two rings about the ball, drawn by the application into the image with the ball, with a shared depth
// buffer.
#pragma once

#include "gl.hpp"

class Rings {
public:
    static constexpr float kNear = 0.1F;  ///< near plane of the rings' projection, which has no far plane

    /// Draws into `image`, an RGBA8 texture of size x size pixels.
    Rings(const Gl& gl, GLuint image, int size);

    /// Returns the depth texture, whose row 0 is at the bottom.
    [[nodiscard]] GLuint depth() const { return depth_; }
    /// Clears the image and its depth.
    void clear() const;
    /// Draws one of the rings at an angle in degrees.
    void draw(int ring, double angle) const;

private:
    void enter() const;
    void leave() const;

    const Gl& gl_;
    int size_;
    GLuint program_ = 0, vertices_ = 0, depth_ = 0, framebuffer_ = 0;
};
