// SPDX-License-Identifier: MIT
// A ball under a clear sky, seen through a polarizer, in a texture of the application's.
#pragma once

#include <string>
#include <vector>

#include "common/handles.hpp"

class Polarized {
public:
    static constexpr int size = 256;

    /// With the application's context current, which must stay so in every call.
    Polarized();

    /// Renders with the sun at this azimuth in degrees, and draws what a polarizer at this angle passes into
    /// the texture: RGBA8, row 0 at the bottom as OpenGL's own images.
    void draw(double sun, double polarizer, unsigned texture);
    /// [channel][row][column][4], the top row first.
    [[nodiscard]] std::vector<float> planes() const;

private:
    Context context_;
    Environment sky_;
    Scene scene_;
    Framebuffer framebuffer_;
    nicol_camera camera_ = NICOL_CAMERA_INIT;
};
