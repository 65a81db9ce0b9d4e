// SPDX-License-Identifier: MIT
// Visibility kept on disk.
#include "visibility/bake_cache.hpp"

#include "geometry/mesh.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

// Two sheets, one above the other.
Mesh scene() {
    Mesh mesh = make_rectangle(2);
    const std::size_t count = mesh.positions.size();
    for (std::size_t v = 0; v < count; ++v) {
        mesh.positions.push_back(mesh.positions[v] + glm::vec3(0.5F, 0, 1));
        mesh.normals.push_back(mesh.normals[v]);
    }
    const std::size_t triangles = mesh.triangles.size();
    for (std::size_t t = 0; t < triangles; ++t) {
        mesh.triangles.push_back(mesh.triangles[t] + static_cast<std::uint32_t>(count));
    }
    return mesh;
}

bool same(const Visibility& a, const Visibility& b) {
    return a.directions() == b.directions() && std::ranges::equal(a.bits(), b.bits()) &&
           std::ranges::equal(a.unoccluded(), b.unoccluded());
}

struct Baked {
    Visibility visibility;
    BakeStatistics statistics;
    std::vector<std::string> notices;
};

Baked bake_with(const Mesh& mesh, const DirectionSet& directions, const std::filesystem::path& folder) {
    Baked out;
    out.visibility = load_or_bake(
        {mesh.positions, mesh.normals, mesh.triangles}, directions, folder,
        [&](const std::string& notice) { out.notices.push_back(notice); }, {}, &out.statistics);
    return out;
}

const DirectionSet& few() {
    static const DirectionSet set(300);
    return set;
}

}  // namespace

TEST_CASE("what was baked comes back from the cache as it was") {
    const TemporaryFolder scratch;
    const auto folder = scratch / "made/on/demand";
    const Baked first = bake_with(scene(), few(), folder);
    CHECK_FALSE(first.statistics.from_cache);
    CHECK(first.statistics.rays > 0);
    const Baked second = bake_with(scene(), few(), folder);
    CHECK(second.statistics.from_cache);
    CHECK(second.statistics.rays == 0);
    CHECK(second.statistics.unoccluded == first.statistics.unoccluded);
    CHECK(same(first.visibility, second.visibility));
    CHECK(first.notices.empty());
    CHECK(second.notices.empty());
    CHECK(files_in(folder).size() == 1);
}

TEST_CASE("without a folder nothing is written") {
    const Baked baked = bake_with(scene(), few(), {});
    CHECK_FALSE(baked.statistics.from_cache);
    CHECK(baked.notices.empty());
}

TEST_CASE("another geometry or other directions have a file of their own") {
    const TemporaryFolder scratch;
    static_cast<void>(bake_with(scene(), few(), scratch.path()));
    std::size_t files = 1;
    const auto is_new = [&](const Mesh& mesh, const DirectionSet& directions) {
        const Baked baked = bake_with(mesh, directions, scratch.path());
        CHECK_FALSE(baked.statistics.from_cache);
        CHECK(baked.notices.empty());
        CHECK(files_in(scratch.path()).size() == ++files);
    };
    Mesh mesh = scene();
    mesh.positions[3].y += 1e-6F;
    is_new(mesh, few());
    mesh = scene();
    mesh.normals[2] = {0, 1, 0};
    is_new(mesh, few());
    mesh = scene();
    std::swap(mesh.triangles[0], mesh.triangles[5]);
    is_new(mesh, few());
    is_new(scene(), DirectionSet(301));
}

TEST_CASE("what is stale, damaged, truncated or foreign is baked anew with a notice") {
    const TemporaryFolder scratch;
    const Baked good = bake_with(scene(), few(), scratch.path());
    const auto file = files_in(scratch.path()).front();
    const std::string bytes = file_bytes(file);
    const auto rebuilt = [&](const std::string& other) {
        write_bytes(file, other);
        const Baked baked = bake_with(scene(), few(), scratch.path());
        CHECK_FALSE(baked.statistics.from_cache);
        REQUIRE(baked.notices.size() == 1);
        CHECK(baked.notices[0].find(file.string()) == 0);
        CHECK(same(good.visibility, baked.visibility));
        CHECK(file_bytes(file) == bytes);
    };
    std::string stale = bytes;
    stale[8] ^= 1;
    rebuilt(stale);
    rebuilt(bytes.substr(0, bytes.size() - 1));
    // Another geometry's file under this one's name.
    Mesh mesh = scene();
    mesh.positions[0].x += 0.5F;
    static_cast<void>(bake_with(mesh, few(), scratch.path()));
    for (const auto& foreign : files_in(scratch.path())) {
        if (foreign != file) rebuilt(file_bytes(foreign));
    }
}

TEST_CASE("a folder that cannot be used is a notice, and cancelling leaves no file") {
    const TemporaryFolder scratch;
    std::ofstream(scratch / "file") << "x";
    const Baked baked = bake_with(scene(), few(), scratch / "file");
    CHECK(baked.notices.size() == 1);
    CHECK(baked.statistics.rays > 0);

    const Mesh mesh = scene();
    const auto folder = scratch / "cancelled";
    CHECK_THROWS_AS(load_or_bake({mesh.positions, mesh.normals, mesh.triangles}, few(), folder, {},
                                 [](double) { throw Error(ErrorCode::cancelled, "enough"); }),
                    Error);
    CHECK_FALSE(std::filesystem::exists(folder));
}
