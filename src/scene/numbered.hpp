// SPDX-License-Identifier: MIT
// Parts of a scene that are known by their ids.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "arguments.hpp"

namespace nicol {

/// Ids count up from 0 and are never given twice.
template <class T>
class Numbered {
public:
    /// `what`: one of them, for messages; it must live as long.
    explicit Numbered(const char* what) : what_(what) {}

    [[nodiscard]] const std::vector<T>& values() const noexcept { return values_; }
    /// Of values(), ascending.
    [[nodiscard]] const std::vector<std::uint32_t>& ids() const noexcept { return ids_; }

    /// That of the next add(). Throws Error(invalid_argument) where there are no more.
    [[nodiscard]] std::uint32_t next() const {
        if (next_ == std::numeric_limits<std::uint32_t>::max())
            refuse("the scene has had too many " + std::string(what_) + "s");
        return next_;
    }

    /// Where in values() it is. Throws Error(invalid_argument) for ids of none.
    [[nodiscard]] std::size_t index_of(std::uint32_t id) const {
        const auto found = std::ranges::lower_bound(ids_, id);
        if (found == ids_.end() || *found != id)
            refuse(
                "there is no " + std::string(what_) + " " + std::to_string(id) +
                (id < next_ ? "; it was removed" : "; ids below " + std::to_string(next_) + " were given"));
        return static_cast<std::size_t>(found - ids_.begin());
    }
    [[nodiscard]] const T& at(std::uint32_t id) const { return values_[index_of(id)]; }
    [[nodiscard]] T& operator[](std::size_t index) { return values_[index]; }

    std::uint32_t add(T value) {
        const std::uint32_t id = next();
        if (ids_.size() == ids_.capacity()) ids_.reserve(2 * ids_.size() + 1);
        values_.push_back(std::move(value));
        ids_.push_back(id);
        ++next_;
        return id;
    }
    void remove(std::uint32_t id) {
        const auto index = static_cast<std::ptrdiff_t>(index_of(id));
        values_.erase(values_.begin() + index);
        ids_.erase(ids_.begin() + index);
    }

private:
    const char* what_;
    std::vector<T> values_;
    std::vector<std::uint32_t> ids_;
    std::uint32_t next_ = 0;
};

}  // namespace nicol
