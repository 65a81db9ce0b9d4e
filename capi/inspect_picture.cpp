// SPDX-License-Identifier: MIT
#include "inspect_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <numbers>
#include <string>

#include "boundary.hpp"
#include "light/environment_checks.hpp"
#include "light/equirect.hpp"
#include "light/equirect_projection.hpp"
#include "nicol/grid.hpp"
#include "nicol/rotation.hpp"
#include "nicol/transform.hpp"

namespace nicol::capi {
namespace {

constexpr double pi = std::numbers::pi;
// Picture frames are the theta-phi frames about the picture's axes, turned by a quarter.
constexpr std::array<double, 4> quarter_turn{1, -1, -1, 1};

// About the picture's axes its rows, from the last to the first, are circles of latitude, and its columns run
// against phi: from the last to the first they are at phi = -pi + pi / width and on.
class PictureGrid {
public:
    PictureGrid(int order, int width, int height)
        : transform_(order, clenshaw_curtis_rows(height), width, -pi + pi / width),
          samples_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

    PshVector analyze(const EquirectImage& image) {
        PshVector field(transform_.order(), image.channels);
        for (int c = 0; c < image.channels; ++c) {
            for (int y = 0; y < image.height; ++y) {
                for (int x = 0; x < image.width; ++x) {
                    const auto from = image.at(c, y, x);
                    double* to = sample(image, y, x);
                    for (std::size_t p = 0; p < 4; ++p)
                        to[p] = quarter_turn[p] * static_cast<double>(from[p]);
                }
            }
            transform_.analyze(samples_, field.channel(c));
        }
        return field;
    }

    void synthesize(const PshVector& field, EquirectImage& image) {
        for (int c = 0; c < image.channels; ++c) {
            transform_.synthesize(field.channel(c), samples_);
            for (int y = 0; y < image.height; ++y) {
                for (int x = 0; x < image.width; ++x) {
                    const double* from = sample(image, y, x);
                    const auto to = image.at(c, y, x);
                    for (std::size_t p = 0; p < 4; ++p) to[p] = static_cast<float>(quarter_turn[p] * from[p]);
                }
            }
        }
    }

private:
    double* sample(const EquirectImage& image, int y, int x) {
        const int position = (image.height - 1 - y) * image.width + image.width - 1 - x;
        return samples_.data() + 4 * static_cast<std::size_t>(position);
    }

    PshTransform transform_;
    std::vector<double> samples_;
};

std::array<bool, 4> components_of(const PshVector& field) {
    std::array<bool, 4> there{};
    for (std::size_t i = 0; i < field.data().size(); ++i) there[i % 4] = there[i % 4] || field.data()[i] != 0;
    there[1] = there[2] = there[1] || there[2];
    return there;
}

}  // namespace

PictureLight::PictureLight(EquirectImage image) : image_(std::move(image)) {
    for (std::size_t i = 0; i < image_.data.size(); i += 4) {
        circular_ = circular_ || image_.data[i + 3] != 0;
        polarized_ = polarized_ || circular_ || image_.data[i + 1] != 0 || image_.data[i + 2] != 0;
    }
}

Stokes PictureLight::radiance(int channel, const glm::dvec3& towards_light) const {
    const glm::dvec2 uv = equirect_coordinates(towards_light);
    const double column = uv.x * image_.width - 0.5;
    const double row = uv.y * (image_.height - 1);
    const int left = static_cast<int>(std::floor(column));
    const int top = std::min(static_cast<int>(row), image_.height - 2);
    const double a = column - left;
    const double b = row - top;
    const int x0 = left < 0 ? image_.width - 1 : left;
    const int x1 = left + 1 < image_.width ? left + 1 : 0;
    const auto between = [&](int y) {
        return (1 - a) * image_.stokes(channel, y, x0) + a * image_.stokes(channel, y, x1);
    };
    const Stokes s = (1 - b) * between(top) + b * between(top + 1);
    return turned(s, angle_between(equirect_frame(uv.x, uv.y), theta_phi_frame(-towards_light)));
}

PshVector PictureLight::project(int order) const {
    EquirectView view = view_of(image_);
    if (!polarized_) view.components = 1;
    return project_equirect(view, order);
}

PshVector project_samples_of(const EquirectImage& image, int order) {
    const int needed = 2 * order + 1;
    if (image.width < needed || image.height < needed)
        refuse("a picture of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
               " pixels cannot hold order " + std::to_string(order) + " as samples; that needs " +
               std::to_string(needed) + " columns and rows");
    return rotated(PictureGrid(order, image.width, image.height).analyze(image), equirect_axes());
}

EquirectImage synthesize_picture(const PshVector& field, int width, int height) {
    const int order = std::min(field.order(), (std::min(width, height) - 1) / 2);
    const PshVector part = with_order(field, order);
    EquirectImage image(width, height, field.channels());
    PictureGrid(order, width, height).synthesize(rotated(part, glm::transpose(equirect_axes())), image);
    // Transforms share their work between components, so that rounding errors stand where nothing is.
    const std::array<bool, 4> there = components_of(part);
    for (std::size_t i = 0; i < image.data.size(); ++i)
        if (!there[i % 4]) image.data[i] = 0;
    return image;
}

EquirectImage resample_picture(const Environment& light, const glm::dmat3& rotation, int source_width,
                               int width, int height) {
    EquirectImage image(width, height, light.channels());
    image.wavelengths = light.wavelengths();
    const int steps = std::clamp((source_width + width - 1) / width, 1, 64);
    std::vector<Stokes> sums(static_cast<std::size_t>(light.channels()));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::ranges::fill(sums, Stokes(0));
            double area = 0;
            for (int j = 0; j < steps; ++j) {
                const double v = (y + (j + 0.5) / steps - 0.5) / (height - 1);
                // Beyond a pole the other side follows, with the frame it has seen from here.
                const double weight = steps == 1 ? 1 : std::abs(std::sin(pi * v));
                for (int i = 0; i < steps; ++i) {
                    const double u = (x + (i + 0.5) / steps) / width;
                    const glm::dvec3 from = glm::transpose(rotation) * equirect_direction(u, v);
                    const double angle =
                        angle_between(rotation * theta_phi_frame(-from), equirect_frame(u, v));
                    for (std::size_t c = 0; c < sums.size(); ++c)
                        sums[c] += weight * turned(light.radiance(static_cast<int>(c), from), angle);
                    area += weight;
                }
            }
            for (std::size_t c = 0; c < sums.size(); ++c)
                for (std::size_t p = 0; p < 4; ++p)
                    image.at(static_cast<int>(c), y, x)[p] =
                        static_cast<float>(sums[c][static_cast<glm::length_t>(p)] / area);
        }
    }
    return image;
}

}  // namespace nicol::capi
