// SPDX-License-Identifier: MIT
// A scene to render from its own camera, and what moves in it.
#pragma once

#include <optional>

#include "common/handles.hpp"
#include "options.hpp"
#include "recipe.hpp"
#include "temporary_folder.hpp"

/// A context, and the scene file and light that the command line asks for.
class Workshop {
public:
    explicit Workshop(const Options& options);

    [[nodiscard]] nicol_context context() const { return context_.get(); }
    /// NULL: scenes keep the light of their file.
    [[nodiscard]] nicol_environment light() const { return light_.get(); }
    [[nodiscard]] Scene load() const;
    /// "llvmpipe ..., 2 threads" for the notes of a report.
    [[nodiscard]] std::string machine() const;

private:
    std::optional<TemporaryFolder> folder_;
    Context context_;
    Environment light_;
    std::string path_;
    std::vector<std::string> definitions_;
};

Context make_context(nicol_backend backend, const std::string& cache_folder);

/// Loads it afresh, so that stages share nothing that a render changes.
class Stage {
public:
    explicit Stage(const Workshop& workshop);

    [[nodiscard]] nicol_context context() const { return context_; }
    [[nodiscard]] nicol_scene scene() const { return scene_.get(); }
    /// In place of the light there is; rotated as that is.
    void set_light(Environment light);
    /// Of all instances.
    void set_material(nicol_material material);
    [[nodiscard]] Framebuffer framebuffer(std::uint32_t width, std::uint32_t height) const;
    /// Rotations the camera about the world's vertical axis, further by `degrees`.
    void orbit(double degrees);
    /// False in darkness.
    [[nodiscard]] bool has_light() const { return light_ != nullptr; }
    /// Rotations the light about the world's vertical axis, further by `degrees`.
    void rotate_light(double degrees);
    nicol_statistics render(const nicol_render_options& options, nicol_framebuffer framebuffer) const;

private:
    nicol_context context_;
    Scene scene_;
    Environment light_;
    double light_to_world_[16] = {};
    double light_scale_ = 1;
    nicol_camera camera_ = NICOL_CAMERA_INIT;
};
