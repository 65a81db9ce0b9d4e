// SPDX-License-Identifier: MIT
// JSON of --stats.
#pragma once

#include <nicol.h>

#include <cstdint>
#include <string>

/// Returns one JSON object with the names of samples/render/README.md.
std::string stats_json(const nicol_context_info& context, std::uint32_t width, std::uint32_t height,
                       std::uint32_t channels, const nicol_statistics& statistics);

/// Writes a file; kStandardOutput is the standard output. The text is written in place, because it is short
/// and useless without the picture of its run. Throws Failure.
void write_file(const std::string& path, const std::string& content);
