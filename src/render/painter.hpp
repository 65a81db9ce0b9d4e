// SPDX-License-Identifier: MIT
// draw: shaded vertices and the environment into a framebuffer.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "gl/draw.hpp"
#include "nicol/scene.hpp"
#include "render/framebuffer.hpp"
#include "render/projection.hpp"
#include "render/vertex_buffers.hpp"

namespace nicol {

/// Keeps a scene's environment's pictures and the programs on the device.
class Painter {
public:
    explicit Painter(std::shared_ptr<gl::Context> context);

    /// one_sided: how many of the triangles are. Everything that can fail for want of memory happens before
    /// the framebuffer is touched.
    void draw(const Scene& scene, const VertexBuffers& buffers, std::size_t one_sided,
              const Projection& projection, Framebuffer& target);

private:
    // Channels that are drawn at once.
    struct Group {
        std::optional<gl::VertexArray> vertices;
        std::vector<gl::Texture2D> environment;  // one of all s0, or one Stokes texture a channel
    };

    gl::Program& program(const char* vertex, const char* fragment, int channels, bool polarized);
    void bind_vertices(const VertexBuffers& buffers, int channels);
    void upload_environment(const Environment* environment, int channels);
    void draw_background(const Scene& scene, const Projection& projection, Framebuffer& target);

    std::shared_ptr<gl::Context> context_;
    std::map<std::tuple<std::string, int, bool>, gl::Program> programs_;
    std::vector<Group> groups_;
    std::uint64_t buffers_revision_ = 0;
    int channels_ = 0;
    EnvironmentPtr environment_;  // that the textures show
};

}  // namespace nicol
