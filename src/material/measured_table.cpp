// SPDX-License-Identifier: MIT
#include "material/measured_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "error.hpp"
#include "files/content_hash.hpp"

namespace nicol {
namespace {

using Type = TensorFile::Type;
using std::numbers::pi;
constexpr double kSameAngle = 1e-4;
constexpr std::uint64_t kMaxAngles = 100000;
constexpr std::size_t kMaxWavelengths = 1000;
constexpr std::size_t kChunkBytes = 1 << 22;
constexpr std::uint64_t kMaxTableBytes = std::uint64_t{1} << 30;
constexpr double kSteps = 32767 / 2.0;  // steps per unit

using Matrix = std::array<double, 16>;

// Returns whether an element of a mirror-symmetric material changes its sign with the side.
bool is_odd(std::size_t element) {
    return (element / 4 < 2) != (element % 4 < 2);
}

Matrix with_odd_elements_times(double sign, Matrix matrix) {
    for (std::size_t e = 0; e < 16; ++e)
        if (is_odd(e)) matrix[e] *= sign;
    return matrix;
}

// Matrices of one record by wavelength; known is false for missing matrices.
struct Record {
    std::vector<Matrix> matrix;
    std::vector<bool> known;
    bool any = false;

    void read(const unsigned char* bytes, std::size_t wavelengths) {
        any = false;
        for (std::size_t w = 0; w < wavelengths; ++w) {
            std::array<float, 16> raw;
            std::memcpy(raw.data(), bytes + w * sizeof raw, sizeof raw);
            known[w] = std::isfinite(raw[0]);
            any = any || known[w];
            for (std::size_t e = 0; e < 16; ++e)
                matrix[w][e] = raw[0] > 0 && std::isfinite(raw[e]) ? static_cast<double>(raw[e]) : 0;
        }
        if (!any) return;
        for (std::size_t w = 0; w < wavelengths; ++w)
            if (!known[w]) matrix[w] = matrix[nearest_known(w)];
    }

    [[nodiscard]] std::size_t nearest_known(std::size_t w) const {
        for (std::size_t d = 1;; ++d) {
            if (d <= w && known[w - d]) return w - d;
            if (w + d < known.size() && known[w + d]) return w + d;
        }
    }
};

}  // namespace

std::vector<double> MeasuredTable::wavelengths(TensorFile& file) {
    std::vector<double> values =
        file.values(file.field("wvls", {1, 2}, {Type::u16, Type::f32}), kMaxWavelengths);
    bool good = !values.empty() && values.front() > 0 && std::isfinite(values.back());
    for (std::size_t i = 1; i < values.size(); ++i) good = good && values[i] > values[i - 1];
    if (!good) file.invalid("field wvls is empty or does not increase");
    return values;
}

MeasuredTable::MeasuredTable(TensorFile& file, const ChannelWeights& weights, bool symmetrize,
                             const LoadBudget& budget)
    : theta_d_(angles(file, "theta_d", 0, pi / 2)),
      theta_h_(angles(file, "theta_h", 0, pi / 2)),
      channels_(weights.size()) {
    const std::vector<double> phi = angles(file, "phi_d", -pi, 2 * pi);
    const std::size_t spectrum = weights.front().size();
    const TensorFile::Field& m = file.field("M", {6}, {Type::f32});
    const std::array<std::uint64_t, 6> shape{phi.size(), theta_d_.size(), theta_h_.size(), spectrum, 4, 4};
    if (!std::ranges::equal(m.shape, shape))
        file.invalid("field M must have the shape [phi_d][theta_d][theta_h][wvls][4][4], here [" +
                     std::to_string(shape[0]) + "][" + std::to_string(shape[1]) + "][" +
                     std::to_string(shape[2]) + "][" + std::to_string(shape[3]) + "][4][4]");
    fold_azimuths(phi);
    const auto has_side = [this](int sign) {
        return std::ranges::any_of(azimuths_, [=](const Azimuth& a) { return a.sign == sign; });
    };
    if (symmetrize || !has_side(1) || !has_side(-1)) sides_ = 1;

    const std::size_t plane = theta_d_.size() * theta_h_.size();
    const std::uint64_t directions = std::uint64_t{sides_ * phi_d_.size()} * plane;
    if (directions > kMaxTableBytes / (34 * channels_))
        throw Error(ErrorCode::unsupported,
                    "the table of a measured material would need more than 1 GiB; "
                    "use fewer channels or angles");
    side_size_ = phi_d_.size() * plane * channels_;
    budget.take_memory(34 * channels_ * directions);
    m00_.assign(sides_ * side_size_, -1.0F);
    rest_.resize(sides_ * side_size_);

    ContentHash hash;
    for (const auto& grid : {phi, theta_d_, theta_h_, wavelengths(file)})
        hash.add({reinterpret_cast<const unsigned char*>(grid.data()), grid.size() * sizeof(double)});
    const std::size_t record_bytes = spectrum * 16 * sizeof(float);
    const auto chunk_bytes =
        static_cast<std::size_t>(std::min<std::uint64_t>(kChunkBytes, m.count * sizeof(float)));
    std::vector<unsigned char> chunk(std::max<std::size_t>(chunk_bytes / record_bytes, 1) * record_bytes);
    Record record{std::vector<Matrix>(spectrum), std::vector<bool>(spectrum)};
    std::uint64_t index = 0;
    for (std::uint64_t done = 0; done < m.count * sizeof(float);) {
        const auto size =
            static_cast<std::size_t>(std::min<std::uint64_t>(chunk.size(), m.count * sizeof(float) - done));
        const auto bytes = std::span(chunk).first(size);
        file.read(m, done, bytes);
        hash.add(bytes);
        done += size;
        for (std::size_t at = 0; at < size; at += record_bytes, ++index) {
            record.read(&chunk[at], spectrum);
            budget.step(64 * spectrum);
            if (!record.any) continue;
            const Azimuth azimuth = azimuths_[index / plane];
            const std::size_t entry = (azimuth.index * plane + index % plane) * channels_;
            for (std::size_t c = 0; c < channels_; ++c) {
                Matrix sum{};
                for (std::size_t w = 0; w < spectrum; ++w) {
                    if (weights[c][w] == 0) continue;
                    for (std::size_t e = 0; e < 16; ++e) sum[e] += weights[c][w] * record.matrix[w][e];
                }
                if (sides_ == 1) {
                    take(entry + c, with_odd_elements_times(azimuth.sign, sum));
                    continue;
                }
                if (azimuth.sign >= 0) take(entry + c, sum);
                if (azimuth.sign <= 0) take(side_size_ + entry + c, sum);
            }
        }
    }
    fill_missing();
    content_ = hash.text();
}

// Returns the increasing angles of a field, in `low` to `high`; even from 0 to `high` if they are implied.
std::vector<double> MeasuredTable::angles(TensorFile& file, const std::string& name, double low,
                                          double high) {
    const TensorFile::Field& field = file.field(name, {1, 2}, {Type::f32});
    if (field.shape.size() == 2 && field.shape[0] == 0 && field.shape[1] > 0) {
        const std::uint64_t count = field.shape[1];
        if (count > kMaxAngles)
            file.invalid("field " + name + " claims " + std::to_string(count) +
                         " angles; it must have at most " + std::to_string(kMaxAngles));
        implied_ += (implied_.empty() ? "" : ", ") + name + (high > pi ? " (0 to 2 pi)" : " (0 to pi/2)");
        const double step = high / static_cast<double>(std::max<std::uint64_t>(count - 1, 1));
        std::vector<double> even(count);
        for (std::size_t i = 0; i < count; ++i) even[i] = step * static_cast<double>(i);
        return even;
    }
    std::vector<double> values = file.values(field, kMaxAngles);
    if (values.empty() || field.shape.back() != field.count)
        file.invalid("field " + name + " is empty or not a single row of angles");
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(values[i] >= low - 1e-3 && values[i] <= high + 1e-3))
            file.invalid("field " + name + " has the angle " + std::to_string(values[i]) +
                         "; it must lie in " + std::to_string(low) + " to " + std::to_string(high));
        if (i > 0 && !(values[i] > values[i - 1]))
            file.invalid("field " + name + " does not increase at position " + std::to_string(i));
    }
    return values;
}

// Makes the grid of |phi_d| and finds the place of each azimuth of the file in the grid.
void MeasuredTable::fold_azimuths(const std::vector<double>& phi) {
    std::vector<double> wrapped;
    wrapped.reserve(phi.size());
    for (const double value : phi)
        wrapped.push_back(std::clamp(value > pi ? value - 2 * pi : value, -pi, pi));
    std::vector<double> sorted = wrapped;
    for (double& value : sorted) value = std::abs(value);
    std::ranges::sort(sorted);
    for (const double value : sorted)
        if (phi_d_.empty() || value - phi_d_.back() > kSameAngle) phi_d_.push_back(value);
    for (const double value : wrapped) {
        const double folded = std::abs(value);
        const auto after = std::ranges::upper_bound(phi_d_, folded);
        const bool in_plane = folded < kSameAngle || folded > pi - kSameAngle;
        const int side = value < 0 ? -1 : 1;
        azimuths_.push_back({static_cast<std::size_t>(after - phi_d_.begin()) - 1, in_plane ? 0 : side});
    }
}

// Stores a matrix in a table entry, averaged with the matrix that is there already.
void MeasuredTable::take(std::size_t entry, const Matrix& matrix) {
    Matrix mean = matrix;
    const auto before = static_cast<double>(m00_[entry]);
    if (before >= 0) {
        mean[0] = (mean[0] + before) / 2;
        for (std::size_t e = 1; e < 16; ++e) mean[e] = (mean[e] + before * rest_[entry][e - 1] / kSteps) / 2;
    }
    // Colours outside the gamut become black.
    if (!(mean[0] > 0)) mean = {};
    m00_[entry] = static_cast<float>(mean[0]);
    for (std::size_t e = 1; e < 16; ++e) {
        const double relative = mean[0] > 0 ? std::clamp(mean[e] / mean[0], -2.0, 2.0) : 0;
        rest_[entry][e - 1] = static_cast<std::int16_t>(std::lround(relative * kSteps));
    }
}

// Fills missing entries with the mirror image of the other side, else with zero.
void MeasuredTable::fill_missing() {
    const auto fill = [this](std::size_t entry, std::size_t from) {
        if (m00_[entry] >= 0) return;
        m00_[entry] = m00_[from];
        for (std::size_t e = 1; e < 16; ++e)
            rest_[entry][e - 1] =
                static_cast<std::int16_t>(is_odd(e) ? -rest_[from][e - 1] : rest_[from][e - 1]);
    };
    for (std::size_t i = 0; sides_ == 2 && i < side_size_; ++i) {
        fill(i, side_size_ + i);
        fill(side_size_ + i, i);
    }
    for (float& value : m00_) value = std::max(value, 0.0F);
}

MeasuredTable::Cell MeasuredTable::find(const std::vector<double>& grid, double value) {
    if (value <= grid.front()) return {0, 0};
    if (value >= grid.back()) return {grid.size() - 1, 0};
    const auto upper = static_cast<std::size_t>(std::ranges::upper_bound(grid, value) - grid.begin());
    return {upper - 1, (value - grid[upper - 1]) / (grid[upper] - grid[upper - 1])};
}

void MeasuredTable::at(const Angles& angles, std::size_t first, std::span<Mueller> out) const {
    const Cell phi = find(phi_d_, std::abs(angles.phi_d));
    const Cell d = find(theta_d_, angles.theta_d);
    const Cell h = find(theta_h_, angles.theta_h);
    const bool behind = angles.phi_d < 0;
    const std::size_t side = behind && sides_ == 2 ? side_size_ : 0;
    for (std::size_t c = 0; c < out.size(); ++c) {
        Matrix sum{};
        for (std::size_t corner = 0; corner < 8; ++corner) {
            const std::size_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
            const double weight = (i != 0 ? phi.fraction : 1 - phi.fraction) *
                                  (j != 0 ? d.fraction : 1 - d.fraction) *
                                  (k != 0 ? h.fraction : 1 - h.fraction);
            if (weight == 0) continue;
            const std::size_t entry =
                side +
                (((phi.index + i) * theta_d_.size() + d.index + j) * theta_h_.size() + h.index + k) *
                    channels_ +
                first + c;
            const double m00 = weight * static_cast<double>(m00_[entry]);
            sum[0] += m00;
            for (std::size_t e = 1; e < 16; ++e) sum[e] += m00 / kSteps * rest_[entry][e - 1];
        }
        out[c] = Mueller(behind && sides_ == 1 ? with_odd_elements_times(-1, sum) : sum);
    }
}

double MeasuredTable::lobe_width() const {
    double smallest = 1;
    for (std::size_t c = 0; c < channels_; ++c) {
        double peak = 0;
        for (std::size_t k = 0; k < theta_h_.size(); ++k) {
            double sum = 0;
            for (std::size_t i = 0; i < sides_ * phi_d_.size(); ++i) {
                for (std::size_t j = 0; j < theta_d_.size() && theta_d_[j] <= pi / 4; ++j)
                    sum += static_cast<double>(
                        m00_[((i * theta_d_.size() + j) * theta_h_.size() + k) * channels_ + c]);
            }
            if (k == 0) peak = sum;
            if (k > 0 && sum < peak / 4) {
                smallest = std::min(smallest, theta_h_[k]);
                break;
            }
        }
    }
    return std::max(smallest, 0.001);
}

}  // namespace nicol
