// SPDX-License-Identifier: MIT
// Environments of a context as coefficients.
#include "psh_sky.hpp"

using namespace capi_test;

TEST_CASE("psh: environments have the coefficients of their light") {
    const nicol_context context = make_context(NICOL_BACKEND_AUTOMATIC);
    nicol_environment environment = nullptr;
    nicol_sky sky = NICOL_SKY_INIT;
    sky.dop_max = static_cast<float>(dop_max);
    for (std::size_t i = 0; i < 3; ++i) sky.sun_direction[i] = static_cast<float>(sun[i]);
    sky.radiance = spectrum({1, 2});
    OK(nicol_environment_create_sky(context, &sky, &environment));
    Doubles f(2 * vector_size(3));
    OK(nicol_psh_project_environment(environment, 3, f.data(), f.size()));
    CHECK(difference_from_sky(3, f.data()) < 1e-6);
    for (std::size_t i = 0; i < vector_size(3); ++i)
        CHECK(f[vector_size(3) + i] == doctest::Approx(2 * f[i]));
    FAILS(nicol_psh_project_environment(environment, 3, f.data(), vector_size(3)),
          NICOL_ERROR_INVALID_ARGUMENT, "coefficients");
    FAILS(nicol_psh_project_environment(environment, 4097, f.data(), f.size()), NICOL_ERROR_INVALID_ARGUMENT,
          "order");
    OK(nicol_environment_release(environment));
    FAILS(nicol_psh_project_environment(environment, 3, f.data(), f.size()), NICOL_ERROR_INVALID_HANDLE,
          "nicol_environment");
    FAILS(nicol_psh_project_environment(nullptr, 3, f.data(), f.size()), NICOL_ERROR_INVALID_HANDLE, "NULL");
    OK(nicol_context_release(context));
}
