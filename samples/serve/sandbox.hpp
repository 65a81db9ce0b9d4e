// SPDX-License-Identifier: MIT
// Confinement of a worker by Landlock. A scene that exploits a fault of a reader reaches no other files and
// no network.
#pragma once

#include "options.hpp"

/// Returns whether the kernel supports the confinement.
bool can_confine();

/// Confines this process: from now on it reads only the scenes, --read, and system files that OpenGL's
/// drivers need, writes only to the cache, runs no program and uses no TCP. Must be called before threads
/// start. Throws Failure.
void confine(const Options& options);
