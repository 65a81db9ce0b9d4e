// SPDX-License-Identifier: MIT
// Table 4 and the errors of each step, as Markdown.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "frames.hpp"

struct StepResult {
    Step step;
    Cost cost;
    std::array<double, 3> errors{};  ///< relative_errors() of s0, s1, s2
    double negative = 0;             ///< share of the object's pixels with s0 < 0 in some channel
    double overpolarized = 0;        ///< share with s0 >= 0 and more polarization than light
};

/// Returns table 4. `components`: Stokes components of the light, 3 or 4. `timed`: whether there are times.
std::string cost_table(const std::vector<StepResult>& results, unsigned components, bool timed);
std::string error_table(const std::vector<StepResult>& results);
std::string range_table(const std::vector<StepResult>& results);
