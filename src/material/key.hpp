// SPDX-License-Identifier: MIT
// Content keys of materials as text.
#pragma once

#include <complex>
#include <string>
#include <string_view>
#include <vector>

#include "shortest_text.hpp"

namespace nicol {

/// Content key: the name of a model and every parameter with all its digits.
class Key {
public:
    explicit Key(std::string_view model) : text_(model) {}

    Key& add(std::string_view name, std::string_view value) {
        text_.append(" ").append(name).append("=").append(value);
        return *this;
    }
    Key& add(std::string_view name, double value) {
        return add(name, std::string_view(shortest_text(value)));
    }
    Key& add(std::string_view name, const std::vector<double>& values) {
        std::string list;
        for (const double value : values) list += shortest_text(value) + ",";
        return add(name, std::string_view(list));
    }
    Key& add(std::string_view name, const std::vector<std::complex<double>>& values) {
        std::string list;
        for (const auto& value : values)
            list += shortest_text(value.real()) + "i" + shortest_text(value.imag()) + ",";
        return add(name, std::string_view(list));
    }
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    std::string text_;
};

}  // namespace nicol
