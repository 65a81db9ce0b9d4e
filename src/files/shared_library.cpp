// SPDX-License-Identifier: MIT
// dlopen with the reasons kept.
#include "files/shared_library.hpp"

#include <dlfcn.h>

#include <cerrno>
#include <new>
#include <system_error>

namespace nicol {

SharedLibrary::SharedLibrary(std::initializer_list<const char*> names, ErrorCode absent) : absent_(absent) {
    std::string reasons;
    for (const char* name : names) {
        // RTLD_LOCAL: libOSMesa exports every gl* function and would take over a host's libGL.
        handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (handle_ != nullptr) {
            name_ = name;
            return;
        }
        const char* reason = dlerror();
        reasons += reasons.empty() ? "" : "; ";
        reasons += reason != nullptr ? reason : name;
    }
    // The loader has no other sign that it lacked memory than its words.
    if (reasons.find(std::generic_category().message(ENOMEM)) != std::string::npos) throw std::bad_alloc();
    throw Error(absent_, "the library cannot be opened: " + reasons);
}

void* SharedLibrary::find(const char* symbol) const {
    void* address = dlsym(handle_, symbol);
    if (address == nullptr) throw Error(absent_, name_ + " lacks the function " + symbol);
    return address;
}

}  // namespace nicol
