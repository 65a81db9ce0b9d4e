// SPDX-License-Identifier: MIT
// A loaded and baked scene that has been rendered at least once.
#pragma once

#include <filesystem>
#include <string>

#include "common/failure.hpp"
#include "common/handles.hpp"
#include "image_request.hpp"
#include "message.hpp"
#include "upload.hpp"

/// Callback asked about ten times a second whether to continue; 0 ends the render.
struct Progress {
    nicol_progress_callback callback = nullptr;
    void* user = nullptr;
};

class Stage {
public:
    /// Loads and renders a scene, which bakes it or reads the bake from the cache. An upload reads only its
    /// own files. Both throw Failure.
    Stage(nicol_context context, const std::filesystem::path& path);
    Stage(nicol_context context, const Upload& upload);

    [[nodiscard]] const SceneInfo& info() const { return info_; }

    /// Returns the answer's content and fills in the head except its status. Throws nicol::Error or Failure.
    std::string render(const ImageRequest& request, const Progress& progress, ResultHead& head);

private:
    void prepare(nicol_scene scene);
    void draw(const View& view, const Progress& progress, ResultHead& head);
    void make_framebuffer(std::uint32_t width, std::uint32_t height);
    [[nodiscard]] double centre_depth() const;
    [[nodiscard]] std::string encode(const ImageRequest& request, ResultHead& head) const;
    [[nodiscard]] std::string stokes(bool half) const;

    nicol_context context_;
    Scene scene_;
    SceneInfo info_;
    nicol_camera camera_ = NICOL_CAMERA_INIT;
    Environment environment_;
    double light_to_world_[16] = {};
    double light_scale_ = 1;
    Framebuffer framebuffer_;
    std::uint32_t width_ = 0, height_ = 0;
    double light_ = 0, light_tilt_ = 0;  ///< present rotation
    bool has_view_ = false;
    View view_;  ///< view in the framebuffer
};
