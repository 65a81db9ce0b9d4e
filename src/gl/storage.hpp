// SPDX-License-Identifier: MIT
// Buffers of compute shaders with one invocation per vertex and channel.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gl/buffer.hpp"
#include "gl/context.hpp"
#include "gl/draw.hpp"

namespace nicol::gl {

/// Granularity of work groups and chunks, in vertices. A chunk of whole multiples begins at an offset where a
/// buffer with any number of floats per vertex can be bound.
inline constexpr std::size_t kGroupOfVertices = 64;

/// Returns the number of vertices in as many whole groups as hold `vertices`.
[[nodiscard]] inline std::size_t in_whole_groups(std::size_t vertices) {
    return (vertices + kGroupOfVertices - 1) / kGroupOfVertices * kGroupOfVertices;
}

/// Channels of one dispatch, which are its work groups in z.
struct ChannelGroup {
    int first;
    int count;
};

/// Returns how many channels a dispatch takes: as many as fit into one binding and into `room` bytes, at
/// least one. bytes: largest distance between channels in the buffers that are bound.
[[nodiscard]] inline int channels_at_once(const Context& context, int channels, std::size_t bytes,
                                          std::size_t room = std::numeric_limits<std::size_t>::max()) {
    const std::size_t fit = std::min(room, context.limits().storage_bytes) / bytes;
    return static_cast<int>(std::clamp(fit, std::size_t{1}, static_cast<std::size_t>(channels)));
}

/// Calls run(ChannelGroup) for all channels, `most` at once.
template <class Run>
void for_channels(int channels, int most, const Run& run) {
    for (int first = 0; first < channels; first += most)
        run(ChannelGroup{.first = first, .count = std::min(most, channels - first)});
}

/// Calls run(ChannelGroup) for all channels, as many at once as fit into one binding. bytes: as for
/// channels_at_once(). All dispatches may run at the same time.
template <class Run>
void for_independent_channels(Context& context, int channels, std::size_t bytes, const Run& run) {
    const IndependentDispatches all(context);
    for_channels(channels, channels_at_once(context, channels, bytes), run);
}

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
    return static_cast<unsigned>(in_whole_groups(invocations) / kGroupOfVertices);
}

/// Makes a storage buffer with a copy of `elements`.
template <class Element>
[[nodiscard]] Buffer storage(const std::shared_ptr<Context>& context, const std::vector<Element>& elements) {
    return {context, BufferUse::storage, std::as_bytes(std::span(elements))};
}

/// Makes `buffer`, which only this function makes, begin with a copy of `elements`.
template <class Element>
void write(const std::shared_ptr<Context>& context, std::optional<Buffer>& buffer,
           const std::vector<Element>& elements) {
    const auto bytes = std::as_bytes(std::span(elements));
    if (buffer && buffer->size() >= bytes.size()) return buffer->update(0, bytes);
    buffer.reset();
    buffer.emplace(context, BufferUse::storage, bytes, BufferUpdate::dynamic);
}

/// Numbers of channels in one buffer, where each channel begins at an offset that can be bound. A single
/// channel serves all.
class ChannelStorage {
public:
    /// numbers: by channel, equally many.
    ChannelStorage(const std::shared_ptr<Context>& context, const std::vector<std::vector<float>>& numbers)
        : step_(numbers.size() == 1 ? 0 : in_whole_groups(numbers.front().size())),
          buffer_(storage(context, joined(numbers, step_))) {}

    /// Returns the distance between channels, in numbers and in bytes; 0: there is one for all.
    [[nodiscard]] std::size_t step() const noexcept { return step_; }
    [[nodiscard]] std::size_t bytes() const noexcept { return step_ * sizeof(float); }

    void bind(unsigned binding, ChannelGroup channels) const {
        if (step_ == 0) return buffer_.bind_storage(binding);
        buffer_.bind_storage(binding, static_cast<std::size_t>(channels.first) * bytes(),
                             static_cast<std::size_t>(channels.count) * bytes());
    }

private:
    static std::vector<float> joined(const std::vector<std::vector<float>>& numbers, std::size_t step) {
        std::vector<float> all;
        for (const std::vector<float>& channel : numbers) {
            const std::size_t end = all.size() + std::max(step, channel.size());
            all.insert(all.end(), channel.begin(), channel.end());
            all.resize(end);
        }
        return all;
    }

    std::size_t step_;
    Buffer buffer_;
};

/// Ensures a storage buffer of at least `bytes` bytes, and at least one byte; the content is unspecified.
inline void make_room(const std::shared_ptr<Context>& context, std::optional<Buffer>& buffer,
                      std::size_t bytes) {
    if (buffer && buffer->size() >= bytes) return;
    buffer.reset();
    buffer.emplace(context, BufferUse::storage, std::max<std::size_t>(bytes, 1), BufferUpdate::fixed);
}

}  // namespace nicol::gl
