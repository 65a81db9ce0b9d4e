// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "comparison.hpp"
#include "dense_memory.hpp"

namespace {

// Adds the contribution of the orders above order_low (Figures 20 and 21).
void add_high_orders(Report& report, const Comparison& comparison, int low) {
    for (const int order : {low, low + 1}) comparison.add(report, {.low = order});
    comparison.add(report, {.low = low, .high = High::convolution, .top = std::max(9, low)});
    for (const int top : {9, 32, 64}) {
        if (top >= low) comparison.add(report, {.low = low, .high = High::split, .top = top});
    }
}

std::vector<std::string> columns(const Options& options) {
    std::vector<std::string> names{"relative RMSE",
                                   "s0",
                                   "s1",
                                   "s2",
                                   "s3",
                                   "s0, 95 %",
                                   "s0, 99 %",
                                   "s0, largest",
                                   "s1 s2, 95 %",
                                   "s1 s2, 99 %",
                                   "s1 s2, largest",
                                   "DoLP, mean",
                                   "DoLP, by light",
                                   "AoLP, degrees",
                                   "streaks",
                                   "s0 < 0"};
    if (options.converged > 0) names.insert(names.end(), {"cut s0", "cut s1", "cut s2"});
    return names;
}

}  // namespace

Report bench_error(const Options& options) {
    const int first = options.first_order < 0 ? 4 : options.first_order;
    const int last = options.last_order < 0 ? 12 : options.last_order;
    const std::uint32_t size = options.size == 0 ? 256 : options.size;
    const std::uint32_t samples = options.samples == 0 ? 256 : options.samples;
    const SceneSource source(options);
    const DenseMemory memory(source);
    Report report(columns(options));
    for (const bool shadows : {true, false}) {
        const Comparison comparison(source, size, samples, shadows, options.converged);
        const auto add_noise = [&](const std::string& what, const StokesErrors& noise) {
            std::vector<double> values(noise.begin(), noise.end());
            values.resize(columns(options).size() - 1, std::numeric_limits<double>::quiet_NaN());
            report.add(shadows ? what : what + ", no shadows", values);
        };
        add_noise("reference, its noise", comparison.truth().noise());
        add_noise("reference, its noise by its variance", comparison.truth().estimated_noise());
        comparison.add(report, {.defaults = true});
        comparison.add(report, {.defaults = true, .shade_at = NICOL_SHADE_AT_PIXELS});
        for (int order = first; order <= last; ++order) {
            comparison.add(report, {.low = order});
            if (memory.at(order) <= options.memory)
                comparison.add(report, {.method = NICOL_METHOD_DENSE, .low = order});
        }
        if (shadows) {
            add_high_orders(report, comparison, first);
            report.note(std::to_string(comparison.pixels()) + " pixels of " + std::to_string(size) + " x " +
                        std::to_string(size) +
                        "; relative to the RMS of s0; the noise of the reference, of " +
                        std::to_string(samples) + " samples twice, is taken out of the errors.");
            report.note(
                "95 %, 99 %, largest: percentiles of the error of a pixel's channel, which include the "
                "reference's "
                "noise. DoLP: the mean absolute error, and weighted by s0; AoLP: the mean error weighted by "
                "polarized light; streaks: the part of the pixels with a DoLP 0.1 above the "
                "largest "
                "true one. By default orders are chosen and Stokes vectors are physical.");
        }
    }
    if (options.converged > 0) {
        report.note("cut: against the factored method to order " + std::to_string(options.converged) +
                    ", which has the same vertices, in place of the reference.");
    }
    report.note("Dense up to " + std::to_string(static_cast<int>(options.memory)) + " GB of matrices.");
    return report;
}
