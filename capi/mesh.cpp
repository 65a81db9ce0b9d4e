// SPDX-License-Identifier: MIT
// Meshes.
#include <cstring>

#include "assets.hpp"
#include "geometry/deformed_mesh.hpp"
#include "geometry/mesh_format.hpp"
#include "initialiser.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

template <glm::length_t n, class Number>
std::vector<glm::vec<n, Number>> vectors(const Number* from, std::uint32_t count) {
    std::vector<glm::vec<n, Number>> out;
    if (from == nullptr || count == 0) return out;
    out.resize(count);
    std::memcpy(out.data(), from, count * sizeof(out[0]));
    return out;
}

Mesh mesh_of(const nicol_mesh_data& given) {
    require(given.positions, "data->positions");
    require(given.indices, "data->indices");
    if (given.texcoords == nullptr && (given.texcoord_count != 0 || given.texcoord_indices != nullptr))
        refuse("data has texcoord_count or texcoord_indices, but no texcoords");
    if (given.texcoords == nullptr && given.tangents != nullptr)
        refuse("data has tangents, but no texcoords; give as many");
    const std::uint32_t texcoords = given.texcoord_count != 0 ? given.texcoord_count : given.vertex_count;
    if (given.texcoord_indices == nullptr && texcoords != given.vertex_count)
        refuse("data->texcoord_count is " + std::to_string(texcoords) +
               "; without texcoord_indices it must be vertex_count, " + std::to_string(given.vertex_count));
    Mesh out;
    out.positions = vectors<3>(given.positions, given.vertex_count);
    out.normals = vectors<3>(given.normals, given.vertex_count);
    out.triangles = vectors<3>(given.indices, given.triangle_count);
    out.colors = vectors<3>(given.colors, given.vertex_count);
    out.face_colors = vectors<3>(given.face_colors, given.triangle_count);
    out.texcoords = vectors<2>(given.texcoords, texcoords);
    out.tangents = vectors<4>(given.tangents, texcoords);
    if (given.texcoord_indices != nullptr)
        out.texcoord_triangles = vectors<3>(given.texcoord_indices, given.triangle_count);
    else if (given.texcoords != nullptr)
        out.texcoord_triangles = out.triangles;
    return out;
}

/// Loads a mesh, for load().
std::shared_ptr<const Mesh> load_mesh_file(const std::filesystem::path& path, const LoadBudget& budget,
                                           const SessionPtr& session) {
    budget.take_file(path);
    const auto mesh = std::make_shared<Mesh>(load_mesh(
        path, [&](const std::string& text) { session->notice(text); }, 0, budget));
    if (mesh_format_of(path)->upward_texcoords) flip_texcoords(*mesh);
    budget.take_instance(path, mesh->positions.size(), mesh->triangles.size());
    return mesh;
}

}  // namespace

nicol_result nicol_mesh_load(nicol_context context, const char* path, nicol_mesh* mesh) {
    return load(context, path, mesh, "mesh", load_mesh_file);
}

nicol_result nicol_mesh_load_memory(nicol_context context, const nicol_memory_file* file, nicol_mesh* mesh) {
    return load(context, file, mesh, "mesh", load_mesh_file);
}

nicol_result nicol_mesh_create(nicol_context context, const nicol_mesh_data* data, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [&] {
        const nicol_mesh_data given = read_struct(data, nicol_mesh_data NICOL_MESH_DATA_INIT, "data");
        Mesh out = mesh_of(given);
        try {
            const std::size_t flat = validate(out, "data");
            if (flat > 0)
                resolve(context).session->notice("a mesh of " + std::to_string(given.triangle_count) +
                                                 " triangles: left out: " + std::to_string(flat) +
                                                 " without area");
        } catch (const Error& error) {  // reports a wrong argument instead of a faulty file
            throw Error(ErrorCode::invalid_argument, error.what());
        }
        return std::make_shared<const Mesh>(std::move(out));
    });
}

nicol_result nicol_mesh_create_sphere(nicol_context context, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [] { return std::make_shared<const Mesh>(make_sphere()); });
}

nicol_result nicol_mesh_create_divided_sphere(nicol_context context, uint32_t segments, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [&] {
        if (segments < 2 || segments > kMaxSphereSegments || segments % 2 != 0)
            refuse("segments is " + std::to_string(segments) + "; it must be even, 2 to " +
                   std::to_string(kMaxSphereSegments));
        return std::make_shared<const Mesh>(
            make_sphere(glm::dvec3(0.0), 1.0, static_cast<double>(segments) / kSphereSegments));
    });
}

nicol_result nicol_mesh_create_rectangle(nicol_context context, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [] { return std::make_shared<const Mesh>(make_rectangle()); });
}

nicol_result nicol_mesh_create_cube(nicol_context context, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [] { return std::make_shared<const Mesh>(make_cube()); });
}

nicol_result nicol_mesh_create_disk(nicol_context context, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [] { return std::make_shared<const Mesh>(make_disk()); });
}

nicol_result nicol_mesh_create_cylinder(nicol_context context, const double p0[3], const double p1[3],
                                        double radius, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [&] {
        require(p0, "p0");
        require(p1, "p1");
        return std::make_shared<const Mesh>(
            make_cylinder({p0[0], p0[1], p0[2]}, {p1[0], p1[1], p1[2]}, radius));
    });
}

nicol_result nicol_mesh_create_deformed(nicol_context context, nicol_mesh base,
                                        const nicol_deformation* deformation, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [&] {
        const nicol_mesh_impl& from = resolve(base);
        require_same_context(resolve(context), from);
        const nicol_deformation given =
            read_struct(deformation, nicol_deformation NICOL_DEFORMATION_INIT, "deformation");
        const std::size_t vertices = from.content->positions.size();
        if (given.vertex_count != vertices)
            refuse("deformation->vertex_count is " + std::to_string(given.vertex_count) +
                   "; it must be that of the base, " + std::to_string(vertices));
        require(given.positions, "deformation->positions");
        return std::make_shared<const Mesh>(deformed(*from.content,
                                                     vectors<3>(given.positions, given.vertex_count),
                                                     vectors<3>(given.normals, given.vertex_count)));
    });
}

nicol_result nicol_mesh_get_size(nicol_mesh mesh, uint32_t* vertices, uint32_t* triangles) {
    return guarded([&] {
        const nicol_mesh_impl& self = resolve(mesh);
        require(vertices, "vertices");
        require(triangles, "triangles");
        *vertices = static_cast<uint32_t>(self.content->positions.size());
        *triangles = static_cast<uint32_t>(self.content->triangles.size());
    });
}

nicol_result nicol_mesh_get_bounds(nicol_mesh mesh, double lower[3], double upper[3]) {
    return guarded([&] {
        const nicol_mesh_impl& self = resolve(mesh);
        require(lower, "lower");
        require(upper, "upper");
        Box box;
        box.add(*self.content, glm::dmat4(1.0));
        write_box(box, lower, upper);
    });
}

nicol_result nicol_mesh_retain(nicol_mesh mesh) {
    return retain(mesh);
}
nicol_result nicol_mesh_release(nicol_mesh mesh) {
    return release(mesh);
}

NICOL_INITIALISER(nicol_mesh_data, NICOL_MESH_DATA_INIT)
NICOL_INITIALISER(nicol_deformation, NICOL_DEFORMATION_INIT)
