// SPDX-License-Identifier: MIT
// Light of coefficients.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "error.hpp"
#include "harmonics/evaluate.hpp"
#include "light/environment_checks.hpp"
#include "light/equirect_projection.hpp"
#include "light/image_light.hpp"

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

    EquirectImage image() const override {
        constexpr int most_order = 1023;
        const int order = std::min(field_.order(), most_order);
        int width = 512;
        while (width < 4 * (order + 1)) width *= 2;
        return image(order, width);
    }

    std::unique_ptr<const Environment> tabulated() const override {
        constexpr int columns_an_order = 16;
        return std::make_unique<const ImageLight>(
            image(field_.order(), std::clamp(columns_an_order * (field_.order() + 1), 512, 4096)));
    }

private:
    EquirectImage image(int order, int width) const {
        EquirectImage image = synthesize_image(with_order(field_, order), width, width / 2 + 1);
        image.wavelengths = wavelengths_;
        return image;
    }

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
