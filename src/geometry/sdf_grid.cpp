// SPDX-License-Identifier: MIT
// Surfaces of grids of signed distances, in the format of Mitsuba's volumes:
//     "VOL", u8 3, i32 1 (single precision), i32 numbers along x, y and z, i32 channels, f32 box[6], then the
//     numbers, x fastest; all little-endian
// A surface is triangulated cell by cell: lines across the sides of a cell join its corners on edges, where
// trilinear interpolation is linear, and fans around a point inside fill the loops that the lines form.
#include "geometry/sdf_grid.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "files/file_error.hpp"
#include "files/read_bytes.hpp"

namespace nicol {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied from memory as they are");

constexpr std::size_t kVolumeHeader = 48;
constexpr int kSinglePrecision = 1;

/// Eight corners of a cell of a grid. Bits 0, 1 and 2 of a corner's number are its x, y and z.
using CellCorners = std::array<double, 8>;

double along(double from, double to, double by) {
    return from + by * (to - from);
}

/// Returns the trilinear interpolation at a place of 0..1 in each coordinate.
double value_at(const CellCorners& corners, const glm::dvec3& place) {
    std::array<double, 4> edges;
    for (std::size_t i = 0; i < 4; ++i) edges[i] = along(corners[2 * i], corners[2 * i + 1], place.x);
    return along(along(edges[0], edges[1], place.y), along(edges[2], edges[3], place.y), place.z);
}

/// Returns the derivatives of value_at().
glm::dvec3 gradient_at(const CellCorners& corners, const glm::dvec3& place) {
    glm::dvec3 out;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        glm::dvec3 low = place, high = place;
        low[axis] = 0;
        high[axis] = 1;
        out[axis] = value_at(corners, high) - value_at(corners, low);
    }
    return out;
}

class DistanceGrid {
public:
    DistanceGrid(const std::filesystem::path& file, std::string_view bytes, const LoadBudget& budget) {
        if (bytes.size() < kVolumeHeader || !bytes.starts_with("VOL\x03"))
            invalid_file(file, "not a volume: it does not begin with VOL and the byte 3");
        std::array<std::int32_t, 5> numbers;
        std::memcpy(numbers.data(), bytes.data() + 4, sizeof(numbers));
        const auto [encoding, x, y, z, channels] = numbers;
        if (encoding != kSinglePrecision)
            unsupported_file(
                file, "a volume of encoding " + std::to_string(encoding) + "; expected 1, single precision");
        if (channels != 1)
            unsupported_file(
                file, "a volume of " + std::to_string(channels) + " channels; a grid of distances has one");
        size_ = {x, y, z};
        const std::size_t in_file = (bytes.size() - kVolumeHeader) / sizeof(float);
        std::size_t left = in_file;
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            if (size_[axis] < 2) invalid_file(file, sizes() + " numbers; expected 2 or more along each axis");
            left /= static_cast<std::size_t>(size_[axis]);
        }
        // Bytes after the numbers are no part of the volume.
        if (left == 0)
            invalid_file(file, "ends early: " + std::to_string(in_file) +
                                   " numbers after its header; expected " + sizes());
        const auto count =
            static_cast<std::size_t>(x) * static_cast<std::size_t>(y) * static_cast<std::size_t>(z);
        budget.take_memory(count * sizeof(float));
        budget.step(count);
        values_.resize(count);
        std::memcpy(values_.data(), bytes.data() + kVolumeHeader, count * sizeof(float));
        const auto wrong =
            std::ranges::find_if_not(values_, [](float value) { return std::isfinite(value); });
        if (wrong != values_.end())
            invalid_file(file, "number " + std::to_string(wrong - values_.begin()) +
                                   " (counted from 0) is not finite; expected distances");
    }

    [[nodiscard]] const glm::ivec3& size() const { return size_; }
    [[nodiscard]] glm::dvec3 cells() const { return size_ - 1; }
    [[nodiscard]] std::size_t index(const glm::ivec3& at) const {
        const auto x = static_cast<std::size_t>(size_.x), y = static_cast<std::size_t>(size_.y);
        return (static_cast<std::size_t>(at.z) * y + static_cast<std::size_t>(at.y)) * x +
               static_cast<std::size_t>(at.x);
    }
    [[nodiscard]] CellCorners corners(const glm::ivec3& cell) const {
        CellCorners out;
        for (std::size_t i = 0; i < 8; ++i) out[i] = values_[index(cell + corner(i))];
        return out;
    }
    [[nodiscard]] static glm::ivec3 corner(std::size_t number) {
        const auto bits = static_cast<int>(number);
        return {bits & 1, bits >> 1 & 1, bits >> 2 & 1};
    }

    /// Returns the normal that blends the gradients of the eight cells around the nearest point of the grid
    /// (Hansson-Soderlund et al. 2022). The last cells repeat at both ends, where Mitsuba 3.9 blends with 0
    /// at the upper ones. place: in cells.
    [[nodiscard]] glm::dvec3 smooth_normal(const glm::dvec3& place) const {
        const glm::ivec3 last = size_ - 2;
        const glm::ivec3 cell = glm::clamp(glm::ivec3(glm::floor(place)), glm::ivec3(0), last);
        const glm::ivec3 low = glm::ivec3(glm::round(place)) - 1;
        const glm::dvec3 weight = glm::clamp(place - glm::dvec3(low) - 0.5, 0.0, 1.0);
        // Differences across the cell and across its neighbour, along each axis.
        std::array<glm::dvec3, 2> differences;
        for (int side = 0; side < 2; ++side)
            for (glm::length_t axis = 0; axis < 3; ++axis) {
                glm::ivec3 of = cell;
                of[axis] = std::clamp(low[axis] + side, 0, last[axis]);
                differences[static_cast<std::size_t>(side)][axis] =
                    gradient_at(corners(of), place - glm::dvec3(cell))[axis];
            }
        glm::dvec3 sum(0);
        for (std::size_t i = 0; i < 8; ++i) {
            const glm::ivec3 high = corner(i);
            glm::dvec3 gradient;
            double share = 1;
            for (glm::length_t axis = 0; axis < 3; ++axis) {
                gradient[axis] = differences[static_cast<std::size_t>(high[axis])][axis];
                share *= high[axis] == 1 ? weight[axis] : 1 - weight[axis];
            }
            gradient *= cells();
            const double length = glm::length(gradient);
            if (length > 0) sum += share / length * gradient;
        }
        return sum;
    }

private:
    [[nodiscard]] std::string sizes() const {
        return std::to_string(size_.x) + " x " + std::to_string(size_.y) + " x " + std::to_string(size_.z);
    }

    glm::ivec3 size_;
    std::vector<float> values_;
};

/// Numbers of the corners around each side of a cell, counter-clockwise seen from outside.
constexpr std::array<std::array<std::uint8_t, 4>, 6> kCellSides{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

/// Edge of a cell: its axis and its corner of lower number.
struct CellEdge {
    std::size_t axis, low;
    [[nodiscard]] std::size_t number() const { return 8 * axis + low; }
    [[nodiscard]] static CellEdge numbered(std::size_t number) { return {number / 8, number % 8}; }
};

CellEdge edge_between(std::size_t a, std::size_t b) {
    const auto bit = static_cast<unsigned>(a ^ b);
    return {static_cast<std::size_t>(std::countr_zero(bit)), std::min(a, b)};
}

/// Loops of edges along which the surface leaves a cell. Loops run counter-clockwise as seen from the
/// positive side.
class CellLoops {
public:
    explicit CellLoops(const CellCorners& corners) {
        next_.fill(kNone);
        for (const std::array<std::uint8_t, 4>& side : kCellSides) link(corners, side);
    }

    /// Calls body(edges) with the numbers of the edges of each loop.
    template <class Body>
    void for_each(const Body& body) {
        for (std::size_t first = 0; first < next_.size(); ++first) {
            std::array<std::uint8_t, 12> loop;
            std::size_t count = 0;
            for (std::size_t edge = first; next_[edge] != kNone; ++count) {
                loop[count] = static_cast<std::uint8_t>(edge);
                edge = std::exchange(next_[edge], kNone);
            }
            if (count > 0) body(std::span<const std::uint8_t>(loop).first(count));
        }
    }

private:
    static constexpr std::uint8_t kNone = 255;

    // Joins the edges of a side at which the sign changes.
    void link(const CellCorners& corners, const std::array<std::uint8_t, 4>& side) {
        const auto of = [&](std::size_t i) { return corners[side[i % 4]]; };
        const auto edge = [&](std::size_t i) {
            return edge_between(side[i % 4], side[(i + 1) % 4]).number();
        };
        const auto leaves = [&](std::size_t i) { return of(i) < 0 && !(of(i + 1) < 0); };
        const auto enters = [&](std::size_t i) { return !(of(i) < 0) && of(i + 1) < 0; };
        // If the diagonals differ in sign, the value at the saddle point decides which of them is connected.
        const double bend = (of(0) + of(2)) - (of(1) + of(3));
        const bool inside_joined = bend != 0 && (of(0) * of(2) - of(1) * of(3)) / bend < 0;
        const std::size_t step = inside_joined ? 1 : 3;
        for (std::size_t i = 0; i < 4; ++i) {
            if (!leaves(i)) continue;
            std::size_t j = i + step;
            while (!enters(j)) j += step;
            next_[edge(j)] = static_cast<std::uint8_t>(edge(i));
        }
    }

    std::array<std::uint8_t, 24> next_;  // by CellEdge::number()
};

class GridSurface {
public:
    GridSurface(const DistanceGrid& grid, SdfNormals normals) : grid_(grid), normals_(normals) {}

    void add(const glm::ivec3& cell, const CellCorners& corners) {
        CellLoops(corners).for_each([&](std::span<const std::uint8_t> edges) {
            std::array<std::uint32_t, 12> ring;
            glm::dvec3 sum(0);
            for (std::size_t i = 0; i < edges.size(); ++i) {
                const CellEdge edge = CellEdge::numbered(edges[i]);
                const double from = corners[edge.low], to = corners[edge.low + (1U << edge.axis)];
                glm::dvec3 place(DistanceGrid::corner(edge.low));
                place[static_cast<glm::length_t>(edge.axis)] = from / (from - to);
                sum += place;
                ring[i] = on_edge(cell, edge, place, corners);
            }
            const std::size_t count = edges.size();
            if (count == 3) {
                mesh.triangles.emplace_back(ring[0], ring[1], ring[2]);
                return;
            }
            const std::uint32_t middle =
                vertex(cell, on_surface(corners, sum / static_cast<double>(count)), corners);
            for (std::size_t i = 0; i < count; ++i)
                mesh.triangles.emplace_back(middle, ring[i], ring[(i + 1) % count]);
        });
    }

    /// Takes memory for what add() makes of all cells.
    void reserve(std::size_t vertices, std::size_t triangles) {
        mesh.positions.reserve(vertices);
        mesh.normals.reserve(vertices);
        mesh.triangles.reserve(triangles);
    }

    Mesh mesh;

private:
    std::uint32_t vertex(const glm::ivec3& cell, const glm::dvec3& place, const CellCorners& corners) {
        const glm::dvec3 at = glm::dvec3(cell) + place;
        const glm::dvec3 normal = normals_ == SdfNormals::smooth
                                      ? grid_.smooth_normal(at)
                                      : gradient_at(corners, place) * grid_.cells();
        const double length = glm::length(normal);
        mesh.positions.emplace_back(at / grid_.cells());
        mesh.normals.emplace_back(length > 0 ? normal / length : glm::dvec3(0));
        return static_cast<std::uint32_t>(mesh.positions.size() - 1);
    }

    // Cells share vertices on edges if their normals are equal.
    std::uint32_t on_edge(const glm::ivec3& cell, const CellEdge& edge, const glm::dvec3& place,
                          const CellCorners& corners) {
        if (normals_ == SdfNormals::analytic) return vertex(cell, place, corners);
        const std::size_t key = 3 * grid_.index(cell + DistanceGrid::corner(edge.low)) + edge.axis;
        const auto found = on_edges_.find(key);
        if (found != on_edges_.end()) return found->second;
        const std::uint32_t added = vertex(cell, place, corners);
        on_edges_.emplace(key, added);
        return added;
    }

    // Moves a place inside a cell to the surface, along gradients.
    static glm::dvec3 on_surface(const CellCorners& corners, glm::dvec3 place) {
        for (int step = 0; step < 4; ++step) {
            const glm::dvec3 gradient = gradient_at(corners, place);
            const double square = glm::dot(gradient, gradient);
            if (!(square > 0)) break;
            place = glm::clamp(place - value_at(corners, place) / square * gradient, 0.0, 1.0);
        }
        return place;
    }

    const DistanceGrid& grid_;
    SdfNormals normals_;
    std::unordered_map<std::size_t, std::uint32_t> on_edges_;
};

/// Calls body(cell, corners) with each cell that the surface crosses.
template <class Body>
void for_crossed(const DistanceGrid& grid, const LoadBudget& budget, const Body& body) {
    glm::ivec3 cell;
    for (cell.z = 0; cell.z < grid.size().z - 1; ++cell.z)
        for (cell.y = 0; cell.y < grid.size().y - 1; ++cell.y)
            for (cell.x = 0; cell.x < grid.size().x - 1; ++cell.x) {
                budget.step(8);
                const CellCorners corners = grid.corners(cell);
                const auto inside = std::ranges::count_if(corners, [](double value) { return value < 0; });
                if (inside > 0 && inside < 8) body(cell, corners);
            }
}

/// Vertices and triangles of a grid's surface.
struct Counts {
    std::size_t on_edges = 0;  ///< vertices on edges of cells
    std::size_t inside = 0;    ///< vertices inside cells
    std::size_t triangles = 0;
};

/// Returns whether no cell before a cell, in any coordinate, has its edge.
bool is_first_with(const glm::ivec3& cell, const CellEdge& edge) {
    const glm::ivec3 low = DistanceGrid::corner(edge.low);
    for (glm::length_t axis = 0; axis < 3; ++axis)
        if (axis != static_cast<glm::length_t>(edge.axis) && low[axis] == 0 && cell[axis] > 0) return false;
    return true;
}

Counts counts_of(const DistanceGrid& grid, SdfNormals normals, const LoadBudget& budget) {
    Counts out;
    for_crossed(grid, budget, [&](const glm::ivec3& cell, const CellCorners& corners) {
        budget.step(64);
        CellLoops(corners).for_each([&](std::span<const std::uint8_t> edges) {
            const std::size_t count = edges.size();
            out.triangles += count == 3 ? 1 : count;
            out.inside += count == 3 ? 0 : 1;
            for (const std::uint8_t edge : edges)
                out.on_edges +=
                    normals == SdfNormals::analytic || is_first_with(cell, CellEdge::numbered(edge)) ? 1 : 0;
        });
    });
    return out;
}

// Memory of an element of GridSurface's table of vertices on edges, its node and its place in the table.
constexpr std::uint64_t kBytesOnEdge = 40;

}  // namespace

Mesh load_sdf_grid(const std::filesystem::path& file, SdfNormals normals, const LoadBudget& budget) {
    const DistanceGrid grid(file, read_bytes(file, budget), budget);
    const Counts counts = counts_of(grid, normals, budget);
    if (counts.triangles == 0)
        invalid_file(file, "no surface: all distances have one sign; 0 counts as positive");
    const std::size_t vertices = counts.on_edges + counts.inside;
    if (vertices >= std::numeric_limits<std::uint32_t>::max())
        unsupported_file(file, "a surface of more than 2^32 - 2 vertices");
    budget.take_mesh(file, vertices, counts.triangles);
    if (normals == SdfNormals::smooth) budget.take_memory(kBytesOnEdge * counts.on_edges);
    GridSurface surface(grid, normals);
    surface.reserve(vertices, counts.triangles);
    for_crossed(grid, budget, [&](const glm::ivec3& cell, const CellCorners& corners) {
        budget.step(256);
        surface.add(cell, corners);
    });
    validate(surface.mesh, file.string());
    return std::move(surface.mesh);
}

}  // namespace nicol
