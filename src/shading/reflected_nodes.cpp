// SPDX-License-Identifier: MIT
#include "shading/reflected_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "geometry/perpendicular.hpp"
#include "material/microfacet.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

constexpr float kLeastCosine = 1e-6F;
// Cosine to the viewer over the deviation of slopes in his direction, beyond which nearly all facets are seen
// alike.
constexpr float kFewHidden = 30;
constexpr float kMostMoved = 8;  // largest exponent of the ratio of two distributions of nodes

// SlopePart::blob where the pixel counts beside the lobe, because its edges are sharp, and how
// many times as wide, squared, the lobe is where it does not.
constexpr float kLargestOfPixels = 0.55F;
constexpr float kSmallPixel = 16;
// Widest blob, in radians, for which nodes are spent: the pBRDF of wide lobes changes within it.
constexpr float kWidest = 0.25F;

// Beckmann's slopes are normally distributed. GGX's slopes are a mixture of normal distributions: of two,
// these keep the number of slopes beyond 0.5, 1, 2, 3 and 4 alpha within a fiftieth.
constexpr std::array<SlopePart, 1> kBeckmann{
    {{.deviation = std::numbers::sqrt2_v<float> / 2, .share = 1, .nodes = 1, .blob = 1}}};
constexpr std::array<SlopePart, 2> kGgx{{{.deviation = 0.6455F, .share = 0.68F, .nodes = 1, .blob = 1},
                                         {.deviation = 2.041F, .share = 0.32F, .nodes = 0.5F, .blob = 0.9F}}};

// Returns the rotation or reflection that is nearest to a matrix.
glm::mat2 nearest_orthogonal(const glm::mat2& m) {
    const float turned = m[0][0] * m[1][1] > m[0][1] * m[1][0] ? 1.0F : -1.0F;
    const float cosine = m[0][0] + turned * m[1][1], sine = m[0][1] - turned * m[1][0];
    const float length = std::sqrt(cosine * cosine + sine * sine);
    if (!(length > 0)) return glm::mat2(1.0F);
    return {glm::vec2(cosine, sine) / length, turned * glm::vec2(-sine, cosine) / length};
}

// Returns the square root of a covariance that is nearest to a matrix.
glm::mat2 root_near(const glm::mat2& covariance, const glm::mat2& near) {
    const float determinant = std::sqrt(std::max(0.0F, glm::determinant(covariance)));
    const float trace = std::sqrt(covariance[0][0] + covariance[1][1] + 2 * determinant);
    if (!(trace > 0)) return glm::mat2(0.0F);
    glm::mat2 root = covariance / trace;
    root[0][0] += determinant / trace;
    root[1][1] += determinant / trace;
    const glm::mat2 inverse(root[1][1], -root[0][1], -root[1][0], root[0][0]);  // times the determinant
    return root * nearest_orthogonal(inverse * near);
}

float squares(const glm::mat2& m) {
    return glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]);
}

// Returns two unit vectors that are orthogonal to n and to each other.
std::array<glm::vec3, 2> axes_across(const glm::vec3& n) {
    const glm::vec3 x(perpendicular(glm::dvec3(n)));
    return {x, glm::cross(n, x)};
}

}  // namespace

std::span<const SlopePart> slope_parts(Distribution distribution) {
    if (distribution == Distribution::ggx) return kGgx;
    return kBeckmann;
}

ReflectedNodes::ReflectedNodes(const NodeGrids& grids, const Lobe& lobe, const SlopePart& part,
                               const LaneVectors& towards_viewer, const MirroredPixels& pixels)
    : lobe_(lobe),
      deviations_(part.deviation * glm::vec2(lobe.alpha)),
      share_(part.share),
      towards_viewer_(towards_viewer),
      pixels_(pixels) {
    const float most = part.nodes * static_cast<float>(grids.count());
    set_all(grids, part.blob, std::max(std::size_t{1}, static_cast<std::size_t>(std::lround(most))));
}

ReflectedNodes::ReflectedNodes(const NodeGrids& grids, const LaneVectors& towards_viewer,
                               const MirroredPixels& pixels)
    : lobe_{glm::dvec2(1.0), Distribution::beckmann},
      deviations_(0.0F),
      share_(1),
      towards_viewer_(towards_viewer),
      pixels_(pixels) {
    set_all(grids, kBeckmann.front().blob, grids.count());
}

void ReflectedNodes::set_all(const NodeGrids& grids, float largest_blob, std::size_t most) {
    for (std::size_t i = 0; i < kLanes; ++i) set(i, grids, largest_blob, most);
    for (const NodeGrid* grid : grids_) count_ = std::max(count_, grid->size());
}

void ReflectedNodes::set(std::size_t lane_index, const NodeGrids& grids, float largest_blob,
                         std::size_t most) {
    const std::size_t i = lane_index;
    const glm::vec3 viewer = vector_at(towards_viewer_, i);
    // A facet of the middle slopes, and the changes of the direction that it mirrors by the slopes, in
    // standard deviations.
    const Seen seen = seen_slopes(viewer);
    const glm::vec3 facet = glm::normalize(glm::vec3(deviations_ * seen.mean, 1));
    const float along = glm::dot(viewer, facet);
    const std::array<glm::vec3, 2> axes = axes_across(2 * along * facet - viewer);
    std::array<glm::vec3, 2> by_slopes;
    for (std::size_t k = 0; k < 2; ++k) {
        const glm::vec3 slope(deviations_ * seen.spread[static_cast<glm::length_t>(k)], 0);
        const glm::vec3 turned = facet.z * (slope - glm::dot(slope, facet) * facet);
        by_slopes[k] = 2.0F * (glm::dot(viewer, turned) * facet + along * turned);
    }
    const float even = std::sqrt(1 / 12.0F);  // standard deviation of an even distribution of width 1
    glm::mat2 lobe, pixel;
    for (glm::length_t k = 0; k < 2; ++k) {
        const auto n = static_cast<std::size_t>(k);
        for (glm::length_t a = 0; a < 2; ++a) {
            const glm::vec3& axis = axes[static_cast<std::size_t>(a)];
            lobe[k][a] = glm::dot(by_slopes[n], axis);
            pixel[k][a] = even * glm::dot(vector_at(pixels_.steps[n], i), axis);
        }
    }
    const bool lobe_is_wider = squares(lobe) >= squares(pixel);
    const glm::mat2 covariance = lobe * glm::transpose(lobe) + pixel * glm::transpose(pixel);
    glm::mat2 root = root_near(covariance, lobe_is_wider ? lobe : pixel);
    if (squares(root) > 0 && glm::length(root[0]) < glm::length(root[1])) std::swap(root[0], root[1]);
    const float longer = glm::length(root[0]), area = std::abs(glm::determinant(root));
    const float shorter = longer > 0 ? area / longer : 0.0F;

    const NodeGrid* best = nullptr;
    float blob = 0;
    const float enough = std::min(
        (kSmallPixel * squares(pixel) < squares(lobe) ? largest_blob : kLargestOfPixels) * shorter, kWidest);
    for (const NodeGrid& grid : lobe_is_wider ? grids.normal() : grids.uniform()) {
        if (best != nullptr && (grid.size() > most || blob <= enough)) break;
        const float wide = std::max(longer * grid.blob_x, shorter * grid.blob_y);
        if (best != nullptr && wide >= blob) continue;
        best = &grid;
        blob = wide;
    }
    grids_[i] = best;
    blob_x_[i] = longer * best->blob_x;
    blob_y_[i] = shorter * best->blob_y;
    even_shares_[i] = best->even_share;
    excess_[i] = blob > enough && enough > 0 ? blob / enough : 1.0F;

    // Nodes and blobs together have the variance of lobe and pixel.
    const auto rest_of = [blob](float length) {
        return length > blob ? std::sqrt(1 - blob * blob / (length * length)) : 0.0F;
    };
    const glm::vec2 rests(rest_of(longer), rest_of(shorter));
    const glm::mat2 turn = nearest_orthogonal(glm::transpose(lobe) * root);
    for (glm::length_t k = 0; k < 2; ++k) {
        const auto n = static_cast<std::size_t>(k);
        const glm::vec2 chosen = rests[k] * turn[k];
        const glm::vec2 moved = rests[k] * root[k] - lobe * chosen;
        const glm::vec2 slopes = seen.spread * chosen;
        slopes_[n][0][i] = slopes.x;
        slopes_[n][1][i] = slopes.y;
        rests_[n][i] = rests[k];
        put(moves_[n], i, moved.x * axes[0] + moved.y * axes[1]);
    }
    middle_[0][i] = seen.mean.x;
    middle_[1][i] = seen.mean.y;
    narrowing_[i] = glm::determinant(seen.spread);
    const glm::vec3 by_first = rests.x * (by_slopes[0] * turn[0].x + by_slopes[1] * turn[0].y);
    middle_way_[i] = glm::dot(by_first, by_first) / 4;
    middle_area_[i] = along * facet.z * facet.z * facet.z;
    lobes_[i] = area > 0 ? std::min(1.0F, std::abs(glm::determinant(lobe)) / area) : 0.0F;
}

ReflectedNodes::Seen ReflectedNodes::seen_slopes(const glm::vec3& viewer) const {
    const glm::vec2 towards = deviations_ * glm::vec2(viewer);
    const float steepness = glm::length(towards);
    if (!(steepness > 0)) return {};
    // A facet looks as large as a + x, where x is its slope towards the viewer, and is not seen where that is
    // below 0.
    const float a = std::max(viewer.z, 0.0F) / steepness;
    if (a > kFewHidden) return {};
    const float density = std::exp(-0.5F * a * a) / std::sqrt(2 * std::numbers::pi_v<float>);
    const float front = 0.5F * std::erfc(-a / std::numbers::sqrt2_v<float>);
    const float all = a * front + density;
    const float mean = front / all;
    const float deviation = std::sqrt(std::max(0.1F, 1 + density / all - mean * mean));
    const glm::vec2 axis = towards / steepness;
    return {mean * axis, glm::mat2(1.0F) + (deviation - 1) * glm::outerProduct(axis, axis)};
}

template <class Number>
[[gnu::always_inline]] inline void ReflectedNodes::reflect(const ReflectedNodes& r,
                                                           const Facets<float>& facets,
                                                           const GridNodes& nodes, ReflectedNode& out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Number a, b, axis_x, axis_y, other_x, other_y, weight, lobe, blob_x, blob_y;
        load_part(nodes.x, first, a);
        load_part(nodes.y, first, b);
        load_part(r.slopes_[0][0], first, axis_x);
        load_part(r.slopes_[0][1], first, axis_y);
        load_part(r.slopes_[1][0], first, other_x);
        load_part(r.slopes_[1][1], first, other_y);
        Vector3<Number> viewer;
        load_part(r.towards_viewer_, first, viewer);

        // A facet of these slopes, and what it mirrors to the viewer.
        Number middle_x, middle_y;
        load_part(r.middle_[0], first, middle_x);
        load_part(r.middle_[1], first, middle_y);
        const Number x = middle_x + axis_x * a + other_x * b;
        const Number y = middle_y + axis_y * a + other_y * b;
        const Vector3<Number> steep{r.deviations_.x * x, r.deviations_.y * y, Number{} + 1.0F};
        const Number length2 = steep.x * steep.x + steep.y * steep.y + 1.0F;
        Number length = length2;
        square_root(length);
        const Number cosine = 1.0F / length;
        const Vector3<Number> half{steep.x * cosine, steep.y * cosine, cosine};
        Number along;
        dot(viewer, half, along);
        const Vector3<Number> towards{2.0F * along * half.x - viewer.x, 2.0F * along * half.y - viewer.y,
                                      2.0F * along * half.z - viewer.z};
        store_part(towards, first, out.towards);

        Number of_facets;
        density(facets, steep, length2, of_facets);
        load_part(nodes.weights, first, weight);
        // The nodes are those of the slopes that the viewer sees.
        Number rest_x, rest_y, narrowing;
        load_part(r.rests_[0], first, rest_x);
        load_part(r.rests_[1], first, rest_y);
        load_part(r.narrowing_, first, narrowing);
        rest_x *= a;
        rest_y *= b;
        Number moved = 0.5F * (rest_x * rest_x + rest_y * rest_y - x * x - y * y) - kMostMoved;
        moved = moved < 0.0F ? moved : Number{};
        moved = moved > -80.0F ? moved : Number{} - 80.0F;
        exponential(moved);
        const auto seen = (along > kLeastCosine) & (of_facets > 0.0F);
        weight = seen
                     ? 4.0F * std::exp(kMostMoved) * weight * narrowing * moved * along / (of_facets * cosine)
                     : Number{};
        store_part(weight, first, out.weights);

        // How a change of the slopes along the grid's x, and of both slopes, changes the direction, relative
        // to the same changes in the middle of the grid.
        const Number slope_x = r.deviations_.x * axis_x, slope_y = r.deviations_.y * axis_y;
        const Number rise = slope_x * half.x + slope_y * half.y;
        const Number turn = slope_x * viewer.x + slope_y * viewer.y - along * rise;
        Number way = turn * turn + along * along * (slope_x * slope_x + slope_y * slope_y - rise * rise);
        Number middle_way, middle_area;
        load_part(r.middle_way_, first, middle_way);
        load_part(r.middle_area_, first, middle_area);
        const Number least = Number{} + 1e-20F;
        way = cosine * cosine * (way > least ? way : least) / (middle_way > least ? middle_way : least);
        square_root(way);
        Number area = along * cosine * cosine * cosine / (middle_area > least ? middle_area : least);
        area = area > 0.0F ? area : Number{};
        load_part(r.lobes_, first, lobe);
        load_part(r.blob_x_, first, blob_x);
        load_part(r.blob_y_, first, blob_y);
        blob_x *= 1.0F + lobe * (way - 1.0F);
        blob_y *= 1.0F + lobe * (area / way - 1.0F);
        const Number blob = blob_x > blob_y ? blob_x : blob_y;
        store_part(Number(blob * blob), first, out.variances);

        Vector3<Number> move, other_move, shift;
        load_part(r.moves_[0], first, move);
        load_part(r.moves_[1], first, other_move);
        load_part(r.pixels_.shift, first, shift);
        store_part(normalized_or(Vector3<Number>{towards.x + shift.x + a * move.x + b * other_move.x,
                                                 towards.y + shift.y + a * move.y + b * other_move.y,
                                                 towards.z + shift.z + a * move.z + b * other_move.z},
                                 0.0F, Vector3<float>{0, 0, 1}),
                   first, out.seen);
    }
}

ReflectedNode ReflectedNodes::node(std::size_t k) const {
    GridNodes nodes;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const NodeGrid& grid = *grids_[i];
        const bool has = k < grid.size();
        nodes.x[i] = has ? grid.x[k] : 0.0F;
        nodes.y[i] = has ? grid.y[k] : 0.0F;
        nodes.weights[i] = has ? share_ * grid.weights[k] : 0.0F;
    }
    ReflectedNode out;
    const Facets<float> facets{lobe_.distribution, static_cast<float>(lobe_.alpha.x),
                               static_cast<float>(lobe_.alpha.y)};
    dispatch<reflect<FourLanes>, reflect<EightLanes>, reflect<AllLanes>>(*this, facets, nodes, out);
    if (deviations_ == glm::vec2(0.0F)) out.weights = nodes.weights;  // a mirror's density is infinite
    return out;
}

}  // namespace nicol
