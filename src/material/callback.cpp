// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

#include "error.hpp"
#include "material/frames.hpp"
#include "material/material.hpp"
#include "material/mixed_terms.hpp"
#include "material/reflectance.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

std::string text(const glm::dvec3& d) {
    std::ostringstream out;
    out << '(' << d.x << ", " << d.y << ", " << d.z << ')';
    return out.str();
}

glm::dvec3 direction(double zenith, double azimuth) {
    return {std::sin(zenith) * std::cos(azimuth), std::sin(zenith) * std::sin(azimuth), std::cos(zenith)};
}

class Callback final : public Material, public MixedTerms {
public:
    explicit Callback(CallbackParameters parameters) : p_(std::move(parameters)) {
        if (!p_.reflect)
            throw Error(ErrorCode::invalid_argument, "the material's function is null; give one");
        check_range(p_.channels, 1, 16, "channels");
        check_range(p_.lobe_width, 0.001, 1, "lobe_width");
        for (int c = 0; c < p_.channels; ++c) test_channel(c);
    }

    [[nodiscard]] int channels() const noexcept override { return p_.channels; }
    [[nodiscard]] int terms() const noexcept override { return p_.channels; }
    [[nodiscard]] double weight(int term, int channel) const override { return term == channel ? 1 : 0; }
    [[nodiscard]] bool mixed(int) const override { return true; }
    [[nodiscard]] double lobe_width(int) const noexcept override { return p_.lobe_width; }

    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        if (towards_light.z <= 0 || towards_viewer.z <= 0) return {};
        return in_rotated_frames(call(term, towards_light, towards_viewer),
                                 rotations_from_s_frames(towards_light, towards_viewer));
    }

private:
    [[nodiscard]] Mueller call(int channel, const glm::dvec3& light, const glm::dvec3& viewer) const {
        const Mueller m = p_.reflect(channel, light, viewer);
        for (std::size_t i = 0; i < 16; ++i) {
            if (!std::isfinite(m(i / 4, i % 4)))
                throw Error(ErrorCode::invalid_argument,
                            "the material's function returned a matrix that is not finite for light from " +
                                text(light) + " towards " + text(viewer));
        }
        return m;
    }

    // Throws if the function is not isotropic or not mirror symmetric. The s-frames rotate with directions,
    // so isotropy requires the same matrix. Mirroring keeps the s-axis up to its sign and negates s2 and s3.
    void test_channel(int channel) const {
        for (const double in : {0.2, 0.7, 1.2}) {
            for (const double out : {0.3, 0.7, 1.3}) {
                for (const double azimuth : {0.4, 1.9, pi - 0.1}) {
                    const glm::dvec3 light = direction(in, azimuth);
                    const glm::dvec3 viewer = direction(out, 0);
                    const Mueller m = call(channel, light, viewer);
                    const Mueller rotated = call(channel, direction(in, azimuth + 2.1), direction(out, 2.1));
                    const Mueller mirrored = call(channel, direction(in, -azimuth), viewer);
                    double largest = 0;
                    for (std::size_t i = 0; i < 16; ++i)
                        largest = std::max(largest, std::abs(m(i / 4, i % 4)));
                    for (std::size_t i = 0; i < 16; ++i) {
                        const double sign = (i / 4 < 2) == (i % 4 < 2) ? 1 : -1;
                        const double value = m(i / 4, i % 4);
                        require(std::abs(value - rotated(i / 4, i % 4)) <= 1e-3 * largest,
                                "is not isotropic: rotating both directions about the normal changes it", i,
                                light, viewer);
                        require(
                            std::abs(value - sign * mirrored(i / 4, i % 4)) <= 1e-3 * largest,
                            "is not mirror symmetric: s0, s1 and s2, s3 may mix only oddly in the azimuth", i,
                            light, viewer);
                    }
                }
            }
        }
    }

    static void require(bool holds, const char* what, std::size_t element, const glm::dvec3& light,
                        const glm::dvec3& viewer) {
        if (holds) return;
        throw Error(ErrorCode::invalid_argument, "the material's function " + std::string(what) +
                                                     " (element " + std::to_string(element / 4) +
                                                     std::to_string(element % 4) + ", light from " +
                                                     text(light) + " towards " + text(viewer) + ")");
    }

    CallbackParameters p_;
};

}  // namespace

MaterialPtr callback_material(CallbackParameters parameters) {
    return std::make_shared<Callback>(std::move(parameters));
}

}  // namespace nicol
