// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& value, const char* right) {
    throw std::runtime_error(name + " " + value + ": it must be " + right);
}

template <class Number>
Number number(const std::string& name, const std::string& value, Number least, Number most,
              const char* right) {
    Number result{};
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), result);
    const bool whole = error == std::errc() && end == value.data() + value.size();
    if (!whole || !(result >= least && result <= most)) refuse(name, value, right);
    return result;
}

nicol_backend backend(const std::string& value) {
    if (value == "egl") return NICOL_BACKEND_EGL;
    if (value == "osmesa") return NICOL_BACKEND_OSMESA;
    refuse("--backend", value, "egl or osmesa");
}

void parse_orders(const std::string& value, Options& options) {
    constexpr const char* right = "FIRST-LAST with 0 <= FIRST <= LAST <= 32";
    const std::size_t dash = value.find('-');
    if (dash == std::string::npos) refuse("--orders", value, right);
    options.first_order = number("--orders", value.substr(0, dash), 0, 32, right);
    options.last_order = number("--orders", value.substr(dash + 1), options.first_order, 32, right);
}

void assign(const std::string& name, const std::string& value, Options& options) {
    if (name == "-D") {
        options.definitions.push_back(value);
    } else if (name == "--light") {
        options.light = value;
    } else if (name == "--backend") {
        options.backend = backend(value);
    } else if (name == "--size") {
        options.size = number(name, value, std::uint32_t{8}, std::uint32_t{4096}, "8 to 4096");
    } else if (name == "--samples") {
        options.samples = number(name, value, 2, 1 << 20, "2 to 1048576");
    } else if (name == "--orders") {
        parse_orders(value, options);
    } else if (name == "--converged") {
        options.converged = number(name, value, 1, 32, "1 to 32");
    } else if (name == "--memory") {
        options.memory = number(name, value, 0.0, 1e6, "gigabytes, 0 to 1000000");
    } else if (name == "--seconds") {
        options.seconds = number(name, value, 1e-6, 3600.0, "above 0, at most 3600");
    } else if (name == "--only") {
        options.only = value;
    } else if (name == "--cache") {
        options.cache = value;
    } else if (name == "--plot") {
        options.plot = value;
    } else if (name == "--peer") {
        options.peer = value;
    } else if (name == "--csv") {
        options.csv = value;
    } else if (name == "--json") {
        options.json = value;
    }
}

}  // namespace

Options parse_options(std::span<char* const> arguments, std::span<const char* const> accepted) {
    const auto takes = [&](const std::string& name) {
        return std::ranges::any_of(accepted, [&](const char* known) { return name == known; });
    };
    Options options;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string name = arguments[i];
        if (name.empty() || name[0] != '-') {
            if (!takes("SCENE.xml") || !options.scene.empty())
                throw std::runtime_error(name + ": nothing of that kind is expected");
            options.scene = name;
        } else if (!takes(name)) {
            throw std::runtime_error(name + ": no option of this sub-command");
        } else if (name == "--large") {
            options.large = true;
        } else if (i + 1 == arguments.size()) {
            throw std::runtime_error(name + ": its value is missing");
        } else {
            assign(name, arguments[++i], options);
        }
    }
    return options;
}
