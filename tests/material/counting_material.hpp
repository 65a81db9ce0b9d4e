// SPDX-License-Identifier: MIT
// A material that counts its evaluations.
#pragma once

#include <atomic>
#include <string>
#include <utility>

#include "material/material.hpp"

namespace nicol::test {

/// A material that counts its evaluations, so that a test can tell whether a result was computed from it.
class Counting final : public Material {
public:
    explicit Counting(std::string key = "counting") : key_(std::move(key)) {}
    [[nodiscard]] int channels() const noexcept override { return 1; }
    [[nodiscard]] int terms() const noexcept override { return 1; }
    [[nodiscard]] double weight(int, int) const override { return 1; }
    [[nodiscard]] double lobe_width(int) const noexcept override { return 1; }
    [[nodiscard]] std::string content_key() const override { return key_; }
    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& i, const glm::dvec3& o) const override {
        ++calls;
        return base_->evaluate(term, i, o);
    }
    mutable std::atomic<int> calls = 0;

private:
    std::string key_;
    MaterialPtr base_ = diffuse({0.5});
};

}  // namespace nicol::test
