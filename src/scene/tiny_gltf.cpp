// SPDX-License-Identifier: MIT
// The code of tinygltf, which is a header. Compiled here because a shared library of it would open images.
#include <fstream>  // which it leaves out of what writes files

#define TINYGLTF_IMPLEMENTATION
#include "scene/tiny_gltf.hpp"
