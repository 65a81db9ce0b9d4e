// SPDX-License-Identifier: MIT
// A worker process: keeps every scene baked and renders the front process's requests.
#pragma once

#include "options.hpp"

/// Talks through this socket until the other end closes it. Returns the process's exit code.
int run_worker(int socket, const Options& options);
