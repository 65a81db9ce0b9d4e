// SPDX-License-Identifier: MIT
#include "scene_files.hpp"

#include <doctest/doctest.h>

#include <filesystem>

#include "common/failure.hpp"
#include "temporary_folder.hpp"

namespace fs = std::filesystem;

TEST_CASE("every XML file of a folder is a scene") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(find_scenes(folder.path()), Failure);
    CHECK_THROWS_AS(find_scenes(folder / "none"), Failure);
    folder.write("b.xml", "");
    folder.write("a-1_x.y.xml", "");
    folder.write("c.ply", "");
    const std::vector<fs::path> scenes = find_scenes(folder.path());
    REQUIRE(scenes.size() == 2);
    CHECK(scenes[0].filename() == "a-1_x.y.xml");
    folder.write("no good.xml", "");
    CHECK_THROWS_AS(find_scenes(folder.path()), Failure);
}

TEST_CASE("a digest follows every file that the scene names") {
    const TemporaryFolder folder;
    const fs::path scene =
        folder.write("a.xml",
                     "<scene><default name=\"mesh\" value=\"m\"/><default value='1' name='w'/>"
                     "<string value=\"$mesh.ply\"/><string value='light_s0.exr'/>"
                     "<include filename=\"part/b.xml\"/><string value=\"absent.ply\"/></scene>");
    folder.write("m.ply", "1");
    folder.write("light_s0.exr", "1");
    folder.write("light_s3.exr", "1");
    folder.write("part/b.xml", "<scene><string value=\"c.ply\"/></scene>");
    folder.write("part/c.ply", "1");
    folder.write("other.ply", "1");
    std::string digest = scene_digest(scene);
    CHECK(digest.size() == 64);
    CHECK(digest == scene_digest(scene));
    for (const char* name : {"m.ply", "light_s0.exr", "light_s3.exr", "part/b.xml", "part/c.ply"}) {
        folder.write(name, "2");
        const std::string changed = scene_digest(scene);
        CHECK_MESSAGE(changed != digest, name);
        digest = changed;
        if (std::string(name) == "part/b.xml") {
            folder.write(name, "<scene><string value=\"c.ply\"/></scene>");
            digest = scene_digest(scene);
        }
    }
    folder.write("other.ply", "2");
    CHECK(digest == scene_digest(scene));
    // Elsewhere the same files have the same digest.
    const TemporaryFolder copy;
    fs::copy(folder.path(), copy.path(), fs::copy_options::recursive);
    CHECK(scene_digest(copy / "a.xml") == digest);
}
