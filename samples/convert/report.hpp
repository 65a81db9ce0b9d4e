// SPDX-License-Identifier: MIT
// Reports on files, as text and as JSON.
#pragma once

#include <nicol_files.h>

#include <cstdint>
#include <string>
#include <vector>

struct LightReport {
    std::string file;
    nicol_light_report numbers = NICOL_LIGHT_REPORT_INIT;
    std::vector<double> energy;  ///< [channel][l][4]
};

struct MaterialReport {
    std::string file;
    nicol_material_report numbers = NICOL_MATERIAL_REPORT_INIT;
    std::vector<double> energy;  ///< [channel][l]
};

/// Returns a name such as "light as coefficients (SHVec .npz)".
std::string kind_name(nicol_file_kind kind);
/// Returns the names R, G, B; Y; wavelengths such as 550 nm; or numbers.
std::vector<std::string> channel_names(std::uint32_t channels, const double* wavelengths);

std::string as_text(const LightReport& report);
std::string as_text(const MaterialReport& report);
/// Returns one JSON object with the names of samples/convert/README.md.
std::string as_json(const LightReport& report);
std::string as_json(const MaterialReport& report);
