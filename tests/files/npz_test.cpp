// SPDX-License-Identifier: MIT
// Tests of NumPy archives: a round trip through files, and archives of other programs.
#include "files/npz.hpp"

#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("Members come back as they were written") {
    const TemporaryFolder folder;
    const NpyArray numbers{{2, 3}, {1, -2, 3.5, 1e300, 0, 1e-300}};
    const NpyArray line{{2}, {7, 8}};
    const NpyArray one{{}, {5}};
    const NpyArray none{{3, 0, 2}, {}};
    const std::vector<NpzMember> members = {
        {"coeff", numbers}, {"line", line}, {"one", one}, {"none", none}, {"sh_type", "REAL"}};
    write_npz(folder / "a.npz", members);
    CHECK(npz_members(folder / "a.npz") ==
          std::vector<std::string>{"coeff", "line", "one", "none", "sh_type"});
    for (const NpzMember& member : members) {
        if (const auto* array = std::get_if<NpyArray>(&member.content)) {
            const NpyArray back = read_npz_member(folder / "a.npz", member.name);
            CHECK(back.shape == array->shape);
            CHECK(back.values == array->values);
        }
    }
    CHECK(read_npz_text(folder / "a.npz", "sh_type") == "REAL");
    write_npz(folder / "b.npz", members);
    CHECK(file_bytes(folder / "a.npz") == file_bytes(folder / "b.npz"));
}

TEST_CASE("The authors' archives are read") {
    const auto file = test_data("polarsh/SHVec_sponza_1024_L100.npz");
    if (file.empty()) return;
    CHECK(read_npz_text(file, "cod_type") == "POLAR4");
    CHECK(read_npz_text(file, "sh_type") == "REAL");
    const NpyArray coefficients = read_npz_member(file, "coeff");
    CHECK(coefficients.shape == std::vector<std::size_t>{3, 10000, 4});
    CHECK(coefficients.values[0] == doctest::Approx(1.390095).epsilon(1e-6));
}
