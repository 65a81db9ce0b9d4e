// SPDX-License-Identifier: MIT
// Tests of PSH functions that refuse arguments beyond the rules of contract_gl_test.cpp: ranges, overlaps and
// callback results.
#include "psh.hpp"

using namespace capi_test;

namespace {

constexpr Rotation identity = {1, 0, 0, 0, 1, 0, 0, 0, 1};

}  // namespace

TEST_CASE("psh: directions and rotations that are none, and memory that overlaps, are refused") {
    const std::size_t n = vector_size(3), samples = 4 * 7 * 7;
    const Doubles f(2 * n), scalar(16), matrix(n * n), zero = {1, 0, 0, 0, 0, 0};
    Doubles shared(n * n + n);
    Untouched out(2 * n), stokes(16);
    double* const both = shared.data();
    const Owned transform(make_transform(NICOL_PSH_GRID_FEJER, 3));
    const auto evaluate = [&](std::uint64_t vectors) {
        return nicol_psh_evaluate(3, vectors, f.data(), vectors * n, zero.data(), 6, stokes.data(),
                                  vectors * 8);
    };
    check_refused({
        {"direction 1 is zero", [&] { return evaluate(1); }},
        {"direction 1 is zero", [&] { return evaluate(2); }},
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
        {"overlap", [&] { return nicol_psh_analyze(transform, 1, both, samples, both + samples - 1, n); }},
        {"overlap", [&] { return nicol_psh_synthesize(transform, 1, both, n, both, samples); }},
    });
    for (const Rotation& r :
         {Rotation{}, Rotation{1, 0, 0, 0, 1, 0, 0, 0, -1}, Rotation{2, 0, 0, 0, 2, 0, 0, 0, 2},
          Rotation{1, 0.1, 0, 0, 1, 0, 0, 0, 1}, Rotation{not_a_number, 0, 0, 0, 1, 0, 0, 0, 1},
          Rotation{infinity, 0, 0, 0, 1, 0, 0, 0, 1}})
        REFUSES(nicol_psh_rotate(3, 2, f.data(), 2 * n, r.data(), out.data(), 2 * n), "rotation");
}

TEST_CASE("psh: no vectors and no directions are nothing to do") {
    OK(nicol_psh_evaluate(3, 0, nullptr, 0, identity.data(), 9, nullptr, 0));
    const Doubles f(2 * vector_size(3)), bands(16);
    OK(nicol_psh_evaluate(3, 2, f.data(), f.size(), nullptr, 0, nullptr, 0));
    OK(nicol_psh_rotate(3, 0, nullptr, 0, identity.data(), nullptr, 0));
    OK(nicol_psh_reflect(3, 0, nullptr, 0, nullptr, 0));
    OK(nicol_psh_multiply(0, identity.data(), 1, 3, 0, nullptr, 0, 2, nullptr, 0));
    OK(nicol_psh_analyze(Owned(make_transform(NICOL_PSH_GRID_FEJER, 4)), 0, nullptr, 0, nullptr, 0));
    OK(nicol_psh_kernel_at(0, bands.data(), bands.size(), nullptr, 0, nullptr, 0));
}

TEST_CASE("psh: samplings that are too coarse, too large or unknown are refused by name") {
    nicol_psh_transform transform = nullptr;
    using S = nicol_psh_sampling;
    S good = NICOL_PSH_SAMPLING_INIT;
    good.order = 4;
    check_wrong(good, [&](const S& sampling) { return nicol_psh_transform_create(&sampling, &transform); },
                {{"grid is 3", [](S& s) { s.grid = 3; }},
                 {"reserved", [](S& s) { s.reserved = 1; }},
                 {"rows", [](S& s) { s.grid = NICOL_PSH_GRID_CLENSHAW_CURTIS, s.rows = 1; }},
                 {"rows", [](S& s) { s.grid = NICOL_PSH_GRID_GAUSS_LEGENDRE, s.rows = 16385; }},
                 {"work space", [](S& s) { s.order = 4096, s.rows = 32768; }},
                 {"rows", [](S& s) { s.rows = 32769; }},
                 {"rows", [](S& s) { s.rows = UINT32_MAX; }},
                 {"columns", [](S& s) { s.columns = 8; }},
                 {"columns", [](S& s) { s.columns = 131073; }},
                 {"columns", [](S& s) { s.columns = UINT32_MAX; }},
                 {"phi0", [](S& s) { s.phi0 = not_a_number; }},
                 {"phi0", [](S& s) { s.phi0 = infinity; }},
                 {"sampling->order is", [](S& s) { s.order = 4097; }},
                 {"sampling->order is", [](S& s) { s.order = UINT32_MAX; }}});
    CHECK(transform == nullptr);
}

TEST_CASE("psh: Mueller fields out of range are refused by name, and their callback can stop the call") {
    using F = nicol_psh_mueller_field;
    Untouched m(vector_size(2) * vector_size(3));
    F good = NICOL_PSH_MUELLER_FIELD_INIT;
    good.order_out = 2;
    good.order_in = 3;
    good.callback = [](void*, const double*, const double*, double*) { return std::int32_t{1}; };
    const auto project = [&](const F& field) { return nicol_psh_project_matrix(&field, m.data(), m.size()); };
    check_wrong(good, project,
                {{"isotropic", [](F& f) { f.isotropic = 2; }},
                 {"callback is NULL", [](F& f) { f.callback = nullptr; }},
                 {"order_out is 65", [](F& f) { f.order_out = 65; }},
                 {"order_in is 4294967295", [](F& f) { f.order_in = UINT32_MAX; }},
                 {"rows_out is 4097", [](F& f) { f.rows_out = 4097; }},
                 {"rows_in", [](F& f) { f.rows_in = UINT32_MAX; }},
                 {"columns_out is 4", [](F& f) { f.columns_out = 4; }},
                 {"columns_in is 6", [](F& f) { f.columns_in = 6; }},
                 {"work space", [](F& f) { f.rows_out = f.columns_out = 4096; }},
                 {"columns_in", [](F& f) { f.isotropic = 1, f.columns_in = 4; }},
                 {"columns_out", [](F& f) { f.isotropic = 1, f.columns_out = 9; }}});
    for (const std::uint32_t isotropic : {0U, 1U}) {
        F field = good;
        int calls = 0;
        field.isotropic = isotropic;
        field.user = &calls;
        field.callback = [](void* user, const double*, const double*, double*) {
            return static_cast<std::int32_t>(++*static_cast<int*>(user) < 10);
        };
        FAILS(project(field), NICOL_ERROR_CANCELLED, "callback");
        CHECK(calls == 10);
        field.callback = [](void*, const double*, const double* out, double* mueller) {
            mueller[7] = out[2] < 0 ? not_a_number : 0;
            return std::int32_t{1};
        };
        REFUSES(project(field), "not finite");
    }
}

TEST_CASE("psh: kernels out of range are refused by name, and their callback can stop the call") {
    Untouched bands(64), mueller(48), out(vector_size(3));
    const Doubles zero(64), f(out.size());
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
    for (const double wrong : {-1e-9, 3.1416}) {
        const Doubles angles = {0, wrong, 1};
        REFUSES(nicol_psh_kernel_at(3, zero.data(), 64, angles.data(), 3, mueller.data(), 48), "theta[1]");
    }
    for (const std::size_t at : {4U, 15U, 20U, 31U}) {
        Doubles spin = zero;
        spin[at] = 1;
        REFUSES(nicol_psh_convolve(3, spin.data(), 64, 1, f.data(), f.size(), out.data(), out.size()),
                "band " + std::to_string(at / 16));
    }
}

TEST_CASE("psh: an image is released once, on success and on failure") {
    const std::vector<float> pixels(16, 1.0F);
    nicol_image image = image_of(pixels, 4, 4, 1, 1);
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
