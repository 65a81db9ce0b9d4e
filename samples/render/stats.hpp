// SPDX-License-Identifier: MIT
// The JSON of --stats.
#pragma once

#include <nicol.h>

#include <string>

/// One JSON object; every number under the name it has in samples/render/README.md.
std::string stats_json(const nicol_context_info& context, std::uint32_t width, std::uint32_t height,
                       std::uint32_t channels, const nicol_statistics& statistics);

/// kStandardOutput is the standard output. The text is written in place: it is short, and without the picture
/// of its run it is of no use. Throws Failure.
void write_file(const std::string& path, const std::string& content);
