// SPDX-License-Identifier: MIT
// Stokes vectors of points on the device.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>

#include "gl/buffer.hpp"
#include "gl/storage.hpp"

namespace nicol {

/// Stokes vectors of points in all channels, one vec4 each: [channel][point]. All members must be called
/// inside run() of the context.
class StokesBuffer {
public:
    StokesBuffer(const std::shared_ptr<gl::Context>& context, gl::BufferUse use, gl::BufferUpdate update,
                 std::size_t points, int channels)
        : step_(gl::in_whole_groups(std::max<std::size_t>(points, 1))),
          channels_(channels),
          buffer_(std::make_shared<gl::Buffer>(
              context, use, static_cast<std::size_t>(channels) * step_ * kBytes, update)) {}

    /// Returns the number of vectors from a channel to the next, at least the number of points.
    [[nodiscard]] std::size_t step() const noexcept { return step_; }
    [[nodiscard]] int channels() const noexcept { return channels_; }
    /// Returns the distance between channels, in bytes.
    [[nodiscard]] std::size_t channel_bytes() const noexcept { return step_ * kBytes; }
    [[nodiscard]] std::size_t offset(int channel) const noexcept {
        return static_cast<std::size_t>(channel) * channel_bytes();
    }
    [[nodiscard]] const std::shared_ptr<gl::Buffer>& buffer() const noexcept { return buffer_; }

    /// Binds some channels from the largest whole group of points not above `first` to point `last` of the
    /// last channel; returns the first point of that group.
    [[nodiscard]] std::size_t bind(unsigned binding, gl::ChannelGroup channels, std::size_t first,
                                   std::size_t last) const {
        const std::size_t begin = first / gl::kGroupOfVertices * gl::kGroupOfVertices;
        buffer_->bind_storage(binding, offset(channels.first) + begin * kBytes,
                              offset(channels.count - 1) + (last - begin) * kBytes);
        return begin;
    }

private:
    static constexpr std::size_t kBytes = 4 * sizeof(float);

    std::size_t step_;
    int channels_;
    std::shared_ptr<gl::Buffer> buffer_;
};

/// Ensures a buffer for at least `points` points; the content is unspecified.
inline void make_room(const std::shared_ptr<gl::Context>& context, std::optional<StokesBuffer>& buffer,
                      std::size_t points, int channels) {
    if (buffer && buffer->step() >= points && buffer->channels() == channels) return;
    buffer.reset();
    buffer.emplace(context, gl::BufferUse::storage, gl::BufferUpdate::fixed, points, channels);
}

}  // namespace nicol
