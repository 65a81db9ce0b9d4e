// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "error.hpp"
#include "files/content_hash.hpp"
#include "harmonics/operator.hpp"
#include "harmonics/spin_harmonics.hpp"
#include "material/key.hpp"
#include "material/matrix_rows.hpp"
#include "material/mixed_terms.hpp"
#include "material/psh_matrix_file.hpp"
#include "material/reflectance.hpp"

namespace nicol {
namespace {

using std::numbers::pi;
// Rounding error of files in single precision, relative to the norm.
constexpr double kRounding = 1e-6;

// Material with rows at outgoing angles a sixth of the shortest half-wave apart and cubics between rows.
class PshMatrixMaterial final : public Material, public MixedTerms {
public:
    PshMatrixMaterial(std::vector<IsotropicMatrix> channels, const std::vector<double>& scale)
        : matrices_(std::move(channels)),
          layout_(matrices_.front().order_in(), LightKind::full),
          cells_(6 * (matrices_.front().order_out() + 1)) {
        for (std::size_t c = 0; c < matrices_.size(); ++c)
            multiply(matrices_[c], of_channel(scale, static_cast<int>(c)));
        for (const IsotropicMatrix& matrix : matrices_)
            mirror_symmetric_ = mirror_symmetric_ && asymmetry(matrix) <= kRounding;
        std::vector<double> rows(4 * pairings() * layout_.row_size());
        for (const IsotropicMatrix& matrix : matrices_) {
            for (int angle = 0; angle <= cells_; ++angle) {
                rows_from_matrix(matrix, angle * pi / 2 / cells_, layout_, pairings(), rows);
                rows_.insert(rows_.end(), rows.begin(), rows.end());
            }
        }
    }

    [[nodiscard]] int channels() const noexcept override { return static_cast<int>(matrices_.size()); }
    [[nodiscard]] int terms() const noexcept override { return channels(); }
    [[nodiscard]] double weight(int term, int channel) const override { return term == channel ? 1 : 0; }
    [[nodiscard]] double lobe_width(int) const noexcept override {
        return std::min(1.0, pi / (layout_.order() + 1));
    }
    [[nodiscard]] bool mixed(int) const override { return true; }
    [[nodiscard]] bool mirror_symmetric() const noexcept override { return mirror_symmetric_; }
    [[nodiscard]] const IsotropicMatrix* matrix(int channel) const override {
        return &matrices_.at(matrices_.size() == 1 ? 0 : static_cast<std::size_t>(channel));
    }
    [[nodiscard]] std::string content_key() const override {
        ContentHash hash;
        for (const IsotropicMatrix& matrix : matrices_) {
            hash.add(std::to_string(matrix.order_in()) + " ");
            for (int m = 0; m <= matrix.order_in(); ++m) {
                const std::span<const IsotropicMatrix::Block> blocks = matrix.blocks(m);
                hash.add({reinterpret_cast<const unsigned char*>(blocks.data()), blocks.size_bytes()});
            }
        }
        return Key("psh").add("coefficients", std::string_view(hash.text())).text();
    }

    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        // The division by the cosine would overflow closer to the horizon.
        if (towards_light.z <= 1e-9 || towards_viewer.z <= 0) return {};
        Mueller m;
        if (mirror_symmetric_) {
            add_term<1>(m, term, towards_light, towards_viewer);
        } else {
            add_term<2>(m, term, towards_light, towards_viewer);
        }
        m *= 1 / towards_light.z;
        return m;
    }

private:
    static void multiply(IsotropicMatrix& matrix, double scale) {
        if (scale == 1) return;
        for (int m = 0; m <= matrix.order_in(); ++m)
            for (IsotropicMatrix::Block& block : matrix.blocks(m))
                for (auto& value : block) value *= scale;
    }

    struct Taps {
        std::size_t first;
        std::array<double, 4> weight;
    };
    [[nodiscard]] Taps taps(const glm::dvec3& viewer) const {
        const double theta = std::atan2(std::hypot(viewer.x, viewer.y), viewer.z);
        const double x = std::min(theta / (pi / 2), 1.0) * cells_;
        const int first = std::clamp(static_cast<int>(x) - 1, 0, cells_ - 3);
        Taps out{static_cast<std::size_t>(first), {}};
        for (int i = 0; i < 4; ++i) {
            double lagrange = 1;
            for (int k = 0; k < 4; ++k) lagrange *= k == i ? 1.0 : (x - first - k) / (i - k);
            out.weight[static_cast<std::size_t>(i)] = lagrange;
        }
        return out;
    }

    // Adds rows times the coefficients of light from one direction, for one Stokes component after the other.
    template <std::size_t Pairings>
    void add_term(Mueller& out, int term, const glm::dvec3& light, const glm::dvec3& viewer) const {
        const Taps tap = taps(viewer);
        const std::size_t size = layout_.row_size();
        constexpr std::size_t rows_at_angle = 4 * Pairings;
        const float* rows =
            rows_.data() +
            rows_at_angle * size *
                (static_cast<std::size_t>(term) * static_cast<std::size_t>(cells_ + 1) + tap.first);
        // Propagation is opposite to `light`, which exchanges the sine and cosine of half the angle.
        const double sine = std::hypot(light.x, light.y);
        const double half = std::atan2(sine, light.z) / 2;
        thread_local std::vector<double> scalar, spin2;
        scalar.resize(psh_count(layout_.order()));
        spin2.resize(scalar.size());
        spin_harmonics(0, layout_.order(), std::cos(half), std::sin(half), scalar);
        spin_harmonics(2, layout_.order(), std::cos(half), std::sin(half), spin2);
        const double azimuth = std::atan2(light.y, light.x) - std::atan2(viewer.y, viewer.x) + pi;

        thread_local std::vector<double> first, second;
        first.resize(size);
        second.resize(size);
        zenith_functions(layout_, scalar, spin2, first, second);
        std::size_t j = 0;
        for (const LightLayout::Run& run : layout_.runs()) {
            std::array<double, rows_at_angle> a{};  // [p][pairing]
            std::array<double, rows_at_angle> b{};
            for (const std::size_t end = j + run.count; j < end; ++j) {
                for (std::size_t r = 0; r < rows_at_angle; ++r) {
                    double row = 0;
                    for (std::size_t i = 0; i < 4; ++i)
                        row += tap.weight[i] * static_cast<double>(rows[(rows_at_angle * i + r) * size + j]);
                    a[r] += row * first[j];
                    b[r] += row * second[j];
                }
            }
            const double c = std::cos(run.m * azimuth);
            const double s = std::sin(run.m * azimuth);
            for (std::size_t r = 0; r < rows_at_angle; ++r) {
                const std::size_t p = r / Pairings;
                const bool even = (p < 2) == (r % Pairings == 0);
                if (run.part == LightKind::unpolarized) {
                    out(p, 0) += (even ? c : s) * a[r];
                } else if (run.part == LightKind::full) {
                    out(p, 3) += (even ? s : c) * a[r];
                } else {
                    const double sign = even ? 1 : static_cast<double>(run.sign);
                    out(p, 1) += sign * (even ? c : s) * a[r];
                    out(p, 2) += sign * (even ? s : -c) * b[r];
                }
            }
        }
    }

    std::vector<IsotropicMatrix> matrices_;
    LightLayout layout_;
    int cells_;
    bool mirror_symmetric_ = true;
    std::vector<float> rows_;  // [channel][angle][p][pairing][j]
};

}  // namespace

MaterialPtr psh_matrix_material(std::vector<IsotropicMatrix> channels, const std::vector<double>& scale,
                                bool symmetrize) {
    if (channels.empty() || channels.size() > 16)
        throw Error(ErrorCode::invalid_argument, "channels: there must be 1 to 16 matrices");
    const int order = channels.front().order_in();
    for (const IsotropicMatrix& matrix : channels)
        if (order < 0 || matrix.order_in() != order || matrix.order_out() != order)
            throw Error(ErrorCode::invalid_argument,
                        "channels: all matrices must have one order, the same on both sides");
    if (scale.size() != 1 && scale.size() != channels.size())
        throw Error(ErrorCode::invalid_argument, "scale has " + std::to_string(scale.size()) +
                                                     " values; it must have 1 or one a channel (" +
                                                     std::to_string(channels.size()) + ")");
    for (const double value : scale) check_range(value, 0, 1e12, "scale");
    if (symmetrize)
        for (IsotropicMatrix& matrix : channels) nicol::symmetrize(matrix);
    return std::make_shared<PshMatrixMaterial>(std::move(channels), scale);
}

}  // namespace nicol
