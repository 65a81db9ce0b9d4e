// SPDX-License-Identifier: MIT
// A window-less OpenGL context of one system library, current on the thread that made it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/context.hpp"

namespace nicol::gl {

/// Made, used and destroyed on one thread that uses no other kind of platform: Mesa's libraries share their
/// thread-local dispatch table. Destruction releases the context before destroying it.
class Platform {
public:
    virtual ~Platform() = default;
    using Function = void (*)();
    /// Non-null even for names that do not exist: check version and extensions instead.
    [[nodiscard]] virtual Function function(const char* name) const = 0;
};

/// An EGL display to try.
struct EglChoice {
    std::optional<int> device;  ///< position in the device list; none is Mesa's surfaceless platform
    std::string name;           ///< for messages
};

struct EglChoices {
    std::vector<EglChoice> choices;  ///< hardware first, then software, then surfaceless
    std::string no_device;           ///< why there is no device among them, or empty
    int devices = 0;                 ///< length of EGL's device list
};

/// Throws Error(no_backend) if there is no libEGL.
[[nodiscard]] EglChoices find_egl_choices();
/// Both throw Error(no_backend) with the reason.
[[nodiscard]] std::unique_ptr<Platform> make_egl_platform(const EglChoice& choice);
[[nodiscard]] std::unique_ptr<Platform> make_osmesa_platform();

}  // namespace nicol::gl
