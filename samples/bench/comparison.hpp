// SPDX-License-Identifier: MIT
// Errors of images of a scene against its reference.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "recipe.hpp"
#include "report.hpp"
#include "truth.hpp"

class Comparison {
public:
    /// `converged` above 0: the order of a factored image against which truncation errors are measured, since
    /// it has the same vertices.
    Comparison(const SceneSource& source, std::uint32_t size, std::uint32_t samples, bool shadows,
               int converged = 0);

    [[nodiscard]] const Truth& truth() const { return truth_; }
    struct Measured {
        StokesErrors errors;
        Truth::DolpError dolp;
        StokesErrors cut;  ///< of truncation alone; zero where there is no converged image
        nicol_statistics statistics;
    };
    /// The recipe's `shadows` is replaced by this comparison's.
    [[nodiscard]] Measured measure(Recipe recipe) const;
    [[nodiscard]] StokesErrors errors(const Recipe& recipe) const { return measure(recipe).errors; }
    /// A row named after the recipe: s0 to s3, those of the DoLP, then, if there is a converged image, the
    /// truncation errors of s0 to s2.
    void add(Report& report, Recipe recipe) const;
    [[nodiscard]] std::ptrdiff_t pixels() const;

private:
    Stage stage_;
    Framebuffer framebuffer_;
    Truth truth_;
    bool shadows_;
    std::optional<Truth> converged_;
};
