// SPDX-License-Identifier: MIT
#include "reference/plates_on_ray.hpp"

#include <algorithm>

namespace nicol {

PlatesOnRay::PlatesOnRay(std::span<const PolarizingPlate> plates) {
    for (const PolarizingPlate& plate : plates) plates_.emplace_back(plate);
}

std::optional<Mueller> PlatesOnRay::mueller(const Ray& ray, const Frame& received) const {
    struct Passed {
        double distance;
        const PlacedPlate* plate;
    };
    std::vector<Passed> passed;
    for (const PlacedPlate& plate : plates_) {
        const std::optional<double> distance = plate.distance(ray.origin, ray.direction);
        if (distance && *distance >= ray.nearest && *distance < ray.farthest)
            passed.push_back({*distance, &plate});
    }
    if (passed.empty()) return std::nullopt;
    std::ranges::sort(passed, {}, &Passed::distance);
    Mueller product = passed.front().plate->mueller(received);
    for (const Passed& next : std::span(passed).subspan(1)) product = product * next.plate->mueller(received);
    return product;
}

}  // namespace nicol
