// SPDX-License-Identifier: MIT
// Reading of ZIP archives: the directory at the end, then each member with zlib.
#include "files/zip.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "error.hpp"
#include "files/file_error.hpp"

namespace nicol {
namespace {

using std::filesystem::path;

constexpr std::uint32_t kEndMagic = 0x06054b50;
constexpr std::uint32_t kDirectoryMagic = 0x02014b50;
constexpr std::uint32_t kLocalMagic = 0x04034b50;
constexpr std::size_t kEndSize = 22;
constexpr std::size_t kDirectorySize = 46;
constexpr std::size_t kLocalSize = 30;
constexpr std::uint64_t kMaxDirectoryBytes = 1 << 20;
/// Largest compression ratio of deflate.
constexpr std::uint64_t kMaxRatio = 1032;
constexpr std::size_t kBufferBytes = 1 << 16;

std::uint32_t u16(const unsigned char* p) {
    return static_cast<std::uint32_t>(p[0] | p[1] << 8);
}
std::uint32_t u32(const unsigned char* p) {
    return u16(p) | u16(p + 2) << 16;
}

std::vector<unsigned char> read_at(std::istream& in, const path& file, std::uint64_t offset,
                                   std::uint64_t size) {
    std::vector<unsigned char> bytes(size);
    in.clear();
    in.seekg(static_cast<std::streamoff>(offset));
    in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (!in) invalid_file(file, "is truncated or cannot be read");
    return bytes;
}

/// Finds the record that closes the archive. A comment of up to 64 KiB may follow the record.
std::vector<unsigned char> find_end(std::istream& in, const path& file, std::uint64_t file_size) {
    const std::uint64_t tail = std::min<std::uint64_t>(file_size, kEndSize + 0xffff);
    std::vector<unsigned char> bytes = read_at(in, file, file_size - tail, tail);
    for (std::size_t i = bytes.size() < kEndSize ? 0 : bytes.size() - kEndSize + 1; i-- > 0;) {
        if (u32(&bytes[i]) == kEndMagic && i + kEndSize + u16(&bytes[i + 20]) == bytes.size())
            return {bytes.begin() + static_cast<std::ptrdiff_t>(i), bytes.end()};
    }
    invalid_file(file, "is not a complete ZIP archive (no end record); .npz files are ZIP archives");
}

ZipEntry parse_entry(const path& file, const unsigned char* p, const std::string& name,
                     std::uint64_t directory_offset) {
    ZipEntry entry{name, u32(p + 42), u32(p + 20), u32(p + 24), u32(p + 16), u16(p + 10) == 8};
    if ((u16(p + 8) & 1u) != 0) unsupported_file(file, "member " + name + " is encrypted");
    if (u16(p + 10) != 0 && u16(p + 10) != 8)
        unsupported_file(file, "member " + name + " uses compression method " + std::to_string(u16(p + 10)) +
                                   "; it must be stored or deflated");
    if (std::max({entry.offset, entry.stored_size, entry.size}) == 0xffffffff)
        unsupported_file(file, "member " + name + " has ZIP64 sizes; it must be smaller than 4 GiB");
    if (entry.offset > directory_offset || entry.stored_size > directory_offset - entry.offset)
        invalid_file(file, "member " + name + " lies outside the file");
    if (entry.deflated ? entry.size > kMaxRatio * (entry.stored_size + 1) : entry.size != entry.stored_size)
        invalid_file(file, "member " + name + " claims " + std::to_string(entry.size) + " bytes, but " +
                               std::to_string(entry.stored_size) + " stored bytes cannot hold them");
    return entry;
}

}  // namespace

std::vector<ZipEntry> read_zip_directory(const path& file, const FileSource& files) {
    const auto found = files.find(file);
    const auto opened = files.open(file);
    if (!found || !opened)
        throw Error(ErrorCode::file_not_found, file.string() + ": cannot be opened for reading");
    std::istream& in = *opened;
    const std::uint64_t file_size = found->bytes;

    const std::vector<unsigned char> end = find_end(in, file, file_size);
    const std::uint64_t count = u16(&end[10]);
    const std::uint64_t size = u32(&end[12]);
    const std::uint64_t offset = u32(&end[16]);
    if (u16(&end[4]) != 0 || u16(&end[6]) != 0)
        unsupported_file(file, "is part of an archive of several volumes");
    if (count == 0xffff || size == 0xffffffff || offset == 0xffffffff)
        unsupported_file(file, "has ZIP64 sizes; the archive must be smaller than 4 GiB");
    if (size > kMaxDirectoryBytes || offset > file_size || size > file_size - offset)
        invalid_file(file, "has a directory that lies outside the file or is larger than 1 MiB");

    const std::vector<unsigned char> directory = read_at(in, file, offset, size);
    std::vector<ZipEntry> entries;
    std::set<std::string> names;
    std::size_t at = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        if (directory.size() - at < kDirectorySize || u32(&directory[at]) != kDirectoryMagic)
            invalid_file(file, "has a damaged directory at entry " + std::to_string(i));
        const unsigned char* p = &directory[at];
        const std::size_t name_size = u16(p + 28);
        const std::size_t entry_size = kDirectorySize + name_size + u16(p + 30) + u16(p + 32);
        if (directory.size() - at < entry_size)
            invalid_file(file, "has a damaged directory at entry " + std::to_string(i));
        std::string name(p + kDirectorySize, p + kDirectorySize + name_size);
        // A name ends at its first zero, as in Python's reader and in error messages.
        name.resize(std::min(name.find('\0'), name.size()));
        entries.push_back(parse_entry(file, p, name, offset));
        if (!names.insert(name).second) invalid_file(file, "has member " + name + " twice");
        at += entry_size;
    }
    return entries;
}

ZipStream::ZipStream(const path& file, const ZipEntry& entry, const FileSource& files)
    : name_(file.string() + ", member " + entry.name),
      file_(files.open(file)),
      entry_(entry),
      left_(entry.size),
      stored_left_(entry.stored_size),
      buffer_(entry.deflated ? std::min<std::uint64_t>(entry.stored_size, kBufferBytes) : 0) {
    if (!file_) throw Error(ErrorCode::file_not_found, file.string() + ": cannot be opened for reading");
    std::array<unsigned char, kLocalSize> head{};
    file_->seekg(static_cast<std::streamoff>(entry.offset));
    file_->read(reinterpret_cast<char*>(head.data()), kLocalSize);
    if (!*file_ || u32(head.data()) != kLocalMagic) invalid("has no local header where the directory says");
    // Sizes may be missing in the local header (they may follow the data), so only the directory's sizes
    // count.
    file_->seekg(static_cast<std::streamoff>(entry.offset + kLocalSize + u16(&head[26]) + u16(&head[28])));
    if (entry.deflated && inflateInit2(&inflate_, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
}

ZipStream::~ZipStream() {
    if (entry_.deflated) inflateEnd(&inflate_);
}

void ZipStream::invalid(const std::string& what) const {
    throw Error(ErrorCode::invalid_file, name_ + " " + what);
}

/// Reads the next stored bytes into the inflater's buffer.
void ZipStream::fill() {
    const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(stored_left_, buffer_.size()));
    if (size == 0) invalid("is truncated");
    file_->read(reinterpret_cast<char*>(buffer_.data()), static_cast<std::streamsize>(size));
    if (!*file_) invalid("is truncated");
    stored_left_ -= size;
    inflate_.next_in = buffer_.data();
    inflate_.avail_in = static_cast<uInt>(size);
}

void ZipStream::read(std::span<unsigned char> bytes) {
    if (bytes.size() > left_) invalid("is truncated: its content is shorter than its header says");
    if (bytes.empty()) return;
    if (entry_.deflated) {
        inflate_.next_out = bytes.data();
        inflate_.avail_out = static_cast<uInt>(bytes.size());
        while (inflate_.avail_out > 0) {
            if (inflate_.avail_in == 0) fill();
            const int result = inflate(&inflate_, Z_NO_FLUSH);
            if (result == Z_MEM_ERROR) throw std::bad_alloc();
            if (result == Z_STREAM_END && inflate_.avail_out > 0)
                invalid("is shorter than the directory says");
            if (result != Z_OK && result != Z_STREAM_END) invalid("is damaged: it cannot be inflated");
        }
    } else {
        file_->read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        if (!*file_) invalid("is truncated");
    }
    left_ -= bytes.size();
    crc_ = static_cast<std::uint32_t>(crc32(crc_, bytes.data(), static_cast<uInt>(bytes.size())));
    if (left_ == 0 && crc_ != entry_.crc) invalid("is damaged: its CRC-32 is not that of the directory");
}

}  // namespace nicol
