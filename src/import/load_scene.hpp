// SPDX-License-Identifier: MIT
// Loading of scene files.
#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "files/load_budget.hpp"
#include "image/reconstruction_filter.hpp"
#include "import/scene_description.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace nicol {

struct LoadedScene {
    Scene scene;
    Camera camera;
    int width = 0;  ///< width of the film or its crop, pixels
    int height = 0;
    bool luminance = false;                ///< the film has one channel
    std::uint32_t sample_count = 0;        ///< samples of a pixel that the file asks for; 0: it does not say
    ReconstructionFilter filter;           ///< filter of the film
    int max_depth = 0;                     ///< see IntegratorDescription
    std::uint32_t aovs = 0;                ///< bits of AovBit that the file asks for
    std::optional<MovingScene> animation;  ///< none: nothing moves
    std::vector<FileRecord> files;         ///< all that were read, as they were then; the scene file first
    std::vector<std::string> notices;      ///< elements without effect, and assumptions; one line each
};

/// Reads a scene file and all files that it names. The format is glTF for the suffixes .gltf and .glb, and
/// Mitsuba's XML for others. The environment determines the channels of colours; with a grey one or none they
/// are red, green and blue. Shapes of the same file share a mesh. Lights have the Stokes state that
/// elements give them, see put_elements_before_lights(). Throws what read_mitsuba_scene(),
/// read_gltf_scene() and the readers of images, meshes and materials throw, and what LoadBudget throws.
[[nodiscard]] LoadedScene load_scene(const std::filesystem::path& file, const SceneParameters& parameters,
                                     const LoadBudget& budget = {});

/// Returns the camera of a sensor.
[[nodiscard]] Camera camera_of(const SensorDescription& sensor);
/// Returns the rotation and the shift of a light's transform, of which other parts have no effect. Throws
/// Error(unsupported) unless the matrix has a rotation.
[[nodiscard]] glm::dmat4 light_placement(const glm::dmat4& to_world);

}  // namespace nicol
