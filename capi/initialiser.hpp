// SPDX-License-Identifier: MIT
// Defaults of structs at run time: nicol_<type>_init(), beside the functions that read the struct.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "boundary.hpp"

namespace nicol::capi {

/// Fills a descriptor of the caller's size with defaults.
template <class T>
nicol_result initialise(T* descriptor, const T& defaults, std::uint32_t struct_size) noexcept {
    return guarded([&] {
        require(descriptor, "descriptor");
        constexpr bool sized = requires {
            descriptor->struct_size;
        };
        if (sized ? !may_be_size<T>(struct_size) : struct_size != sizeof defaults) {
            refuse("struct_size is " + std::to_string(struct_size) + "; it must be sizeof(the struct), " +
                   std::to_string(sizeof defaults) + " in this version");
        }
        // Fields that only a newer caller has are 0, as read_struct() demands.
        std::memset(descriptor, 0, struct_size);
        std::memcpy(descriptor, &defaults, std::min<std::size_t>(struct_size, sizeof defaults));
        if constexpr (sized) descriptor->struct_size = struct_size;
    });
}

}  // namespace nicol::capi

/// Defines nicol_<type>_init(), given the struct's NICOL_<TYPE>_INIT. Static defaults have zeros between
/// fields, too.
#define NICOL_INITIALISER(type, ...)                                       \
    nicol_result type##_init(type* descriptor, uint32_t struct_size) {     \
        static constexpr type defaults = __VA_ARGS__;                      \
        return nicol::capi::initialise(descriptor, defaults, struct_size); \
    }
