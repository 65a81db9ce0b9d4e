// SPDX-License-Identifier: MIT
// Members of ZIP archives, read as streams.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "files/file_source.hpp"

namespace nicol {

struct ZipEntry {
    std::string name;
    std::uint64_t offset = 0;       ///< offset of the local header
    std::uint64_t stored_size = 0;  ///< bytes in the archive
    std::uint64_t size = 0;         ///< bytes of content
    std::uint32_t crc = 0;
    bool deflated = false;
};

/// Reads the central directory. Throws Error(file_not_found), Error(unsupported) for archives of several
/// volumes, with ZIP64 sizes, with encrypted members or with compression other than deflate, and
/// Error(invalid_file) if the archive is damaged. Every returned entry lies inside the file, names are
/// unique, and no size exceeds the size that deflate can make of the stored bytes.
[[nodiscard]] std::vector<ZipEntry> read_zip_directory(const std::filesystem::path& path,
                                                       const FileSource& files = file_system());

/// Stream of one member's content from its beginning. Uses a few tens of KiB of memory.
class ZipStream {
public:
    /// Throws Error(invalid_file) if there is no such member at the entry's offset.
    ZipStream(const std::filesystem::path& path, const ZipEntry& entry,
              const FileSource& files = file_system());
    ~ZipStream();
    ZipStream(const ZipStream&) = delete;
    ZipStream& operator=(const ZipStream&) = delete;

    /// Returns the number of content bytes not yet read.
    [[nodiscard]] std::uint64_t left() const noexcept { return left_; }
    /// Fills `bytes`, which must not be more than left(). The last byte of the member is given only if the
    /// CRC-32 agrees. Throws Error(invalid_file) that names file and member.
    void read(std::span<unsigned char> bytes);

private:
    void fill();
    [[noreturn]] void invalid(const std::string& what) const;

    std::string name_;
    std::unique_ptr<std::istream> file_;
    ZipEntry entry_;
    std::uint64_t left_;
    std::uint64_t stored_left_;
    std::uint32_t crc_ = 0;
    std::vector<unsigned char> buffer_;
    z_stream inflate_{};
};

}  // namespace nicol
