// SPDX-License-Identifier: MIT
// Memory of blocks of sixteen consecutive vertices.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "simd/lanes.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// Values of blocks of sixteen consecutive vertices, equally many in each block that has values. Each block
/// has memory of its own: a block whose vertices get other numbers is handed over, not copied.
template <class Value>
class BlockMemory {
public:
    /// Changes the number of blocks. Blocks below both numbers keep their values; other blocks have none.
    void resize(std::size_t blocks) { blocks_.resize(blocks); }
    [[nodiscard]] std::size_t blocks() const noexcept { return blocks_.size(); }

    /// Gives a block `size` values of zero. Calls for different blocks may run side by side.
    void allocate(std::size_t block, std::size_t size) { blocks_[block] = std::make_unique<Value[]>(size); }

    /// Returns the values of a block, or null if it has none.
    [[nodiscard]] Value* at(std::size_t block) { return blocks_[block].get(); }
    [[nodiscard]] const Value* at(std::size_t block) const { return blocks_[block].get(); }
    [[nodiscard]] std::size_t count() const {
        return static_cast<std::size_t>(
            std::ranges::count_if(blocks_, [](const auto& b) { return b != nullptr; }));
    }

    /// Moves values of `size` to other vertices: those of vertex former[v] to v. A block then has values if
    /// wanted(block) is true. Returns the vertices of such blocks whose values are unset, ascending: those
    /// for which former[v] is kNoVertex or had no values. copy(to, lane, from, lane_before) copies the values
    /// of one vertex. Runs on the calling thread's TBB arena.
    template <class Wanted, class Copy>
    std::vector<std::uint32_t> renumber(std::span<const std::uint32_t> former, std::size_t size,
                                        const Wanted& wanted, const Copy& copy) {
        std::vector<std::unique_ptr<Value[]>> before((former.size() + kLanes - 1) / kLanes);
        before.swap(blocks_);
        const auto had_values = [&](std::uint32_t v) {
            return v != kNoVertex && v / kLanes < before.size() && before[v / kLanes];
        };
        std::vector<std::uint32_t> unset;
        std::vector<std::uint8_t> handed_over(before.size(), 0);
        std::vector<std::pair<std::size_t, std::size_t>> whole;  // blocks and the former blocks that they are
        std::vector<std::size_t> mixed;
        for (std::size_t block = 0; block < blocks_.size(); ++block) {
            if (!wanted(block)) continue;
            const auto vertices =
                former.subspan(block * kLanes, std::min(kLanes, former.size() - block * kLanes));
            std::size_t same = before.size();  // the former block of all known vertices
            bool in_order = true;
            for (std::size_t i = 0; i < vertices.size(); ++i) {
                if (!had_values(vertices[i])) {
                    unset.push_back(static_cast<std::uint32_t>(block * kLanes + i));
                    continue;
                }
                if (same == before.size()) same = vertices[i] / kLanes;
                in_order = in_order && vertices[i] == same * kLanes + i;
            }
            // Unset values of a block that is handed over are those of vertices that changed.
            if (in_order && same < before.size() && std::exchange(handed_over[same], 1) == 0)
                whole.emplace_back(block, same);
            else
                mixed.push_back(block);
        }
        tbb::parallel_for(std::size_t{0}, mixed.size(), [&](std::size_t i) {
            allocate(mixed[i], size);
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const std::uint32_t v = former[std::min(mixed[i] * kLanes + lane, former.size() - 1)];
                if (!had_values(v)) continue;
                copy(at(mixed[i]), lane, std::as_const(before[v / kLanes]).get(), v % kLanes);
            }
        });
        for (const auto& [block, same] : whole) blocks_[block] = std::move(before[same]);
        return unset;
    }

private:
    std::vector<std::unique_ptr<Value[]>> blocks_;
};

}  // namespace nicol
