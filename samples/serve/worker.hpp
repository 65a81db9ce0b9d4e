// SPDX-License-Identifier: MIT
// A worker process: holds every scene warm and renders what the front process asks for.
#pragma once

#include "options.hpp"

/// Talks through this socket until the other end closes it. Returns the process's exit code.
int run_worker(int socket, const Options& options);
