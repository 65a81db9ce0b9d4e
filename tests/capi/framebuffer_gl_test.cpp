// SPDX-License-Identifier: MIT
// Framebuffers: sizes, planes in the caller's memory, files.
#include <array>
#include <cmath>
#include <numbers>

#include "capi.hpp"

using namespace capi_test;

TEST_CASE("framebuffers have 1 to 16384 pixels a side, and not too many in all") {
    on_every_backend([](nicol_context context) {
        nicol_framebuffer framebuffer = marker<nicol_framebuffer>();
        const auto create = [&](std::uint32_t width, std::uint32_t height, std::uint32_t channels) {
            return nicol_framebuffer_create(context, width, height, channels, &framebuffer);
        };
        for (const std::uint32_t bad : {0U, 16385U, 100000U, UINT32_MAX}) {
            FAILS(create(bad, 4, 1), NICOL_ERROR_INVALID_ARGUMENT, std::to_string(bad));
            FAILS(create(4, bad, 1), NICOL_ERROR_INVALID_ARGUMENT, std::to_string(bad));
        }
        for (const std::uint32_t bad : {0U, 17U, UINT32_MAX})
            FAILS(create(4, 4, bad), NICOL_ERROR_INVALID_ARGUMENT, "channels");
        FAILS(create(16384, 16384, 1), NICOL_ERROR_INVALID_ARGUMENT, "pixels");
        FAILS(create(16384, 16384, 16), NICOL_ERROR_INVALID_ARGUMENT, "pixels");
        CHECK(framebuffer == marker<nicol_framebuffer>());

        for (const auto& [width, height, channels] :
             std::vector<std::array<std::uint32_t, 3>>{{1, 1, 1}, {1, 300, 16}, {8192, 1, 1}, {7, 5, 5}}) {
            OK(create(width, height, channels));
            std::uint32_t w = 0, h = 0, c = 0;
            OK(nicol_framebuffer_get_size(framebuffer, &w, &h, &c));
            CHECK(w == width);
            CHECK(h == height);
            CHECK(c == channels);
            w = h = c = 9;
            CHECK(w + h + c == 27);
            OK(nicol_framebuffer_release(framebuffer));
        }
    });
}

TEST_CASE("planes tell the same story") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        float most_polarized = 0;
        for (std::uint32_t c = 0; c < 3; ++c) {
            const std::vector<float> stokes = read_plane(stage.framebuffer, NICOL_PLANE_STOKES, c);
            std::vector<float> single[4];
            for (nicol_plane p = 0; p < 4; ++p)
                single[p] = read_plane(stage.framebuffer, NICOL_PLANE_S0 + p, c);
            const std::vector<float> dolp = read_plane(stage.framebuffer, NICOL_PLANE_DOLP, c);
            const std::vector<float> aolp = read_plane(stage.framebuffer, NICOL_PLANE_AOLP, c);
            for (std::size_t i = 0; i < dolp.size(); ++i) {
                for (std::size_t p = 0; p < 4; ++p) CHECK(single[p][i] == stokes[4 * i + p]);
                const double s0 = stokes[4 * i], s1 = stokes[4 * i + 1], s2 = stokes[4 * i + 2];
                REQUIRE(s0 > 0);
                const double degree = std::sqrt(s1 * s1 + s2 * s2) / s0;
                CHECK(dolp[i] == doctest::Approx(std::min(degree, 1.0)).epsilon(1e-5));
                CHECK(aolp[i] > -std::numbers::pi_v<float> / 2);
                CHECK(aolp[i] <= std::numbers::pi_v<float> / 2 + 1e-6F);
                CHECK(s0 * degree * std::cos(2 * static_cast<double>(aolp[i])) ==
                      doctest::Approx(s1).epsilon(1e-4));
                CHECK(s0 * degree * std::sin(2 * static_cast<double>(aolp[i])) ==
                      doctest::Approx(s2).epsilon(1e-4));
                most_polarized = std::max(most_polarized, dolp[i]);
            }
        }
        CHECK(most_polarized > 0.2F);
    });
}

TEST_CASE("planes are read with a row stride, and only the rows are written") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        for (nicol_plane plane = NICOL_PLANE_S0; plane <= NICOL_PLANE_AOLP; ++plane) {
            const std::size_t row = plane == NICOL_PLANE_STOKES ? 96 : 24;
            const std::vector<float> tight = read_plane(stage.framebuffer, plane, 1);
            const std::size_t stride = row + 3;
            std::vector<float> loose(stride * 15 + row, -7.5F);  // the last row needs no padding
            OK(nicol_framebuffer_read(stage.framebuffer, plane, 1, loose.data(), stride * sizeof(float),
                                      loose.size() * sizeof(float)));
            for (std::size_t i = 0; i < loose.size(); ++i) {
                const bool between = i % stride >= row;
                CHECK(loose[i] == (between ? -7.5F : tight[i / stride * row + i % stride]));
            }
        }
    });
}

TEST_CASE("planes that do not fit are refused and nothing is written") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        std::vector<float> pixels(24 * 16 * 4, -7.5F);
        const auto read = [&](nicol_plane plane, std::uint32_t channel, std::uint64_t stride,
                              std::uint64_t size) {
            return nicol_framebuffer_read(stage.framebuffer, plane, channel, pixels.data(), stride, size);
        };
        FAILS(read(NICOL_PLANE_S0, 0, 0, 24 * 16 * 4 - 1), NICOL_ERROR_INVALID_ARGUMENT, "byte_size");
        FAILS(read(NICOL_PLANE_STOKES, 0, 0, 24 * 16 * 4), NICOL_ERROR_INVALID_ARGUMENT, "byte_size");
        FAILS(read(NICOL_PLANE_DOLP, 0, 0, 0), NICOL_ERROR_INVALID_ARGUMENT, "byte_size");
        FAILS(read(NICOL_PLANE_S0, 0, 100, 100 * 15 + 95), NICOL_ERROR_INVALID_ARGUMENT, "byte_size");
        FAILS(read(NICOL_PLANE_S0, 0, 92, 6144), NICOL_ERROR_INVALID_ARGUMENT, "row_stride");
        FAILS(read(NICOL_PLANE_S0, 0, 98, 6144), NICOL_ERROR_INVALID_ARGUMENT, "row_stride");
        FAILS(read(NICOL_PLANE_S0, 0, UINT64_MAX - 3, UINT64_MAX), NICOL_ERROR_INVALID_ARGUMENT,
              "row_stride");
        FAILS(read(NICOL_PLANE_S0, 0, std::uint64_t{1} << 62, 6144), NICOL_ERROR_INVALID_ARGUMENT,
              "row_stride");
        FAILS(read(7, 0, 0, 6144), NICOL_ERROR_INVALID_ARGUMENT, "plane NICOL_PLANE_DEPTH is not there");
        FAILS(read(11, 0, 0, 6144), NICOL_ERROR_INVALID_ARGUMENT, "plane");
        FAILS(read(UINT32_MAX, 0, 0, 6144), NICOL_ERROR_INVALID_ARGUMENT, "plane");
        FAILS(read(NICOL_PLANE_S0, 3, 0, 6144), NICOL_ERROR_INVALID_ARGUMENT, "channel");
        FAILS(read(NICOL_PLANE_S0, UINT32_MAX, 0, 6144), NICOL_ERROR_INVALID_ARGUMENT, "channel");
        for (const float value : pixels) REQUIRE(value == -7.5F);
    });
}

TEST_CASE("images are written in every kind and read back") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        const TemporaryFolder folder;
        std::set<std::string> contents;
        for (nicol_observation_kind kind = NICOL_OBSERVATION_S0; kind <= NICOL_OBSERVATION_POLARIZER;
             ++kind) {
            nicol_observation image = NICOL_OBSERVATION_INIT;
            image.kind = kind;
            const std::string path = folder.file(std::to_string(kind) + ".png");
            OK(nicol_framebuffer_write_png(stage.framebuffer, &image, path.c_str()));
            std::ifstream file(path, std::ios::binary);
            const std::string bytes((std::istreambuf_iterator<char>(file)), {});
            CHECK(bytes.starts_with("\x89PNG"));
            CHECK_MESSAGE(contents.insert(bytes).second, "two kinds of image are the same");
        }
        const std::string path = folder.file("\xC3\xA9.exr");
        OK(nicol_framebuffer_write_exr(stage.framebuffer, path.c_str()));
        CHECK(folder.names().size() == 8);
        // The file's s0 serves as light again.
        Owned<nicol_environment> environment;
        OK(nicol_environment_load(context, path.c_str(), nullptr, &environment));
    });
}

TEST_CASE("files that cannot be written leave nothing behind") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        const TemporaryFolder folder;
        const std::string file = folder.write("file", "content");
        std::filesystem::create_directory(folder.file("folder"));
        const std::set<std::string> before = folder.names();
        const nicol_observation image = NICOL_OBSERVATION_INIT;
        for (const std::string& path :
             {file + "/below.out", folder.file("absent/below.out"), folder.file("folder"),
              folder.file("folder/"), std::string("/proc/nicol.out"), folder.file(std::string(300, 'n')),
              std::string()}) {
            CAPTURE(path);
            FAILS(nicol_framebuffer_write_exr(stage.framebuffer, path.c_str()), NICOL_ERROR_WRITE_FAILED,
                  path);
            FAILS(nicol_framebuffer_write_png(stage.framebuffer, &image, path.c_str()),
                  NICOL_ERROR_WRITE_FAILED, path);
        }
        CHECK(folder.names() == before);
        CHECK(std::filesystem::is_empty(folder.file("folder")));
        std::ifstream kept(file);
        CHECK(std::string((std::istreambuf_iterator<char>(kept)), {}) == "content");
    });
}

TEST_CASE("images out of range are refused by name") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        const TemporaryFolder folder;
        const std::string path = folder.file("image.png");
        const auto with = [&](auto change, const char* text) {
            nicol_observation image = NICOL_OBSERVATION_INIT;
            change(image);
            FAILS(nicol_framebuffer_write_png(stage.framebuffer, &image, path.c_str()),
                  NICOL_ERROR_INVALID_ARGUMENT, text);
        };
        with([](nicol_observation& p) { p.kind = 7; }, "kind");
        with([](nicol_observation& p) { p.exposure = NAN; }, "exposure");
        with([](nicol_observation& p) { p.exposure = INFINITY; }, "exposure");
        for (const nicol_observation_kind kind :
             {NICOL_OBSERVATION_S1, NICOL_OBSERVATION_S2, NICOL_OBSERVATION_S3}) {
            with(
                [&](nicol_observation& p) {
                    p.kind = static_cast<nicol_observation_kind>(kind);
                    p.scale = -1;
                },
                "scale");
            with(
                [&](nicol_observation& p) {
                    p.kind = static_cast<nicol_observation_kind>(kind);
                    p.scale = NAN;
                },
                "scale");
        }
        with(
            [](nicol_observation& p) {
                p.kind = NICOL_OBSERVATION_POLARIZER;
                p.polarizer_angle = INFINITY;
            },
            "angle");
        CHECK(folder.names().empty());
    });
}
