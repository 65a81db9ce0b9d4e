// SPDX-License-Identifier: MIT
#include "error.hpp"

#include <algorithm>

#include "dense_memory.hpp"
#include "truth.hpp"

namespace {

constexpr int highest_dense_order = 9;

class Comparison {
public:
    Comparison(const Workshop& workshop, std::uint32_t size, std::int32_t samples, bool shadows)
        : stage_(workshop),
          framebuffer_(stage_.framebuffer(kReduction * size, kReduction * size)),
          truth_(make_truth(workshop, size, samples, shadows)),
          shadows_(shadows) {}

    void add_noise(Report& report) const {
        add(report, shadows_ ? "reference, its noise" : "reference, its noise, no shadows", truth_.noise());
    }
    void add(Report& report, Recipe recipe) const {
        recipe.shadows = shadows_;
        add(report, recipe.name(), truth_.errors(reduced_picture(stage_, recipe, framebuffer_.get())));
    }
    [[nodiscard]] std::ptrdiff_t pixels() const { return std::ranges::count(truth_.mask, 1); }

private:
    static void add(Report& report, const std::string& what, const StokesErrors& errors) {
        report.add(what, std::vector<double>(errors.begin(), errors.end()));
    }

    Stage stage_;
    Framebuffer framebuffer_;
    Truth truth_;
    bool shadows_;
};

// Figures 20 and 21: what the orders above order_low add.
void add_high_orders(Report& report, const Comparison& comparison, int low) {
    for (const int order : {low, low + 1}) comparison.add(report, {.low = order});
    comparison.add(report, {.low = low, .high = High::convolution, .top = std::max(9, low)});
    for (const int top : {9, 32, 64}) {
        if (top >= low) comparison.add(report, {.low = low, .high = High::split, .top = top});
    }
}

}  // namespace

Report bench_error(const Options& options) {
    const int first = options.first_order < 0 ? 4 : options.first_order;
    const int last = options.last_order < 0 ? 12 : options.last_order;
    const std::uint32_t size = options.size == 0 ? 256 : options.size;
    const std::int32_t samples = options.samples == 0 ? 256 : options.samples;
    const Workshop workshop(options);
    const DenseMemory memory(workshop);
    Report report({"relative RMSE", "s0", "s1", "s2", "s3"});
    for (const bool shadows : {true, false}) {
        const Comparison comparison(workshop, size, samples, shadows);
        comparison.add_noise(report);
        for (int order = first; order <= last; ++order) {
            comparison.add(report, {.low = order});
            if (order <= highest_dense_order && memory.at(order) <= options.memory)
                comparison.add(report, {.method = NICOL_METHOD_DENSE, .low = order});
        }
        if (shadows) {
            add_high_orders(report, comparison, first);
            report.note(std::to_string(comparison.pixels()) + " pixels of " + std::to_string(size) + " x " +
                        std::to_string(size) +
                        "; relative to the RMS of s0; the noise of the reference, of " +
                        std::to_string(samples) + " samples twice, is taken out of the errors.");
        }
    }
    report.note("Dense up to order " + std::to_string(highest_dense_order) + " and " +
                std::to_string(static_cast<int>(options.memory)) + " GB of matrices.");
    return report;
}
