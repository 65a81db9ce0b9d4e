// SPDX-License-Identifier: MIT
#include "render/grazing_lobes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include "material/sampled_terms.hpp"
#include "material/spatial_variation.hpp"

namespace nicol {
namespace {

// Widest lobe that is sampled. Low orders hold wider ones at all but a few angles.
constexpr double kWidestSampled = 0.35;
// Width of a lobe across the plane of incidence below which orders do not hold it.
constexpr double kNarrowAcross = 0.05;
// Smallest share of the image in which a lobe is so narrow.
constexpr double kLeastShare = 0.1;

// Returns the widest lobe of a material that may be sampled; 0 if there is none.
double widest_sampled(const Material& material) {
    double widest = 0;
    (void)any_term(material, [&](const Material& layer, int term) {
        const glm::dvec2 widths = layer.lobe_widths(term);
        if (!layer.smooth(term) && layer.matrix(0) == nullptr && widths.x == widths.y &&
            widths.x < kWidestSampled)
            widest = std::max(widest, widths.x);
        return false;
    });
    return widest;
}

}  // namespace

double narrowest_in_harmonics(const WorldGeometry& geometry, const SeenTriangles& seen,
                              const Projection& projection) {
    std::vector<double> of_ranges;
    of_ranges.reserve(geometry.ranges.size());
    for (const VertexRange& range : geometry.ranges) of_ranges.push_back(widest_sampled(*range.material));
    const std::set<double, std::greater<>> widths(of_ranges.begin(), of_ranges.end());
    for (const double width : widths) {
        if (width < kNarrowestLobe) break;
        double share = 0;
        const auto add = [&](std::size_t i, double shown) {
            if (of_ranges[range_of(geometry, geometry.triangles[i].x)] == width) share += shown;
        };
        seen.for_each(geometry, projection, add, kNarrowAcross / width);
        if (share > kLeastShare) return std::nextafter(width, 1.0);
    }
    return kNarrowestLobe;
}

}  // namespace nicol
