// SPDX-License-Identifier: MIT
// Transforms between fields on grids and coefficients, separably: Fourier along phi, Legendre along theta.
#pragma once

#include <complex>
#include <memory>
#include <span>
#include <vector>

#include "harmonics/grid.hpp"
#include "harmonics/psh.hpp"

namespace nicol {

/// Fourier coefficients along phi of a Stokes vector field on rows of latitude, up to degree order: s0(theta,
/// phi) = sum_m g_m exp(i m phi), and s1 + i s2 = sum_m w_m exp(i m phi). Because s0 and s3 are real, only
/// their m >= 0 is kept.
struct FourierRows {
    FourierRows(int order, int rows);

    int order;
    int rows;
    std::vector<std::complex<double>> s0;    ///< [row][m], m = 0..order
    std::vector<std::complex<double>> s3;    ///< [row][m], m = 0..order
    std::vector<std::complex<double>> spin;  ///< [row][m + order], m = -order..order

    [[nodiscard]] std::size_t scalar_index(int row, int m) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(order + 1) +
               static_cast<std::size_t>(m);
    }
    [[nodiscard]] std::size_t spin_index(int row, int m) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(2 * order + 1) +
               static_cast<std::size_t>(m + order);
    }
};

/// Step of the transform along theta. Not for use by two threads at once.
class LegendreTransform {
public:
    /// Throws Error(invalid_argument) for an order out of range or rows whose members differ in length.
    LegendreTransform(int order, LatitudeRows rows);
    ~LegendreTransform();
    LegendreTransform(LegendreTransform&&) noexcept;
    LegendreTransform& operator=(LegendreTransform&&) noexcept;

    [[nodiscard]] int order() const noexcept;
    [[nodiscard]] const LatitudeRows& rows() const noexcept;

    /// Computes the coefficients [psh_index(l, m)][p] of one channel: the inner products with the basis (Eq.
    /// 32), with the rows' weights for the integral over theta. `fourier` must have this order and row count.
    /// Throws Error(invalid_argument) if it does not, and if a value is not finite.
    void analyze(const FourierRows& fourier, std::span<double> coefficients);

    /// Computes the field of the coefficients on the rows, as Fourier coefficients. p = 1, 2 below l = 2 are
    /// ignored. Throws what analyze() throws.
    void synthesize(std::span<const double> coefficients, FourierRows& fourier);

private:
    struct Plan;
    std::unique_ptr<Plan> plan_;
};

/// Largest number of samples in a row.
inline constexpr int kMaxColumns = 1 << 17;

/// Step of the transform along phi, for rows of `columns` samples at phi_c = phi0 + 2 pi c / columns. Not for
/// use by two threads at once.
class FourierTransform {
public:
    /// Throws Error(invalid_argument) unless columns >= 2 order + 1 (fewer cannot tell the degrees apart).
    FourierTransform(int order, int columns, double phi0 = 0);
    ~FourierTransform();
    FourierTransform(FourierTransform&&) noexcept;
    FourierTransform& operator=(FourierTransform&&) noexcept;

    [[nodiscard]] int order() const noexcept;
    [[nodiscard]] int columns() const noexcept;

    /// Transforms samples [row][column][4] of one or more rows into `fourier` from row `first_row` on;
    /// several rows in one call are faster. Components that are zero throughout a row are not transformed.
    void analyze(std::span<const double> samples, FourierRows& fourier, int first_row);
    /// Computes the inverse for as many rows of `fourier` as `samples` holds.
    void synthesize(const FourierRows& fourier, int first_row, std::span<double> samples);

private:
    struct Plan;
    std::unique_ptr<Plan> plan_;
};

/// Transform by both steps for one channel on a grid [row][column][4], with Stokes components in the
/// theta-phi frame of each point. Holds its work space: no allocation after construction, not for use by two
/// threads at once.
class PshTransform {
public:
    PshTransform(int order, LatitudeRows rows, int columns, double phi0 = 0);

    [[nodiscard]] int order() const noexcept { return legendre_.order(); }
    [[nodiscard]] const LatitudeRows& rows() const noexcept { return legendre_.rows(); }
    [[nodiscard]] int columns() const noexcept { return fourier_.columns(); }

    /// Transforms between samples, rows * columns * 4 values, and coefficients, 4 * psh_count(order) values.
    /// Overwrites the output.
    void analyze(std::span<const double> samples, std::span<double> coefficients);
    void synthesize(std::span<const double> coefficients, std::span<double> samples);

private:
    LegendreTransform legendre_;
    FourierTransform fourier_;
    FourierRows work_;
};

}  // namespace nicol
