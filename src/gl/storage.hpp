// SPDX-License-Identifier: MIT
// Buffers that compute shaders work on, one invocation a vertex.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gl/buffer.hpp"

namespace nicol::gl {

/// Work groups and chunks are whole multiples of so many vertices. A chunk then begins where a buffer of any
/// numbers of vertices can be bound.
inline constexpr std::size_t kGroupOfVertices = 64;

/// Binds two to four floats a vertex from the largest whole group not above `first`; that group's vertex is
/// returned.
[[nodiscard]] inline std::size_t bind_vertices(const Buffer& buffer, unsigned binding, std::size_t floats,
                                               std::size_t first, std::size_t last) {
    const std::size_t begin = first / kGroupOfVertices * kGroupOfVertices;
    const std::size_t bytes = floats * sizeof(float);
    buffer.bind_storage(binding, begin * bytes, (last - begin) * bytes);
    return begin;
}

/// Work groups for so many invocations.
[[nodiscard]] inline unsigned groups_for(std::size_t invocations) {
    return static_cast<unsigned>((invocations + kGroupOfVertices - 1) / kGroupOfVertices);
}

/// A copy for shaders.
template <class Element>
[[nodiscard]] Buffer storage(const std::shared_ptr<Context>& context, const std::vector<Element>& elements) {
    return {context, BufferUse::storage, std::as_bytes(std::span(elements))};
}

/// Makes a buffer for shaders of at least so many bytes, and at least one; the content is unspecified.
inline void make_room(const std::shared_ptr<Context>& context, std::optional<Buffer>& buffer,
                      std::size_t bytes) {
    if (buffer && buffer->size() >= bytes) return;
    buffer.reset();
    buffer.emplace(context, BufferUse::storage, std::max<std::size_t>(bytes, 1), BufferUpdate::fixed);
}

}  // namespace nicol::gl
