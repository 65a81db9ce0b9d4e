// SPDX-License-Identifier: MIT
// Versions of values, and the steps of a computation that depend on them.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

namespace nicol {

/// Identifier of one state of one value. No two states in a process share a version; 0 identifies no state.
using Version = std::uint64_t;

/// Returns a version greater than every earlier one. Safe to call from any thread.
[[nodiscard]] inline Version new_version() noexcept {
    static std::atomic<Version> last{0};
    return ++last;
}

/// Value with a version, which identifies the value's state without a comparison of values.
template <class T>
class Versioned {
public:
    [[nodiscard]] const T& operator*() const noexcept { return value_; }
    [[nodiscard]] const T* operator->() const noexcept { return &value_; }
    [[nodiscard]] Version version() const noexcept { return version_; }

    /// Returns the value for changes in place and gives it a new version.
    [[nodiscard]] T& change() noexcept {
        version_ = new_version();
        return value_;
    }

private:
    T value_{};
    Version version_ = new_version();
};

/// Step of a computation. The step has to run if its inputs (versions or plain values) differ from the inputs
/// of its last complete run.
template <class... Inputs>
class Stage {
public:
    /// Returns whether the last run had these inputs and was completed.
    [[nodiscard]] bool is_current(const Inputs&... inputs) const {
        return inputs_ && *inputs_ == std::tie(inputs...);
    }

    /// Calls body() unless is_current(inputs...). Returns whether it called body(). If body() throws, the
    /// stage is current for no inputs.
    template <class Body>
    bool run(const Inputs&... inputs, Body&& body) {
        if (is_current(inputs...)) return false;
        inputs_.reset();
        std::forward<Body>(body)();
        inputs_.emplace(inputs...);
        return true;
    }

    /// Makes the next run() call its body.
    void reset() noexcept { inputs_.reset(); }

private:
    std::optional<std::tuple<Inputs...>> inputs_;
};

}  // namespace nicol
