// SPDX-License-Identifier: MIT
// Limit of oneTBB to the calling thread, for ThreadSanitizer.
#pragma once

#ifdef __SANITIZE_THREAD__
#include <tbb/global_control.h>
// oneTBB is not instrumented, so handing work to its threads looks like a race. With this limit every loop
// runs on the thread that started it.
static const tbb::global_control no_workers(tbb::global_control::max_allowed_parallelism, 1);
#endif
