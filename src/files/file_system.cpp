// SPDX-License-Identifier: MIT
// The file system as a source of files.
#include <sys/stat.h>

#include <fstream>

#include "files/file_source.hpp"

namespace nicol {
namespace {

class FileSystem final : public FileSource {
public:
    [[nodiscard]] std::optional<Found> find(const std::filesystem::path& file) const override {
        struct stat status = {};
        if (::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
        // The time of the last status change cannot be set back, unlike the time of the last modification.
        std::string identity;
        for (const auto part :
             {static_cast<long long>(status.st_dev), static_cast<long long>(status.st_ino),
              static_cast<long long>(status.st_size), static_cast<long long>(status.st_ctim.tv_sec),
              static_cast<long long>(status.st_ctim.tv_nsec)})
            identity += std::to_string(part) + ' ';
        return Found{.bytes = static_cast<std::uint64_t>(status.st_size), .identity = std::move(identity)};
    }

    [[nodiscard]] bool has_folder(const std::filesystem::path& folder) const override {
        std::error_code ignored;
        return std::filesystem::is_directory(folder, ignored);
    }

    [[nodiscard]] std::unique_ptr<std::istream> open(const std::filesystem::path& file) const override {
        if (!find(file)) return nullptr;
        auto stream = std::make_unique<std::ifstream>(file, std::ios::binary);
        if (!*stream) return nullptr;
        return stream;
    }
};

}  // namespace

const FileSource& file_system() {
    static const FileSystem files;
    return files;
}

}  // namespace nicol
