// SPDX-License-Identifier: MIT
// Which results still belong to their inputs.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

namespace nicol {

/// Names one state of one value: no two states in a process share a version. 0 names none.
using Version = std::uint64_t;

/// Greater than all before it. May be called from any thread.
[[nodiscard]] inline Version new_version() noexcept {
    static std::atomic<Version> last{0};
    return ++last;
}

/// A value with a version, which identifies its state without a comparison of values.
template <class T>
class Versioned {
public:
    [[nodiscard]] const T& operator*() const noexcept { return value_; }
    [[nodiscard]] const T* operator->() const noexcept { return &value_; }
    [[nodiscard]] Version version() const noexcept { return version_; }

    /// For changes in place; the version becomes another.
    [[nodiscard]] T& change() noexcept {
        version_ = new_version();
        return value_;
    }

private:
    T value_{};
    Version version_ = new_version();
};

/// A step of a computation. It has to run where its inputs, versions or plain values, differ from those of
/// its last complete run.
template <class... Inputs>
class Stage {
public:
    /// Whether these were the inputs of the last run, and that was completed.
    [[nodiscard]] bool is_current(const Inputs&... inputs) const {
        return inputs_ && *inputs_ == std::tie(inputs...);
    }

    /// Calls body() unless is_current(inputs...); returns whether it did. Where body() throws, the stage is
    /// current for no inputs.
    template <class Body>
    bool run(const Inputs&... inputs, Body&& body) {
        if (is_current(inputs...)) return false;
        inputs_.reset();
        std::forward<Body>(body)();
        inputs_.emplace(inputs...);
        return true;
    }

    /// The next run() calls its body.
    void reset() noexcept { inputs_.reset(); }

private:
    std::optional<std::tuple<Inputs...>> inputs_;
};

}  // namespace nicol
