// SPDX-License-Identifier: MIT
// Tests of framebuffers: sizes, planes in the caller's memory, files.
#include "capi.hpp"
#include "jobs.hpp"

using namespace capi_test;

STAGE_TEST_CASE("planes tell the same story") {
    stage.render();
    float most_polarized = 0;
    for (std::uint32_t c = 0; c < 3; ++c) {
        const std::vector<float> stokes = read_plane(stage.framebuffer, NICOL_PLANE_STOKES, c);
        std::vector<float> single[4];
        for (nicol_plane p = 0; p < 4; ++p) single[p] = read_plane(stage.framebuffer, NICOL_PLANE_S0 + p, c);
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
}

STAGE_TEST_CASE("images are written in every kind and read back") {
    stage.render();
    const TemporaryFolder folder;
    std::set<std::string> contents;
    for (nicol_observation_kind kind = NICOL_OBSERVATION_S0; kind <= NICOL_OBSERVATION_POLARIZER; ++kind) {
        nicol_observation image = NICOL_OBSERVATION_INIT;
        image.kind = kind;
        const std::string path = folder.file(std::to_string(kind) + ".png");
        OK(nicol_framebuffer_write_png(stage.framebuffer, &image, path.c_str()));
        const std::string bytes = file_bytes(path);
        CHECK(bytes.starts_with("\x89PNG"));
        CHECK_MESSAGE(contents.insert(bytes).second, "two kinds of image are the same");
    }
    const std::string path = folder.file("\xC3\xA9.exr");
    OK(nicol_framebuffer_write_exr(stage.framebuffer, path.c_str()));
    CHECK(folder.names().size() == 8);
    // The file can be loaded as an environment again.
    Owned<nicol_environment> environment;
    OK(nicol_environment_load(stage.context, path.c_str(), nullptr, &environment));
}

STAGE_TEST_CASE("files that cannot be written leave nothing behind") {
    stage.render();
    const TemporaryFolder folder;
    const nicol_observation image = NICOL_OBSERVATION_INIT;
    for (const std::string& path : {folder.file("absent/below.out"), std::string()}) {
        FAILS(nicol_framebuffer_write_exr(stage.framebuffer, path.c_str()), NICOL_ERROR_WRITE_FAILED, path);
        FAILS(nicol_framebuffer_write_png(stage.framebuffer, &image, path.c_str()), NICOL_ERROR_WRITE_FAILED,
              path);
    }
    // Names that end as other files do would deceive the programs that read them.
    for (const char* name : {"image.png", "image.JPG", "image.tiff"})
        REFUSES(nicol_framebuffer_write_exr(stage.framebuffer, folder.file(name).c_str()),
                "what is written is .exr");
    for (const char* name : {"image.exr", "image.jpeg"})
        REFUSES(nicol_framebuffer_write_png(stage.framebuffer, &image, folder.file(name).c_str()),
                "what is written is .png");
    CHECK(folder.names().empty());
    OK(nicol_framebuffer_write_png(stage.framebuffer, &image, folder.file("image.1").c_str()));
}

STAGE_TEST_CASE("a framebuffer of another size keeps its handle, also while a job renders into it") {
    const std::vector<float> before = stage.image();
    OK(nicol_framebuffer_resize(stage.framebuffer, 24, 16));  // its own size
    CHECK(read_all(stage.framebuffer) == before);
    for (const std::uint32_t wrong : {0U, NICOL_MAX_SIZE + 1U})
        FAILS(nicol_framebuffer_resize(stage.framebuffer, wrong, 16), NICOL_ERROR_INVALID_ARGUMENT,
              std::to_string(wrong) + " x 16");
    CHECK(read_all(stage.framebuffer) == before);

    Gate gate;
    const Owned job(submit(stage, gated(gate)));
    gate.wait_until_entered();
    OK(nicol_framebuffer_resize(stage.framebuffer, 10, 20));
    std::uint32_t width = 0, height = 0, channels = 0;
    OK(nicol_framebuffer_get_size(stage.framebuffer, &width, &height, &channels));
    CHECK((width == 10 && height == 20 && channels == 3));
    gate.open();
    OK(nicol_job_wait(job, NICOL_WAIT_FOREVER));

    const Stage other(stage.context);
    const Owned expected(framebuffer_of(stage.context, 10, 20, 3));
    const nicol_render_options options = plain_options();
    OK(nicol_render(other.scene, &other.camera, &options, expected));
    CHECK(stage.image() == read_all(expected));
}
