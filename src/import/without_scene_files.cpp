// SPDX-License-Identifier: MIT
// Scene files in builds without them.
#include "files/file_error.hpp"
#include "import/load_scene.hpp"

namespace nicol {

LoadedScene load_scene(const std::filesystem::path& file, const SceneParameters& /*parameters*/,
                       const LoadBudget& /*budget*/) {
    refuse_left_out_format(file, "scene files", "NICOL_SCENE_FILES");
}

// No scene has been loaded.
void MovingScene::set_time(double /*time*/, const LoadBudget& /*budget*/, Scene& /*scene*/,
                           Camera& /*camera*/) {}

}  // namespace nicol
