// SPDX-License-Identifier: MIT
// Every argument of the calls on fields and transforms, wrong in turn.
#include "psh_checks.hpp"

using namespace capi_test;

namespace {

const Rotation identity = {1, 0, 0, 0, 1, 0, 0, 0, 1};

}  // namespace

TEST_CASE("psh errors: evaluate") {
    const std::size_t n = vector_size(3);
    const Doubles f(2 * n), w = {1, 0, 0, 0, 1, 0};
    Untouched s(16);
    check_order(4096, "order", [&](std::uint32_t order) {
        return nicol_psh_evaluate(order, 2, f.data(), 2 * n, w.data(), 6, s.data(), 16);
    });
    check_input(2 * n, "coefficients", [&](const double* x, std::uint64_t count) {
        return nicol_psh_evaluate(3, 2, x, count, w.data(), 6, s.data(), 16);
    });
    check_output(16, "stokes", [&](double* x, std::uint64_t count) {
        return nicol_psh_evaluate(3, 2, f.data(), 2 * n, w.data(), 6, x, count);
    });
    FAILS(nicol_psh_evaluate(3, huge, f.data(), 2 * n, w.data(), 6, s.data(), 16),
          NICOL_ERROR_INVALID_ARGUMENT, "coefficients");
    FAILS(nicol_psh_evaluate(3, 2, f.data(), 2 * n, nullptr, 6, s.data(), 16), NICOL_ERROR_INVALID_ARGUMENT,
          "directions is NULL");
    FAILS(nicol_psh_evaluate(3, 2, f.data(), 2 * n, w.data(), 5, s.data(), 16), NICOL_ERROR_INVALID_ARGUMENT,
          "directions");
    for (const std::uint64_t vectors : {1U, 2U}) {
        const Doubles zero = {1, 0, 0, 0, 0, 0}, bad = {1, 0, 0, 0, not_a_number, 0};
        FAILS(nicol_psh_evaluate(3, vectors, f.data(), vectors * n, zero.data(), 6, s.data(), 8 * vectors),
              NICOL_ERROR_INVALID_ARGUMENT, "direction 1 is zero");
        FAILS(nicol_psh_evaluate(3, vectors, f.data(), vectors * n, bad.data(), 6, s.data(), 8 * vectors),
              NICOL_ERROR_INVALID_ARGUMENT, "directions[4]");
    }
    OK(nicol_psh_evaluate(3, 0, nullptr, 0, w.data(), 6, nullptr, 0));
    OK(nicol_psh_evaluate(3, 2, f.data(), 2 * n, nullptr, 0, nullptr, 0));
}

TEST_CASE("psh errors: rotate and reflect") {
    const std::size_t n = vector_size(3);
    const Doubles f(2 * n);
    Untouched g(2 * n);
    check_order(4096, "order", [&](std::uint32_t order) {
        return nicol_psh_rotate(order, 2, f.data(), 2 * n, identity.data(), g.data(), 2 * n);
    });
    check_input(2 * n, "in", [&](const double* x, std::uint64_t count) {
        return nicol_psh_rotate(3, 2, x, count, identity.data(), g.data(), 2 * n);
    });
    check_output(2 * n, "out", [&](double* x, std::uint64_t count) {
        return nicol_psh_rotate(3, 2, f.data(), 2 * n, identity.data(), x, count);
    });
    check_order(4096, "order", [&](std::uint32_t order) {
        return nicol_psh_reflect(order, 2, f.data(), 2 * n, g.data(), 2 * n);
    });
    check_input(2 * n, "in", [&](const double* x, std::uint64_t count) {
        return nicol_psh_reflect(3, 2, x, count, g.data(), 2 * n);
    });
    check_output(2 * n, "out", [&](double* x, std::uint64_t count) {
        return nicol_psh_reflect(3, 2, f.data(), 2 * n, x, count);
    });
    const Rotation no_rotations[] = {{},
                                     {1, 0, 0, 0, 1, 0, 0, 0, -1},
                                     {2, 0, 0, 0, 2, 0, 0, 0, 2},
                                     {1, 0.1, 0, 0, 1, 0, 0, 0, 1},
                                     {not_a_number, 0, 0, 0, 1, 0, 0, 0, 1},
                                     {infinity, 0, 0, 0, 1, 0, 0, 0, 1}};
    for (const Rotation& r : no_rotations)
        FAILS(nicol_psh_rotate(3, 2, f.data(), 2 * n, r.data(), g.data(), 2 * n),
              NICOL_ERROR_INVALID_ARGUMENT, "rotation");
    FAILS(nicol_psh_rotate(3, 2, f.data(), 2 * n, nullptr, g.data(), 2 * n), NICOL_ERROR_INVALID_ARGUMENT,
          "rotation is NULL");
    Doubles shared(3 * n);
    FAILS(nicol_psh_rotate(3, 2, shared.data(), 2 * n, identity.data(), shared.data() + n, 2 * n),
          NICOL_ERROR_INVALID_ARGUMENT, "in and out");
    FAILS(nicol_psh_reflect(3, 2, shared.data() + n, 2 * n, shared.data(), 2 * n),
          NICOL_ERROR_INVALID_ARGUMENT, "in and out");
    OK(nicol_psh_rotate(3, 0, nullptr, 0, identity.data(), nullptr, 0));
    OK(nicol_psh_reflect(3, 0, nullptr, 0, nullptr, 0));
}

TEST_CASE("psh errors: multiply and shadow matrix") {
    const std::size_t n = vector_size(3), k = vector_size(2);
    const Doubles scalar(25), f(2 * n);
    Untouched g(2 * k), m(k * n);
    const auto multiply = [&](std::uint32_t scalar_order, std::uint32_t order, std::uint32_t order_out) {
        return nicol_psh_multiply(scalar_order, scalar.data(), 25, order, 2, f.data(), 2 * n, order_out,
                                  g.data(), 2 * k);
    };
    check_order(4096, "scalar_order", [&](std::uint32_t order) { return multiply(order, 3, 2); });
    check_order(4096, "order", [&](std::uint32_t order) { return multiply(4, order, 2); });
    check_order(4096, "order_out", [&](std::uint32_t order) { return multiply(4, 3, order); });
    check_input(25, "scalar", [&](const double* x, std::uint64_t count) {
        return nicol_psh_multiply(4, x, count, 3, 2, f.data(), 2 * n, 2, g.data(), 2 * k);
    });
    check_input(2 * n, "in", [&](const double* x, std::uint64_t count) {
        return nicol_psh_multiply(4, scalar.data(), 25, 3, 2, x, count, 2, g.data(), 2 * k);
    });
    check_output(2 * k, "out", [&](double* x, std::uint64_t count) {
        return nicol_psh_multiply(4, scalar.data(), 25, 3, 2, f.data(), 2 * n, 2, x, count);
    });
    Doubles shared(2 * n);
    FAILS(nicol_psh_multiply(4, scalar.data(), 25, 3, 2, shared.data(), 2 * n, 2, shared.data(), 2 * k),
          NICOL_ERROR_INVALID_ARGUMENT, "in and out");
    FAILS(nicol_psh_multiply(4, shared.data(), 25, 3, 2, f.data(), 2 * n, 2, shared.data(), 2 * k),
          NICOL_ERROR_INVALID_ARGUMENT, "scalar and out");
    OK(nicol_psh_multiply(4, scalar.data(), 25, 3, 0, nullptr, 0, 2, nullptr, 0));

    const auto shadow = [&](std::uint32_t scalar_order, std::uint32_t out, std::uint32_t in) {
        return nicol_psh_shadow_matrix(scalar_order, scalar.data(), 25, out, in, m.data(), k * n);
    };
    check_order(128, "scalar_order", [&](std::uint32_t order) { return shadow(order, 2, 3); });
    check_order(64, "order_out", [&](std::uint32_t order) { return shadow(4, order, 3); });
    check_order(64, "order_in", [&](std::uint32_t order) { return shadow(4, 2, order); });
    check_input(25, "scalar", [&](const double* x, std::uint64_t count) {
        return nicol_psh_shadow_matrix(4, x, count, 2, 3, m.data(), k * n);
    });
    check_output(k * n, "matrix", [&](double* x, std::uint64_t count) {
        return nicol_psh_shadow_matrix(4, scalar.data(), 25, 2, 3, x, count);
    });
}

TEST_CASE("psh errors: transforms") {
    nicol_psh_transform transform = nullptr;
    const auto create = [&](auto change) {
        nicol_psh_sampling sampling = NICOL_PSH_SAMPLING_INIT;
        sampling.order = 4;
        change(sampling);
        return nicol_psh_transform_create(&sampling, &transform);
    };
    using S = nicol_psh_sampling;
    FAILS(nicol_psh_transform_create(nullptr, &transform), NICOL_ERROR_INVALID_ARGUMENT, "sampling is NULL");
    FAILS(create([](S& s) { s.struct_size = 3; }), NICOL_ERROR_INVALID_ARGUMENT, "struct_size");
    FAILS(create([](S& s) { s.grid = 3; }), NICOL_ERROR_INVALID_ARGUMENT, "grid is 3");
    check_order(4096, "sampling->order",
                [&](std::uint32_t order) { return create([&](S& s) { s.order = order; }); });
    for (const std::uint32_t rows : {32769U, UINT32_MAX})
        FAILS(create([&](S& s) { s.rows = rows; }), NICOL_ERROR_INVALID_ARGUMENT, "rows");
    FAILS(create([](S& s) { s.grid = NICOL_PSH_GRID_CLENSHAW_CURTIS, s.rows = 1; }),
          NICOL_ERROR_INVALID_ARGUMENT, "rows");
    FAILS(create([](S& s) { s.grid = NICOL_PSH_GRID_GAUSS_LEGENDRE, s.rows = 16385; }),
          NICOL_ERROR_INVALID_ARGUMENT, "rows");
    FAILS(create([](S& s) { s.order = 4096, s.rows = 32768; }), NICOL_ERROR_INVALID_ARGUMENT, "work space");
    for (const std::uint32_t columns : {8U, 131073U, UINT32_MAX})
        FAILS(create([&](S& s) { s.columns = columns; }), NICOL_ERROR_INVALID_ARGUMENT, "columns");
    FAILS(create([](S& s) { s.reserved = 1; }), NICOL_ERROR_INVALID_ARGUMENT, "reserved");
    for (const double phi0 : {not_a_number, infinity})
        FAILS(create([&](S& s) { s.phi0 = phi0; }), NICOL_ERROR_INVALID_ARGUMENT, "phi0");
    CHECK(transform == nullptr);
    const nicol_psh_sampling plain = NICOL_PSH_SAMPLING_INIT;
    FAILS(nicol_psh_transform_create(&plain, nullptr), NICOL_ERROR_INVALID_ARGUMENT, "transform is NULL");

    transform = make_transform(NICOL_PSH_GRID_FEJER, 4);
    const std::size_t n = vector_size(4), samples = 4 * 9 * 9;
    const Doubles f(2 * n), x(2 * samples);
    Untouched g(2 * n), y(2 * samples);
    check_input(2 * n, "coefficients", [&](const double* in, std::uint64_t count) {
        return nicol_psh_synthesize(transform, 2, in, count, y.data(), 2 * samples);
    });
    check_output(2 * samples, "samples", [&](double* out, std::uint64_t count) {
        return nicol_psh_synthesize(transform, 2, f.data(), 2 * n, out, count);
    });
    check_input(2 * samples, "samples", [&](const double* in, std::uint64_t count) {
        return nicol_psh_analyze(transform, 2, in, count, g.data(), 2 * n);
    });
    check_output(2 * n, "coefficients", [&](double* out, std::uint64_t count) {
        return nicol_psh_analyze(transform, 2, x.data(), 2 * samples, out, count);
    });
    check_output(9, "theta", [&](double* out, std::uint64_t count) {
        Untouched weight(9);
        return nicol_psh_transform_get_rows(transform, out, weight.data(), count);
    });
    Untouched theta(9);
    FAILS(nicol_psh_transform_get_rows(transform, theta.data(), nullptr, 9), NICOL_ERROR_INVALID_ARGUMENT,
          "weight is NULL");
    std::uint32_t size = 5;
    FAILS(nicol_psh_transform_get_size(transform, nullptr, &size), NICOL_ERROR_INVALID_ARGUMENT,
          "rows is NULL");
    FAILS(nicol_psh_transform_get_size(transform, &size, nullptr), NICOL_ERROR_INVALID_ARGUMENT,
          "columns is NULL");
    CHECK(size == 5);
    Doubles shared(2 * samples);
    FAILS(nicol_psh_analyze(transform, 1, shared.data(), samples, shared.data() + samples - 1, n),
          NICOL_ERROR_INVALID_ARGUMENT, "overlap");
    FAILS(nicol_psh_synthesize(transform, 1, shared.data(), n, shared.data(), samples),
          NICOL_ERROR_INVALID_ARGUMENT, "overlap");
    OK(nicol_psh_analyze(transform, 0, nullptr, 0, nullptr, 0));
    OK(nicol_psh_transform_release(transform));
    FAILS(nicol_psh_analyze(transform, 0, nullptr, 0, nullptr, 0), NICOL_ERROR_INVALID_HANDLE,
          "nicol_psh_transform");
    FAILS(nicol_psh_synthesize(nullptr, 0, nullptr, 0, nullptr, 0), NICOL_ERROR_INVALID_HANDLE, "NULL");
    FAILS(nicol_psh_transform_get_rows(nullptr, nullptr, nullptr, 0), NICOL_ERROR_INVALID_HANDLE, "NULL");
}
