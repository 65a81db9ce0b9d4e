// SPDX-License-Identifier: MIT
// The relight step: rotation of the environment's light into the frame of each vertex.
#pragma once

#include <complex>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "harmonics/lane_rotation.hpp"
#include "harmonics/light_layout.hpp"
#include "simd/lanes.hpp"
#include "transfer/light_fields.hpp"
#include "visibility/block_memory.hpp"

namespace nicol {

/// Coefficients of the light arriving at vertices, in each vertex's own frame: z along the normal, x and y
/// along theta-hat and phi-hat at the normal (theta_phi_frame). 32-bit floats, sixteen consecutive vertices
/// side by side; the last block may have unused lanes.
class VertexLight {
public:
    VertexLight() = default;
    VertexLight(const LightLayout& layout, int channels, std::size_t vertices) {
        resize(layout, channels, vertices);
    }
    /// Changes the size. If layout and channels do not change, vertices below both sizes keep their light;
    /// otherwise the content is unspecified. Does not allocate if the size does not change.
    void resize(const LightLayout& layout, int channels, std::size_t vertices);

    [[nodiscard]] int channels() const noexcept { return channels_; }
    [[nodiscard]] std::size_t blocks() const noexcept { return data_.blocks(); }
    /// Returns the coefficients of LightLayout of vertices 16 block to 16 block + 15.
    [[nodiscard]] std::span<const Lanes> block(std::size_t block, int channel) const {
        return {data_.at(block) + static_cast<std::size_t>(channel) * size_, size_};
    }
    [[nodiscard]] std::span<Lanes> block(std::size_t block, int channel) {
        return {data_.at(block) + static_cast<std::size_t>(channel) * size_, size_};
    }

    /// Moves light to other vertices: that of vertex former[v] to v. The light of a block is unspecified if
    /// former[v] is kNoVertex for one of its vertices. The size becomes that of `former`. rows: whether all
    /// blocks have been reordered by to_rows(). Runs on the calling thread's TBB arena.
    void renumber(std::span<const std::uint32_t> former, bool rows);

    /// Reorders a block in place: the coefficients of each vertex follow one another.
    void to_rows(std::size_t block);
    /// Returns the coefficients of one vertex, [channel][number], after to_rows() of its block.
    [[nodiscard]] const float* row(std::size_t vertex) const {
        return data_.at(vertex / kLanes)->value.data() + vertex % kLanes * row_size();
    }
    [[nodiscard]] std::size_t row_size() const noexcept {
        return static_cast<std::size_t>(channels_) * size_;
    }

    [[nodiscard]] std::size_t bytes() const noexcept { return blocks() * row_size() * sizeof(Lanes); }

private:
    // Gives memory to blocks that have none.
    void allocate();

    std::size_t size_ = 0;
    int channels_ = 0;
    BlockMemory<Lanes> data_;  // of a block: [channel][number], or [lane][channel][number] after to_rows()
};

/// Distant light, prepared for rotation into many vertices' frames.
class Relight {
public:
    /// Takes `light`, coefficients in the world's axes, of at least the layout's order.
    Relight(const LightLayout& layout, const PshVector& light);

    /// Writes blocks first <= b < last of `out`, which has the layout's kind and order. `normals`: unit
    /// vectors, one for each vertex. Runs on the calling thread; calls for different blocks may run side by
    /// side.
    void run(std::span<const glm::vec3> normals, std::size_t first, std::size_t last, VertexLight& out) const;

private:
    // Complex fields: s0 and s3 over complex harmonics for m >= 0, s1 + i s2 for all m.
    using Field = std::vector<std::complex<float>>;

    void run_part(std::size_t part, LaneRotation::Work& work, std::size_t block, VertexLight& out) const;

    int order_;
    LaneRotation rotation_;
    LightFields fields_;
    std::vector<std::vector<Field>> channels_;  // [part][channel]
};

}  // namespace nicol
