// SPDX-License-Identifier: MIT
#include "material/measured.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "error.hpp"
#include "material/frames.hpp"
#include "material/key.hpp"
#include "material/measured_table.hpp"
#include "material/mixed_terms.hpp"
#include "material/reflectance.hpp"

namespace nicol {
namespace {

// Measured material with one term per channel.
class Measured final : public Material, public MixedTerms {
public:
    Measured(MeasuredTable table, std::string key)
        : table_(std::move(table)), lobe_(table_.lobe_width()), key_(std::move(key)) {}

    [[nodiscard]] int channels() const noexcept override { return static_cast<int>(table_.channels()); }
    [[nodiscard]] int terms() const noexcept override { return channels(); }
    [[nodiscard]] double weight(int term, int channel) const override { return term == channel ? 1 : 0; }
    [[nodiscard]] double lobe_width(int) const noexcept override { return lobe_; }
    [[nodiscard]] bool mirror_symmetric() const noexcept override { return table_.mirror_symmetric(); }
    [[nodiscard]] bool mixed(int) const override { return true; }
    [[nodiscard]] std::string content_key() const override { return key_; }
    [[nodiscard]] std::uint64_t bytes() const noexcept override { return table_.bytes(); }

    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        Mueller m;
        look_up(towards_light, towards_viewer, static_cast<std::size_t>(term), {&m, 1});
        return m;
    }
    void evaluate_terms(const glm::dvec3& towards_light, const glm::dvec3& towards_viewer,
                        std::span<Mueller> out) const override {
        look_up(towards_light, towards_viewer, 0, out);
    }

private:
    void look_up(const glm::dvec3& light, const glm::dvec3& viewer, std::size_t first,
                 std::span<Mueller> out) const {
        if (light.z <= 0 || viewer.z <= 0) {
            std::ranges::fill(out, Mueller{});
            return;
        }
        table_.at(angles(light, viewer), first, out);
        const SurfaceRotations<double> rotations = rotations_from_s_frames(light, viewer);
        for (Mueller& m : out) m = in_rotated_frames(m, rotations);
    }

    static MeasuredTable::Angles angles(const glm::dvec3& light, const glm::dvec3& viewer) {
        const glm::dvec3 sum = light + viewer;
        const glm::dvec3 half = glm::normalize(sum);
        const double tilt = std::hypot(half.x, half.y);
        const double theta_d = std::atan2(glm::length(light - viewer), glm::length(sum));
        // The azimuth does not matter if the half vector is along the normal.
        if (tilt < 1e-12) return {0, theta_d, 0};
        const glm::dvec3 b(-half.y / tilt, half.x / tilt, 0);
        const glm::dvec3 t = glm::cross(b, half);
        return {std::atan2(glm::dot(b, light), glm::dot(t, light)), theta_d, std::atan2(tilt, half.z)};
    }

    MeasuredTable table_;
    double lobe_;
    std::string key_;
};

}  // namespace

MaterialPtr load_measured(const std::filesystem::path& path, const MeasuredParameters& parameters,
                          const std::function<void(const std::string&)>& notice, const LoadBudget& budget) {
    if (parameters.wavelengths.size() > 16)
        throw Error(ErrorCode::invalid_argument, "wavelengths: there must be at most 16");
    for (const double wanted : parameters.wavelengths) check_range(wanted, 100, 5000, "a wavelength");
    const bool nearest = parameters.sampling == WavelengthSampling::nearest;

    TensorFile file(path, budget.files());
    const std::vector<double> measured = MeasuredTable::wavelengths(file);
    const ChannelWeights weights = !parameters.wavelengths.empty()
                                       ? (nearest ? nearest_weights(measured, parameters.wavelengths)
                                                  : linear_weights(measured, parameters.wavelengths))
                                   : measured.size() == 1 ? ChannelWeights{{1.0}}
                                                          : rgb_weights(measured);
    MeasuredTable table(file, weights, parameters.symmetrize, budget);
    if (notice && !table.implied().empty())
        notice(path.string() + ": angles without values are taken as evenly spaced: " + table.implied());
    const std::string key = Key("measured_polarized")
                                .add("content", std::string_view(table.content()))
                                .add("wavelengths", parameters.wavelengths)
                                .add("nearest", nearest)
                                .add("symmetrize", parameters.symmetrize)
                                .text();
    return std::make_shared<Measured>(std::move(table), key);
}

}  // namespace nicol
