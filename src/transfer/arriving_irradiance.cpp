// SPDX-License-Identifier: MIT
#include "transfer/arriving_irradiance.hpp"

#include "visibility/even_irradiance.hpp"

namespace nicol {

ArrivingIrradiance::ArrivingIrradiance(const LightLayout& layout) {
    const std::vector<double> irradiance = zonal_irradiance(layout.order());
    for (std::size_t j = 0; j < layout.even().size(); ++j) {
        const LightLayout::Harmonic& harmonic = layout.even()[j];
        if (harmonic.m != 0) continue;
        const Part part{j, static_cast<float>(irradiance[static_cast<std::size_t>(harmonic.l) / 2])};
        parts_.push_back(part);
        square_ += part.irradiance * part.irradiance;
    }
}

void ArrivingIrradiance::set(const Lanes& irradiance, std::span<Lanes> numbers) const {
    Lanes missing = irradiance;
    for (const Part& part : parts_)
        for (std::size_t i = 0; i < kLanes; ++i) missing[i] -= part.irradiance * numbers[part.number][i];
    for (const Part& part : parts_)
        for (std::size_t i = 0; i < kLanes; ++i)
            numbers[part.number][i] += part.irradiance / square_ * missing[i];
}

}  // namespace nicol
