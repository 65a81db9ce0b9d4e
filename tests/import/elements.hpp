// SPDX-License-Identifier: MIT
// Polarization elements in scene files for tests.
#pragma once

#include "import/scene_file.hpp"

inline std::string to_world(const std::string& operations) {
    return "<transform name='to_world'>" + operations + "</transform>";
}

inline std::string number(const char* name, double value) {
    return "<float name='" + std::string(name) + "' value='" + std::to_string(value) + "'/>";
}

inline std::string polarizer(double theta, const std::string& more = "") {
    return "<bsdf type='polarizer'>" + number("theta", theta) + more + "</bsdf>";
}

inline std::string retarder(double theta, double delta) {
    return "<bsdf type='retarder'>" + number("theta", theta) + number("delta", delta) + "</bsdf>";
}

inline const std::string right = "<bsdf type='circular'/>";
inline const std::string left = "<bsdf type='circular'><boolean name='left_handed' value='true'/></bsdf>";

/// Returns a rectangle of half side 1 at height z above the lamp, transformed by `operations` first.
inline std::string element(const std::string& bsdf, double z, const std::string& operations = "",
                           const std::string& more = "") {
    return "<shape type='rectangle'>" + bsdf + more +
           to_world(operations + "<translate z='" + std::to_string(z) + "'/>") + "</shape>";
}

inline const std::string backwards = "<rotate y='1' angle='180'/>";
inline const std::string flipped = "<boolean name='flip_normals' value='true'/>";

inline void check_near(const nicol::Stokes& a, const nicol::Stokes& b, double tolerance) {
    CAPTURE(a);
    CAPTURE(b);
    CHECK(glm::distance(a, b) < tolerance);
}
