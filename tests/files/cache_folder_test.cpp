// SPDX-License-Identifier: MIT
// Tests of the files that a cache folder keeps.

#include <atomic>
#include <thread>

#include "files/cache_file.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;
using std::filesystem::path;

namespace {

/// Sets NICOL_CACHE_LIMIT during its lifetime.
class Limit {
public:
    explicit Limit(const std::string& value) { ::setenv("NICOL_CACHE_LIMIT", value.c_str(), 1); }
    ~Limit() { ::unsetenv("NICOL_CACHE_LIMIT"); }
    Limit(const Limit&) = delete;
    Limit& operator=(const Limit&) = delete;
};

constexpr std::size_t kContent = 1000;

CacheFile file_of(const path& folder, int key) {
    return {folder, "NICOLTST", 1, std::to_string(key), ".test"};
}
std::string write(const CacheFile& file) {
    const std::vector<unsigned char> content(kContent, 7);
    return file.write(std::array{std::span(content)});
}
CacheFile::State read(const CacheFile& file) {
    std::vector<unsigned char> content;
    return file.read(content, kContent).state;
}
void age(const path& file, int minutes) {
    std::filesystem::last_write_time(file,
                                     std::filesystem::last_write_time(file) - std::chrono::minutes(minutes));
}

}  // namespace

TEST_CASE("the limit of a cache is a number of bytes") {
    constexpr std::uint64_t usual = std::uint64_t{4} << 30;
    ::unsetenv("NICOL_CACHE_LIMIT");
    CHECK(cache_limit() == usual);
    for (const auto& [text, limit] : {std::pair{"", usual},
                                      {"123", std::uint64_t{123}},
                                      {"0", UINT64_MAX},
                                      {"18446744073709551615", UINT64_MAX}}) {
        const Limit set(text);
        CHECK(cache_limit() == limit);
    }
    for (const char* text : {"4GB", "-1", "1e9", " 1", "18446744073709551616"}) {
        const Limit set(text);
        CHECK(error_of(CALL(cache_limit())).find(text) != std::string::npos);
        const TemporaryFolder folder;
        CHECK(write(file_of(folder.path(), 0)).find("NICOL_CACHE_LIMIT") != std::string::npos);
    }
}

TEST_CASE("a full cache loses what was used longest ago, and nothing of others") {
    const TemporaryFolder folder;
    std::vector<CacheFile> files;
    for (int key = 0; key < 4; ++key) files.push_back(file_of(folder.path(), key));
    for (int i = 0; i < 3; ++i) {
        CHECK(write(files[i]).empty());
        age(files[i].path(), 30 - 10 * i);
    }
    // Entries that are no cache files: a file of another name, a folder, a link.
    folder.write("notes.txt", std::string(10 * kContent, 'x'));
    folder.write(std::string(32, 'a') + ".test/inside", "x");
    std::filesystem::create_symlink(folder / "notes.txt", folder / (std::string(32, 'b') + ".test"));

    CHECK(read(files[0]) == CacheFile::State::complete);  // the oldest file, used just now
    const std::uint64_t size = std::filesystem::file_size(files[0].path());
    const Limit limit(std::to_string(3 * size));
    CHECK(write(files[3]).empty());
    CHECK(read(files[1]) == CacheFile::State::missing);
    for (const int kept : {0, 2, 3}) CHECK(read(files[kept]) == CacheFile::State::complete);
    CHECK(folder.names().size() == 6);

    SUBCASE("a file that is replaced needs no room of its own") {
        CHECK(write(files[3]).empty());
        for (const int kept : {0, 2, 3}) CHECK(read(files[kept]) == CacheFile::State::complete);
    }
    SUBCASE("what the cache as a whole cannot hold is not written") {
        const Limit less(std::to_string(size - 1));
        const std::string reason = write(files[1]);
        CHECK(reason.find(files[1].path().string() + ": ") == 0);
        CHECK(reason.find("NICOL_CACHE_LIMIT") != std::string::npos);
        CHECK(folder.names().size() == 6);
    }
}

TEST_CASE("what killed writers left is removed after an hour") {
    const TemporaryFolder folder;
    const CacheFile file = file_of(folder.path(), 0);
    // Temporary files as writers leave them on file systems without nameless files.
    int writers = 0;
    const auto leave = [&] {
        folder.write(file.path().filename().string() + '.' + std::to_string(++writers) + ".tmp", "half");
    };
    leave();
    REQUIRE(files_in(folder.path()).size() == 1);
    const path old = files_in(folder.path()).front();
    age(old, 61);
    leave();
    for (const char* other : {"mine.tmp", "a.test.12.tmp"}) age(folder.write(other, "x"), 1000);
    CHECK(folder.names().size() == 4);
    CHECK(write(file_of(folder.path(), 1)).empty());
    CHECK_FALSE(std::filesystem::exists(old));
    CHECK(folder.names().size() == 4);  // one added, one removed
}

TEST_CASE("a folder that is shared, full and emptied all the time costs no more than a miss") {
    const TemporaryFolder folder;
    const Limit limit(std::to_string(5 * kContent));
    std::atomic<bool> done = false;
    std::atomic<int> unfit = 0;
    std::vector<std::thread> threads;
    for (int user = 0; user < 3; ++user)
        threads.emplace_back([&, user] {
            for (int i = 0; i < 200; ++i) {
                const CacheFile file = file_of(folder.path() / "cache", (i * 7 + user) % 10);
                if (read(file) == CacheFile::State::unfit) ++unfit;
                static_cast<void>(write(file));
            }
        });
    std::thread emptier([&] {
        std::error_code ignored;
        while (!done) std::filesystem::remove_all(folder.path() / "cache", ignored);
    });
    for (std::thread& thread : threads) thread.join();
    done = true;
    emptier.join();
    CHECK(unfit == 0);
}
