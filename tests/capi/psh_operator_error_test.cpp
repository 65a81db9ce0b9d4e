// SPDX-License-Identifier: MIT
// Every argument of the calls on operators and kernels, wrong in turn.
#include "psh_checks.hpp"

using namespace capi_test;

TEST_CASE("psh errors: Mueller fields") {
    using F = nicol_psh_mueller_field;
    const nicol_psh_mueller_callback zero = [](void*, const double*, const double*, double*) {
        return std::int32_t{1};
    };
    const std::size_t count = vector_size(2) * vector_size(3);
    Untouched m(count);
    const auto project = [&](auto change) {
        F field = NICOL_PSH_MUELLER_FIELD_INIT;
        field.order_out = 2;
        field.order_in = 3;
        field.callback = zero;
        change(field);
        return nicol_psh_project_matrix(&field, m.data(), count);
    };
    FAILS(nicol_psh_project_matrix(nullptr, m.data(), count), NICOL_ERROR_INVALID_ARGUMENT, "field is NULL");
    FAILS(project([](F& f) { f.struct_size = 0; }), NICOL_ERROR_INVALID_ARGUMENT, "struct_size");
    FAILS(project([](F& f) { f.isotropic = 2; }), NICOL_ERROR_INVALID_ARGUMENT, "isotropic");
    FAILS(project([](F& f) { f.callback = nullptr; }), NICOL_ERROR_INVALID_ARGUMENT, "callback is NULL");
    check_order(64, "order_out", [&](std::uint32_t o) { return project([&](F& f) { f.order_out = o; }); });
    check_order(64, "order_in", [&](std::uint32_t o) { return project([&](F& f) { f.order_in = o; }); });
    FAILS(project([](F& f) { f.rows_out = 4097; }), NICOL_ERROR_INVALID_ARGUMENT, "rows_out is 4097");
    FAILS(project([](F& f) { f.rows_in = UINT32_MAX; }), NICOL_ERROR_INVALID_ARGUMENT, "rows_in");
    FAILS(project([](F& f) { f.columns_out = 4; }), NICOL_ERROR_INVALID_ARGUMENT, "columns_out is 4");
    FAILS(project([](F& f) { f.columns_in = 6; }), NICOL_ERROR_INVALID_ARGUMENT, "columns_in is 6");
    FAILS(project([](F& f) { f.rows_out = f.columns_out = 4096; }), NICOL_ERROR_INVALID_ARGUMENT,
          "work space");
    FAILS(project([](F& f) { f.isotropic = 1, f.columns_in = 4; }), NICOL_ERROR_INVALID_ARGUMENT,
          "columns_in");
    FAILS(project([](F& f) { f.isotropic = 1, f.columns_out = 9; }), NICOL_ERROR_INVALID_ARGUMENT,
          "columns_out");
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
        FAILS(project([&](F& f) {
                  f.isotropic = isotropic;
                  f.callback = [](void*, const double*, const double* out, double* mueller) {
                      mueller[7] = out[2] < 0 ? not_a_number : 0;
                      return std::int32_t{1};
                  };
              }),
              NICOL_ERROR_INVALID_ARGUMENT, "not finite");
    }
    F field = NICOL_PSH_MUELLER_FIELD_INIT;
    field.order_out = 2;
    field.order_in = 3;
    field.callback = zero;
    check_output(count, "matrix",
                 [&](double* x, std::uint64_t n) { return nicol_psh_project_matrix(&field, x, n); });
}

TEST_CASE("psh errors: matrices") {
    const std::size_t n = vector_size(2), k = vector_size(3);
    const Doubles m(n * k), f(2 * k), square(n * n);
    Untouched g(2 * n), both(n * k);
    check_order(64, "order_out", [&](std::uint32_t o) {
        return nicol_psh_apply_matrix(o, 3, m.data(), n * k, 2, f.data(), 2 * k, g.data(), 2 * n);
    });
    check_order(64, "order_in", [&](std::uint32_t o) {
        return nicol_psh_apply_matrix(2, o, m.data(), n * k, 2, f.data(), 2 * k, g.data(), 2 * n);
    });
    check_input(n * k, "matrix", [&](const double* x, std::uint64_t count) {
        return nicol_psh_apply_matrix(2, 3, x, count, 2, f.data(), 2 * k, g.data(), 2 * n);
    });
    check_input(2 * k, "in", [&](const double* x, std::uint64_t count) {
        return nicol_psh_apply_matrix(2, 3, m.data(), n * k, 2, x, count, g.data(), 2 * n);
    });
    check_output(2 * n, "out", [&](double* x, std::uint64_t count) {
        return nicol_psh_apply_matrix(2, 3, m.data(), n * k, 2, f.data(), 2 * k, x, count);
    });
    Doubles shared(n * n + n);
    FAILS(nicol_psh_apply_matrix(2, 2, square.data(), n * n, 1, shared.data(), n, shared.data(), n),
          NICOL_ERROR_INVALID_ARGUMENT, "in and out");
    FAILS(nicol_psh_apply_matrix(2, 2, shared.data(), n * n, 1, f.data(), n, shared.data() + n, n),
          NICOL_ERROR_INVALID_ARGUMENT, "matrix and out");

    const auto compose = [&](std::uint32_t out, std::uint32_t between, std::uint32_t in) {
        return nicol_psh_compose_matrix(out, between, in, square.data(), n * n, m.data(), n * k, both.data(),
                                        n * k);
    };
    check_order(64, "order_out", [&](std::uint32_t o) { return compose(o, 2, 3); });
    check_order(64, "order_between", [&](std::uint32_t o) { return compose(2, o, 3); });
    check_order(64, "order_in", [&](std::uint32_t o) { return compose(2, 2, o); });
    check_input(n * n, "second", [&](const double* x, std::uint64_t count) {
        return nicol_psh_compose_matrix(2, 2, 3, x, count, m.data(), n * k, both.data(), n * k);
    });
    check_input(n * k, "first", [&](const double* x, std::uint64_t count) {
        return nicol_psh_compose_matrix(2, 2, 3, square.data(), n * n, x, count, both.data(), n * k);
    });
    check_output(n * k, "matrix", [&](double* x, std::uint64_t count) {
        return nicol_psh_compose_matrix(2, 2, 3, square.data(), n * n, m.data(), n * k, x, count);
    });
}

TEST_CASE("psh errors: kernels") {
    const nicol_psh_kernel_callback zero = [](void*, double, double*) { return std::int32_t{1}; };
    const std::size_t n = vector_size(3);
    const Doubles b(4 * 16), f(2 * n), theta = {0, 1, pi}, m(n * n);
    Untouched bands(4 * 16), g(2 * n), mueller(3 * 16), matrix(n * n);

    FAILS(nicol_psh_project_kernel(nullptr, nullptr, 3, 0, bands.data(), 64), NICOL_ERROR_INVALID_ARGUMENT,
          "callback is NULL");
    check_order(4096, "order", [&](std::uint32_t order) {
        return nicol_psh_project_kernel(zero, nullptr, order, 0, bands.data(), 64);
    });
    FAILS(nicol_psh_project_kernel(zero, nullptr, 3, 16385, bands.data(), 64), NICOL_ERROR_INVALID_ARGUMENT,
          "rows is 16385");
    check_output(64, "bands", [&](double* x, std::uint64_t count) {
        return nicol_psh_project_kernel(zero, nullptr, 3, 0, x, count);
    });
    FAILS(nicol_psh_project_kernel([](void*, double t, double*) { return std::int32_t{t < 2}; }, nullptr, 3,
                                   0, bands.data(), 64),
          NICOL_ERROR_CANCELLED, "callback");
    FAILS(nicol_psh_project_kernel(
              [](void*, double, double* x) {
                  x[15] = infinity;
                  return std::int32_t{1};
              },
              nullptr, 3, 0, bands.data(), 64),
          NICOL_ERROR_INVALID_ARGUMENT, "not finite");

    check_order(4096, "order", [&](std::uint32_t order) {
        return nicol_psh_kernel_at(order, b.data(), 64, theta.data(), 3, mueller.data(), 48);
    });
    check_input(64, "bands", [&](const double* x, std::uint64_t count) {
        return nicol_psh_kernel_at(3, x, count, theta.data(), 3, mueller.data(), 48);
    });
    check_output(48, "mueller", [&](double* x, std::uint64_t count) {
        return nicol_psh_kernel_at(3, b.data(), 64, theta.data(), 3, x, count);
    });
    FAILS(nicol_psh_kernel_at(3, b.data(), 64, nullptr, 3, mueller.data(), 48), NICOL_ERROR_INVALID_ARGUMENT,
          "theta is NULL");
    for (const double wrong : {-1e-9, 3.1416, not_a_number, infinity}) {
        const Doubles angles = {0, wrong, 1};
        FAILS(nicol_psh_kernel_at(3, b.data(), 64, angles.data(), 3, mueller.data(), 48),
              NICOL_ERROR_INVALID_ARGUMENT, "theta[1]");
    }

    check_order(4096, "order", [&](std::uint32_t order) {
        return nicol_psh_convolve(order, b.data(), 64, 2, f.data(), 2 * n, g.data(), 2 * n);
    });
    check_input(64, "bands", [&](const double* x, std::uint64_t count) {
        return nicol_psh_convolve(3, x, count, 2, f.data(), 2 * n, g.data(), 2 * n);
    });
    check_input(2 * n, "in", [&](const double* x, std::uint64_t count) {
        return nicol_psh_convolve(3, b.data(), 64, 2, x, count, g.data(), 2 * n);
    });
    check_output(2 * n, "out", [&](double* x, std::uint64_t count) {
        return nicol_psh_convolve(3, b.data(), 64, 2, f.data(), 2 * n, x, count);
    });
    for (const std::size_t at : {4U, 15U, 20U, 31U}) {
        Doubles spin = b;
        spin[at] = 1;
        FAILS(nicol_psh_convolve(3, spin.data(), 64, 2, f.data(), 2 * n, g.data(), 2 * n),
              NICOL_ERROR_INVALID_ARGUMENT, "band " + std::to_string(at / 16));
    }

    check_order(64, "order", [&](std::uint32_t order) {
        return nicol_psh_kernel_matrix(order, b.data(), 64, matrix.data(), n * n);
    });
    check_input(64, "bands", [&](const double* x, std::uint64_t count) {
        return nicol_psh_kernel_matrix(3, x, count, matrix.data(), n * n);
    });
    check_output(n * n, "matrix", [&](double* x, std::uint64_t count) {
        return nicol_psh_kernel_matrix(3, b.data(), 64, x, count);
    });
    check_order(64, "order", [&](std::uint32_t order) {
        return nicol_psh_nearest_kernel(order, m.data(), n * n, bands.data(), 64);
    });
    check_input(n * n, "matrix", [&](const double* x, std::uint64_t count) {
        return nicol_psh_nearest_kernel(3, x, count, bands.data(), 64);
    });
    check_output(64, "bands", [&](double* x, std::uint64_t count) {
        return nicol_psh_nearest_kernel(3, m.data(), n * n, x, count);
    });
}
