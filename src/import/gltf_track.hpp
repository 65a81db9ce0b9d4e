// SPDX-License-Identifier: MIT
// Values of one animation channel of a glTF file over time.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "files/load_budget.hpp"
#include "import/gltf_document.hpp"

namespace nicol::scene {

/// Returns the value of an animation sampler at a time in seconds, as glTF 2.0 interpolates it (appendix C).
/// size: numbers per value; 0: as many as the sampler has. rotation: whether values are quaternions x, y, z,
/// w, whose result has unit length. Throws Error(invalid_file) beginning with the file and `where` for times
/// that do not ascend, counts that do not fit, and numbers that are not finite.
[[nodiscard]] std::vector<double> gltf_track_value(const GltfDocument& document,
                                                   const tinygltf::AnimationSampler& sampler, double time,
                                                   std::size_t size, bool rotation, const std::string& where,
                                                   const LoadBudget& budget);

}  // namespace nicol::scene
