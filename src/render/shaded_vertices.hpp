// SPDX-License-Identifier: MIT
// Which vertices' Stokes vectors still are right.
#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "polarization/viewpoint.hpp"
#include "render/geometry.hpp"
#include "render/render.hpp"
#include "render/transfer_input.hpp"

namespace nicol {

class ShadedVertices {
public:
    /// All but geometry, visibility and materials that Stokes vectors depend on.
    struct Key {
        Viewpoint view;
        Method method;
        HighOrders high_orders;
        bool at_pixels;
        int order_low;
        int order_high;
        std::uint64_t light;    // revision of the low orders' light
        std::uint64_t distant;  // of the high orders'
        bool shadowed;
        bool high_shadowed;
        int channels;
        std::size_t least_components;
        std::size_t most_components;
        bool operator==(const Key&) const = default;
    };

    /// Follows changes. `same_places`: 1 for vertices that had the same place and number in the state that
    /// input.unchanged tells of.
    void follow(const Key& key, const TransferInput& input, std::span<const std::uint8_t> same_places);
    /// Nothing is right any more.
    void forget() noexcept { key_.reset(); }

    /// 1 for those with visible[v] != 0 that must be shaded. Lives until the next call.
    [[nodiscard]] std::span<const std::uint8_t> choose(std::span<const std::uint8_t> visible);
    /// How many they were.
    [[nodiscard]] std::uint64_t chosen_count() const;
    /// They have been shaded.
    void done();

private:
    std::optional<Key> key_;
    std::uint64_t geometry_ = 0;
    std::uint64_t visibility_ = 0;
    std::vector<VertexRange> ranges_;
    std::vector<std::uint8_t> right_;
    std::vector<std::uint8_t> chosen_;
};

}  // namespace nicol
