// SPDX-License-Identifier: MIT
// Libraries opened at run time. They are never closed, because Mesa leaves threads and exit handlers behind.
#pragma once

#include <initializer_list>
#include <string>

#include "error.hpp"

namespace nicol {

class SharedLibrary {
public:
    /// Opens the first of the names that can be opened. Its symbols are not visible to other libraries.
    /// Throws an error with the code `absent` and the linker's reason for each name.
    SharedLibrary(std::initializer_list<const char*> names, ErrorCode absent);

    [[nodiscard]] const std::string& name() const noexcept { return name_; }

    /// Returns the function of the library itself, whatever other libraries define under that name. Throws an
    /// error with the code `absent` if the library lacks it.
    template <class Function>
    [[nodiscard]] Function function(const char* symbol) const {
        return reinterpret_cast<Function>(find(symbol));
    }

private:
    [[nodiscard]] void* find(const char* symbol) const;

    ErrorCode absent_;
    void* handle_ = nullptr;
    std::string name_;
};

}  // namespace nicol
