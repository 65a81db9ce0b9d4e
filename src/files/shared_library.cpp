// SPDX-License-Identifier: MIT
// dlopen with the reasons kept.
#include "files/shared_library.hpp"

#include <dlfcn.h>

#include <cerrno>
#include <new>

namespace nicol {

SharedLibrary::SharedLibrary(std::initializer_list<const char*> names, ErrorCode absent) : absent_(absent) {
    std::string reasons;
    bool lacks_memory = false;
    for (const char* name : names) {
        // RTLD_LOCAL: libOSMesa exports every gl* function and would take over a host's libGL.
        errno = 0;
        handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (handle_ != nullptr) {
            name_ = name;
            return;
        }
        // The words of the loader do not always say why it cannot map a library.
        lacks_memory = lacks_memory || errno == ENOMEM;
        const char* reason = dlerror();
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
