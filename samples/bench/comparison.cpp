// SPDX-License-Identifier: MIT
#include "comparison.hpp"

#include <algorithm>
#include <vector>

Comparison::Comparison(const SceneSource& source, std::uint32_t size, std::uint32_t samples, bool shadows,
                       int converged)
    : stage_(source),
      framebuffer_(stage_.framebuffer(kReduction * size, kReduction * size)),
      truth_(make_truth(source, size, samples, shadows)),
      shadows_(shadows) {
    if (converged == 0) return;
    const Image limit = reduced_image(stage_, {.low = converged, .shadows = shadows}, framebuffer_.get());
    converged_ = Truth{.first = limit, .second = limit, .mask = truth_.mask};
}

Comparison::Measured Comparison::measure(Recipe recipe) const {
    recipe.shadows = shadows_;
    const Image made = reduced_image(stage_, recipe, framebuffer_.get());
    Measured measured{.errors = truth_.errors(made),
                      .tails = truth_.tails(made),
                      .polarization = truth_.polarization_error(made),
                      .cut = {},
                      .statistics = NICOL_STATISTICS_INIT};
    if (converged_) measured.cut = converged_->errors(made);
    check(nicol_framebuffer_get_statistics(framebuffer_.get(), &measured.statistics));
    return measured;
}

void Comparison::add(Report& report, Recipe recipe) const {
    recipe.shadows = shadows_;
    const Measured measured = measure(recipe);
    std::vector<double> values(measured.errors.begin(), measured.errors.end());
    for (const Truth::Tail& tail : {measured.tails.s0, measured.tails.linear})
        values.insert(values.end(), {tail.percentile_95, tail.percentile_99, tail.largest});
    const Truth::PolarizationError& polarization = measured.polarization;
    values.insert(values.end(), {polarization.dolp, polarization.dolp_by_light, polarization.aolp,
                                 polarization.streaks, polarization.negative});
    if (converged_) values.insert(values.end(), measured.cut.begin(), measured.cut.end() - 1);
    report.add(recipe.name(), values);
}

std::ptrdiff_t Comparison::pixels() const {
    return std::ranges::count(truth_.mask, 1);
}
