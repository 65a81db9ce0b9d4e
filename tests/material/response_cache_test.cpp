// SPDX-License-Identifier: MIT
#include "material/response_cache.hpp"

#include <set>

#include "counting_material.hpp"
#include "files/cache_checks.hpp"
#include "material/conductor.hpp"
#include "material/psh_matrix_file.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;
using test::Counting;

namespace {

const LightLayout layout(2, LightKind::linear);

}  // namespace

TEST_CASE("a table comes back from the cache as it was, and files that cannot be used are notices") {
    test::check_cache(
        [](const std::filesystem::path& folder) {
            const Counting material;
            std::vector<std::string> notices;
            ResponseTable table = load_or_build(material, layout, 3, folder,
                                                [&](const std::string& text) { notices.push_back(text); });
            return test::CacheUse<ResponseTable>{std::move(table), material.calls > 0, notices};
        },
        [](const ResponseTable& a, const ResponseTable& b) {
            return a.channels() == 1 && b.channels() == 1 && b.makes(0) && !b.makes(1) &&
                   std::ranges::equal(a.data(), b.data());
        });
}

TEST_CASE("without a folder or a key nothing is written") {
    const TemporaryFolder scratch;
    const Counting keyless("");
    static_cast<void>(load_or_build(keyless, layout, 1, scratch.path()));
    static_cast<void>(load_or_build(Counting(), layout, 1));
    CHECK(files_in(scratch.path()).empty());
}

TEST_CASE("every parameter is in the key") {
    const auto gold = metal_index("Au");
    const std::vector<MaterialPtr> materials{
        diffuse({0.5}),
        diffuse({0.5, 0.5, 0.5}),
        diffuse({0.5000000001}),
        pplastic({}),
        pplastic({.diffuse_reflectance = {0.4}}),
        pplastic({.specular_reflectance = {0.4}}),
        pplastic({.int_ior = 1.5}),
        pplastic({.ext_ior = 1.1}),
        pplastic({.alpha = 0.2}),
        pplastic({.distribution = Distribution::ggx}),
        conductor(gold),
        conductor(gold, {0.5}),
        conductor({gold[0]}),
        conductor({std::conj(std::complex(1.0, 2.0))}),
        rough_conductor({.eta = gold}),
        rough_conductor({.eta = gold, .distribution = Distribution::ggx}),
        psh_matrix_material({IsotropicMatrix(1, 1)}),
        psh_matrix_material({IsotropicMatrix(2, 2)}),
        psh_matrix_material({IsotropicMatrix(2, 2), IsotropicMatrix(2, 2)}),
    };
    std::set<std::string> keys;
    for (const MaterialPtr& material : materials) {
        CHECK_FALSE(material->content_key().empty());
        keys.insert(material->content_key());
    }
    CHECK(keys.size() == materials.size());
    CHECK(twosided(materials[0])->content_key() == materials[0]->content_key());
    const TemporaryFolder scratch;
    const Counting material;
    for (const int order : {0, 1}) {
        for (const LightKind kind : {LightKind::unpolarized, LightKind::full})
            static_cast<void>(load_or_build(material, LightLayout(order, kind), 1, scratch.path()));
    }
    CHECK(files_in(scratch.path()).size() == 4);
}

TEST_CASE("a file of the cache is read by its name alone") {
    const TemporaryFolder scratch;
    const ResponseTable built = load_or_build(Counting(), layout, 1, scratch.path());
    const std::string good = file_bytes(files_in(scratch.path()).front());
    const auto file = scratch / "renamed";
    write_bytes(file, good);
    const StoredResponse stored = read_response_table(file);
    CHECK(stored.layout.order() == 2);
    CHECK(stored.layout.kind() == LightKind::linear);
    CHECK(stored.table.channels() == 1);
    CHECK(std::ranges::equal(stored.table.data(), built.data()));

    const auto refuse = [&](const std::string& bytes, ErrorCode code) {
        write_bytes(file, bytes);
        check_error(code, CALL(read_response_table(file)), "renamed");
    };
    const auto with = [&](const std::string& old, const std::string& now) {
        std::string bytes = good;
        return bytes.replace(bytes.find(old), old.size(), now);
    };
    for (const std::size_t size : {std::size_t{0}, std::size_t{15}, std::size_t{40}, good.size() / 2})
        refuse(good.substr(0, size), ErrorCode::invalid_file);
    refuse(good + "x", ErrorCode::invalid_file);
    refuse(with(" order=2", " order=9"), ErrorCode::invalid_file);
    refuse(with(" order=2", " order=x"), ErrorCode::invalid_file);
    refuse(with(" kind=3", " kind=2"), ErrorCode::invalid_file);
    refuse(with(" channels=1", " channels=0"), ErrorCode::invalid_file);
    refuse(with(" pairings=1", " pairings=2"), ErrorCode::invalid_file);
    refuse(with(" pairings=1", " pairings=3"), ErrorCode::invalid_file);
    refuse(with(" angles=513", " angles=512"), ErrorCode::invalid_file);
    std::string bytes = good;
    bytes[8] = static_cast<char>(bytes[8] + 1);
    refuse(bytes, ErrorCode::unsupported);
    bytes = good;
    bytes[good.size() / 2] = static_cast<char>(bytes[good.size() / 2] ^ 1);
    refuse(bytes, ErrorCode::invalid_file);
    std::filesystem::remove(file);
    CHECK_THROWS_AS(read_response_table(file), Error);
}
