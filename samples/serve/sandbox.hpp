// SPDX-License-Identifier: MIT
// Confines a worker by Landlock: a scene that turns a reader's fault to its own ends finds no other files
// and no network.
#pragma once

#include "options.hpp"

/// Whether the kernel can.
bool can_confine();

/// From here on this process reads nothing but the scenes, --read, what OpenGL's drivers need of the system,
/// writes to the cache alone, runs no program and uses no TCP. Throws Failure. Call it
/// before there are threads.
void confine(const Options& options);
