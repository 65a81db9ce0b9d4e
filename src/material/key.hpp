// SPDX-License-Identifier: MIT
// Content keys of materials as text.
#pragma once

#include <array>
#include <charconv>
#include <complex>
#include <string>
#include <string_view>
#include <vector>

namespace nicol {

/// Content key: the name of a model and every parameter with all its digits.
class Key {
public:
    explicit Key(std::string_view model) : text_(model) {}

    Key& add(std::string_view name, std::string_view value) {
        text_.append(" ").append(name).append("=").append(value);
        return *this;
    }
    Key& add(std::string_view name, double value) { return add(name, std::string_view(digits(value))); }
    Key& add(std::string_view name, const std::vector<double>& values) {
        std::string list;
        for (const double value : values) list += digits(value) + ",";
        return add(name, std::string_view(list));
    }
    Key& add(std::string_view name, const std::vector<std::complex<double>>& values) {
        std::string list;
        for (const auto& value : values) list += digits(value.real()) + "i" + digits(value.imag()) + ",";
        return add(name, std::string_view(list));
    }
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    static std::string digits(double value) {
        std::array<char, 32> buffer{};
        const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
        return {buffer.data(), end};
    }
    std::string text_;
};

}  // namespace nicol
