// SPDX-License-Identifier: MIT
// Conversion between coefficients and an image's pixels as samples of a band-limited field.
#include "light/equirect_projection.hpp"

#include <algorithm>
#include <array>
#include <glm/matrix.hpp>
#include <numbers>
#include <string>

#include "error.hpp"
#include "harmonics/grid.hpp"
#include "harmonics/rotation.hpp"
#include "harmonics/transform.hpp"
#include "light/equirect.hpp"

namespace nicol {
namespace {

using std::numbers::pi;
// Image frames are the theta-phi frames about the image's axes, rotated by a quarter circle.
constexpr std::array<double, 4> kQuarterRotation{1, -1, -1, 1};

// Grid of an image's pixels on the sphere. About the image's axes, the rows from the last to the first are
// circles of latitude. The columns run against phi: from the last to the first they are at phi = -pi + pi /
// width and on.
class ImageGrid {
public:
    ImageGrid(int order, int width, int height)
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
                        to[p] = kQuarterRotation[p] * static_cast<double>(from[p]);
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
                    for (std::size_t p = 0; p < 4; ++p)
                        to[p] = static_cast<float>(kQuarterRotation[p] * from[p]);
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
    std::array<bool, 4> present{};
    for (std::size_t i = 0; i < field.data().size(); ++i)
        present[i % 4] = present[i % 4] || field.data()[i] != 0;
    present[1] = present[2] = present[1] || present[2];
    return present;
}

}  // namespace

PshVector project_samples_of(const EquirectImage& image, int order) {
    const int needed = 2 * order + 1;
    if (image.width < needed || image.height < needed)
        throw Error(ErrorCode::invalid_argument,
                    "an image of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                        " pixels cannot hold order " + std::to_string(order) + " as samples; that needs " +
                        std::to_string(needed) + " columns and rows");
    return rotated(ImageGrid(order, image.width, image.height).analyze(image), equirect_axes());
}

EquirectImage synthesize_image(const PshVector& field, int width, int height) {
    const int order = std::min(field.order(), (std::min(width, height) - 1) / 2);
    const PshVector part = with_order(field, order);
    EquirectImage image(width, height, field.channels());
    ImageGrid(order, width, height).synthesize(rotated(part, glm::transpose(equirect_axes())), image);
    // Transforms share work between components, which leaves rounding errors in components that are zero.
    const std::array<bool, 4> present = components_of(part);
    for (std::size_t i = 0; i < image.data.size(); ++i)
        if (!present[i % 4]) image.data[i] = 0;
    return image;
}

}  // namespace nicol
