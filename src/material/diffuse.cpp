// SPDX-License-Identifier: MIT
#include <numbers>

#include "material/key.hpp"
#include "material/material.hpp"
#include "material/reflectance.hpp"
#include "material/shared_terms.hpp"
#include "material/textured.hpp"

namespace nicol {
namespace {

class Diffuse final : public Material, public SharedTerms {
public:
    explicit Diffuse(std::vector<double> reflectance) : reflectance_(std::move(reflectance)) {
        check_reflectance(reflectance_, "reflectance");
    }

    [[nodiscard]] int channels() const noexcept override { return static_cast<int>(reflectance_.size()); }
    [[nodiscard]] int terms() const noexcept override { return 1; }
    [[nodiscard]] double weight(int, int channel) const override { return of_channel(reflectance_, channel); }
    [[nodiscard]] double lobe_width(int) const noexcept override { return 1; }
    [[nodiscard]] std::string content_key() const override {
        return Key("diffuse").add("reflectance", reflectance_).text();
    }
    [[nodiscard]] std::string own_terms_key() const override { return "diffuse"; }

    [[nodiscard]] Mueller evaluate(int, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        Mueller m;
        if (towards_light.z > 0 && towards_viewer.z > 0) m(0, 0) = 1 / std::numbers::pi;
        return m;
    }
    void evaluate_lanes(const LaneVectors& towards_light, const LaneVectors& towards_viewer, std::size_t,
                        std::span<LaneMueller> out) const override {
        out.front() = {};
        for (std::size_t i = 0; i < kLanes; ++i)
            if (towards_light.z[i] > 0 && towards_viewer.z[i] > 0)
                out.front().m[0][i] = 1 / std::numbers::pi_v<float>;
    }

private:
    std::vector<double> reflectance_;
};

}  // namespace

MaterialPtr diffuse(const ColorParameter& reflectance) {
    return times(std::make_shared<Diffuse>(factor(reflectance).values), reflectance);
}

}  // namespace nicol
