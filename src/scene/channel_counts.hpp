// SPDX-License-Identifier: MIT
// Colour channels of the parts of a scene.
#pragma once

#include <cstddef>
#include <vector>

namespace nicol {

/// How many parts have each number of channels.
class ChannelCounts {
public:
    /// Allocates what add() needs, so that a change to a scene happens as a whole or not at all.
    void make_room(int channels) { parts_.reserve(static_cast<std::size_t>(channels) + 1); }
    void add(int channels) {
        const auto at = static_cast<std::size_t>(channels);
        if (at >= parts_.size()) parts_.resize(at + 1);
        ++parts_[at];
    }
    /// Removes a part that was added.
    void remove(int channels) {
        --parts_[static_cast<std::size_t>(channels)];
        while (!parts_.empty() && parts_.back() == 0) parts_.pop_back();
    }

    /// The largest number; 1 where there are no parts.
    [[nodiscard]] int largest() const { return parts_.empty() ? 1 : static_cast<int>(parts_.size()) - 1; }
    /// The same without one part that has so many.
    [[nodiscard]] int largest_without(int channels) const {
        int most = largest();
        if (most != channels || parts_.back() > 1) return most;
        while (--most > 1 && parts_[static_cast<std::size_t>(most)] == 0) continue;
        return most < 1 ? 1 : most;
    }

private:
    std::vector<std::size_t> parts_;  // by number of channels; the last is not 0
};

}  // namespace nicol
