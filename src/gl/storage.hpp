// SPDX-License-Identifier: MIT
// Buffers of compute shaders with one invocation per vertex.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gl/buffer.hpp"

namespace nicol::gl {

/// Granularity of work groups and chunks, in vertices. A chunk of whole multiples begins at an offset where a
/// buffer with any number of floats per vertex can be bound.
inline constexpr std::size_t kGroupOfVertices = 64;

/// Binds two to four floats per vertex from the largest whole group not above `first`; returns the first
/// vertex of that group.
[[nodiscard]] inline std::size_t bind_vertices(const Buffer& buffer, unsigned binding, std::size_t floats,
                                               std::size_t first, std::size_t last) {
    const std::size_t begin = first / kGroupOfVertices * kGroupOfVertices;
    const std::size_t bytes = floats * sizeof(float);
    buffer.bind_storage(binding, begin * bytes, (last - begin) * bytes);
    return begin;
}

/// Returns the number of work groups for a number of invocations.
[[nodiscard]] inline unsigned groups_for(std::size_t invocations) {
    return static_cast<unsigned>((invocations + kGroupOfVertices - 1) / kGroupOfVertices);
}

/// Makes a storage buffer with a copy of `elements`.
template <class Element>
[[nodiscard]] Buffer storage(const std::shared_ptr<Context>& context, const std::vector<Element>& elements) {
    return {context, BufferUse::storage, std::as_bytes(std::span(elements))};
}

/// Ensures a storage buffer of at least `bytes` bytes, and at least one byte; the content is unspecified.
inline void make_room(const std::shared_ptr<Context>& context, std::optional<Buffer>& buffer,
                      std::size_t bytes) {
    if (buffer && buffer->size() >= bytes) return;
    buffer.reset();
    buffer.emplace(context, BufferUse::storage, std::max<std::size_t>(bytes, 1), BufferUpdate::fixed);
}

}  // namespace nicol::gl
