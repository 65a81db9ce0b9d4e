// SPDX-License-Identifier: MIT
// The half of a sphere that faces an orthographic camera.
#pragma once

#include <filesystem>

/// Of the unit sphere, z >= 0, as OBJ: a vertex at the top and `rings` circles of 6, 12, 18 ... vertices
/// around it, with the sphere's own normals; all triangles are of about the same size.
void write_sphere_cap(const std::filesystem::path& path, int rings);
