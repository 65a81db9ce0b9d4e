// SPDX-License-Identifier: MIT
// Lights that need high orders.
#pragma once

#include <nicol.h>

#include <filesystem>

/// Writes the light of a room with four lamps, each about 1,800 times the mean.
void write_lamp_room(const std::filesystem::path& path, nicol_backend backend);

/// Writes the light of a room with one such lamp, 45 degrees high and behind what a camera on the positive z
/// axis sees.
void write_lamp_behind(const std::filesystem::path& path, nicol_backend backend);
