// SPDX-License-Identifier: MIT
// States of a host's OpenGL in which nothing can be drawn, or which cannot be restored.
#pragma once

#include "gl/state.hpp"

namespace nicol::gl {

/// Both throw Error(unsupported), which names the state, with the context current.
void require_drawable(const Context::State& state);
/// For conditional rendering, with no error pending.
void require_unconditional(const Context::State& state);

}  // namespace nicol::gl
