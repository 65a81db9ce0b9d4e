// SPDX-License-Identifier: MIT
// Fuzzer of the mesh readers. NICOL_FUZZ_MESH is a file name whose suffix selects the format.
#include "drawable_mesh.hpp"
#include "geometry/polygon_mesh.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const std::filesystem::path name = NICOL_FUZZ_MESH;
    nicol::fuzz::may_refuse(name, [&] {
        nicol::fuzz::require_drawable(nicol::geometry::mesh_of(name, nicol::fuzz::text_of(bytes, size)));
    });
    return 0;
}
