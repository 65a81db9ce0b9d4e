// SPDX-License-Identifier: MIT
// Fuzzer of NumPy archives of light and material coefficients. With NICOL_FUZZ_MEMBER the input is the array
// `coeff` of a valid archive, so that no checksum shields the array reader.
#include "files/archive.hpp"
#include "files/npz.hpp"
#include "light/psh_file.hpp"
#include "material/psh_matrix_file.hpp"
#include "memory_file.hpp"

namespace {

std::string archive_of(std::string_view input) {
#ifdef NICOL_FUZZ_MEMBER
    const std::string bytes(input);
    const bool scalar = bytes.size() % 2 != 0, deflated = bytes.size() % 8 == 7;
    const std::string codomain = scalar ? "SCALAR" : "POLAR4";
    const auto text = [](const std::string& s) { return npy(header("|S6", "()"), s); };
    return archive({ArchiveMember("coeff.npy", bytes, deflated),
                    ArchiveMember("cod_type.npy", text(codomain)),
                    ArchiveMember("sh_type.npy", npy(header("|S4", "()"), "REAL"))});
#else
    return std::string(input);
#endif
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::filesystem::path file = "input.npz";
    const std::string archive = archive_of(nicol::fuzz::text_of(bytes, size));
    const nicol::LoadLimits limits = nicol::fuzz::in_memory(file, archive);
    nicol::fuzz::may_refuse(file, [&] { static_cast<void>(nicol::read_psh_vector(file, limits)); });
    nicol::fuzz::may_refuse(file, [&] { static_cast<void>(nicol::read_psh_matrix(file, limits)); });
    nicol::fuzz::may_refuse(file, [&] {
        for (const std::string& name : nicol::npz_members(file, limits))
            static_cast<void>(nicol::read_npz_text(file, name, limits));
    });
    return 0;
}
