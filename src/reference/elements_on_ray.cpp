// SPDX-License-Identifier: MIT
#include "reference/elements_on_ray.hpp"

#include <algorithm>

namespace nicol {

ElementsOnRay::ElementsOnRay(std::span<const PolarizationElement> elements, const glm::dmat4& from_world) {
    for (const PolarizationElement& element : elements) elements_.emplace_back(element, from_world);
}

std::optional<Mueller> ElementsOnRay::mueller(const Ray& ray, const Frame& received) const {
    struct Passed {
        double distance;
        const PlacedElement* element;
    };
    std::vector<Passed> passed;
    for (const PlacedElement& element : elements_) {
        const std::optional<double> distance = element.distance(ray.origin, ray.direction);
        if (distance && *distance >= ray.nearest && *distance < ray.farthest)
            passed.push_back({*distance, &element});
    }
    if (passed.empty()) return std::nullopt;
    std::ranges::sort(passed, {}, &Passed::distance);
    Mueller product = passed.front().element->mueller(received);
    for (const Passed& next : std::span(passed).subspan(1))
        product = product * next.element->mueller(received);
    return product;
}

}  // namespace nicol
