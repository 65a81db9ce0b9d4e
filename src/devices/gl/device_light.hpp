// SPDX-License-Identifier: MIT
// Light of vertices, or of points that pixels show, on the device.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "gl/buffer.hpp"
#include "gl/context.hpp"
#include "gl/storage.hpp"

namespace nicol {

/// Light of the vertices, or points, first .. first + count - 1: [channel][coefficient][vertex].
class DeviceLight {
public:
    /// Channels are computed together if their work space is at most as large.
    static constexpr std::size_t kWorkBytes = std::size_t{1} << 26;

    /// Returns the largest number of vertices in one object: as many as the context lets a shader reach, and
    /// no more than keeps the work space small.
    [[nodiscard]] static std::size_t most_vertices(const gl::Context& context, std::size_t coefficients) {
        const std::size_t fit = context.limits().storage_bytes / (coefficients * sizeof(float));
        return std::clamp(fit / gl::kGroupOfVertices * gl::kGroupOfVertices, gl::kGroupOfVertices,
                          std::size_t{65536});
    }

    /// coefficients: number per vertex and channel.
    DeviceLight(const std::shared_ptr<gl::Context>& context, std::size_t first, std::size_t count,
                std::size_t coefficients, int channels)
        : first_(first),
          count_(count),
          stride_(gl::in_whole_groups(count)),
          coefficients_(coefficients),
          channels_(channels),
          buffer_(context, gl::BufferUse::storage, static_cast<std::size_t>(channels) * channel_bytes(),
                  gl::BufferUpdate::dynamic) {}

    /// Copies light from the host: coefficients_of(vertex, channel) returns a span of coefficients() numbers.
    template <class CoefficientsOf>
    void upload(const CoefficientsOf& coefficients_of) {
        std::vector<float> data(static_cast<std::size_t>(channels_) * coefficients_ * stride_);
        for (int c = 0; c < channels_; ++c) {
            float* channel = data.data() + static_cast<std::size_t>(c) * coefficients_ * stride_;
            for (std::size_t v = 0; v < count_; ++v) {
                const std::span<const float> from = coefficients_of(first_ + v, c);
                for (std::size_t j = 0; j < coefficients_; ++j) channel[j * stride_ + v] = from[j];
            }
        }
        buffer_.update(0, std::as_bytes(std::span(data)));
    }

    /// Makes the object hold the light of other points, at most as many as at first. The content is
    /// unspecified.
    void place(std::size_t first, std::size_t count) noexcept {
        first_ = first;
        count_ = count;
    }

    void bind(unsigned binding, gl::ChannelGroup channels) const {
        buffer_.bind_storage(binding, static_cast<std::size_t>(channels.first) * channel_bytes(),
                             static_cast<std::size_t>(channels.count) * channel_bytes());
    }

    [[nodiscard]] std::size_t first() const noexcept { return first_; }
    [[nodiscard]] std::size_t count() const noexcept { return count_; }
    [[nodiscard]] std::size_t last() const noexcept { return first_ + count_; }
    /// Returns the distance between coefficients, in vertices.
    [[nodiscard]] std::size_t stride() const noexcept { return stride_; }
    [[nodiscard]] std::size_t coefficients() const noexcept { return coefficients_; }
    [[nodiscard]] int channels() const noexcept { return channels_; }
    /// Returns the distance between channels, in numbers and in bytes.
    [[nodiscard]] std::size_t channel_step() const noexcept { return coefficients_ * stride_; }
    [[nodiscard]] std::size_t channel_bytes() const noexcept { return channel_step() * sizeof(float); }

private:
    std::size_t first_;
    std::size_t count_;
    std::size_t stride_;
    std::size_t coefficients_;
    int channels_;
    gl::Buffer buffer_;
};

}  // namespace nicol
