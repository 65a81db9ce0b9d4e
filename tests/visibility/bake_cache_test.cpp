// SPDX-License-Identifier: MIT
// Tests of visibility kept on disk.
#include "visibility/bake_cache.hpp"

#include "files/cache_checks.hpp"
#include "geometry/mesh.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

// Returns two sheets, one above the other.
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

test::CacheUse<Visibility> bake_with(const Mesh& mesh, const DirectionSet& directions,
                                     const std::filesystem::path& folder) {
    std::vector<std::string> notices;
    BakeStatistics statistics;
    Visibility visibility = load_or_bake(
        {mesh.positions, mesh.normals, mesh.triangles}, directions, folder,
        [&](const std::string& notice) { notices.push_back(notice); }, {}, &statistics);
    CHECK(statistics.from_cache == (statistics.rays == 0));
    CHECK(statistics.unoccluded == visibility.unoccluded_count());
    return {std::move(visibility), !statistics.from_cache, notices};
}

bool same(const Refinement& a, const Refinement& b) {
    return a.parents == b.parents && a.triangles == b.triangles && a.sources == b.sources &&
           same(a.visibility, b.visibility);
}

test::CacheUse<Refinement> refine_with(const Mesh& mesh, const DirectionSet& directions, double tolerance,
                                       const std::filesystem::path& folder) {
    const BakeGeometry geometry{mesh.positions, mesh.normals, mesh.triangles};
    std::vector<std::string> notices;
    BakeStatistics statistics;
    Refinement refinement = load_or_refine(
        geometry, directions, bake(geometry, directions), {.tolerance = tolerance, .max_vertices = 500},
        folder, [&](const std::string& notice) { notices.push_back(notice); }, {}, statistics);
    CHECK(refinement.parents.size() > 20);
    return {std::move(refinement), statistics.rays > 0, notices};
}

const DirectionSet& few() {
    static const DirectionSet set(300);
    return set;
}

}  // namespace

TEST_CASE("what was baked comes back from the cache as it was, and files that cannot be used are notices") {
    test::check_cache([](const std::filesystem::path& folder) { return bake_with(scene(), few(), folder); },
                      [](const Visibility& a, const Visibility& b) { return same(a, b); });
}

TEST_CASE("so does what was refined, of each tolerance in a file of its own") {
    test::check_cache(
        [](const std::filesystem::path& folder) { return refine_with(scene(), few(), 0.02, folder); },
        [](const Refinement& a, const Refinement& b) { return same(a, b); });
    const TemporaryFolder scratch;
    CHECK(refine_with(scene(), few(), 0.02, scratch.path()).computed);
    CHECK(refine_with(scene(), few(), 0.03, scratch.path()).computed);
    CHECK(!refine_with(scene(), few(), 0.02, scratch.path()).computed);
}

TEST_CASE("another geometry or other directions have a file of their own") {
    const TemporaryFolder scratch;
    static_cast<void>(bake_with(scene(), few(), scratch.path()));
    std::size_t files = 1;
    const auto is_new = [&](const Mesh& mesh, const DirectionSet& directions) {
        const auto baked = bake_with(mesh, directions, scratch.path());
        CHECK(baked.computed);
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

TEST_CASE("cancelling leaves no file") {
    const TemporaryFolder scratch;
    const Mesh mesh = scene();
    const auto folder = scratch / "cancelled";
    CHECK_THROWS_AS(load_or_bake({mesh.positions, mesh.normals, mesh.triangles}, few(), folder, {},
                                 [](double) { throw Error(ErrorCode::cancelled, "enough"); }),
                    Error);
    CHECK_FALSE(std::filesystem::exists(folder));
}
