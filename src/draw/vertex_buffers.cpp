// SPDX-License-Identifier: MIT
#include "draw/vertex_buffers.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace nicol {

void VertexBuffers::update(const WorldGeometry& geometry, Version geometry_version, int channels) {
    sizing_.run(geometry_version, channels, [&] {
        version_ = new_version();
        stokes_.clear();
        placing_.run(geometry_version, [&] {
            indices_.reset();
            positions_.reset();
            normals_.reset();
            fractions_.reset();
            if (geometry.triangles.empty()) return;
            positions_ = std::make_shared<gl::Buffer>(context_, gl::BufferUse::vertex,
                                                      std::as_bytes(std::span(geometry.positions)));
            std::vector<glm::uvec3> room;
            const std::span triangles = shown_triangles(geometry, room);
            indices_ = std::make_shared<gl::IndexBuffer>(
                context_, std::span(&triangles.front().x, 3 * triangles.size()));
        });
        for (int c = 0; !empty() && c < channels; ++c) {
            stokes_.push_back(std::make_shared<gl::Buffer>(context_, gl::BufferUse::vertex,
                                                           geometry.positions.size() * sizeof(glm::vec4),
                                                           gl::BufferUpdate::dynamic));
        }
    });
}

void VertexBuffers::upload(const VertexStokes& stokes) {
    for (std::size_t c = 0; c < stokes_.size(); ++c) {
        stokes_[c]->update(0, std::as_bytes(std::span(stokes[c])));
    }
}

const std::shared_ptr<const gl::Buffer>& VertexBuffers::normals(const WorldGeometry& geometry) {
    if (!normals_) {
        normals_ = std::make_shared<gl::Buffer>(context_, gl::BufferUse::vertex,
                                                std::as_bytes(std::span(geometry.normals)));
    }
    return normals_;
}

const std::shared_ptr<gl::Buffer>& VertexBuffers::fractions() {
    if (!fractions_) {
        const std::size_t vertices = positions_->size() / sizeof(glm::vec3);
        fractions_ = std::make_shared<gl::Buffer>(context_, gl::BufferUse::vertex,
                                                  vertices * sizeof(glm::vec2), gl::BufferUpdate::dynamic);
    }
    return fractions_;
}

void set_view_uniforms(gl::Program& program, const Viewpoint& view) {
    const auto set = [&](const char* name, const auto& value) {
        if (program.uses(name)) program.set(name, value);
    };
    const glm::vec3 eye(view.eye);
    set("eye", eye);
    set("eye_rest", glm::vec3(view.eye - glm::dvec3(eye)));
    set("forward", glm::vec3(view.forward));
    set("up", glm::vec3(view.up));
    set("right", glm::vec3(view.right));
    set("orthographic", view.orthographic ? 1 : 0);
}

}  // namespace nicol
