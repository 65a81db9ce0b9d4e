// SPDX-License-Identifier: MIT
// Tests of the load limits in every reader: bytes before decoding, time, and cancellation during the load.
#include <cmath>

#include "files/bomb.hpp"
#include "files/npz.hpp"
#include "image/bitmap.hpp"
#include "import/gltf_file.hpp"
#include "import/load_scene.hpp"
#include "import/scene_file.hpp"
#include "light/cube_cross.hpp"
#include "light/psh_file.hpp"
#include "material/measured.hpp"
#include "material/pbsdf_file.hpp"
#include "material/psh_matrix_file.hpp"
#include "texture/texture.hpp"

using namespace nicol;
using std::filesystem::path;

namespace {

struct Loading {
    std::string name;
    std::function<void(const LoadBudget&)> load;
};

/// Returns an uncompressed Radiance picture in a file of the run-length format.
std::string radiance_hdr(int width, int height) {
    std::string out = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
                      std::to_string(width) + "\n";
    out.append(static_cast<std::size_t>(4 * width) * static_cast<std::size_t>(height), '\x80');
    return out;
}

std::string pbsdf_of_zeros(std::size_t angles) {
    test::PbsdfFile file;
    const double half = std::acos(0.0);
    file.add("theta_h", {1, angles}, 10, test::even_angles(angles, 0, half));
    file.add("theta_d", {1, angles}, 10, test::even_angles(angles, 0, half));
    file.add("phi_d", {1, angles}, 10, test::even_angles(angles, 0, 4 * half));
    file.add("wvls", {1, 1}, 3, std::vector<std::uint16_t>{550});
    file.add("M", {angles, angles, angles, 1, 4, 4}, 10,
             std::vector<float>(16 * angles * angles * angles, 0.25F));
    return file.bytes();
}

std::string many_shapes(std::size_t count) {
    std::string out = a_sensor;
    for (std::size_t i = 0; i < count; ++i) out += "<shape type='rectangle'/>\n";
    return scene(out);
}

/// Returns a GLB without a buffer, with this many nodes.
std::string many_nodes(std::size_t count) {
    std::string nodes;
    for (std::size_t i = 0; i < count; ++i) nodes += nodes.empty() ? "{\"mesh\":0}" : ",{\"mesh\":0}";
    return triangle_buffer().json(one_mesh() + ",\"nodes\":[" + nodes + "]");
}

}  // namespace

TEST_CASE("what would be decoded counts before it is") {
    const TemporaryFolder folder;
    // Each file has a few KiB and would decode to many MiB.
    const path grey = folder.write("grey.png", black_png(16384, 8192, 1, 8192 * 2049ULL));
    write_exr(folder / "a.exr", StokesImage(4096, 2048, 3), {.components = 0});
    const path exr = folder / "a.exr";
    for (int p = 0; p < 4; ++p)
        write_exr(cube_cross_file(folder / "cube", p), StokesImage(2048, 1536, 1), {.components = 0});
    const LoadLimits limits{.bytes = 3 << 20};
    const std::vector<Loading> cases{
        {"bitmap", [&](const LoadBudget& b) { static_cast<void>(read_bitmap(grey, b)); }},
        {"environment", [&](const LoadBudget& b) { static_cast<void>(load_environment(grey, 1, {}, b)); }},
        {"texture", [&](const LoadBudget& b) { static_cast<void>(load_texture_image(grey, false, b)); }},
        {"EXR", [&](const LoadBudget& b) { static_cast<void>(load_environment(exr, 1, {}, b)); }},
        {"EXR texture", [&](const LoadBudget& b) { static_cast<void>(load_texture_image(exr, false, b)); }},
        {"cube",
         [&](const LoadBudget& b) { static_cast<void>(load_environment(folder / "cube", 1, {}, b)); }}};
    for (const Loading& one : cases) {
        CAPTURE(one.name);
        check_error(
            ErrorCode::unsupported, [&] { one.load(limits); }, "load_bytes_limit");
    }
    const SceneFile envmap(scene(a_sensor + a_shape +
                                 "<emitter type='envmap'><string name='filename' value='a.png'/></emitter>"));
    envmap.write("a.png", black_png(16384, 8192, 1, 8192 * 2049ULL));
    check_error(ErrorCode::unsupported, CALL(load_scene(envmap.scene(), {}, limits)), "load_bytes_limit",
                "a.png");
}

TEST_CASE("an image is not inflated beyond its pixels") {
    const TemporaryFolder folder;
    const path bomb = folder.write("bomb.png", black_png(1, 1, 8, std::uint64_t{1} << 26));
    check_error(ErrorCode::invalid_file, CALL(read_bitmap(bomb)), bomb.string(), "more than its pixels");
    // The limit admits loads that need no more than it.
    CHECK(read_bitmap(folder.write("a.png", black_png(1, 1, 8, 2))).values.size() == 1);
    CHECK(read_bitmap(folder.write("b.png", black_png(999, 1, 16, 1 + 2 * 999))).values.size() == 999);
    CHECK(read_bitmap(folder.write("c.png", black_png(1, 9999, 1, 2 * 9999))).values.size() == 9999);
}

TEST_CASE("every reader is asked to stop while it works") {
    const TemporaryFolder folder;
    write_exr(folder / "a.exr", StokesImage(4096, 2048, 3), {.components = 0});
    for (int p = 0; p < 4; ++p)
        write_exr(cube_cross_file(folder / "cube", p), StokesImage(4096, 3072, 1), {.components = 0});
    const std::string hdr = radiance_hdr(8192, 2048);
    write_psh_vector(folder / "light.npz", PshVector(1400, 4));
    const path pbsdf = folder.write("a.pbsdf", pbsdf_of_zeros(120));
    const path shapes = folder.write("shapes.xml", many_shapes(90000));
    const path nodes = folder.write("nodes.gltf", many_nodes(90000));
    folder.write("a.bin", triangle_buffer().bytes);
    const path plain = folder.write("plain.obj", std::string(std::size_t{1} << 24, '\n') + "v 0 0 0\n");
    const std::vector<Loading> cases{
        {"EXR", [&](const LoadBudget& b) { static_cast<void>(read_exr(folder / "a.exr", {}, b)); }},
        {"HDR",
         [&](const LoadBudget& b) {
             b.take_file(folder / "a.hdr");
             static_cast<void>(read_bitmap("a.hdr", hdr, b));
         }},
        {"cube",
         [&](const LoadBudget& b) { static_cast<void>(load_environment(folder / "cube", 1, {}, b)); }},
        {"npz", [&](const LoadBudget& b) { static_cast<void>(read_psh_vector(folder / "light.npz", b)); }},
        {"pbsdf", [&](const LoadBudget& b) { static_cast<void>(load_measured(pbsdf, {}, {}, b)); }},
        {"bytes", [&](const LoadBudget& b) { static_cast<void>(load_mesh(plain, {}, 0, b)); }},
        {"XML", [&](const LoadBudget& b) { static_cast<void>(load_scene(shapes, {}, b)); }},
        {"glTF", [&](const LoadBudget& b) { static_cast<void>(load_scene(nodes, {}, b)); }}};
    for (const Loading& one : cases) {
        CAPTURE(one.name);
        // The first call comes with the file's name and lasts as long as the pause between two calls, so that
        // the next check meets the limit however fast the machine is.
        int asked = 0;
        const auto slow_then_stop = [&](const char*, double) {
            if (++asked == 2) return false;
            for (const Stopwatch time; time.milliseconds() < 110;) {
            }
            return true;
        };
        check_error(ErrorCode::cancelled, [&] { one.load(LoadLimits{.progress = slow_then_stop}); });
        CHECK(asked == 2);
        asked = 0;
        check_error(
            ErrorCode::unsupported, [&] { one.load(LoadLimits{.seconds = 0.1, .progress = slow_then_stop}); },
            "load_seconds_limit");
    }
}
