// SPDX-License-Identifier: MIT
#include "light/extract_lights.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "light/equirect.hpp"
#include "light/image_light.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

// Smallest brightness of an extracted light's pixels, divided by the mean of the light.
constexpr double kContrast = 4;
// Largest solid angle (sr) and radius (rad) of an extracted light. Harmonics miss less of a larger light, and
// samples on it are far apart.
constexpr double kMostSolidAngle = 0.2;
constexpr double kMostRadius = 0.5;
// Highest order of an extracted light that harmonics hold, and the highest order that matters for the light
// it gives.
constexpr double kHeldOrder = 9;
constexpr double kLastOrder = 32;
// Limit of the light of omitted extracted lights: the RMS of the sum of their light between these orders,
// divided by the mean of the light. Below the limit extracted lights are not worth their time. A point with 6
// % of the light reaches the limit.
constexpr double kOmitted = 2;
// Distance (radians) up to which extracted lights are merged.
constexpr double kReach = 0.05;
// Largest number of regions, the brightest, from which extracted lights are made.
constexpr std::size_t kMostRegions = 1024;

struct Pixel {
    int row, column;
};

// Small bright part of an image: neighbouring pixels, or the pixels of several parts that are close.
struct Region {
    std::vector<Pixel> pixels;
    /// Light that is taken out of the pixels: Stokes vectors, [pixel][channel][p], physically realizable if
    /// the image is. The unpolarized light that is left has the brightness of the light around the extracted
    /// light, or all the brightness that a pixel has.
    std::vector<float> values;
    double flux = 0;    // integral of the removed brightness
    double energy = 0;  // integral of the squared removed brightness
    glm::dvec3 centre{};
    double radius = 0;
};

class LightSearch {
public:
    explicit LightSearch(const EquirectView& view) : view_(view), open_(size(), 0) {
        for (int y = 0; y < view.height; ++y) {
            solid_angles_.push_back(pixel_solid_angle(view.width, view.height, y));
            double sum = 0;
            for (int x = 0; x < view.width; ++x) sum += brightness({y, x});
            flux_ += sum * solid_angles_.back();
        }
    }

    // Returns at most `most` extracted lights, sorted by the energy that harmonics miss, largest first.
    [[nodiscard]] std::vector<Region> extracted_lights(int most) {
        std::vector<Region> found = regions();
        std::ranges::stable_sort(found, std::greater{}, &Region::flux);
        if (found.size() > kMostRegions) found.resize(kMostRegions);
        std::vector<Region> extracted_lights;
        for (Region& region : found) add(extracted_lights, std::move(region));
        std::ranges::stable_sort(extracted_lights, std::greater{}, missed);
        const double bound = kOmitted * flux_ / (4 * pi);
        double omitted = 0;
        while (!extracted_lights.empty() &&
               (omitted += missed(extracted_lights.back()) / (4 * pi)) <= bound * bound)
            extracted_lights.pop_back();
        if (extracted_lights.size() > static_cast<std::size_t>(most))
            extracted_lights.resize(static_cast<std::size_t>(most));
        return extracted_lights;
    }

private:
    [[nodiscard]] std::size_t size() const {
        return static_cast<std::size_t>(view_.width) * static_cast<std::size_t>(view_.height);
    }
    [[nodiscard]] std::uint8_t& open(Pixel at) {
        return open_[static_cast<std::size_t>(at.row) * static_cast<std::size_t>(view_.width) +
                     static_cast<std::size_t>(at.column)];
    }
    [[nodiscard]] const float* values(int channel, Pixel at) const {
        return view_.values + static_cast<std::size_t>(channel) * view_.channel_stride +
               static_cast<std::size_t>(at.row) * view_.row_stride +
               static_cast<std::size_t>(at.column) * view_.pixel_stride;
    }
    [[nodiscard]] double brightness(Pixel at) const {
        double sum = 0;
        for (int c = 0; c < view_.channels; ++c) sum += double{*values(c, at)};
        return sum / view_.channels;
    }
    [[nodiscard]] double solid_angle(Pixel at) const {
        return solid_angles_[static_cast<std::size_t>(at.row)];
    }
    [[nodiscard]] glm::dvec3 towards(Pixel at) const {
        return equirect_direction((at.column + 0.5) / view_.width,
                                  static_cast<double>(at.row) / (view_.height - 1));
    }
    template <class Visit>
    void for_neighbours(Pixel at, const Visit& visit) const {
        for (int row = std::max(at.row - 1, 0); row <= std::min(at.row + 1, view_.height - 1); ++row)
            for (const int step : {-1, 0, 1})
                visit(Pixel{row, (at.column + step + view_.width) % view_.width});
    }

    // Returns regions of neighbouring pixels above a level. A region that is too large is divided into
    // regions of pixels above higher levels.
    [[nodiscard]] std::vector<Region> regions() {
        struct Part {
            std::vector<Pixel> pixels;
            double level;
        };
        std::vector<Part> parts(1);
        parts[0].level = kContrast * flux_ / (4 * pi);
        for (int y = 0; y < view_.height; ++y)
            for (int x = 0; x < view_.width; ++x)
                if (brightness({y, x}) > parts[0].level) parts[0].pixels.push_back({y, x});

        std::vector<Region> found;
        while (!parts.empty()) {
            const Part part = std::move(parts.back());
            parts.pop_back();
            for (const Pixel at : part.pixels) open(at) = brightness(at) > part.level ? 1 : 0;
            for (const Pixel at : part.pixels) {
                if (open(at) == 0) continue;
                Region region;
                region.pixels = connected(at);
                if (describe(region)) {
                    take(region);
                    found.push_back(std::move(region));
                } else {
                    parts.push_back({std::move(region.pixels), 2 * part.level});
                }
            }
        }
        return found;
    }

    // Returns the open pixels that are connected with `first`, and closes them.
    [[nodiscard]] std::vector<Pixel> connected(Pixel first) {
        std::vector<Pixel> pixels{first};
        open(first) = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            for_neighbours(pixels[i], [&](Pixel next) {
                if (open(next) == 0) return;
                open(next) = 0;
                pixels.push_back(next);
            });
        }
        return pixels;
    }

    // Finds centre and radius. Returns whether the region is small enough.
    [[nodiscard]] bool describe(Region& region) const {
        double total = 0;
        for (const Pixel at : region.pixels) {
            total += solid_angle(at);
            region.centre += solid_angle(at) * brightness(at) * towards(at);
        }
        const double length = glm::length(region.centre);
        if (total > kMostSolidAngle || !(length > 0)) return false;
        region.centre /= length;
        for (const Pixel at : region.pixels) {
            const double cosine = glm::dot(region.centre, towards(at));
            region.radius = std::max(region.radius, std::acos(std::clamp(cosine, -1.0, 1.0)));
        }
        return region.radius <= kMostRadius;
    }

    // Sets the light that is taken out. Unpolarized light is left, as much as the light around the region or
    // as its pixels have.
    void take(Region& region) {
        for (const Pixel at : region.pixels) open(at) = 1;
        std::vector<double> around(static_cast<std::size_t>(view_.channels));
        double total = 0;
        for (const Pixel at : region.pixels) {
            for_neighbours(at, [&](Pixel next) {
                if (open(next) != 0) return;
                total += solid_angle(next);
                for (int c = 0; c < view_.channels; ++c)
                    around[static_cast<std::size_t>(c)] += solid_angle(next) * double{*values(c, next)};
            });
        }
        for (const Pixel at : region.pixels) open(at) = 0;
        for (const Pixel at : region.pixels) {
            double sum = 0;
            for (int c = 0; c < view_.channels; ++c) {
                const float* from = values(c, at);
                std::array<float, 4> taken{};
                std::copy_n(from, view_.components, taken.begin());
                const double polarized = std::hypot(double{taken[1]}, double{taken[2]}, double{taken[3]});
                const double left = total > 0 ? around[static_cast<std::size_t>(c)] / total : 0;
                taken[0] -= static_cast<float>(std::clamp(taken[0] - polarized, 0.0, left));
                sum += double{taken[0]} / view_.channels;
                region.values.insert(region.values.end(), taken.begin(), taken.end());
            }
            region.flux += solid_angle(at) * sum;
            region.energy += solid_angle(at) * sum * sum;
        }
    }

    // Returns the energy of orders above kHeldOrder up to kLastOrder, as if the region's light fell off as a
    // Gaussian.
    [[nodiscard]] static double missed(const Region& region) {
        if (!(region.energy > 0)) return 0;
        const double solid_angle = region.flux * region.flux / region.energy;
        const auto above = [&](double order) {
            return std::exp(-(order + 1) * (order + 1) * solid_angle / (4 * pi));
        };
        return region.energy * (above(kHeldOrder) - above(kLastOrder));
    }

    // Adds the region to a near extracted light, or makes it a new extracted light.
    static void add(std::vector<Region>& extracted_lights, Region region) {
        const auto near = std::ranges::find_if(extracted_lights, [&](const Region& extracted_light) {
            const double cosine = std::clamp(glm::dot(extracted_light.centre, region.centre), -1.0, 1.0);
            return std::acos(cosine) + region.radius <= std::max(kReach, extracted_light.radius);
        });
        if (near == extracted_lights.end()) {
            extracted_lights.push_back(std::move(region));
            return;
        }
        near->pixels.insert(near->pixels.end(), region.pixels.begin(), region.pixels.end());
        near->values.insert(near->values.end(), region.values.begin(), region.values.end());
        near->flux += region.flux;
        near->energy += region.energy;
    }

    EquirectView view_;
    std::vector<std::uint8_t> open_;
    std::vector<double> solid_angles_;  // by row: solid angle of one pixel
    double flux_ = 0;                   // flux of all light
};

// Returns the window of the pixels and the pixels around them. Columns begin after the widest gap.
EquirectWindow window_around(const std::vector<Pixel>& pixels, const EquirectView& view) {
    const auto [first, last] = std::ranges::minmax(pixels, {}, &Pixel::row);
    std::vector<int> columns;
    columns.reserve(pixels.size());
    for (const auto& at : pixels) columns.push_back(at.column);
    std::ranges::sort(columns);
    int left = columns.front();
    int gap = columns.front() + view.width - columns.back();
    for (std::size_t i = 1; i < columns.size(); ++i) {
        if (columns[i] - columns[i - 1] <= gap) continue;
        gap = columns[i] - columns[i - 1];
        left = columns[i];
    }
    const int top = std::max(first.row - 1, 0);
    return {.width = view.width,
            .height = view.height,
            .top = top,
            .left = left - 1,
            .rows = std::min(last.row + 1, view.height - 1) - top,
            .columns = std::min(view.width - gap + 2, view.width)};
}

// Takes the extracted light out of the image `rest`.
std::shared_ptr<const ExtractedLight> extract(const Region& extracted_light, const EquirectView& view,
                                              EquirectImage& rest) {
    const EquirectWindow window = window_around(extracted_light.pixels, view);
    const auto channels = static_cast<std::size_t>(view.channels);
    const int across = window.columns + 1;
    std::vector<float> values(static_cast<std::size_t>((window.rows + 1) * across) * channels * 4);
    const float* taken = extracted_light.values.data();
    for (const auto& at : extracted_light.pixels) {
        for (int c = 0; c < view.channels; ++c) {
            const auto from = rest.at(c, at.row, at.column);
            for (std::size_t p = 0; p < 4; ++p) from[p] -= taken[4 * static_cast<std::size_t>(c) + p];
        }
        // If the window spans all columns, its first column is also its last column.
        for (int x = (at.column - window.left + view.width) % view.width; x < across; x += view.width) {
            const auto to = static_cast<std::size_t>((at.row - window.top) * across + x) * channels * 4;
            std::copy_n(taken, channels * 4, values.begin() + static_cast<std::ptrdiff_t>(to));
        }
        taken += channels * 4;
    }
    return std::make_shared<const ExtractedLight>(window, view.channels, std::move(values));
}

}  // namespace

SplitLight extract_lights(const EnvironmentPtr& light, int most) {
    const EquirectView view = light != nullptr ? light->pixels() : EquirectView{};
    if (most == 0 || view.values == nullptr) return {light, {}};
    const std::vector<Region> found = LightSearch(view).extracted_lights(most);
    if (found.empty()) return {light, {}};
    SplitLight split;
    EquirectImage rest = light->image();
    for (const Region& extracted_light : found)
        split.extracted_lights.push_back(extract(extracted_light, view, rest));
    split.rest = std::make_shared<const ImageLight>(std::move(rest));
    return split;
}

}  // namespace nicol
