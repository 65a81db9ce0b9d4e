// SPDX-License-Identifier: MIT
// A scene rendered from its camera, with rotations of the camera and of the light.
#pragma once

#include <optional>
#include <utility>

#include "common/handles.hpp"
#include "options.hpp"
#include "recipe.hpp"
#include "temporary_folder.hpp"

/// A context, and the scene file and light of the command line.
class SceneSource {
public:
    explicit SceneSource(const Options& options);

    [[nodiscard]] nicol_context context() const { return context_.get(); }
    /// Returns the replaced light, or NULL if scenes keep their light.
    [[nodiscard]] nicol_environment light() const { return light_.get(); }
    [[nodiscard]] Scene load() const;
    /// Sets the material of all instances in scenes loaded from now on.
    void set_material(Material material) { material_ = std::move(material); }
    /// Returns a text for the notes of a report, such as "llvmpipe ..., 2 threads".
    [[nodiscard]] std::string machine() const;

private:
    std::optional<TemporaryFolder> folder_;
    Context context_;
    Environment light_;
    Material material_;
    std::string path_;
    std::vector<std::string> definitions_;
};

Context make_context(nicol_backend backend, const std::string& cache_folder);

/// A separate scene: stages share nothing that rendering changes.
class Stage {
public:
    explicit Stage(const SceneSource& source);

    [[nodiscard]] nicol_context context() const { return context_; }
    [[nodiscard]] nicol_scene scene() const { return scene_.get(); }
    /// Replaces the light and keeps its rotation.
    void set_light(Environment light);
    /// Sets the material of all instances.
    void set_material(nicol_material material);
    [[nodiscard]] Framebuffer framebuffer(std::uint32_t width, std::uint32_t height) const;
    /// Rotates the camera about the world's vertical axis by `degrees` more.
    void orbit(double degrees);
    /// Jitters the camera by an offset in pixels.
    void jitter(double right, double down);
    /// Returns false in darkness.
    [[nodiscard]] bool has_light() const { return light_ != nullptr; }
    /// Rotates the light about the world's vertical axis by `degrees` more.
    void rotate_light(double degrees);
    nicol_statistics render(const nicol_render_options& options, nicol_framebuffer framebuffer) const;
    void adjoint(const nicol_render_options& options, const nicol_stokes_image& picture,
                 const nicol_gradient& gradient) const;

private:
    nicol_context context_;
    Scene scene_;
    Environment light_;
    double light_to_world_[16] = {};
    double light_scale_ = 1;
    nicol_camera camera_ = NICOL_CAMERA_INIT;
};
