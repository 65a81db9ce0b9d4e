// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <cstdio>

namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
    char text[256];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

// Returns the numbers of a convolution kernel per order: 9 without s3, all 16 with it.
unsigned kernel_size(unsigned components) {
    return components == 3 ? 9 : 16;
}

std::string times(const Cost& cost) {
    return format(" %.1f | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f |", cost.dense.light_ms,
                  cost.factored.light_ms, cost.dense.light_ms / cost.factored.light_ms,
                  cost.dense.light_physical_ms, cost.factored.light_physical_ms, cost.dense.camera_ms,
                  cost.factored.camera_ms);
}

}  // namespace

std::string cost_table(const std::vector<StepResult>& results, unsigned components, bool timed) {
    std::string text =
        "| step | vertices | lighting coeff. | matrix entries a vertex | convolution coeff. a material | "
        "bytes a "
        "vertex, dense | factored |";
    if (timed) {
        text +=
            " light rotates, ms: dense | factored | dense / factored | with Eq. 70: dense | factored | "
            "camera "
            "moves, ms: dense | factored |";
    }
    text += "\n|---|---|---|---|---|---|---|";
    if (timed) text += "---|---|---|---|---|---|---|";
    text += '\n';
    for (const StepResult& result : results) {
        const Recipe& recipe = result.step.recipe;
        const auto count = [](std::int32_t order) {
            return static_cast<unsigned>((order + 1) * (order + 1));
        };
        const unsigned row = components * count(recipe.order_low);
        const std::string kernel =
            recipe.high_orders == NICOL_HIGH_ORDERS_CONVOLUTION
                ? format("%u", kernel_size(components) *
                                   static_cast<unsigned>(recipe.order_high - recipe.order_low))
                : "-";
        text += format("| %s | %llu | %u | %u | %s | %.0f | %.0f |", result.step.name,
                       static_cast<unsigned long long>(result.cost.vertices),
                       components * count(recipe.order_high), row * row, kernel.c_str(),
                       result.cost.dense.bytes, result.cost.factored.bytes);
        if (timed) text += times(result.cost);
        text += '\n';
    }
    return text;
}

std::string error_table(const std::vector<StepResult>& results) {
    std::string text = "| relative error to the reference | s0 | s1 | s2 |\n|---|---|---|---|\n";
    for (const StepResult& result : results) {
        text += format("| %s |", result.step.name);
        for (const double error : result.errors)
            text += error > 0 ? format(" %.4f |", error) : " below the noise |";
        text += '\n';
    }
    return text;
}

std::string range_table(const std::vector<StepResult>& results) {
    std::string text =
        "| share of the objects' pixels | s0 < 0 | more polarization than light |\n|---|---|---|\n";
    for (const StepResult& result : results) {
        text += format("| %s | %.1f %% | %.1f %% |\n", result.step.name, 100 * result.negative,
                       100 * result.overpolarized);
    }
    return text;
}
