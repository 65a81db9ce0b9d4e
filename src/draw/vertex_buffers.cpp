// SPDX-License-Identifier: MIT
#include "draw/vertex_buffers.hpp"

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

#include "error.hpp"
#include "gl/context.hpp"
#include "gl/storage.hpp"
#include "surfaces/tangents.hpp"

namespace nicol {

void CornerBuffers::update(const WorldGeometry& geometry, Version geometry_version,
                           Version material_version) {
    copying_.run(geometry_version, material_version, [&] {
        buffer_.reset();
        colored_ = !geometry.colors.empty();
        with_tangents_ = !geometry.tangents.empty();
        const auto of_triangle = static_cast<std::size_t>(numbers());
        const std::size_t most = context_->limits().storage_bytes / sizeof(float) / of_triangle;
        if (geometry.triangles.size() > most)
            throw Error(ErrorCode::unsupported,
                        "shaders of " + context_->info().renderer + " texture at most " +
                            std::to_string(most) + " triangles, and the scene has " +
                            std::to_string(geometry.triangles.size()) + "; use fewer");
        std::vector<float> all;
        all.reserve(of_triangle * geometry.triangles.size());
        for (std::size_t t = 0; t < geometry.triangles.size(); ++t) {
            std::array<glm::vec2, 3> texcoords{};
            if (!geometry.texcoords.empty()) texcoords = geometry.texcoords[t];
            for (const glm::vec2& uv : texcoords) all.insert(all.end(), {uv.x, uv.y});
            const TextureAxes axes = texture_axes(geometry, static_cast<std::uint32_t>(t));
            for (const glm::vec3& axis : {axes.by_u, axes.by_v})
                all.insert(all.end(), {axis.x, axis.y, axis.z});
            if (with_tangents_)
                for (const glm::vec4& tangent : geometry.tangents[t])
                    all.insert(all.end(), {tangent.x, tangent.y, tangent.z, tangent.w});
            if (!colored_) continue;
            for (const glm::vec3& color : geometry.colors[t])
                all.insert(all.end(), {color.x, color.y, color.z});
        }
        if (!all.empty()) buffer_.emplace(gl::storage(context_, all));
    });
}

void VertexBuffers::update(const WorldGeometry& geometry, Version geometry_version, int channels) {
    sizing_.run(geometry_version, channels, [&] {
        version_ = new_version();
        stokes_.reset();
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
        if (!empty())
            stokes_.emplace(context_, gl::BufferUse::vertex, gl::BufferUpdate::dynamic,
                            geometry.positions.size(), channels);
    });
}

void VertexBuffers::upload(const VertexStokes& stokes) {
    for (int c = 0; stokes_ && c < stokes_->channels(); ++c) {
        const std::span<const glm::vec4> channel(stokes[static_cast<std::size_t>(c)]);
        stokes_->buffer()->update(stokes_->offset(c), std::as_bytes(channel));
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
