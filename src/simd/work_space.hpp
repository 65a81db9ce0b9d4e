// SPDX-License-Identifier: MIT
// Memory that a thread keeps, so that frames allocate no memory.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace nicol {

/// Returns elements of unspecified value. All calls with one tag on one thread return the same elements, so a
/// call ends the use of the elements of earlier calls.
template <class Tag, class Element>
[[nodiscard]] std::span<Element> work_space(std::size_t count) {
    thread_local std::vector<Element> kept;
    if (kept.size() < count) kept.resize(count);
    return std::span(kept).first(count);
}

}  // namespace nicol
