// SPDX-License-Identifier: MIT
// A light that needs high orders.
#pragma once

#include <nicol.h>

#include <filesystem>

/// Writes the light of a room with four lamps, each about 1,800 times the mean.
void write_lamp_room(const std::filesystem::path& path, nicol_backend backend);
