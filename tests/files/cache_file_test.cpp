// SPDX-License-Identifier: MIT
#include "files/cache_file.hpp"

#include <numeric>

#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

using State = CacheFile::State;

std::vector<unsigned char> some_bytes(std::size_t count) {
    std::vector<unsigned char> bytes(count);
    std::iota(bytes.begin(), bytes.end(), static_cast<unsigned char>(3));
    return bytes;
}

}  // namespace

TEST_CASE("content of unknown length comes back whole") {
    const TemporaryFolder folder;
    for (const std::size_t size : {0, 1, 7, 4096}) {
        const CacheFile file(folder.path(), "NICOLTST", 1, "some key", ".test");
        const std::vector<unsigned char> bytes = some_bytes(size);
        CHECK(file.write(std::array{std::span(bytes).first(size / 2), std::span(bytes).subspan(size / 2)})
                  .empty());
        std::vector<unsigned char> found = some_bytes(9);
        CHECK(file.read(found, size).state == State::complete);
        CHECK(found == bytes);
        if (size > 0) CHECK(file.read(found, size - 1).state == State::unfit);
    }
}

TEST_CASE("nothing but the same file is taken") {
    const TemporaryFolder folder;
    const CacheFile file(folder.path(), "NICOLTST", 1, "some key", ".test");
    std::vector<unsigned char> found;
    CHECK(file.read(found, 1000).state == State::missing);
    const std::vector<unsigned char> bytes = some_bytes(100);
    CHECK(file.write(std::array{std::span<const unsigned char>(bytes)}).empty());
    const std::string good = file_bytes(file.path());
    CHECK(CacheFile(folder.path(), "NICOLTST", 2, "some key", ".test").read(found, 1000).state ==
          State::missing);
    for (std::size_t cut = 0; cut < good.size(); cut += 11) {
        write_bytes(file.path(), good.substr(0, cut));
        CHECK(file.read(found, 1000).state == State::unfit);
    }
    for (std::size_t at = 0; at < good.size(); at += 5) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 4);
        write_bytes(file.path(), bad);
        CHECK(file.read(found, 1000).state == State::unfit);
    }
    const CacheFile another(folder.path(), "NICOLTST", 1, "more key", ".test");
    CHECK(another.write(std::array{std::span<const unsigned char>(bytes)}).empty());
    for (const std::string& other :
         {good + "x", std::string(good.size(), '\0'), std::string("foreign"), file_bytes(another.path())}) {
        write_bytes(file.path(), other);
        CHECK(file.read(found, 1000).state == State::unfit);
    }
    write_bytes(file.path(), good);
    CHECK(file.read(found, 1000).state == State::complete);
}
