// SPDX-License-Identifier: MIT
// Fuzzer of the reader of measured materials.
#include "material/measured.hpp"
#include "memory_file.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::filesystem::path file = "input.pbsdf";
    const nicol::LoadLimits limits = nicol::fuzz::in_memory(file, nicol::fuzz::text_of(bytes, size));
    nicol::fuzz::may_refuse(file, [&] {
        const nicol::MaterialPtr material = nicol::load_measured(file, {}, {}, limits);
        const nicol::Mueller m = material->evaluate(0, {0.6, 0, 0.8}, {0, 0.28, 0.96});
        for (std::size_t e = 0; e < 16; ++e)
            nicol::fuzz::require(std::isfinite(m(e / 4, e % 4)), "reflectance is finite");
    });
    return 0;
}
