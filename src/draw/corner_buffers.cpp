// SPDX-License-Identifier: MIT
#include "draw/corner_buffers.hpp"

#include <array>
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

}  // namespace nicol
