// SPDX-License-Identifier: MIT
// A window-less OpenGL context of one system library, current on the thread that made it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/context.hpp"

namespace nicol::gl {

/// OpenGL context of a system library. Must be made, used and destroyed on one thread that uses no other kind
/// of platform, because Mesa's libraries share their thread-local dispatch table. Destruction releases the
/// context before destroying it.
class Platform {
public:
    virtual ~Platform() = default;
    using Function = void (*)();
    /// Returns a function. The result is non-null even for unknown names; check version and extensions
    /// instead.
    [[nodiscard]] virtual Function function(const char* name) const = 0;
};

/// An EGL display to try.
struct EglChoice {
    std::optional<int> device;  ///< position in the device list; empty: Mesa's surfaceless platform
    std::string name;           ///< name for messages
};

struct EglChoices {
    std::vector<EglChoice> choices;  ///< ordered: hardware first, then software, then surfaceless
    std::string no_device;           ///< reason why there is no device among the choices, or empty
    int devices = 0;                 ///< length of EGL's device list
};

/// Returns the EGL displays to try. Throws Error(no_backend) if there is no libEGL.
[[nodiscard]] EglChoices find_egl_choices();
/// Both functions make a platform and throw Error(no_backend) with the reason if they cannot.
[[nodiscard]] std::unique_ptr<Platform> make_egl_platform(const EglChoice& choice);
[[nodiscard]] std::unique_ptr<Platform> make_osmesa_platform();

}  // namespace nicol::gl
