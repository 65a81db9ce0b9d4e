// SPDX-License-Identifier: MIT
// Times of frames, with alternating contestants.
#pragma once

#include <vector>

#include "stage.hpp"

/// Median times in milliseconds. A frame is the whole call of nicol_render.
struct FrameTimes {
    double camera = 0;  ///< frame after a move of the camera
    double light = 0;   ///< frame after a rotation of the light; NaN in darkness
    double still = 0;   ///< frame after no change
    double camera_shade = 0, camera_draw = 0;
    double light_relight = 0, light_shade = 0, light_draw = 0;
    double transfer_mb = 0;  ///< memory of vertices, with shadows, and of shaded pixels

    /// Returns the milliseconds of relight and shade after a rotation of the light.
    [[nodiscard]] double light_transfer() const { return light_relight + light_shade; }
};

/// Replacement of a scene's light and material.
enum class SceneVariant {
    original,         ///< the unchanged scene
    polarized,        ///< rough plastic under a polarized sky, which needs all Stokes components
    unpolarized_sky,  ///< rough plastic under the same sky, unpolarized
    unpolarized,      ///< diffuse surfaces of the same colour under the same sky, unpolarized
};

/// One way to render, with a separate scene.
class Contestant {
public:
    Contestant(const SceneSource& source, const Recipe& recipe, std::uint32_t size,
               SceneVariant variant = SceneVariant::original);

    /// Replaces the material of all instances.
    void set_material(nicol_material material) { stage_.set_material(material); }
    [[nodiscard]] const Recipe& recipe() const { return recipe_; }
    [[nodiscard]] const Stage& stage() const { return stage_; }
    /// Moves the camera until its frames bake nothing that former ones did not show.
    void show_all();
    /// Renders three frames: after a move of the camera, after a rotation of the light, and after no change.
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

/// Runs rounds until `seconds` per contestant have passed, at least five, after one uncounted round.
std::vector<FrameTimes> time_frames(std::vector<Contestant>& contestants, double seconds);

/// Returns options that draw the triangles into the same attachments in one colour: light of order 0. The
/// floor is the median of camera_draw.
Recipe floor_recipe();
