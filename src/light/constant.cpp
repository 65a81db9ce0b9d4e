// SPDX-License-Identifier: MIT
// Environment light of one radiance in all directions.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "light/environment_checks.hpp"

namespace nicol {
namespace {

class ConstantEnvironment final : public Environment {
public:
    explicit ConstantEnvironment(std::vector<double> radiance) : radiance_(std::move(radiance)) {}

    int channels() const noexcept override { return static_cast<int>(radiance_.size()); }
    bool polarized() const noexcept override { return false; }
    bool circular() const noexcept override { return false; }
    bool dark() const noexcept override {
        return std::ranges::all_of(radiance_, [](double value) { return value == 0; });
    }

    Stokes radiance(int channel, const glm::dvec3& towards_light) const override {
        check_look_up(*this, channel, towards_light);
        return {radiance_[static_cast<std::size_t>(channel)], 0, 0, 0};
    }

    PshVector project(int order) const override {
        check_projection_order(order);
        PshVector result(order, channels());
        // Y_00 = 1 / sqrt(4 pi), integrated over the solid angle 4 pi.
        for (int c = 0; c < channels(); ++c)
            result.at(c, 0, 0, 0) = radiance_[static_cast<std::size_t>(c)] * std::sqrt(4 * std::numbers::pi);
        return result;
    }

    EquirectImage image() const override {
        EquirectImage image(2, 2, channels());
        for (int c = 0; c < channels(); ++c)
            for (int y = 0; y < 2; ++y)
                for (int x = 0; x < 2; ++x)
                    image.at(c, y, x)[0] = static_cast<float>(radiance_[static_cast<std::size_t>(c)]);
        return image;
    }

private:
    std::vector<double> radiance_;
};

}  // namespace

EnvironmentPtr constant_environment(std::vector<double> radiance) {
    check_radiance("constant_environment", radiance);
    return std::make_shared<ConstantEnvironment>(std::move(radiance));
}

}  // namespace nicol
