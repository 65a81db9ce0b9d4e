// SPDX-License-Identifier: MIT
// Light from coefficients.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <glm/matrix.hpp>

#include "light/environment_checks.hpp"
#include "light/equirect.hpp"
#include "nicol/error.hpp"
#include "nicol/evaluate.hpp"
#include "nicol/grid.hpp"
#include "nicol/rotation.hpp"
#include "nicol/transform.hpp"

namespace nicol {
namespace {

class PshEnvironment final : public Environment {
public:
    PshEnvironment(PshVector field, std::vector<double> wavelengths)
        : field_(std::move(field)), wavelengths_(std::move(wavelengths)) {
        const std::span<const double> data = field_.data();
        for (std::size_t i = 0; i < data.size(); i += 4) {
            circular_ = circular_ || data[i + 3] != 0;
            polarized_ = polarized_ || circular_ || data[i + 1] != 0 || data[i + 2] != 0;
        }
    }

    int channels() const noexcept override { return field_.channels(); }
    bool polarized() const noexcept override { return polarized_; }
    bool circular() const noexcept override { return circular_; }
    const std::vector<double>& wavelengths() const noexcept override { return wavelengths_; }

    Stokes radiance(int channel, const glm::dvec3& towards_light) const override {
        check_look_up(*this, channel, towards_light);
        return evaluate(field_, channel, -towards_light);
    }

    PshVector project(int order) const override {
        check_projection_order(order);
        return with_order(field_, order);
    }

    EquirectImage picture() const override {
        constexpr int most_order = 1023;
        const int order = std::min(field_.order(), most_order);
        int width = 512;
        while (width < 4 * (order + 1)) width *= 2;
        const int height = width / 2 + 1;

        // About the picture's axes, its rows are circles of latitude from south to north: theta = pi (1 - v),
        // phi = pi - 2 pi u; its frames are the theta-phi frames turned by a quarter.
        const PshVector turned_field = rotated(with_order(field_, order), glm::transpose(equirect_axes()));
        const double first_phi = -std::numbers::pi + std::numbers::pi / width;
        PshTransform transform(order, clenshaw_curtis_rows(height), width, first_phi);
        EquirectImage image(width, height, channels());
        image.wavelengths = wavelengths_;
        const auto columns = static_cast<std::size_t>(width);
        std::vector<double> samples(4 * columns * static_cast<std::size_t>(height));
        const std::array<double, 4> sign = {1, -1, -1, 1};
        for (int c = 0; c < channels(); ++c) {
            transform.synthesize(turned_field.channel(c), samples);
            for (int y = 0; y < height; ++y) {
                const double* row = samples.data() + 4 * columns * static_cast<std::size_t>(height - 1 - y);
                float* out = image.at(c, y, 0).data();
                for (std::size_t x = 0; x < columns; ++x)
                    for (std::size_t p = 0; p < 4; ++p)
                        out[4 * x + p] = static_cast<float>(sign[p] * row[4 * (columns - 1 - x) + p]);
            }
        }
        return image;
    }

private:
    PshVector field_;
    std::vector<double> wavelengths_;
    bool polarized_ = false;
    bool circular_ = false;
};

}  // namespace

EnvironmentPtr psh_environment(PshVector field, std::vector<double> wavelengths) {
    const auto refuse = [](const std::string& what) {
        throw Error(ErrorCode::invalid_argument, "psh_environment: " + what);
    };
    if (field.channels() < 1) refuse("coefficients must have at least one channel");
    check_wavelengths("psh_environment", wavelengths, field.channels());
    for (int c = 0; c < field.channels(); ++c) {
        const std::span<const double> f = field.channel(c);
        for (std::size_t i = 0; i < f.size(); ++i) {
            const std::string where =
                "channel " + std::to_string(c) + ", coefficient " + std::to_string(i / 4);
            if (!std::isfinite(f[i])) refuse(where + " is not finite");
            if (i < 4 * psh_index(2, -2) && (i % 4 == 1 || i % 4 == 2) && f[i] != 0)
                refuse(where + ": s1 and s2 must be zero below l = 2");
        }
    }
    return std::make_shared<PshEnvironment>(std::move(field), std::move(wavelengths));
}

}  // namespace nicol
