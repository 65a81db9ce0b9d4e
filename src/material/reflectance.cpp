// SPDX-License-Identifier: MIT
#include "material/reflectance.hpp"

#include <sstream>

#include "error.hpp"

namespace nicol {

void check_range(double value, double low, double high, std::string_view name) {
    if (value >= low && value <= high) return;
    std::ostringstream message;
    message << name << " is " << value << "; it must lie in " << low << " to " << high;
    throw Error(ErrorCode::invalid_argument, message.str());
}

void check_reflectance(const std::vector<double>& values, std::string_view name) {
    if (values.empty()) {
        throw Error(ErrorCode::invalid_argument,
                    std::string(name) + " has no value; give one, or one a channel");
    }
    for (const double value : values) check_range(value, 0, 1, name);
}

void check_channels(std::size_t a, std::string_view a_name, std::size_t b, std::string_view b_name) {
    if (a == b || a == 1 || b == 1) return;
    throw Error(ErrorCode::invalid_argument,
                std::string(a_name) + " has " + std::to_string(a) + " channels and " + std::string(b_name) +
                    " " + std::to_string(b) + "; they must agree, or one of them have a single value");
}

}  // namespace nicol
