// SPDX-License-Identifier: MIT
// Table 4, and how far each step is from the truth, as Markdown.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "frames.hpp"

struct StepResult {
    Step step;
    Cost cost;
    std::array<double, 3> errors{};  ///< of s0, s1, s2; see relative_errors()
    double negative = 0;             ///< share of the object's pixels with s0 < 0 in some channel
    double overpolarized = 0;        ///< likewise with s0 >= 0 and more polarization than light
};

/// `components`: Stokes components that the light has, 3 or 4. Without times where there are none.
std::string cost_table(const std::vector<StepResult>& results, unsigned components, bool timed);
std::string error_table(const std::vector<StepResult>& results);
std::string range_table(const std::vector<StepResult>& results);
