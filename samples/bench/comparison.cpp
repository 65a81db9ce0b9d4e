// SPDX-License-Identifier: MIT
#include "comparison.hpp"

#include <algorithm>
#include <vector>

Comparison::Comparison(const Workshop& workshop, std::uint32_t size, std::int32_t samples, bool shadows,
                       int converged)
    : stage_(workshop),
      framebuffer_(stage_.framebuffer(kReduction * size, kReduction * size)),
      truth_(make_truth(workshop, size, samples, shadows)),
      shadows_(shadows) {
    if (converged == 0) return;
    const Picture limit = picture({.low = converged});
    converged_ = Truth{.first = limit, .second = limit, .mask = truth_.mask};
}

StokesErrors Comparison::errors(const Recipe& recipe) const {
    return truth_.errors(picture(recipe));
}

void Comparison::add(Report& report, Recipe recipe) const {
    recipe.shadows = shadows_;
    const Picture made = picture(recipe);
    const StokesErrors errors = truth_.errors(made);
    std::vector<double> values(errors.begin(), errors.end());
    if (converged_) {
        const StokesErrors cut = converged_->errors(made);
        values.insert(values.end(), cut.begin(), cut.end() - 1);
    }
    report.add(recipe.name(), values);
}

std::ptrdiff_t Comparison::pixels() const {
    return std::ranges::count(truth_.mask, 1);
}

Picture Comparison::picture(Recipe recipe) const {
    recipe.shadows = shadows_;
    return reduced_picture(stage_, recipe, framebuffer_.get());
}
