// SPDX-License-Identifier: MIT
// Meshes.
#include "assets.hpp"

using namespace nicol;
using namespace nicol::capi;

nicol_result nicol_mesh_load(nicol_context context, const char* path, nicol_mesh* mesh) {
    return load(context, path, mesh, "mesh", [&](LoadBudget& budget, const Session& session) {
        budget.take_file(path);
        const auto loaded =
            std::make_shared<Mesh>(load_mesh(path, [&](const std::string& text) { session.notice(text); }));
        if (has_upward_texcoords(path)) flip_texcoords(*loaded);
        budget.take_instance(path, loaded->positions.size(), loaded->triangles.size());
        return std::shared_ptr<const Mesh>(loaded);
    });
}

nicol_result nicol_mesh_create(nicol_context context, const nicol_mesh_data* data, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [&] {
        const nicol_mesh_data given = read_struct(data, nicol_mesh_data NICOL_MESH_DATA_INIT, "data");
        require(given.positions, "data->positions");
        require(given.indices, "data->indices");
        if (given.reserved != 0) refuse("data->reserved must be 0");
        Mesh out;
        for (std::uint32_t v = 0; v < given.vertex_count; ++v) {
            const float* p = given.positions + 3 * std::size_t{v};
            out.positions.emplace_back(p[0], p[1], p[2]);
            if (given.normals == nullptr) continue;
            const float* n = given.normals + 3 * std::size_t{v};
            out.normals.emplace_back(n[0], n[1], n[2]);
        }
        for (std::uint32_t t = 0; t < given.triangle_count; ++t) {
            const std::uint32_t* i = given.indices + 3 * std::size_t{t};
            out.triangles.emplace_back(i[0], i[1], i[2]);
        }
        try {
            const std::size_t flat = validate(out, "data");
            if (flat > 0)
                resolve(context).session->notice("a mesh of " + std::to_string(given.triangle_count) +
                                                 " triangles: left out: " + std::to_string(flat) +
                                                 " without area");
        } catch (const Error& error) {  // of a file it would be the file's fault
            throw Error(ErrorCode::invalid_argument, error.what());
        }
        return std::make_shared<const Mesh>(std::move(out));
    });
}

nicol_result nicol_mesh_create_sphere(nicol_context context, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [] { return std::make_shared<const Mesh>(make_sphere()); });
}

nicol_result nicol_mesh_create_rectangle(nicol_context context, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [] { return std::make_shared<const Mesh>(make_rectangle()); });
}

nicol_result nicol_mesh_create_cube(nicol_context context, nicol_mesh* mesh) {
    return create(context, mesh, "mesh", [] { return std::make_shared<const Mesh>(make_cube()); });
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

nicol_result nicol_mesh_retain(nicol_mesh mesh) {
    return retain(mesh);
}
nicol_result nicol_mesh_release(nicol_mesh mesh) {
    return release(mesh);
}
