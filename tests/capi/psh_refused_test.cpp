// SPDX-License-Identifier: MIT
// What the mathematics refuses beyond the rules of contract_gl_test.cpp: ranges, overlaps, and what callbacks
// answer.
#include "psh_checks.hpp"

using namespace capi_test;

namespace {

constexpr Rotation identity = {1, 0, 0, 0, 1, 0, 0, 0, 1};

}  // namespace

TEST_CASE("psh: directions and rotations that are none, and memory that overlaps, are refused") {
    const std::size_t n = vector_size(3);
    const Doubles f(2 * n), scalar(16), matrix(n * n), zero = {1, 0, 0, 0, 0, 0};
    Doubles shared(n * n + n);
    Untouched out(2 * n), stokes(16);
    double* const both = shared.data();
    const auto evaluate = [&](const Doubles& directions, std::uint64_t vectors) {
        return nicol_psh_evaluate(3, vectors, f.data(), vectors * n, directions.data(), directions.size(),
                                  stokes.data(), vectors * directions.size() / 3 * 4);
    };
    check_refused({
        {"direction 1 is zero", [&] { return evaluate(zero, 1); }},
        {"direction 1 is zero", [&] { return evaluate(zero, 2); }},
        {"in and out", [&] { return nicol_psh_rotate(3, 1, both, n, identity.data(), both + n - 1, n); }},
        {"in and out", [&] { return nicol_psh_reflect(3, 1, both + n - 1, n, both, n); }},
        {"in and out",
         [&] { return nicol_psh_multiply(3, scalar.data(), 16, 3, 1, both, n, 2, both, vector_size(2)); }},
        {"scalar and out",
         [&] { return nicol_psh_multiply(3, both, 16, 3, 1, f.data(), n, 3, both + 15, n); }},
        {"in and out",
         [&] { return nicol_psh_apply_matrix(3, 3, matrix.data(), n * n, 1, both, n, both, n); }},
        {"matrix and out",
         [&] { return nicol_psh_apply_matrix(3, 3, both, n * n, 1, f.data(), n, both + n, n); }},
    });
    for (const Rotation& r :
         {Rotation{}, Rotation{1, 0, 0, 0, 1, 0, 0, 0, -1}, Rotation{2, 0, 0, 0, 2, 0, 0, 0, 2},
          Rotation{1, 0.1, 0, 0, 1, 0, 0, 0, 1}, Rotation{not_a_number, 0, 0, 0, 1, 0, 0, 0, 1},
          Rotation{infinity, 0, 0, 0, 1, 0, 0, 0, 1}})
        REFUSES(nicol_psh_rotate(3, 2, f.data(), 2 * n, r.data(), out.data(), 2 * n), "rotation");
}

TEST_CASE("psh: no vectors and no directions are nothing to do") {
    OK(nicol_psh_evaluate(3, 0, nullptr, 0, identity.data(), 9, nullptr, 0));
    const Doubles f(2 * vector_size(3));
    OK(nicol_psh_evaluate(3, 2, f.data(), f.size(), nullptr, 0, nullptr, 0));
    OK(nicol_psh_rotate(3, 0, nullptr, 0, identity.data(), nullptr, 0));
    OK(nicol_psh_reflect(3, 0, nullptr, 0, nullptr, 0));
    OK(nicol_psh_multiply(0, identity.data(), 1, 3, 0, nullptr, 0, 2, nullptr, 0));
    const nicol_psh_transform transform = make_transform(NICOL_PSH_GRID_FEJER, 4);
    OK(nicol_psh_analyze(transform, 0, nullptr, 0, nullptr, 0));
    OK(nicol_psh_transform_release(transform));
    nicol_psh_kernel_callback zero = [](void*, double, double*) { return std::int32_t{1}; };
    Doubles bands(16);
    OK(nicol_psh_project_kernel(zero, nullptr, 0, 0, bands.data(), bands.size()));
    OK(nicol_psh_kernel_at(0, bands.data(), bands.size(), nullptr, 0, nullptr, 0));
}

TEST_CASE("psh: samplings that are too coarse, too large or unknown are refused by name") {
    nicol_psh_transform transform = nullptr;
    using S = nicol_psh_sampling;
    const auto with = [&](const char* text, auto change) {
        S sampling = NICOL_PSH_SAMPLING_INIT;
        sampling.order = 4;
        change(sampling);
        REFUSES(nicol_psh_transform_create(&sampling, &transform), text);
    };
    with("grid is 3", [](S& s) { s.grid = 3; });
    with("reserved", [](S& s) { s.reserved = 1; });
    with("rows", [](S& s) { s.grid = NICOL_PSH_GRID_CLENSHAW_CURTIS, s.rows = 1; });
    with("rows", [](S& s) { s.grid = NICOL_PSH_GRID_GAUSS_LEGENDRE, s.rows = 16385; });
    with("work space", [](S& s) { s.order = 4096, s.rows = 32768; });
    for (const std::uint32_t rows : {32769U, UINT32_MAX}) with("rows", [&](S& s) { s.rows = rows; });
    for (const std::uint32_t columns : {8U, 131073U, UINT32_MAX})
        with("columns", [&](S& s) { s.columns = columns; });
    for (const double phi0 : {not_a_number, infinity}) with("phi0", [&](S& s) { s.phi0 = phi0; });
    for (const std::uint32_t order : {4097U, UINT32_MAX})
        with("sampling->order is", [&](S& s) { s.order = order; });
    CHECK(transform == nullptr);

    transform = make_transform(NICOL_PSH_GRID_FEJER, 4);
    const std::size_t n = vector_size(4), samples = 4 * 9 * 9;
    Doubles shared(2 * samples);
    REFUSES(nicol_psh_analyze(transform, 1, shared.data(), samples, shared.data() + samples - 1, n),
            "overlap");
    REFUSES(nicol_psh_synthesize(transform, 1, shared.data(), n, shared.data(), samples), "overlap");
    OK(nicol_psh_transform_release(transform));
}

TEST_CASE("psh: Mueller fields out of range are refused by name, and their callback can stop the call") {
    using F = nicol_psh_mueller_field;
    Untouched m(vector_size(2) * vector_size(3));
    const auto project = [&](auto change) {
        F field = NICOL_PSH_MUELLER_FIELD_INIT;
        field.order_out = 2;
        field.order_in = 3;
        field.callback = [](void*, const double*, const double*, double*) { return std::int32_t{1}; };
        change(field);
        return nicol_psh_project_matrix(&field, m.data(), m.size());
    };
    check_refused({
        {"isotropic", [&] { return project([](F& f) { f.isotropic = 2; }); }},
        {"callback is NULL", [&] { return project([](F& f) { f.callback = nullptr; }); }},
        {"order_out is 65", [&] { return project([](F& f) { f.order_out = 65; }); }},
        {"order_in is 4294967295", [&] { return project([](F& f) { f.order_in = UINT32_MAX; }); }},
        {"rows_out is 4097", [&] { return project([](F& f) { f.rows_out = 4097; }); }},
        {"rows_in", [&] { return project([](F& f) { f.rows_in = UINT32_MAX; }); }},
        {"columns_out is 4", [&] { return project([](F& f) { f.columns_out = 4; }); }},
        {"columns_in is 6", [&] { return project([](F& f) { f.columns_in = 6; }); }},
        {"work space", [&] { return project([](F& f) { f.rows_out = f.columns_out = 4096; }); }},
        {"columns_in", [&] { return project([](F& f) { f.isotropic = 1, f.columns_in = 4; }); }},
        {"columns_out", [&] { return project([](F& f) { f.isotropic = 1, f.columns_out = 9; }); }},
    });
    for (const std::uint32_t isotropic : {0U, 1U}) {
        int calls = 0;
        FAILS(project([&](F& f) {
                  f.isotropic = isotropic;
                  f.user = &calls;
                  f.callback = [](void* user, const double*, const double*, double*) {
                      return static_cast<std::int32_t>(++*static_cast<int*>(user) < 10);
                  };
              }),
              NICOL_ERROR_CANCELLED, "callback");
        CHECK(calls == 10);
        REFUSES(project([&](F& f) {
                    f.isotropic = isotropic;
                    f.callback = [](void*, const double*, const double* out, double* mueller) {
                        mueller[7] = out[2] < 0 ? not_a_number : 0;
                        return std::int32_t{1};
                    };
                }),
                "not finite");
    }
}

TEST_CASE("psh: kernels out of range are refused by name, and their callback can stop the call") {
    Untouched bands(64), mueller(48);
    const std::size_t n = vector_size(3);
    const auto project = [&](nicol_psh_kernel_callback callback, std::uint32_t rows) {
        return nicol_psh_project_kernel(callback, nullptr, 3, rows, bands.data(), bands.size());
    };
    check_refused({
        {"rows is 16385",
         [&] { return project([](void*, double, double*) { return std::int32_t{1}; }, 16385); }},
        {"callback", [&] { return project([](void*, double t, double*) { return std::int32_t{t < 2}; }, 0); },
         NICOL_ERROR_CANCELLED},
        {"not finite",
         [&] {
             return project([](void*, double, double* m) { return m[15] = infinity, std::int32_t{1}; }, 0);
         }},
    });
    const Doubles zero(64), f(n);
    Untouched out(n);
    for (const double wrong : {-1e-9, 3.1416}) {
        const Doubles angles = {0, wrong, 1};
        REFUSES(nicol_psh_kernel_at(3, zero.data(), 64, angles.data(), 3, mueller.data(), 48), "theta[1]");
    }
    for (const std::size_t at : {4U, 15U, 20U, 31U}) {
        Doubles spin = zero;
        spin[at] = 1;
        REFUSES(nicol_psh_convolve(3, spin.data(), 64, 1, f.data(), n, out.data(), n),
                "band " + std::to_string(at / 16));
    }
}

TEST_CASE("psh: an image is released once, on success and on failure") {
    const std::vector<float> pixels(16, 1.0F);
    nicol_image image = NICOL_IMAGE_INIT;
    image.width = image.height = 4;
    image.channels = image.components = 1;
    image.pixels = pixels.data();
    image.byte_size = pixels.size() * sizeof(float);
    int released = 0;
    image.release = [](void* user) { ++*static_cast<int*>(user); };
    image.release_user = &released;
    Doubles f(vector_size(1));
    OK(nicol_psh_project_image(&image, 1, f.data(), f.size()));
    CHECK(released == 1);
    REFUSES(nicol_psh_project_image(&image, 1, f.data(), f.size() - 1), "coefficients");
    CHECK(released == 2);
    image.channels = 0;
    REFUSES(nicol_psh_project_image(&image, 1, f.data(), f.size()), "channels");
    CHECK(released == 3);
}
