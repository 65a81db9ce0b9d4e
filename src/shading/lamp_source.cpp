// SPDX-License-Identifier: MIT
#include "shading/lamp_source.hpp"

#include <utility>

namespace nicol {
namespace {

void rotate(const glm::mat3& axes, LaneVectors& v) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = v.x[i], y = v.y[i], z = v.z[i];
        v.x[i] = axes[0].x * x + axes[1].x * y + axes[2].x * z;
        v.y[i] = axes[0].y * x + axes[1].y * y + axes[2].y * z;
        v.z[i] = axes[0].z * x + axes[1].z * y + axes[2].z * z;
    }
}

}  // namespace

LampSource::LampSource(std::shared_ptr<const Lamp> lamp, const glm::dmat3& axes, double scale)
    : lamp_(std::move(lamp)), axes_(axes), scale_(static_cast<float>(scale)) {}

void LampSource::sample(const LaneVectors&, const Lanes& u, const Lanes& v, LaneLight& out) const {
    lamp_->sample(u, v, out);
    rotate(axes_, out.towards);
    if (out.components > 1) rotate(axes_, out.x);
    if (scale_ == 1) return;
    for (std::array<Lanes, 4>& channel : out.irradiance)
        for (std::size_t p = 0; p < out.components; ++p)
            for (float& value : channel[p].value) value *= scale_;
}

}  // namespace nicol
