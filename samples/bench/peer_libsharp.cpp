// SPDX-License-Identifier: MIT
#include <libsharp/sharp.h>
#include <libsharp/sharp_almhelpers.h>
#include <libsharp/sharp_geomhelpers.h>

#include <complex>
#include <vector>

#include "peer.hpp"

namespace {

// libsharp on one thread, as in Nicol's measurement.
class Libsharp final : public PeerTransform {
public:
    explicit Libsharp(int order) {
        sharp_make_gauss_geom_info(order + 1, 2 * order + 2, 0, 1, 2 * order + 2, &grid_);
        sharp_make_triangular_alm_info(order, order, 1, &layout_);
        for (int i = 0; i < 2; ++i) {
            coefficients_[i].assign(static_cast<std::size_t>(sharp_alm_count(layout_)), {0.5, 0.25});
            map_[i].assign(static_cast<std::size_t>(sharp_map_size(grid_)), 1.0);
        }
    }
    ~Libsharp() override {
        sharp_destroy_alm_info(layout_);
        sharp_destroy_geom_info(grid_);
    }
    void synthesize_spin2() override { run(SHARP_ALM2MAP, 2); }
    void analyze_spin2() override { run(SHARP_MAP2ALM, 2); }
    void synthesize_scalar() override { run(SHARP_ALM2MAP, 0); }
    void analyze_scalar() override { run(SHARP_MAP2ALM, 0); }

private:
    void run(sharp_jobtype job, int spin) {
        void* coefficients[2] = {coefficients_[0].data(), coefficients_[1].data()};
        void* map[2] = {map_[0].data(), map_[1].data()};
        sharp_execute(job, spin, coefficients, map, grid_, layout_, SHARP_DP | SHARP_NO_OPENMP, nullptr,
                      nullptr);
    }

    sharp_geom_info* grid_ = nullptr;
    sharp_alm_info* layout_ = nullptr;
    std::vector<std::complex<double>> coefficients_[2];
    std::vector<double> map_[2];
};

}  // namespace

std::unique_ptr<PeerTransform> libsharp_transform(int order) {
    return std::make_unique<Libsharp>(order);
}
