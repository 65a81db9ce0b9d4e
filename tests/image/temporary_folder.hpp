// SPDX-License-Identifier: MIT
// A folder for the files of one test.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "error.hpp"

/// Exists while the object lives.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::random_device random;
        folder_ = std::filesystem::temp_directory_path() / ("nicol_test_" + std::to_string(random()));
        std::filesystem::create_directories(folder_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
    }

private:
    std::filesystem::path folder_;
};

inline std::string file_bytes(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

/// Checks that `call` throws nicol::Error with this code and a message that contains every one of `parts`.
template <class Call, class... Parts>
void check_error(nicol::ErrorCode code, Call&& call, const Parts&... parts) {
    try {
        call();
    } catch (const nicol::Error& e) {
        CHECK_MESSAGE(e.code() == code, e.what());
        const std::string message = e.what();
        for (const std::string& part : std::vector<std::string>{parts...})
            CHECK_MESSAGE(message.find(part) != std::string::npos, message, " lacks ", part);
        return;
    }
    FAIL_CHECK("no error");
}
