// SPDX-License-Identifier: MIT
// A worker process, which keeps every scene baked and renders the front process's requests.
#pragma once

#include "options.hpp"

/// Serves requests from this socket until the other end closes it. Returns the process's exit code.
int run_worker(int socket, const Options& options);
