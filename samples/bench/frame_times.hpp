// SPDX-License-Identifier: MIT
// Times of frames, with alternating contestants.
#pragma once

#include <vector>

#include "stage.hpp"

/// Median milliseconds. A frame is the whole call of nicol_render.
struct FrameTimes {
    double camera = 0;  ///< frame after a move of the camera
    double light = 0;   ///< frame after the light rotated; NaN in darkness
    double still = 0;   ///< frame after no change at all
    double camera_shade = 0, camera_draw = 0;
    double light_relight = 0, light_shade = 0, light_draw = 0;
    double transfer_mb = 0;  ///< kept of vertices, shadows included, and of pixels that are shaded
};

/// Replacement of a scene's light and material.
enum class SceneVariant {
    original,     ///< the scene as it is
    polarized,    ///< rough plastic under a polarized sky, which needs all Stokes components
    unpolarized,  ///< diffuse surfaces of the same colour under the same sky, unpolarized
};

/// One way to render, with a scene of its own.
class Contestant {
public:
    Contestant(const SceneSource& source, const Recipe& recipe, std::uint32_t size,
               SceneVariant variant = SceneVariant::original);

    /// Of all instances.
    void set_material(nicol_material material) { stage_.set_material(material); }
    [[nodiscard]] const Recipe& recipe() const { return recipe_; }
    [[nodiscard]] const Stage& stage() const { return stage_; }
    /// Camera, light, nothing.
    void run_round();
    [[nodiscard]] FrameTimes medians() const;

private:
    struct Frame {
        double milliseconds;
        nicol_statistics statistics;
    };
    Frame frame();

    Stage stage_;
    Recipe recipe_;
    Framebuffer framebuffer_;
    std::vector<Frame> camera_, light_, still_;
};

/// Rounds until `seconds` a contestant have passed, at least five; one round before them is not counted.
std::vector<FrameTimes> time_frames(std::vector<Contestant>& contestants, double seconds);

/// The same triangles into the same attachments, in one colour: light of order 0. The floor is its median
/// camera_draw.
Recipe floor_recipe();
