// SPDX-License-Identifier: MIT
// validate() for meshes whose triangles come from polygons.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "geometry/mesh.hpp"

namespace nicol::geometry {

/// As validate(). Messages name faces[t] in place of triangle t; empty `faces`: the triangle itself.
void validate(Mesh& mesh, std::string_view name, std::span<const std::uint32_t> faces);

}  // namespace nicol::geometry
