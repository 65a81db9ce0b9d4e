// SPDX-License-Identifier: MIT
// Memory that a thread keeps, so that frames allocate none.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace nicol {

/// Elements of unspecified value: the same ones for every call with this tag on a thread, so a call ends the
/// use of those before.
template <class Tag, class Element>
[[nodiscard]] std::span<Element> work_space(std::size_t count) {
    thread_local std::vector<Element> kept;
    if (kept.size() < count) kept.resize(count);
    return std::span(kept).first(count);
}

}  // namespace nicol
