// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "comparison.hpp"

namespace {

// Order of the light against which truncation errors are measured.
constexpr int kConverged = 24;

double largest(const StokesErrors& errors) {
    return std::max({errors[0], errors[1], errors[2]});
}

}  // namespace

Report bench_tolerance(const Options& options) {
    const std::uint32_t size = options.size == 0 ? 256 : options.size;
    const std::uint32_t samples = options.samples == 0 ? 256 : options.samples;
    const SceneSource source(options);
    Report report({"tolerance", "order low", "to order", "predicted", "truncation", "truncation / tolerance",
                   "against reference"});
    for (const bool shadows : {true, false}) {
        const Comparison comparison(source, size, samples, shadows, kConverged);
        for (const double tolerance : {0.2, 0.1, 0.05, 0.02}) {
            const Recipe recipe{.high = High::split, .tolerance = tolerance};
            const Comparison::Measured measured = comparison.measure(recipe);
            const nicol_statistics& s = measured.statistics;
            const double cut = largest(measured.cut);
            std::string name = std::to_string(tolerance);
            name.erase(name.find_last_not_of('0') + 1);
            report.add(shadows ? name : name + ", no shadows",
                       {static_cast<double>(s.order_low), static_cast<double>(s.order), s.predicted_error,
                        cut, cut / tolerance, largest(measured.errors)});
        }
    }
    report.note(
        "Relative RMSE, the largest of s0, s1 and s2. Truncation: against the factored method to order " +
        std::to_string(kConverged) + ", which has the same vertices.");
    return report;
}
