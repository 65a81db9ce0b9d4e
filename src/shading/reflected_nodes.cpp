// SPDX-License-Identifier: MIT
#include "shading/reflected_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "material/microfacet.hpp"
#include "shading/lane_frames.hpp"
#include "shading/lane_matrix.hpp"
#include "simd/all_lanes.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

// Cosine to the viewer over the deviation of slopes in his direction, beyond which nearly all facets are seen
// alike.
constexpr float kFewHidden = 30;

// SlopePart::blob where the pixel counts beside the lobe, because its edges are sharp, and how
// many times as wide, squared, the lobe is where it does not.
constexpr float kLargestOfPixels = 0.55F;
constexpr float kSmallPixel = 16;
// Blobs are this much narrower where a lobe is less than so much longer than wide, because one blob would be
// all of it, and one shadow ray would decide for it.
constexpr float kRound = 1.5F;
constexpr float kRoundBlob = 0.5F;
// Blobs are this much wider where a lobe is so much longer than wide, because each node counts less.
constexpr float kLong = 6;
constexpr float kLongBlob = 1.15F;
// Blobs of brushed GGX are this much wider, because the three parts of its lobe have many nodes together.
constexpr float kBrushedGgxBlob = 1.2F;
// Widest blob, in radians, for which nodes are spent: the pBRDF of wide lobes, and the shadows that they see,
// change within it.
constexpr float kWidest = 0.15F;
// Widest blob, in radians, that is not counted as too wide.
constexpr float kWideEnough = 0.25F;

// Beckmann's slopes are normally distributed. GGX's slopes are a mixture of normal distributions: of three,
// these keep the number of slopes beyond any steepness within a two-hundredth, the long tail included.
constexpr std::array<SlopePart, 1> kBeckmann{
    {{.deviation = std::numbers::sqrt2_v<float> / 2, .share = 1, .nodes = 1, .blob = 1}}};
constexpr std::array<SlopePart, 3> kGgx{
    {{.deviation = 0.5508F, .share = 0.4804F, .nodes = 1, .blob = 1},
     {.deviation = 1.272F, .share = 0.432F, .nodes = 0.5F, .blob = 0.9F},
     {.deviation = 4.2117F, .share = 0.0876F, .nodes = 0.25F, .blob = 0.9F}}};

// Normal distribution of slopes, in standard deviations of the facets' own.
template <class Number>
struct SeenSlopes {
    Vector2<Number> mean;
    Matrix2<Number> spread;
    Number narrowing;  // determinant of `spread`
};

// Returns the slopes that a viewer sees.
template <class Number>
[[gnu::always_inline]] inline SeenSlopes<Number> seen_slopes(const glm::vec2& deviations,
                                                             const Vector3<Number>& viewer) {
    const Vector3<Number> towards{deviations.x * viewer.x, deviations.y * viewer.y, Number{}};
    const Vector3<Number> axis = normalized_or(towards, 0.0F, Vector3<float>{1, 0, 0});
    Number steepness;
    dot(axis, towards, steepness);
    // A facet looks as large as a + x, where x is its slope towards the viewer, and is not seen where that is
    // below 0.
    const Number height = viewer.z > 0.0F ? viewer.z : Number{};
    const auto some_hidden = steepness * kFewHidden > height;
    const Number a = height / (some_hidden ? steepness : Number{} + 1.0F);
    Number density = -0.5F * a * a;
    density = density > -80.0F ? density : Number{} - 80.0F;
    exponential(density);
    // The integral of the density from a on (Abramowitz and Stegun 7.1.26).
    const Number t = 1.0F / (1.0F + 0.23164189F * a);
    const Number back =
        density * t *
        (0.12741480F + t * (-0.14224837F + t * (0.71070687F + t * (-0.72657601F + t * 0.53070271F))));
    density *= 0.39894228F;
    const Number front = 1.0F - back;
    const Number all = a * front + density;
    Number mean = front / all;
    Number deviation = 1.0F + density / all - mean * mean;
    deviation = deviation > 0.1F ? deviation : Number{} + 0.1F;
    square_root(deviation);
    mean = some_hidden ? mean : Number{};
    deviation = some_hidden ? deviation : Number{} + 1.0F;
    const Number xy = (deviation - 1.0F) * axis.x * axis.y;
    return {{mean * axis.x, mean * axis.y},
            {{1.0F + (deviation - 1.0F) * axis.x * axis.x, xy},
             {xy, 1.0F + (deviation - 1.0F) * axis.y * axis.y}},
            deviation};
}

// Returns the change of the direction that a facet mirrors to the viewer by a change of its slopes, given in
// standard deviations. cosine: that of the angle between viewer and facet.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> change_by(const Vector2<Number>& slopes,
                                                        const glm::vec2& deviations,
                                                        const Vector3<Number>& viewer,
                                                        const Vector3<Number>& facet, const Number& cosine) {
    const Vector3<Number> slope{deviations.x * slopes.x, deviations.y * slopes.y, Number{}};
    Number rise, towards;
    dot(slope, facet, rise);
    const Vector3<Number> turned = minus_scaled(slope, rise, facet);
    dot(viewer, turned, towards);
    const Number scale = 2.0F * facet.z;
    return {scale * (towards * facet.x + cosine * turned.x), scale * (towards * facet.y + cosine * turned.y),
            scale * (towards * facet.z + cosine * turned.z)};
}

// Returns the components of two vectors along two axes, as columns.
template <class Number>
[[gnu::always_inline]] inline Matrix2<Number> along_axes(const Vector3<Number>& first,
                                                         const Vector3<Number>& second,
                                                         const Vector3<Number>& x, const Vector3<Number>& y) {
    Matrix2<Number> out;
    dot(first, x, out.first.x);
    dot(first, y, out.first.y);
    dot(second, x, out.second.x);
    dot(second, y, out.second.y);
    return out;
}

// Returns the vector with these components along two axes.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> in_plane(const Vector2<Number>& v, const Vector3<Number>& x,
                                                       const Vector3<Number>& y) {
    return {v.x * x.x + v.y * y.x, v.x * x.y + v.y * y.y, v.x * x.z + v.y * y.z};
}

// Computes sqrt(1 - (part / whole)^2), 0 if `part` is larger.
template <class Number>
[[gnu::always_inline]] inline void rest_of(const Number& whole, const Number& part, Number& out) {
    const auto some = whole > part;
    const Number ratio = part / (some ? whole : Number{} + 1.0F);
    out = some ? 1.0F - ratio * ratio : Number{};
    square_root(out);
}

// Computes the node that ReflectedNodes has of mirrors with one node.
template <class Number>
[[gnu::always_inline]] inline void find_mirrored(const LaneVectors& towards_viewer,
                                                 const MirroredPixels& pixels, ReflectedNode& out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> viewer, right, down, shift;
        load_part(towards_viewer, first, viewer);
        load_part(pixels.steps[0], first, right);
        load_part(pixels.steps[1], first, down);
        load_part(pixels.shift, first, shift);
        Number of_right, of_down, product;
        dot(right, right, of_right);
        dot(down, down, of_down);
        dot(right, down, product);
        Number longer;
        longer_column(of_right, of_down, product, longer);
        const Number variance = (1 / 12.0F) * longer;  // of an even distribution along the longer side
        store_part(variance, first, out.variances);
        const Vector3<Number> towards{-viewer.x, -viewer.y, viewer.z};
        store_part(towards, first, out.towards);
        store_part(Vector3<Number>{towards.x + shift.x, towards.y + shift.y, towards.z + shift.z}, first,
                   out.seen);
        store_part(Number{} + 1.0F, first, out.weights);
    }
}

}  // namespace

std::uint32_t mirror_node(float narrowest, const LaneVectors& towards_viewer, const MirroredPixels& pixels,
                          ReflectedNode& out) {
    dispatch<find_mirrored<FourLanes>, find_mirrored<EightLanes>, find_mirrored<AllLanes>>(towards_viewer,
                                                                                           pixels, out);
    const float most = std::min(narrowest, kWidest);
    std::uint32_t narrow = 0;
    for (std::size_t i = 0; i < kLanes; ++i)
        narrow |= (out.variances[i] <= most * most ? std::uint32_t{1} : 0U) << i;
    return narrow;
}

std::span<const SlopePart> slope_parts(Distribution distribution) {
    if (distribution == Distribution::ggx) return kGgx;
    return kBeckmann;
}

ReflectedNodes::ReflectedNodes(const NodeGrids& grids, const Lobe& lobe, const SlopePart& part,
                               const LaneVectors& towards_viewer, const MirroredPixels& pixels)
    : facets_{lobe.distribution, static_cast<float>(lobe.alpha.x), static_cast<float>(lobe.alpha.y)},
      deviations_(part.deviation * glm::vec2(lobe.alpha)),
      share_(part.share),
      towards_viewer_(towards_viewer),
      pixels_(pixels) {
    const float most = part.nodes * static_cast<float>(grids.count());
    set_all(grids, {.largest_blob = part.blob,
                    .narrowest = 0,
                    .nodes = std::max(std::size_t{1}, static_cast<std::size_t>(std::lround(most)))});
}

ReflectedNodes::ReflectedNodes(const NodeGrids& grids, float narrowest, const LaneVectors& towards_viewer,
                               const MirroredPixels& pixels)
    : facets_{Distribution::beckmann, 1.0F},
      deviations_(0.0F),
      share_(1),
      towards_viewer_(towards_viewer),
      pixels_(pixels) {
    set_all(grids, {.largest_blob = kBeckmann.front().blob, .narrowest = narrowest, .nodes = grids.count()});
}

template <class Number>
[[gnu::always_inline]] inline void ReflectedNodes::set(ReflectedNodes& r, const NodeGrids& grids,
                                                       const Limits& limits, Chosen& chosen) {
    const Facets<float>& facets = r.facets_;
    const bool brushed_ggx = facets.distribution == Distribution::ggx && facets.alpha != facets.alpha_y;
    const float wider = brushed_ggx ? kBrushedGgxBlob : 1.0F;
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> viewer, right, down;
        load_part(r.towards_viewer_, first, viewer);
        load_part(r.pixels_.steps[0], first, right);
        load_part(r.pixels_.steps[1], first, down);
        // A facet of the middle slopes, and the changes of the direction that it mirrors by the slopes, in
        // standard deviations.
        const SeenSlopes<Number> seen = seen_slopes(r.deviations_, viewer);
        const Vector3<Number> facet = normalized_or(
            Vector3<Number>{r.deviations_.x * seen.mean.x, r.deviations_.y * seen.mean.y, Number{} + 1.0F},
            0.0F, Vector3<float>{0, 0, 1});
        Number cosine;
        dot(viewer, facet, cosine);
        Vector3<Number> x_axis, y_axis;
        some_axes(Vector3<Number>{2.0F * cosine * facet.x - viewer.x, 2.0F * cosine * facet.y - viewer.y,
                                  2.0F * cosine * facet.z - viewer.z},
                  x_axis, y_axis);
        const Vector3<Number> by_first = change_by(seen.spread.first, r.deviations_, viewer, facet, cosine);
        const Vector3<Number> by_second = change_by(seen.spread.second, r.deviations_, viewer, facet, cosine);
        const Matrix2<Number> lobe = along_axes(by_first, by_second, x_axis, y_axis);
        const Matrix2<Number> step = along_axes(right, down, x_axis, y_axis);
        const float even = std::sqrt(1 / 12.0F);  // standard deviation of an even distribution of width 1
        const Matrix2<Number> pixel{{even * step.first.x, even * step.first.y},
                                    {even * step.second.x, even * step.second.y}};
        Number of_lobe, of_pixel;
        squares(lobe, of_lobe);
        squares(pixel, of_pixel);
        const auto lobe_is_wider = of_lobe >= of_pixel;
        const Matrix2<Number> a = times(lobe, transposed(lobe)), b = times(pixel, transposed(pixel));
        const Matrix2<Number> covariance{{a.first.x + b.first.x, a.first.y + b.first.y},
                                         {a.second.x + b.second.x, a.second.y + b.second.y}};
        const Matrix2<Number> root =
            with_orthogonal_columns(root_near(covariance, choose(lobe_is_wider, lobe, pixel)));
        Number longer = root.first.x * root.first.x + root.first.y * root.first.y;
        square_root(longer);
        Number area;
        determinant(root, area);
        area = area > 0.0F ? area : -area;
        const Number shorter = area / (longer > 0.0F ? longer : Number{} + 1.0F);

        const auto small_pixel = kSmallPixel * of_pixel < of_lobe;
        Number wanted =
            shorter * (small_pixel ? Number{} + limits.largest_blob : Number{} + kLargestOfPixels);
        wanted *= longer < kRound * shorter ? Number{} + kRoundBlob : Number{} + 1.0F;
        wanted *= wider;
        wanted = wanted > limits.narrowest ? wanted : Number{} + limits.narrowest;
        const Number close = wanted < kWideEnough ? wanted : Number{} + kWideEnough;
        wanted = wanted < kWidest ? wanted : Number{} + kWidest;
        const Number enough = longer > kLong * shorter ? kLongBlob * wanted : wanted;
        Number index{}, blob_x{}, blob_y{}, mean_x{}, mean_y{}, blob = Number{} + 1e30F;
        for (std::size_t g = 0; g < grids.normal().size(); ++g) {
            const NodeGrid& normal = grids.normal()[g];
            const NodeGrid& uniform = grids.uniform()[g];  // of as many nodes
            // Points whose blobs are narrow enough keep them.
            if (g > 0 && (normal.size() > limits.nodes || all_lanes(blob <= enough))) break;
            const Number wide_x =
                longer * (lobe_is_wider ? Number{} + normal.blob_x : Number{} + uniform.blob_x);
            const Number wide_y =
                shorter * (lobe_is_wider ? Number{} + normal.blob_y : Number{} + uniform.blob_y);
            const Number wide = wide_x > wide_y ? wide_x : wide_y;
            // GCC 12 does not vectorise two combined conditions.
            const Number limit = blob > enough ? blob : Number{};
            const auto better = wide < limit;
            index = better ? Number{} + static_cast<float>(g) : index;
            blob_x = better ? wide_x : blob_x;
            blob_y = better ? wide_y : blob_y;
            mean_x = better ? (lobe_is_wider ? normal.width_x * wide_x : wide_x) : mean_x;
            mean_y = better ? (lobe_is_wider ? normal.width_y * wide_y : wide_y) : mean_y;
            blob = better ? wide : blob;
        }
        store_part(index, first, chosen.index);
        store_part(Number(lobe_is_wider ? Number{} + 1.0F : Number{}), first, chosen.normal);
        store_part(blob_x, first, r.blob_x_);
        store_part(blob_y, first, r.blob_y_);
        Number excess = blob / (close > 0.0F ? close : blob);
        excess = excess > 1.0F ? excess : Number{} + 1.0F;  // of points, too
        store_part(excess, first, r.excess_);

        // Nodes and blobs together have the variance of lobe and pixel.
        Number rest_x, rest_y;
        rest_of(longer, Number(mean_x > blob ? mean_x : blob), rest_x);
        rest_of(shorter, Number(mean_y > blob ? mean_y : blob), rest_y);
        store_part(rest_x, first, r.rests_[0]);
        store_part(rest_y, first, r.rests_[1]);
        const Matrix2<Number> turn = nearest_orthogonal(times(transposed(lobe), root));
        const Matrix2<Number> nodes{{rest_x * turn.first.x, rest_x * turn.first.y},
                                    {rest_y * turn.second.x, rest_y * turn.second.y}};
        const Matrix2<Number> slopes = times(seen.spread, nodes), by_slopes = times(lobe, nodes);
        store_part(slopes.first.x, first, r.slopes_[0][0]);
        store_part(slopes.first.y, first, r.slopes_[0][1]);
        store_part(slopes.second.x, first, r.slopes_[1][0]);
        store_part(slopes.second.y, first, r.slopes_[1][1]);
        const Matrix2<Number> moved{
            {rest_x * root.first.x - by_slopes.first.x, rest_x * root.first.y - by_slopes.first.y},
            {rest_y * root.second.x - by_slopes.second.x, rest_y * root.second.y - by_slopes.second.y}};
        store_part(in_plane(moved.first, x_axis, y_axis), first, r.moves_[0]);
        store_part(in_plane(moved.second, x_axis, y_axis), first, r.moves_[1]);

        store_part(seen.mean.x, first, r.middle_[0]);
        store_part(seen.mean.y, first, r.middle_[1]);
        store_part(seen.narrowing, first, r.narrowing_);
        const Vector2<Number> way = times(lobe, nodes.first);
        store_part(Number(0.25F * (way.x * way.x + way.y * way.y)), first, r.middle_way_);
        store_part(Number(cosine * facet.z * facet.z * facet.z), first, r.middle_area_);
        Number of_slopes;
        determinant(lobe, of_slopes);
        of_slopes = of_slopes > 0.0F ? of_slopes : -of_slopes;
        const Number share = of_slopes / (area > 0.0F ? area : Number{} + 1.0F);
        store_part(Number(share < 1.0F ? share : Number{} + 1.0F), first, r.lobes_);
    }
}

void ReflectedNodes::set_all(const NodeGrids& grids, const Limits& limits) {
    Chosen chosen;
    dispatch<set<FourLanes>, set<EightLanes>, set<AllLanes>>(*this, grids, limits, chosen);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::span<const NodeGrid> of_shape = chosen.normal[i] > 0 ? grids.normal() : grids.uniform();
        grids_[i] = &of_shape[static_cast<std::size_t>(chosen.index[i])];
        one_grid_ = one_grid_ && grids_[i] == grids_[0];
        even_shares_[i] = grids_[i]->even_share;
        count_ = std::max(count_, grids_[i]->size());
    }
}

}  // namespace nicol
