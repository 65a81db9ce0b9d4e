// SPDX-License-Identifier: MIT
// Transforms between samples on a grid and coefficients.
#include <cmath>
#include <mutex>
#include <utility>

#include "handles.hpp"
#include "harmonics/transform.hpp"
#include "initialiser.hpp"
#include "psh_arguments.hpp"

namespace nicol::capi {
struct SharedTransform {
    explicit SharedTransform(PshTransform made) : transform(std::move(made)) {}

    PshTransform transform;
    std::mutex mutex;  // the transform has only one work space

    [[nodiscard]] std::uint64_t vector_samples() const {
        return 4 * static_cast<std::uint64_t>(transform.rows().count()) *
               static_cast<std::uint64_t>(transform.columns());
    }
};

}  // namespace nicol::capi

struct nicol_psh_transform_impl : nicol::capi::Handle<nicol::capi::SharedTransform> {
    static constexpr auto kKind = nicol::capi::HandleKind::psh_transform;
};

using namespace nicol;
using namespace nicol::capi;

namespace {

LatitudeRows rows_of(const nicol_psh_sampling& sampling) {
    const std::uint32_t exact =
        sampling.grid == NICOL_PSH_GRID_GAUSS_LEGENDRE ? sampling.order + 1 : 2 * sampling.order + 1;
    const std::uint32_t least = sampling.grid == NICOL_PSH_GRID_CLENSHAW_CURTIS ? 2 : 1;
    const auto most =
        static_cast<std::uint32_t>(sampling.grid == NICOL_PSH_GRID_GAUSS_LEGENDRE ? kMaxGaussRows : kMaxRows);
    const std::uint32_t rows = sampling.rows == 0 ? std::max(exact, least) : sampling.rows;
    if (rows < least || rows > most) {
        refuse("sampling->rows is " + std::to_string(rows) + "; it must lie in " + std::to_string(least) +
               " to " + std::to_string(most));
    }
    const std::uint64_t work = std::uint64_t{rows} * (4 * std::uint64_t{sampling.order} + 3) * 16;
    if (work > kMaxWorkBytes) {
        refuse("sampling->rows is " + std::to_string(rows) + "; at order " + std::to_string(sampling.order) +
               " that takes " + std::to_string(work) + " bytes of work space, at most " +
               std::to_string(kMaxWorkBytes) + " are given");
    }
    const int count = static_cast<int>(rows);
    switch (sampling.grid) {
        case NICOL_PSH_GRID_FEJER:
            return fejer_rows(count);
        case NICOL_PSH_GRID_CLENSHAW_CURTIS:
            return clenshaw_curtis_rows(count);
        default:
            return gauss_legendre_rows(count);
    }
}

int columns_of(const nicol_psh_sampling& sampling) {
    const std::uint32_t least = 2 * sampling.order + 1;
    const std::uint32_t columns = sampling.columns == 0 ? least : sampling.columns;
    if (columns < least || columns > static_cast<std::uint32_t>(kMaxColumns)) {
        refuse("sampling->columns is " + std::to_string(columns) + "; it must lie in " +
               std::to_string(least) + " (2 order + 1) to " + std::to_string(kMaxColumns));
    }
    return static_cast<int>(columns);
}

}  // namespace

nicol_result nicol_psh_transform_create(const nicol_psh_sampling* sampling, nicol_psh_transform* transform) {
    return guarded([&] {
        require(transform, "transform");
        const nicol_psh_sampling given =
            read_struct(sampling, nicol_psh_sampling NICOL_PSH_SAMPLING_INIT, "sampling");
        if (given.grid > NICOL_PSH_GRID_GAUSS_LEGENDRE) {
            refuse("sampling->grid is " + std::to_string(given.grid) +
                   "; it must be one of NICOL_PSH_GRID_...");
        }
        if (given.reserved != 0) refuse("sampling->reserved must be 0");
        if (!std::isfinite(given.phi0)) refuse("sampling->phi0 is not finite");
        const int order = read_order(given.order, "sampling->order");
        const int columns = columns_of(given);
        *transform = make_handle<nicol_psh_transform_impl>(
            nullptr,
            std::make_shared<SharedTransform>(PshTransform(order, rows_of(given), columns, given.phi0)));
    });
}

nicol_result nicol_psh_transform_retain(nicol_psh_transform transform) {
    return retain(transform);
}
nicol_result nicol_psh_transform_release(nicol_psh_transform transform) {
    return release(transform);
}

nicol_result nicol_psh_transform_get_size(nicol_psh_transform transform, uint32_t* rows, uint32_t* columns) {
    return guarded([&] {
        const auto self = resolve(transform);
        require(rows, "rows");
        require(columns, "columns");
        *rows = static_cast<std::uint32_t>(self.content->transform.rows().count());
        *columns = static_cast<std::uint32_t>(self.content->transform.columns());
    });
}

nicol_result nicol_psh_transform_get_rows(nicol_psh_transform transform, double* theta, double* weight,
                                          uint64_t count) {
    return guarded([&] {
        const auto self = resolve(transform);
        const LatitudeRows& rows = self.content->transform.rows();
        const auto angles = write_array(theta, count, 1, rows.theta.size(), "theta");
        const auto weights = write_array(weight, count, 1, rows.theta.size(), "weight");
        std::ranges::copy(rows.theta, angles.begin());
        std::ranges::copy(rows.weight, weights.begin());
    });
}

nicol_result nicol_psh_analyze(nicol_psh_transform transform, uint64_t vectors, const double* samples,
                               uint64_t sample_count, double* coefficients, uint64_t coefficient_count) {
    return guarded([&] {
        const auto self = resolve(transform);
        PshTransform& plan = self.content->transform;
        const std::uint64_t size = vector_size(plan.order());
        const std::uint64_t grid = self.content->vector_samples();
        const auto from = read_array(samples, sample_count, vectors, grid, "samples");
        const auto to = write_array(coefficients, coefficient_count, vectors, size, "coefficients");
        require_apart(from, to, "samples and coefficients");
        const std::lock_guard lock(self.content->mutex);
        for (std::uint64_t v = 0; v < vectors; ++v)
            plan.analyze(from.subspan(v * grid, grid), to.subspan(v * size, size));
    });
}

nicol_result nicol_psh_synthesize(nicol_psh_transform transform, uint64_t vectors, const double* coefficients,
                                  uint64_t coefficient_count, double* samples, uint64_t sample_count) {
    return guarded([&] {
        const auto self = resolve(transform);
        PshTransform& plan = self.content->transform;
        const std::uint64_t size = vector_size(plan.order());
        const std::uint64_t grid = self.content->vector_samples();
        const auto from = read_array(coefficients, coefficient_count, vectors, size, "coefficients");
        const auto to = write_array(samples, sample_count, vectors, grid, "samples");
        require_apart(from, to, "coefficients and samples");
        const std::lock_guard lock(self.content->mutex);
        for (std::uint64_t v = 0; v < vectors; ++v)
            plan.synthesize(from.subspan(v * size, size), to.subspan(v * grid, grid));
    });
}

NICOL_INITIALISER(nicol_psh_sampling, NICOL_PSH_SAMPLING_INIT)
