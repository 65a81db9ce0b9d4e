// SPDX-License-Identifier: MIT
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#define DOCTEST_CONFIG_IMPLEMENT  // follows from the line above unless test.hpp is precompiled
#include <doctest/doctest.h>

#ifdef NICOL_SANITIZED
// The LeakSanitizer of LLVM 14 and of GCC 12 crashes when it follows thread-local memory of libraries opened
// at run time, such as Embree. GCC's sanitizer is a library, which looks up this function in the program.
extern "C" [[gnu::visibility("default")]] const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
    return "intercept_tls_get_addr=0";
}
#endif
