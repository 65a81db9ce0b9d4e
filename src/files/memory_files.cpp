// SPDX-License-Identifier: MIT
#include "files/memory_files.hpp"

#include <streambuf>
#include <utility>

namespace nicol {
namespace {

/// Buffer of a stream that reads bytes in memory and can be positioned.
class MemoryBuffer : public std::streambuf {
public:
    explicit MemoryBuffer(std::string_view bytes) {
        // Streams take mutable pointers, but this one has no function that writes.
        char* const first = const_cast<char*>(bytes.data());
        setg(first, first, first + bytes.size());
    }

protected:
    pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override {
        const off_type base = from == std::ios_base::beg   ? 0
                              : from == std::ios_base::cur ? gptr() - eback()
                                                           : egptr() - eback();
        if (offset < -base || offset > egptr() - eback() - base) return off_type{-1};
        setg(eback(), eback() + base + offset, egptr());
        return base + offset;
    }
    pos_type seekpos(pos_type position, std::ios_base::openmode mode) override {
        return seekoff(off_type(position), std::ios_base::beg, mode);
    }
};

class MemoryStream : public std::istream {
public:
    explicit MemoryStream(std::string_view bytes) : std::istream(nullptr), buffer_(bytes) { rdbuf(&buffer_); }

private:
    MemoryBuffer buffer_;
};

}  // namespace

MemoryFiles::MemoryFiles(const std::filesystem::path& name, std::string_view bytes, Resolve resolve)
    : resolve_(std::move(resolve)) {
    known_.emplace(name.lexically_normal().string(), bytes);
}

std::optional<std::string_view> MemoryFiles::content(const std::filesystem::path& file) const {
    std::string name = file.lexically_normal().string();
    const auto known = known_.find(name);
    if (known != known_.end()) return known->second;
    const std::optional<std::string_view> found = resolve_ ? resolve_(name) : std::nullopt;
    return known_.emplace(std::move(name), found).first->second;
}

std::optional<FileSource::Found> MemoryFiles::find(const std::filesystem::path& file) const {
    const std::optional<std::string_view> bytes = content(file);
    if (!bytes) return std::nullopt;
    return Found{.bytes = bytes->size(), .identity = file.lexically_normal().string()};
}

bool MemoryFiles::has_folder(const std::filesystem::path& /*folder*/) const {
    return true;
}

std::unique_ptr<std::istream> MemoryFiles::open(const std::filesystem::path& file) const {
    const std::optional<std::string_view> bytes = content(file);
    return bytes ? std::make_unique<MemoryStream>(*bytes) : nullptr;
}

}  // namespace nicol
