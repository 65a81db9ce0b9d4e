// SPDX-License-Identifier: MIT
#include "light/extracted_light.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "light/equirect.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

struct Choice {
    std::size_t index;
    double rest;  // position inside the chosen share, above 0 and below 1
};

// Moves x away from the edges of an extracted light, where the density may be 0 and cannot be a divisor.
double within(double x) {
    return std::clamp(x, 1e-6, 1 - 1e-6);
}

Choice choose(std::span<const double> cumulative, double u) {
    const double wanted = within(u) * cumulative.back();
    const auto found = std::upper_bound(cumulative.begin(), cumulative.end() - 1, wanted);
    const double before = found == cumulative.begin() ? 0 : *(found - 1);
    const double share = *found - before;
    return {static_cast<std::size_t>(found - cumulative.begin()),
            within(share > 0 ? (wanted - before) / share : 0.5)};
}

// Returns x in [0, 1] with density proportional to (1 - x) a + x b; a + b > 0. Squares of floats fit into a
// double.
float linear_sample(double u, double a, double b) {
    return static_cast<float>(u * (a + b) / (a + std::sqrt((1 - u) * a * a + u * b * b)));
}

std::size_t components_of(const std::vector<float>& values) {
    std::size_t count = 1;
    for (std::size_t i = 0; i < values.size(); i += 4) {
        if (values[i + 3] != 0) return 4;
        if (values[i + 1] != 0 || values[i + 2] != 0) count = 3;
    }
    return count;
}

}  // namespace

ExtractedLight::ExtractedLight(const EquirectWindow& window, int channels, std::vector<float> values)
    : window_(window),
      channels_(static_cast<std::size_t>(channels)),
      values_(std::move(values)),
      components_(components_of(values_)),
      densities_(values_.size() / (4 * channels_)) {
    const auto across = static_cast<std::size_t>(window.columns) + 1;
    for (std::size_t i = 0; i < densities_.size(); ++i) {
        const int row = window.top + static_cast<int>(i / across);
        const double solid_angle = pixel_solid_angle(window.width, window.height, row);
        for (std::size_t c = 0; c < channels_; ++c)
            densities_[i] += solid_angle * double{values_[4 * (channels_ * i + c)]};
    }
    double total = 0;
    for (std::size_t row = 0; row + 1 < densities_.size() / across; ++row) {
        const double* upper = densities_.data() + row * across;
        const double* lower = upper + across;
        double sum = 0;
        for (std::size_t i = 0; i + 1 < across; ++i) {
            sum += (upper[i] + upper[i + 1] + lower[i] + lower[i + 1]) / 4;
            cells_.push_back(sum);
        }
        rows_.push_back(total += sum);
    }
    find_cone();
}

void ExtractedLight::find_cone() {
    const auto direction = [&](double row, double column) {
        return equirect_direction((window_.left + column + 0.5) / window_.width,
                                  (window_.top + row) / (window_.height - 1));
    };
    const auto for_bright_cells = [&](const auto& visit) {
        for (int row = 0; row < window_.rows; ++row) {
            double before = 0;
            for (int column = 0; column < window_.columns; ++column) {
                const double to = cells_[static_cast<std::size_t>(row * window_.columns + column)];
                if (to > before) visit(row, column, to - before);
                before = to;
            }
        }
    };
    for_bright_cells(
        [&](int row, int column, double share) { centre_ += share * direction(row + 0.5, column + 0.5); });
    centre_ = glm::normalize(centre_);
    double least = 1;
    for_bright_cells([&](int row, int column, double) {
        for (const int y : {row, row + 1})
            for (const int x : {column, column + 1})
                least = std::min(least, glm::dot(centre_, direction(y, x)));
    });
    // Rows are no great circles, so a point between two pixels of a row may be farther away by half their
    // distance.
    angular_radius_ = std::min(pi, std::acos(least) + pi / window_.width);
}

void ExtractedLight::put(std::size_t first, float right, float down, float scale, std::size_t lane,
                         LaneLight& out) const {
    const std::size_t pixel = 4 * channels_;
    const float upper_left = scale * (1 - right) * (1 - down), upper_right = scale * right * (1 - down);
    const float lower_left = scale * (1 - right) * down, lower_right = scale * right * down;
    const float* above = values_.data() + first * pixel;
    const float* below = above + (static_cast<std::size_t>(window_.columns) + 1) * pixel;
    for (std::size_t c = 0; c < channels_; ++c) {
        for (std::size_t p = 0; p < components_; ++p) {
            const std::size_t k = 4 * c + p;
            out.irradiance[c][p][lane] = upper_left * above[k] + upper_right * above[k + pixel] +
                                         lower_left * below[k] + lower_right * below[k + pixel];
        }
    }
}

void ExtractedLight::intersect(const LaneVectors& directions, LaneLight& out) const {
    out.towards = directions;
    out.points = 0;
    out.components = components_;
    out.irradiance.resize(channels_);
    for (auto& stokes : out.irradiance)
        for (Lanes& lanes : stokes) lanes.value.fill(0);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::dvec2 at = equirect_coordinates(
            glm::normalize(glm::dvec3(directions.x[i], directions.y[i], directions.z[i])));
        const double from_left = at.x * window_.width - 0.5 - window_.left;
        const double column = from_left - window_.width * std::floor(from_left / window_.width);
        const double row = at.y * (window_.height - 1) - window_.top;
        out.distance[i] = std::numeric_limits<float>::infinity();
        if (!(row >= 0 && row <= window_.rows && column <= window_.columns)) continue;
        const int upper = std::min(static_cast<int>(row), window_.rows - 1);
        const int left = std::min(static_cast<int>(column), window_.columns - 1);
        put(static_cast<std::size_t>(upper * (window_.columns + 1) + left), static_cast<float>(column - left),
            static_cast<float>(row - upper), 1, i, out);
        out.points |= 1U << i;
        const glm::vec3 x(equirect_frame(at.x, at.y)[0]);
        out.x.x[i] = x.x;
        out.x.y[i] = x.y;
        out.x.z[i] = x.z;
    }
}

void ExtractedLight::sample(const Lanes& u, const Lanes& v, LaneLight& out) const {
    out.points = (std::uint32_t{1} << kLanes) - 1;
    out.components = components_;
    out.irradiance.resize(channels_);
    for (auto& stokes : out.irradiance)
        for (std::size_t p = components_; p < 4; ++p) stokes[p].value.fill(0);
    const auto columns = static_cast<std::size_t>(window_.columns);
    const auto angle = static_cast<float>(pi / (window_.height - 1));
    const auto azimuth = static_cast<float>(2 * pi / window_.width);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const Choice row = choose(rows_, double{v[i]});
        const Choice column = choose(std::span(cells_).subspan(row.index * columns, columns), double{u[i]});
        const std::size_t first = row.index * (columns + 1) + column.index;
        const double* upper = densities_.data() + first;
        const double* lower = upper + columns + 1;
        const float down = linear_sample(row.rest, upper[0] + upper[1], lower[0] + lower[1]);
        const double at_left = upper[0] + double{down} * (lower[0] - upper[0]);
        const double at_right = upper[1] + double{down} * (lower[1] - upper[1]);
        const float right = linear_sample(column.rest, at_left, at_right);
        const double density = (at_left + double{right} * (at_right - at_left)) / rows_.back();

        // Angles are measured from the nearer pole, because rounding would give points at the nadir a
        // negative solid angle.
        const float zenith_rows = static_cast<float>(window_.top) + static_cast<float>(row.index) + down;
        const float nadir_rows =
            static_cast<float>(window_.height - 1 - window_.top) - static_cast<float>(row.index) - down;
        const float from_pole = angle * std::min(zenith_rows, nadir_rows);
        const float radius = std::sin(from_pole);
        const float phi =
            azimuth * (static_cast<float>(window_.left) + static_cast<float>(column.index) + 0.5F + right);
        const float cosine = std::cos(phi), sine = std::sin(phi);
        out.towards.x[i] = radius * sine;
        out.towards.y[i] = std::copysign(std::cos(from_pole), nadir_rows - zenith_rows);
        out.towards.z[i] = -radius * cosine;
        out.distance[i] = std::numeric_limits<float>::infinity();
        out.x.x[i] = cosine;
        out.x.y[i] = 0;
        out.x.z[i] = sine;

        put(first, right, down, angle * azimuth * radius / static_cast<float>(density), i, out);
    }
}

}  // namespace nicol
