// SPDX-License-Identifier: MIT
#include "files/cache_file.hpp"

#include <doctest/doctest.h>

#include <array>
#include <fstream>
#include <iterator>
#include <numeric>
#include <random>

using namespace nicol;

namespace {

using State = CacheFile::State;

struct Folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() /
                                 ("nicol-cache-file-" + std::to_string(std::random_device()()));
    ~Folder() { std::filesystem::remove_all(path); }
};

std::vector<unsigned char> some_bytes(std::size_t count) {
    std::vector<unsigned char> bytes(count);
    std::iota(bytes.begin(), bytes.end(), static_cast<unsigned char>(3));
    return bytes;
}

std::string content_of(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write(const std::filesystem::path& path, const std::string& content) {
    std::ofstream(path, std::ios::binary) << content;
}

}  // namespace

TEST_CASE("content of unknown length comes back whole") {
    const Folder folder;
    for (const std::size_t size : {0, 1, 7, 4096}) {
        const CacheFile file(folder.path, "NICOLTST", 1, "some key", ".test");
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
    const Folder folder;
    const CacheFile file(folder.path, "NICOLTST", 1, "some key", ".test");
    std::vector<unsigned char> found;
    CHECK(file.read(found, 1000).state == State::missing);
    const std::vector<unsigned char> bytes = some_bytes(100);
    CHECK(file.write(std::array{std::span<const unsigned char>(bytes)}).empty());
    const std::string good = content_of(file.path());
    CHECK(CacheFile(folder.path, "NICOLTST", 2, "some key", ".test").read(found, 1000).state ==
          State::missing);
    for (std::size_t cut = 0; cut < good.size(); cut += 11) {
        write(file.path(), good.substr(0, cut));
        CHECK(file.read(found, 1000).state == State::unfit);
    }
    for (std::size_t at = 0; at < good.size(); at += 5) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 4);
        write(file.path(), bad);
        CHECK(file.read(found, 1000).state == State::unfit);
    }
    write(file.path(), good + "x");
    CHECK(file.read(found, 1000).state == State::unfit);
    write(file.path(), good);
    CHECK(file.read(found, 1000).state == State::complete);
}
