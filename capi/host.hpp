// SPDX-License-Identifier: MIT
// What contexts of our own and of hosts share on their way to a handle.
#pragma once

#include <memory>

#include "gl/context.hpp"
#include "nicol.h"

namespace nicol::capi {

/// The caller's options, or the defaults for NULL. Throws Error(invalid_argument) naming what is out of
/// range.
nicol_context_options context_options(const nicol_context_options* options);
/// A handle with one reference.
nicol_context make_context(std::shared_ptr<gl::Context> context, const nicol_context_options& options);

}  // namespace nicol::capi
