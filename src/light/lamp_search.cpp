// SPDX-License-Identifier: MIT
#include "light/lamp_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "light/equirect.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

// Of a lamp's pixels over the mean of the light.
constexpr double kContrast = 4;
// Of a lamp, steradians and radians from its centre. Of what is larger harmonics miss less, and samples are
// far apart.
constexpr double kMostSolidAngle = 0.2;
constexpr double kMostRadius = 0.5;
// Orders that harmonics hold of a lamp, and those that matter of what it gives.
constexpr double kHeldOrder = 9;
constexpr double kLastOrder = 32;
// Of lamps that are not worth their time: RMS of what all have between these orders, over the mean of the
// light. A point has this with 6 % of the light.
constexpr double kOmitted = 2;
// Lamps this near to each other (radians) are one.
constexpr double kReach = 0.05;
// Brightest regions of which lamps are made.
constexpr std::size_t kMostRegions = 1024;

using Pixel = LampPixels::Pixel;

// Neighbouring pixels, or those of regions that are close.
struct Region : LampPixels {
    double flux = 0;    // integral of the brightness that is taken
    double energy = 0;  // and of its square
    glm::dvec3 centre{};
    double radius = 0;
};

class LampSearch {
public:
    explicit LampSearch(const EquirectView& view) : view_(view), open_(size(), 0) {
        for (int y = 0; y < view.height; ++y) {
            solid_angles_.push_back(pixel_solid_angle(view.width, view.height, y));
            double sum = 0;
            for (int x = 0; x < view.width; ++x) sum += brightness({y, x});
            flux_ += sum * solid_angles_.back();
        }
    }

    // Those of which harmonics miss most, these first.
    [[nodiscard]] std::vector<Region> lamps(int most) {
        std::vector<Region> found = regions();
        std::ranges::stable_sort(found, std::greater{}, &Region::flux);
        if (found.size() > kMostRegions) found.resize(kMostRegions);
        std::vector<Region> lamps;
        for (Region& region : found) add(lamps, std::move(region));
        std::ranges::stable_sort(lamps, std::greater{}, missed);
        const double bound = kOmitted * flux_ / (4 * pi);
        double omitted = 0;
        while (!lamps.empty() && (omitted += missed(lamps.back()) / (4 * pi)) <= bound * bound)
            lamps.pop_back();
        if (lamps.size() > static_cast<std::size_t>(most)) lamps.resize(static_cast<std::size_t>(most));
        return lamps;
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

    // Of neighbouring pixels above a level; where there are too many, those above higher levels.
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

    // Those that are open, which they are no longer.
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

    // Finds centre and radius; returns whether it is small enough.
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

    // Leaves as much unpolarized light as there is around the region, or as its pixels have.
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

    // Energy of orders above kHeldOrder up to kLastOrder, as if the region's light fell off as a Gaussian.
    [[nodiscard]] static double missed(const Region& region) {
        if (!(region.energy > 0)) return 0;
        const double solid_angle = region.flux * region.flux / region.energy;
        const auto above = [&](double order) {
            return std::exp(-(order + 1) * (order + 1) * solid_angle / (4 * pi));
        };
        return region.energy * (above(kHeldOrder) - above(kLastOrder));
    }

    // To the lamp that it is near to.
    static void add(std::vector<Region>& lamps, Region region) {
        const auto near = std::ranges::find_if(lamps, [&](const Region& lamp) {
            const double cosine = std::clamp(glm::dot(lamp.centre, region.centre), -1.0, 1.0);
            return std::acos(cosine) + region.radius <= std::max(kReach, lamp.radius);
        });
        if (near == lamps.end()) {
            lamps.push_back(std::move(region));
            return;
        }
        near->pixels.insert(near->pixels.end(), region.pixels.begin(), region.pixels.end());
        near->values.insert(near->values.end(), region.values.begin(), region.values.end());
        near->flux += region.flux;
        near->energy += region.energy;
    }

    EquirectView view_;
    std::vector<std::uint8_t> open_;
    std::vector<double> solid_angles_;  // of a row's pixels
    double flux_ = 0;                   // of all light
};

}  // namespace

std::vector<LampPixels> find_lamps(const EquirectView& view, int most) {
    std::vector<LampPixels> lamps;
    for (Region& region : LampSearch(view).lamps(most)) lamps.push_back(std::move(region));
    return lamps;
}

}  // namespace nicol
