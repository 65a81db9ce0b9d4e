// SPDX-License-Identifier: MIT
// The code of tinygltf, which is a header. Compiled here because a shared library of it would open images.
#include <fstream>  // which it leaves out of what writes files

#include "scene/json.hpp"

namespace nicol::scene::tiny_json {
using json = Json;
}

// tinygltf calls its values nlohmann::json, which cannot be destroyed where memory is short.
#define TINYGLTF_NO_INCLUDE_JSON
#define nlohmann nicol::scene::tiny_json
#define TINYGLTF_IMPLEMENTATION
#include "scene/tiny_gltf.hpp"
