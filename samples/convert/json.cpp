// SPDX-License-Identifier: MIT
// Reports in JSON.
#include <cmath>
#include <cstdio>
#include <functional>

#include "report.hpp"

namespace {

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char letter : text) {
        const auto c = static_cast<unsigned char>(letter);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += letter;
        } else if (c < 0x20) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
            result += escape;
        } else {
            result += letter;
        }
    }
    return result + '"';
}

std::string number(double value) {
    if (!std::isfinite(value)) return "null";
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

std::string list(std::size_t count, const std::function<std::string(std::size_t)>& item) {
    std::string out;
    for (std::size_t i = 0; i < count; ++i) out += (i == 0 ? "" : ", ") + item(i);
    return "[" + out + "]";
}

std::string numbers(const double* values, std::size_t count) {
    return list(count, [values](std::size_t i) { return number(values[i]); });
}

const char* short_name(nicol_file_kind kind) {
    switch (kind) {
        case NICOL_FILE_LIGHT_IMAGE:
            return "light image";
        case NICOL_FILE_LIGHT_CROSS:
            return "light cross";
        case NICOL_FILE_LIGHT_PSH:
            return "light psh";
        case NICOL_FILE_MATERIAL_PSH:
            return "material psh";
        case NICOL_FILE_MATERIAL_MEASURED:
            return "material measured";
        default:
            return "material table";
    }
}

class Object {
public:
    Object& add(const char* name, const std::string& value) {
        text_ += (text_.empty() ? "  " : ",\n  ") + quoted(name) + ": " + value;
        return *this;
    }
    Object& add(const char* name, std::uint32_t value) { return add(name, std::to_string(value)); }
    [[nodiscard]] std::string text() const { return "{\n" + text_ + "\n}\n"; }

private:
    std::string text_;
};

template <class Report>
Object start(const Report& report) {
    const auto& n = report.numbers;
    Object object;
    object.add("file", quoted(report.file)).add("kind", quoted(short_name(n.kind)));
    object.add("channels", n.channels);
    object.add("wavelengths",
               n.wavelengths[0] > 0 ? numbers(n.wavelengths, n.channels) : std::string("null"));
    return object.add("order", n.order);
}

}  // namespace

std::string as_json(const LightReport& report) {
    const nicol_light_report& n = report.numbers;
    Object object = start(report);
    object.add("width", n.width).add("height", n.height);
    object.add("polarized", n.polarized != 0 ? "true" : "false");
    object.add("circular", n.circular != 0 ? "true" : "false");
    const auto add = [&](const char* name, const double* values) {
        object.add(name, numbers(values, n.channels));
    };
    add("mean", n.mean);
    add("smallest", n.smallest);
    add("largest", n.largest);
    object.add("direction", list(n.channels, [&](std::size_t c) { return numbers(n.direction + 3 * c, 3); }));
    add("mean_dolp", n.mean_dolp);
    add("largest_dolp", n.largest_dolp);
    add("largest_circular", n.largest_circular);
    add("unphysical", n.unphysical);
    add("largest_excess", n.largest_excess);
    const std::size_t orders = n.order + 1;
    object.add("energy", list(n.channels, [&](std::size_t c) {
                   return list(orders, [&](std::size_t l) {
                       return numbers(&report.energy[4 * (c * orders + l)], 4);
                   });
               }));
    return object.text();
}

std::string as_json(const MaterialReport& report) {
    const nicol_material_report& n = report.numbers;
    Object object = start(report);
    object.add("file_order", n.file_order).add("stokes_columns", n.stokes_columns);
    object.add("measured_wavelengths", n.measured_wavelengths);
    object.add("measured_range", numbers(n.measured_range, 2));
    const auto add = [&](const char* name, const double* values) {
        object.add(name, numbers(values, n.channels));
    };
    add("albedo", n.albedo);
    add("largest_albedo", n.largest_albedo);
    add("asymmetry", n.asymmetry);
    add("unphysical", n.unphysical);
    add("excess", n.excess);
    object.add("norms", list(n.channels, [&](std::size_t c) {
                   return list(3, [&](std::size_t out) { return numbers(n.norms + 9 * c + 3 * out, 3); });
               }));
    const std::size_t orders = n.order + 1;
    object.add("energy",
               list(n.channels, [&](std::size_t c) { return numbers(&report.energy[c * orders], orders); }));
    return object.text();
}
