// SPDX-License-Identifier: MIT
// Objects of a context written to files.
#include "inspect.hpp"
#include "psh_checks.hpp"

using namespace capi_test;

TEST_CASE("inspect: an environment is written in every format") {
    const TemporaryFolder folder;
    const Owned context(make_context(NICOL_BACKEND_AUTOMATIC));
    nicol_sky sky = NICOL_SKY_INIT;
    sky.sun_direction[0] = 0.5F;
    sky.sun_direction[1] = 0.7F;
    Owned<nicol_environment> environment;
    OK(nicol_environment_create_sky(context, &sky, &environment));
    Doubles wanted(3 * vector_size(2));
    OK(nicol_psh_project_environment(environment, 2, wanted.data(), wanted.size()));
    const nicol_file_options options = of_order(2, NICOL_FILE_BAND_LIMITED);
    OK(nicol_environment_write(environment, &options, folder.file("a.npz").c_str()));
    OK(nicol_environment_write(environment, nullptr, folder.file("a.exr").c_str()));
    OK(nicol_environment_write(environment, nullptr, folder.file("a_s0.exr").c_str()));
    CHECK(difference(coefficients_of(folder.file("a.npz"), 2, 3), wanted) < 1e-6);
    CHECK(difference(coefficients_of(folder.file("a.exr"), 2, 3), wanted) < 5e-4);
    CHECK(difference(coefficients_of(folder.file("a_s0.exr"), 2, 3), wanted) < 5e-4);

    nicol_file_options wavelengths = NICOL_FILE_OPTIONS_INIT;
    wavelengths.wavelengths = spectrum({550});
    FAILS(nicol_environment_write(environment, &wavelengths, folder.file("b.npz").c_str()),
          NICOL_ERROR_INVALID_ARGUMENT, "wavelengths");
    FAILS(nicol_environment_write(environment, nullptr, folder.file("b.png").c_str()),
          NICOL_ERROR_INVALID_ARGUMENT, "b.png");
}

TEST_CASE("inspect: a material is written as SHMat and into a cache") {
    const TemporaryFolder folder;
    const Owned context(make_context(NICOL_BACKEND_AUTOMATIC));
    const Owned material(diffuse(context, {0.25F, 0.75F}));
    nicol_file_options options = of_order(6);
    OK(nicol_material_write(material, &options, folder.file("cache/").c_str()));
    options.scale = 2;
    OK(nicol_material_write(material, &options, folder.file("m.npz").c_str()));
    nicol_material_report r = NICOL_MATERIAL_REPORT_INIT;
    OK(nicol_file_describe_material(folder.file("m.npz").c_str(), nullptr, &r, nullptr, 0));
    CHECK((r.channels == 2 && r.file_order == 6));
    CHECK(r.albedo[0] == doctest::Approx(0.5).epsilon(0.01));
    CHECK(r.albedo[1] == doctest::Approx(1.5).epsilon(0.01));
    CHECK(std::filesystem::exists(folder.file("cache")));
    CHECK(!std::filesystem::is_empty(folder.file("cache")));
    FAILS(nicol_material_write(material, nullptr, folder.file("m.exr").c_str()), NICOL_ERROR_INVALID_ARGUMENT,
          "m.exr");
}
