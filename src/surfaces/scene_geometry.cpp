// SPDX-License-Identifier: MIT
#include "surfaces/scene_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <span>
#include <utility>

#include "error.hpp"
#include "geometry/deformed_mesh.hpp"
#include "material/dielectric.hpp"
#include "material/spatial_variation.hpp"
#include "scene/middle.hpp"
#include "surfaces/rigid_motion.hpp"

namespace nicol {
namespace {

// Triangles of a batch of blockers that ends.
constexpr std::size_t kBatch = 4096;
// Most bounds of other instances that a change lists.
constexpr std::size_t kMostBounds = 16384;

// numbers: see SceneGeometry::VertexOrder.
void append_triangles(const Mesh& mesh, std::span<const std::uint32_t> numbers, bool flipped,
                      std::size_t first, std::vector<glm::uvec3>& triangles) {
    const auto offset = static_cast<std::uint32_t>(first);
    for (glm::uvec3 t : mesh.triangles) {
        if (!numbers.empty()) t = glm::uvec3(numbers[t.x], numbers[t.y], numbers[t.z]);
        triangles.push_back((flipped ? glm::uvec3(t.x, t.z, t.y) : t) + offset);
    }
}

// Appends values of vertices, times a factor. numbers: see SceneGeometry::VertexOrder.
void append_vertices(const std::vector<glm::vec3>& values, std::span<const std::uint32_t> numbers,
                     float factor, std::vector<glm::vec3>& out) {
    const std::size_t first = out.size();
    out.resize(first + values.size());
    for (std::size_t v = 0; v < values.size(); ++v)
        out[first + (numbers.empty() ? v : numbers[v])] = factor * values[v];
}

MaterialPtr material_of(const Instance& instance, bool back) {
    const MaterialPtr behind = back ? instance.material->behind() : nullptr;
    return behind ? behind : instance.material;
}

// Returns what one side of an instance shows of its emission. The back of a two-sided material emits only if
// its emission is two-sided as well.
EmissionPtr emission_of(const Scene& scene, const Instance& instance, bool back) {
    const bool emits =
        !scene.emitters_hidden() && instance.emission != nullptr && (instance.emission->two_sided || !back);
    return emits ? instance.emission : nullptr;
}

// Appends the values at the corners of a mesh's triangles: `values` indexed by `triangles`, or `missing` if
// there are no values.
template <class Value>
void append_corners(const std::vector<Value>& values, const std::vector<glm::uvec3>& triangles,
                    std::size_t count, const Value& missing, bool flipped,
                    std::vector<std::array<Value, 3>>& corners) {
    for (std::size_t i = 0; i < count; ++i) {
        std::array<Value, 3> of{missing, missing, missing};
        if (!values.empty()) {
            const glm::uvec3& t = triangles[i];
            of = {values[t.x], values[flipped ? t.z : t.y], values[flipped ? t.y : t.z]};
        }
        corners.push_back(of);
    }
}

}  // namespace

void SceneGeometry::update(const Scene& scene) {
    placing_.run(scene.geometry_version(), [&] {
        std::vector<Piece> pieces = place(scene);
        bool same = version_ != 0 && pieces.size() == pieces_.size();
        for (const Piece& piece : pieces) same = same && piece.former != kNone;
        if (!same) build(scene, pieces);
    });
    assigning_.run(scene.material_version(), scene.emission_version(), [&] { set_materials(scene); });
    completing_.run(version_, material_version_, [&] { set_corners(); });
}

std::vector<SceneGeometry::Piece> SceneGeometry::place(const Scene& scene) {
    const std::vector<Instance>& instances = scene.instances();
    std::vector<Piece> pieces;
    if (instances.empty()) return pieces;
    find_axes(scene, largest_instance(scene));
    const bool moved = to_world_ != glm::dmat4(1.0);
    const glm::dmat4 from_world = inverse_motion(to_world_);
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const Instance& instance = instances[i];
        Piece& piece =
            pieces.emplace_back(Piece{.id = scene.ids()[i],
                                      .twosided = instance.material->twosided(),
                                      .glass = glass_key(*instance.material),
                                      .roles = instance.roles,
                                      .divided = false,
                                      .mesh = instance.mesh,
                                      .mask = alpha_mask_of(*instance.material),
                                      .placement = moved ? from_world * instance.to_world : instance.to_world,
                                      .extent = {},
                                      .details = {},
                                      .in_place = nullptr,
                                      .order = nullptr,
                                      .first = 0,
                                      .last = 0,
                                      .former = kNone});
        const auto former = std::ranges::lower_bound(pieces_, piece.id, {}, &Piece::id);
        if (former == pieces_.end() || former->id != piece.id || former->twosided != piece.twosided ||
            former->mask != piece.mask || former->glass != piece.glass || former->roles != piece.roles) {
            continue;
        }
        if (former->mesh != piece.mesh) {
            if (same_triangles(*former->mesh, *piece.mesh))
                piece.elsewhere = static_cast<std::size_t>(former - pieces_.begin());
        } else if (stays(*former, piece.placement, to_world_)) {
            piece.placement = former->placement;
            piece.extent = former->extent;
            piece.former = static_cast<std::size_t>(former - pieces_.begin());
        } else {
            piece.elsewhere = static_cast<std::size_t>(former - pieces_.begin());
        }
    }
    divide(pieces);
    order_vertices(pieces);
    return pieces;
}

void SceneGeometry::divide(std::vector<Piece>& pieces) const {
    const auto put_in_place = [](Piece& piece) {
        piece.in_place = std::make_shared<const Mesh>(placed(*piece.mesh, piece.placement, piece.id));
    };
    std::vector<MeshExtent> extents;
    for (Piece& piece : pieces) {
        if (piece.former == kNone) {
            put_in_place(piece);
            piece.extent = extent_of(*piece.in_place);
        }
        extents.push_back(piece.extent);
    }
    const Details details(extents);
    for (Piece& piece : pieces) {
        piece.details = details.beside(piece.extent);
        if (piece.former != kNone) {
            const Piece& former = pieces_[piece.former];
            if (piece.details == former.details) {
                piece.in_place = former.in_place;
                piece.divided = former.divided;
                continue;
            }
            piece.former = kNone;
            put_in_place(piece);
        }
        if (auto parts = graded(*piece.in_place, piece.details)) {
            piece.in_place = std::move(parts);
            piece.divided = true;
        }
    }
}

void SceneGeometry::build(const Scene& scene, std::vector<Piece>& pieces) {
    WorldGeometry next;
    Change change{.before = version_, .kept = {}, .added = {}, .removed = {}, .moved = {}, .triangles = {}};
    std::vector<glm::uvec3> two_sided;
    std::vector<char> stays(pieces_.size(), 0);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        Piece& piece = pieces[i];
        const Mesh& mesh = piece.parts();
        const std::size_t count = mesh.positions.size();
        const std::size_t sides = piece.twosided ? 2 : 1;
        piece.first = next.positions.size();
        piece.last = piece.first + sides * count;
        if (piece.last > std::numeric_limits<std::uint32_t>::max()) {
            throw Error(ErrorCode::invalid_argument, "the scene has more than 2^32 vertices");
        }
        if (piece.former != kNone) {
            const Piece& former = pieces_[piece.former];
            stays[piece.former] = 1;
            piece.placed = former.placed;
            piece.batch = former.batch;
            const auto copy = [&](const std::vector<glm::vec3>& from, std::vector<glm::vec3>& to) {
                to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(former.first),
                          from.begin() + static_cast<std::ptrdiff_t>(former.last));
            };
            copy(geometry_->positions, next.positions);
            copy(geometry_->normals, next.normals);
            change.kept.push_back({.first = piece.first, .last = piece.last, .before = former.first});
        } else {
            const Mesh& in_place = *piece.in_place;
            change.added.push_back(piece.extent.ball);
            for (std::size_t side = 0; side < sides; ++side) {
                append_vertices(in_place.positions, *piece.order, 1, next.positions);
                append_vertices(in_place.normals, *piece.order, side == 0 ? 1.0F : -1.0F, next.normals);
            }
            if (!piece.divided) piece.in_place.reset();
        }
        piece.first_triangle = (piece.twosided ? two_sided : next.triangles).size();
        for (std::size_t side = 0; side < sides; ++side) {
            const std::size_t first = piece.first + side * count;
            const Instance& instance = scene.instances()[i];
            append_triangles(mesh, *piece.order, piece.mirrored() != (side == 1), first,
                             piece.twosided ? two_sided : next.triangles);
            next.ranges.push_back({.first = first,
                                   .last = first + count,
                                   .material = equal_materials_.first_of(material_of(instance, side == 1)),
                                   .instance = piece.id,
                                   .emission = emission_of(scene, instance, side == 1),
                                   .roles = piece.roles});
        }
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        if (stays[i] == 0) change.removed.push_back(pieces_[i].extent.ball);
    }
    next.one_sided = next.triangles.size();
    for (Piece& piece : pieces)
        if (piece.twosided) piece.first_triangle += next.one_sided;
    follow_pieces(pieces, change);
    next.triangles.insert(next.triangles.end(), two_sided.begin(), two_sided.end());
    if (!std::ranges::all_of(pieces, &Piece::blocks)) {
        next.blocking = next.triangles;
        for (const Piece& piece : pieces) {
            if (piece.blocks()) continue;
            for (glm::uvec3& triangle :
                 std::span(next.blocking).subspan(piece.first_triangle, piece.triangles()))
                triangle = glm::uvec3(triangle.x);
        }
    }

    equal_materials_.forget_unused();
    if (geometry_->ranges != next.ranges) material_version_ = new_version();
    geometry_ = std::make_shared<WorldGeometry>(std::move(next));
    pieces_ = std::move(pieces);
    change_ = std::move(change);
    version_ = new_version();
    find_blockers();
}

void SceneGeometry::find_blockers() {
    blockers_.clear();
    std::uint32_t batch = 0;
    std::size_t triangles = 0;  // in this batch
    for (Piece& piece : pieces_) {
        const std::size_t count = piece.parts().triangles.size();
        if (piece.placed == 0) {
            if (triangles >= kBatch) {
                ++batch;
                triangles = 0;
            }
            piece.placed = version_;
            piece.batch = batch;
            triangles += count;
        }
        if (!piece.blocks() || count == 0) continue;
        blockers_.push_back({.placed = piece.placed,
                             .batch = piece.batch,
                             .first = piece.first,
                             .last = piece.first + piece.parts().positions.size(),
                             .first_triangle = piece.first_triangle,
                             .triangles = count,
                             .two_sided = piece.twosided});
    }
}

SceneGeometry::Bounds SceneGeometry::others(const std::vector<Piece>& pieces, const Piece& piece,
                                            const glm::dvec3& shift) {
    Bounds out;
    for (const Piece& other : pieces) {
        if (&other == &piece || !other.blocks() || other.extent.box.empty()) continue;
        const Ball& ball = other.extent.ball;
        const Box& box = other.extent.box;
        out.balls.push_back({.centre = ball.centre + glm::vec3(shift), .radius = ball.radius});
        out.boxes.push_back({.lower = box.lower + shift, .upper = box.upper + shift});
    }
    return out;
}

void SceneGeometry::follow_pieces(const std::vector<Piece>& pieces, Change& change) const {
    const auto moves = std::ranges::count(pieces, kNone, &Piece::former);
    const bool few = static_cast<std::size_t>(moves) * (pieces.size() + pieces_.size()) <= kMostBounds;
    for (const Piece& piece : pieces) {
        const bool moved = piece.former == kNone;
        const std::size_t number = moved ? piece.elsewhere : piece.former;
        if (number == kNone) continue;
        const Piece& former = pieces_[number];
        if (moved) {
            if (piece.divided || former.divided || piece.mirrored() != former.mirrored()) continue;
            MovedRun& run = change.moved.emplace_back(
                MovedRun{.vertices = {.first = piece.first, .last = piece.last, .before = former.first},
                         .rotation = rotation_between(former.placement, piece.placement),
                         .deformed = former.mesh != piece.mesh,
                         .others = {},
                         .shift = glm::dvec3(piece.placement[3] - former.placement[3])});
            if (few && !run.deformed && run.rotation == glm::dmat3(1.0)) {
                run.others = {others(pieces, piece, glm::dvec3(0)), others(pieces_, former, run.shift)};
            }
        }
        change.triangles.push_back({.first = piece.first_triangle,
                                    .last = piece.first_triangle + piece.triangles(),
                                    .before = former.first_triangle});
    }
}

void SceneGeometry::set_materials(const Scene& scene) {
    bool changed = false;
    for (VertexRange& range : geometry_->ranges) {
        const Instance& instance = scene.at(range.instance);
        const bool back = is_back(*geometry_, range);
        const EmissionPtr emission = emission_of(scene, instance, back);
        const MaterialPtr material = equal_materials_.first_of(material_of(instance, back));
        if (range.material == material && range.emission == emission) continue;
        range.material = material;
        range.emission = emission;
        changed = true;
    }
    equal_materials_.forget_unused();
    if (changed) material_version_ = new_version();
}

void SceneGeometry::set_corners() {
    bool texcoords = false;
    bool colors = false;
    const auto needs_colors = [](const VertexRange& range, ColorsOf of) {
        return nicol::needs_colors(*range.material, of) || nicol::needs_colors(range.emission.get(), of);
    };
    const auto has_tangents = [this](const Piece& piece) {
        return !piece.mesh->tangents.empty() &&
               follows_tangents(*geometry_->ranges[range_of(*geometry_, piece.first)].material);
    };
    const bool tangents = std::ranges::any_of(pieces_, has_tangents);
    for (const VertexRange& range : geometry_->ranges) {
        const SpatialVariation* const variation = range.material->variation();
        texcoords = texcoords || range.material->anisotropic() ||
                    (variation != nullptr && variation->needs_texcoords()) ||
                    (range.emission != nullptr && range.emission->texture != nullptr);
        colors = colors || needs_colors(range, ColorsOf::vertices) || needs_colors(range, ColorsOf::faces);
    }
    geometry_->texcoords.clear();
    geometry_->colors.clear();
    geometry_->tangents.clear();
    for (const bool twosided : {false, true}) {
        for (const Piece& piece : pieces_) {
            if (piece.twosided != twosided) continue;
            const Mesh& mesh = piece.parts();
            const VertexRange& range = geometry_->ranges[range_of(*geometry_, piece.first)];
            const std::size_t count = mesh.triangles.size();
            std::vector<glm::vec4> of_corners;
            if (has_tangents(piece))
                of_corners =
                    piece.divided ? mesh.tangents : transformed_tangents(mesh, glm::dmat3(piece.placement));
            for (const bool back : {false, true}) {
                if (back && !twosided) continue;
                const bool flipped = piece.mirrored() != back;
                if (texcoords) {
                    append_corners(mesh.texcoords, mesh.texcoord_triangles, count, glm::vec2(0), flipped,
                                   geometry_->texcoords);
                }
                if (tangents) {
                    append_corners(of_corners, mesh.texcoord_triangles, count, glm::vec4(0), flipped,
                                   geometry_->tangents);
                }
                if (colors && needs_colors(range, ColorsOf::faces)) {
                    for (const glm::vec3& color : mesh.face_colors)
                        geometry_->colors.push_back({color, color, color});
                } else if (colors) {
                    append_corners(mesh.colors, mesh.triangles, count, glm::vec3(1), flipped,
                                   geometry_->colors);
                }
            }
        }
    }
}

}  // namespace nicol
