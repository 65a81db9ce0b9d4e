// SPDX-License-Identifier: MIT
// A ball under a clear sky behind a polarizer, drawn into a texture of the application.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/handles.hpp"

class Polarized {
public:
    static constexpr int kSize = 256;

    /// Requires the application's context to be current, as every call does. time_budget: of a frame, in
    /// milliseconds, as time_budget_ms of the render options.
    explicit Polarized(double time_budget);

    /// Renders with the sun at this azimuth in degrees, with twice as many samples per pixel as the last time
    /// if the sun is where it was, and draws the light behind a polarizer at this angle
    /// in degrees into the texture: RGBA8, row 0 at the bottom, as in OpenGL. If `depth` is not 0, the ball
    /// and what the application draws with this depth texture and this near plane hide each other.
    void draw(double sun, double polarizer, unsigned texture, unsigned depth = 0, float depth_near = 0);
    /// Returns [channel][row][column][4], the top row first.
    [[nodiscard]] std::vector<float> planes() const;

private:
    Context context_;
    Environment sky_;
    Scene scene_;
    Framebuffer framebuffer_;
    double time_budget_;
    double sun_ = 0;
    std::uint32_t samples_ = 0;  // per pixel, of the last image; 0: there is none
    nicol_camera camera_ = NICOL_CAMERA_INIT;
};
