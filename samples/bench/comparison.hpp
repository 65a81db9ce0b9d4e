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
    /// Renders the reference. If `converged` is above 0, truncation errors are measured against a factored
    /// image of this order, because it has the same vertices.
    Comparison(const SceneSource& source, std::uint32_t size, std::uint32_t samples, bool shadows,
               int converged = 0);

    [[nodiscard]] const Truth& truth() const { return truth_; }
    struct Measured {
        StokesErrors errors;
        Truth::Tails tails;
        Truth::PolarizationError polarization;
        StokesErrors cut;  ///< truncation errors; zero without a converged image
        nicol_statistics statistics;
    };
    /// Measures a recipe, with this comparison's `shadows`.
    [[nodiscard]] Measured measure(Recipe recipe) const;
    [[nodiscard]] StokesErrors errors(const Recipe& recipe) const { return measure(recipe).errors; }
    /// Adds a row named after the recipe: errors of s0 to s3, their tails, errors of DoLP and AoLP, and
    /// truncation errors of s0 to s2 if there is a converged image.
    void add(Report& report, Recipe recipe) const;
    [[nodiscard]] std::ptrdiff_t pixels() const;

private:
    Stage stage_;
    Framebuffer framebuffer_;
    Truth truth_;
    bool shadows_;
    std::optional<Truth> converged_;
};
