// SPDX-License-Identifier: MIT
// Fuzzer of the reader of grids of signed distances.
#include "drawable_mesh.hpp"
#include "geometry/sdf_grid.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::filesystem::path file = "input.vol";
    const nicol::LoadLimits limits = nicol::fuzz::in_memory(file, nicol::fuzz::text_of(bytes, size));
    for (const nicol::SdfNormals normals : {nicol::SdfNormals::smooth, nicol::SdfNormals::analytic})
        nicol::fuzz::may_refuse(file, [&] {
            nicol::fuzz::require_drawable(nicol::load_sdf_grid(file, normals, nicol::LoadBudget(limits)));
        });
    return 0;
}
