// SPDX-License-Identifier: MIT
// A writer of measured materials for tests.
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "polarization/mueller.hpp"

namespace nicol::test {

/// The parts of a .pbsdf file, which tests may damage before writing it.
struct PbsdfFile {
    struct Field {
        std::string name;
        std::vector<std::uint64_t> shape;
        std::uint8_t type;
        std::string bytes;
    };
    std::string magic = std::string("tensor_file\0", 12) + '\1' + '\0';
    std::vector<Field> fields;

    template <class T>
    void add(const std::string& name, std::vector<std::uint64_t> shape, std::uint8_t type,
             const std::vector<T>& values) {
        fields.push_back(
            {name, std::move(shape), type,
             std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T))});
    }
    Field& field(const std::string& name) {
        for (Field& f : fields)
            if (f.name == name) return f;
        throw std::logic_error("no such field");
    }

    template <class T>
    static void append(std::string& out, T value) {
        out.append(reinterpret_cast<const char*>(&value), sizeof value);
    }

    /// Returns the file: directory and data.
    [[nodiscard]] std::string bytes() const {
        std::size_t head = magic.size() + 4;
        for (const Field& f : fields) head += 2 + f.name.size() + 2 + 1 + 8 + 8 * f.shape.size();
        std::string out = magic;
        append(out, static_cast<std::uint32_t>(fields.size()));
        std::uint64_t offset = head;
        for (const Field& f : fields) {
            append(out, static_cast<std::uint16_t>(f.name.size()));
            out += f.name;
            append(out, static_cast<std::uint16_t>(f.shape.size()));
            append(out, f.type);
            append(out, offset);
            for (const std::uint64_t n : f.shape) append(out, n);
            offset += f.bytes.size();
        }
        for (const Field& f : fields) out += f.bytes;
        return out;
    }
};

inline std::vector<float> even_angles(std::size_t count, double from, double to) {
    std::vector<float> out;
    for (std::size_t i = 0; i < count; ++i)
        out.push_back(static_cast<float>(count == 1 ? from
                                                    : from + (to - from) * static_cast<double>(i) /
                                                                 static_cast<double>(count - 1)));
    return out;
}

/// Mueller matrix in s-frames by wavelength index, direction to the light and direction to the viewer.
/// make_pbsdf() writes NaN below the horizon and does not call it there.
using SFrameMueller = std::function<Mueller(std::size_t, const glm::dvec3&, const glm::dvec3&)>;

inline PbsdfFile make_pbsdf(const std::vector<float>& phi_d, const std::vector<float>& theta_d,
                            const std::vector<float>& theta_h, const std::vector<std::uint16_t>& wavelengths,
                            const SFrameMueller& mueller) {
    std::vector<float> m;
    for (const float phi : phi_d) {
        for (const float d : theta_d) {
            for (const float h : theta_h) {
                const auto a = static_cast<double>(h);
                const auto b = static_cast<double>(d);
                const auto c = static_cast<double>(phi);
                const glm::dvec3 half(std::sin(a), 0, std::cos(a));
                const glm::dvec3 across(0, 1, 0);
                const glm::dvec3 along(std::cos(a), 0, -std::sin(a));
                const glm::dvec3 light =
                    std::cos(b) * half + std::sin(b) * (std::cos(c) * along + std::sin(c) * across);
                const glm::dvec3 viewer = 2 * glm::dot(half, light) * half - light;
                for (std::size_t w = 0; w < wavelengths.size(); ++w) {
                    const bool there = light.z > 1e-6 && viewer.z > 1e-6;
                    const Mueller value = there ? mueller(w, light, viewer) : Mueller();
                    for (std::size_t e = 0; e < 16; ++e)
                        m.push_back(there ? static_cast<float>(value(e / 4, e % 4)) : std::nanf(""));
                }
            }
        }
    }
    PbsdfFile file;
    file.add("theta_h", {1, theta_h.size()}, 10, theta_h);
    file.add("theta_d", {1, theta_d.size()}, 10, theta_d);
    file.add("phi_d", {1, phi_d.size()}, 10, phi_d);
    file.add("wvls", {1, wavelengths.size()}, 3, wavelengths);
    file.add("M", {phi_d.size(), theta_d.size(), theta_h.size(), wavelengths.size(), 4, 4}, 10, m);
    return file;
}

}  // namespace nicol::test
