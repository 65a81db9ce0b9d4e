// SPDX-License-Identifier: MIT
#include "scene_files.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <random>

#include "common/failure.hpp"

namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("nicol-scenes-" + std::to_string(std::random_device()()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    fs::path write(const std::string& name, const std::string& content) const {
        fs::create_directories((path / name).parent_path());
        std::ofstream(path / name) << content;
        return path / name;
    }
};

}  // namespace

TEST_CASE("every XML file of a folder is a scene") {
    const Folder folder;
    CHECK_THROWS_AS(find_scenes(folder.path), Failure);
    CHECK_THROWS_AS(find_scenes(folder.path / "none"), Failure);
    folder.write("b.xml", "");
    folder.write("a-1_x.y.xml", "");
    folder.write("c.ply", "");
    const std::vector<fs::path> scenes = find_scenes(folder.path);
    REQUIRE(scenes.size() == 2);
    CHECK(scenes[0].filename() == "a-1_x.y.xml");
    folder.write("no good.xml", "");
    CHECK_THROWS_AS(find_scenes(folder.path), Failure);
}

TEST_CASE("a digest follows every file that the scene names") {
    const Folder folder;
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
    const Folder copy;
    fs::copy(folder.path, copy.path, fs::copy_options::recursive);
    CHECK(scene_digest(copy.path / "a.xml") == digest);
}
