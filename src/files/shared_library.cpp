// SPDX-License-Identifier: MIT
// Opening of shared libraries by dlopen(), with the reasons of failures kept.
#include "files/shared_library.hpp"

#include <dlfcn.h>

#include <cerrno>
#include <new>
#include <string_view>
#include <system_error>

namespace nicol {
namespace {

/// Returns whether the loader lacked memory. The text is the loader's only sign of it. If the loader cannot
/// map a library for another reason, it appends that reason to the text.
bool tells_of_shortage(std::string_view reason) {
    return reason.ends_with("failed to map segment from shared object") ||
           reason.find(std::generic_category().message(ENOMEM)) != std::string_view::npos;
}

}  // namespace

SharedLibrary::SharedLibrary(std::initializer_list<const char*> names, ErrorCode absent) : absent_(absent) {
    std::string reasons;
    bool lacks_memory = false;
    for (const char* name : names) {
        // RTLD_LOCAL is necessary because libOSMesa exports every gl* function and would take over a host's
        // libGL.
        handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (handle_ != nullptr) {
            name_ = name;
            return;
        }
        const char* reason = dlerror();
        lacks_memory = lacks_memory || (reason != nullptr && tells_of_shortage(reason));
        reasons += reasons.empty() ? "" : "; ";
        reasons += reason != nullptr ? reason : name;
    }
    if (lacks_memory) throw std::bad_alloc();
    throw Error(absent_, "the library cannot be opened: " + reasons);
}

void* SharedLibrary::find(const char* symbol) const {
    void* address = dlsym(handle_, symbol);
    if (address == nullptr) throw Error(absent_, name_ + " lacks the function " + symbol);
    return address;
}

}  // namespace nicol
