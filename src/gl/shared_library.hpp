// SPDX-License-Identifier: MIT
// A library opened at run time and never closed: Mesa leaves threads and exit handlers behind.
#pragma once

#include <initializer_list>
#include <string>

namespace nicol::gl {

class SharedLibrary {
public:
    /// The first of the names that opens. Throws Error(no_backend) with the linker's reason for each.
    explicit SharedLibrary(std::initializer_list<const char*> names);

    /// Throws Error(no_backend) if the library lacks the symbol.
    template <class Function>
    [[nodiscard]] Function function(const char* symbol) const {
        return reinterpret_cast<Function>(find(symbol));
    }

private:
    [[nodiscard]] void* find(const char* symbol) const;

    void* handle_ = nullptr;
    std::string name_;
};

}  // namespace nicol::gl
