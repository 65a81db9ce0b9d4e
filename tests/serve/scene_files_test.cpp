// SPDX-License-Identifier: MIT
#include "scene_files.hpp"

#include <doctest/doctest.h>

#include <filesystem>

#include "common/failure.hpp"
#include "temporary_folder.hpp"

namespace fs = std::filesystem;

TEST_CASE("every XML and glTF file of a folder is a scene") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(find_scenes(folder.path()), Failure);
    CHECK_THROWS_AS(find_scenes(folder / "none"), Failure);
    folder.write("b.xml", "");
    folder.write("a-1_x.y.xml", "");
    folder.write("c.ply", "");
    const std::vector<fs::path> scenes = find_scenes(folder.path());
    REQUIRE(scenes.size() == 2);
    CHECK(scenes[0].filename() == "a-1_x.y.xml");
    folder.write("d.gltf", "");
    folder.write("e.glb", "");
    CHECK(find_scenes(folder.path()).size() == 4);
    folder.write("b.glb", "");
    CHECK_THROWS_WITH_AS(find_scenes(folder.path()), doctest::Contains("b.glb and b.xml"), Failure);
    std::filesystem::remove(folder / "b.glb");
    folder.write("no good.xml", "");
    CHECK_THROWS_AS(find_scenes(folder.path()), Failure);
}
