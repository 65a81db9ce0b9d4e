// SPDX-License-Identifier: MIT
// Tests against images of Mitsuba 3, on object pixels away from silhouettes. Nicol takes fewer samples than
// the truth. Only noise may remain, so averages over blocks of pixels must fall as noise does.
#include "import/load_scene.hpp"
#include "reference/camera_rays.hpp"
#include "scenes.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

namespace fs = std::filesystem;

/// Returns 1 for pixels whose eight neighbours show the same object.
std::vector<char> inner_pixels(const LoadedScene& s) {
    std::vector<Mesh> meshes;
    std::vector<RaySurface> surfaces;
    for (const Instance& i : s.scene.instances()) meshes.push_back(transformed(*i.mesh, i.to_world));
    for (const Mesh& m : meshes) surfaces.push_back({m.positions, m.triangles});
    const RayScene rays(surfaces);
    const CameraRays camera(project(s.camera, s.width, s.height), s.width, s.height);
    std::vector<int> object(static_cast<std::size_t>(s.width * s.height), -1);
    for (int i = 0; i < s.width * s.height; ++i) {
        const auto hit = rays.intersect(camera.through(i % s.width + 0.5, i / s.width + 0.5));
        if (hit) object[static_cast<std::size_t>(i)] = static_cast<int>(hit->surface);
    }
    std::vector<char> inner(object.size(), 0);
    for (int y = 1; y + 1 < s.height; ++y) {
        for (int x = 1; x + 1 < s.width; ++x) {
            const int own = object[static_cast<std::size_t>(y * s.width + x)];
            bool same = own >= 0;
            for (int n = 0; n < 9; ++n)
                same = same &&
                       object[static_cast<std::size_t>((y + n / 3 - 1) * s.width + x + n % 3 - 1)] == own;
            inner[static_cast<std::size_t>(y * s.width + x)] = same ? 1 : 0;
        }
    }
    return inner;
}

struct Comparison {
    double mean_ratio = 0;              // of s0, ours divided by the truth
    double slope[4] = {0, 0, 0, 0};     // least-squares slope of ours against the truth
    double residual[4] = {0, 0, 0, 0};  // RMS of the difference divided by the mean of s0
};

/// Compares the means of blocks of side x side pixels that lie wholly inside the object.
Comparison compare(const StokesImage& ours, const StokesImage& truth, const std::vector<char>& inner,
                   int side) {
    double total = 0, total_truth = 0, count = 0;
    double product[4] = {0, 0, 0, 0}, square[4] = {0, 0, 0, 0}, error[4] = {0, 0, 0, 0};
    for (int y = 0; y + side <= ours.height; y += side) {
        for (int x = 0; x + side <= ours.width; x += side) {
            bool whole = true;
            for (int i = 0; i < side * side; ++i)
                whole =
                    whole && inner[static_cast<std::size_t>((y + i / side) * ours.width + x + i % side)] != 0;
            if (!whole) continue;
            for (int c = 0; c < ours.channels; ++c) {
                Stokes a(0.0), b(0.0);
                for (int i = 0; i < side * side; ++i) {
                    a += ours.stokes(c, y + i / side, x + i % side) / double(side * side);
                    b += truth.stokes(c, y + i / side, x + i % side) / double(side * side);
                }
                ++count;
                total += a[0];
                total_truth += b[0];
                for (int p = 0; p < 4; ++p) {
                    product[p] += a[p] * b[p];
                    square[p] += b[p] * b[p];
                    error[p] += (a[p] - b[p]) * (a[p] - b[p]);
                }
            }
        }
    }
    Comparison out;
    out.mean_ratio = total / total_truth;
    for (int p = 0; p < 4; ++p) {
        out.slope[p] = product[p] / square[p];
        out.residual[p] = std::sqrt(error[p] / count) / (total_truth / count);
    }
    return out;
}

void check(const LoadedScene& s, const fs::path& truth_file, int samples) {
    const StokesImage truth = read_exr(truth_file);
    const StokesImage ours = render(s.scene, s.camera, s.width, s.height, {.samples = samples});
    REQUIRE(ours.width == truth.width);
    REQUIRE(ours.height == truth.height);
    const std::vector<char> inner = inner_pixels(s);
    const Comparison pixels = compare(ours, truth, inner, 1);
    const Comparison blocks = compare(ours, truth, inner, 4);
    MESSAGE(truth_file.filename().string()
            << " at " << samples << " samples: mean s0 ratio " << pixels.mean_ratio << ", slopes s1 "
            << blocks.slope[1] << " s2 " << blocks.slope[2] << ", residual of pixels s0 "
            << pixels.residual[0] << " s1 " << pixels.residual[1] << " s2 " << pixels.residual[2]
            << ", of 4 x 4 blocks s0 " << blocks.residual[0] << " s1 " << blocks.residual[1] << " s2 "
            << blocks.residual[2]);
    CHECK(std::abs(pixels.mean_ratio - 1) < 0.005);
    CHECK(std::abs(blocks.slope[1] - 1) < 0.015);
    CHECK(std::abs(blocks.slope[2] - 1) < 0.015);
    CHECK(pixels.residual[3] < 1e-6);
    // The noise of the mean of 16 pixels is a quarter, while systematic errors would stay.
    for (int p = 0; p < 3; ++p) CHECK(blocks.residual[p] < 1.15 * pixels.residual[p] / 4);
}

}  // namespace

TEST_CASE("a sphere under an image of light is Mitsuba 3's, but for noise") {
    const fs::path truth = test_data("mitsuba/sphere_env_a03.exr");
    if (truth.empty()) return;
    check(load_scene(truth.parent_path() / "sphere_env.xml", {}), truth, 128);
}

TEST_CASE("a statue on a plane, with shadows, is Mitsuba 3's, but for noise") {
    const fs::path truth = test_data("mitsuba/buddha_plane_venice.exr");
    if (truth.empty() || test_data("polarsh/buddha.obj").empty()) return;
    // The scene's files are in two folders.
    const TemporaryFolder folder;
    for (const char* name :
         {"mitsuba/buddha.xml", "mitsuba/venice.exr", "polarsh/buddha.obj", "polarsh/plane.obj"})
        fs::create_symlink(fs::absolute(test_data(name)), folder / fs::path(name).filename().string());
    check(load_scene(folder / "buddha.xml", {}), truth, 64);
}
