// SPDX-License-Identifier: MIT
// relight: the environment's light in the frame of each vertex.
#pragma once

#include <complex>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "nicol/light_layout.hpp"

namespace nicol {

/// Packed coefficients (LightLayout) of the light arriving at vertices, in each vertex's own frame: z along
/// the normal, x and y along theta-hat and phi-hat at the normal (theta_phi_frame). 32-bit floats.
class VertexLight {
public:
    VertexLight() = default;
    VertexLight(const LightLayout& layout, int channels, std::size_t vertices) {
        resize(layout, channels, vertices);
    }
    /// Without allocating where the size is the same; what it holds afterwards is unspecified.
    void resize(const LightLayout& layout, int channels, std::size_t vertices);

    /// Real, then imaginary parts of the packed coefficients, row_size() each.
    [[nodiscard]] std::span<const float> at(std::size_t vertex, int channel) const {
        return {data_.data() + offset(vertex, channel), 2 * row_size_};
    }
    [[nodiscard]] std::span<float> at(std::size_t vertex, int channel) {
        return {data_.data() + offset(vertex, channel), 2 * row_size_};
    }
    [[nodiscard]] int channels() const noexcept { return channels_; }
    [[nodiscard]] std::size_t row_size() const noexcept { return row_size_; }
    [[nodiscard]] std::size_t bytes() const noexcept { return data_.size() * sizeof(float); }

private:
    [[nodiscard]] std::size_t offset(std::size_t vertex, int channel) const {
        return (vertex * static_cast<std::size_t>(channels_) + static_cast<std::size_t>(channel)) * 2 *
               row_size_;
    }

    std::size_t row_size_ = 0;
    int channels_ = 0;
    std::vector<float> data_;
};

/// A distant light ready to be turned into many vertices' frames.
class Relight {
public:
    /// `light`: coefficients in the world's axes, of at least the layout's order.
    Relight(const LightLayout& layout, const PshVector& light);

    /// `normals`: unit vectors, one for each vertex of `out` from `first` on. Runs on the calling thread;
    /// calls for different vertices may run side by side.
    void run(std::span<const glm::vec3> normals, std::size_t first, VertexLight& out) const;

private:
    struct Channel {
        std::vector<std::complex<float>> s0;    // over complex harmonics, m >= 0
        std::vector<std::complex<float>> s3;    // likewise, or empty
        std::vector<std::complex<float>> spin;  // s1 + i s2, all m, or empty
    };

    LightLayout layout_;
    std::vector<Channel> channels_;
};

}  // namespace nicol
