// SPDX-License-Identifier: MIT
// MirrorBasis on the device.
#pragma once

#include <memory>

#include "gl/buffer.hpp"
#include "harmonics/mirror_basis.hpp"

namespace nicol {

/// Rows as in glsl/sparse.glsl: one for each number of a split light, made of a packed light.
[[nodiscard]] gl::Buffer split_rows(const std::shared_ptr<gl::Context>& context, const MirrorBasis& basis);
/// One for each number of a packed light, made of a split light.
[[nodiscard]] gl::Buffer join_rows(const std::shared_ptr<gl::Context>& context, const MirrorBasis& basis);

}  // namespace nicol
