// SPDX-License-Identifier: MIT
#include "material/response_cache.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string_view>
#include <utility>
#include <vector>

#include "error.hpp"
#include "files/cache_file.hpp"
#include "files/content_hash.hpp"
#include "material/key.hpp"

namespace nicol {
namespace {

constexpr std::string_view kMagic("NICOLRT\0", 8);
// Format version, to be raised whenever the numbers of any table change.
constexpr std::uint32_t kVersion = 4;

// Returns the key of a table: the material's own key, then the table's parameters.
std::string key_of(const std::string& content, const LightLayout& layout, int channels,
                   std::size_t pairings) {
    return Key(content)
        .add("order", layout.order())
        .add("kind", static_cast<double>(layout.kind()))
        .add("channels", channels)
        .add("pairings", static_cast<double>(pairings))
        .add("angles", ResponseTable::kAngles)
        .text();
}

bool all_finite(std::span<const float> data) {
    return std::ranges::all_of(data, [](float value) { return std::isfinite(value); });
}

class StoredTable {
public:
    explicit StoredTable(const std::filesystem::path& file)
        : name_(file.string()), in_(file, std::ios::binary) {
        if (!in_) throw Error(ErrorCode::file_not_found, name_ + ": cannot be opened");
        size_ = std::filesystem::file_size(file);
    }

    StoredResponse read() {
        const std::string header = read_header();
        const int order = number("order", 0, kMaxOrder);
        const int kind = number("kind", 1, 4);
        const int channels = number("channels", 1, 99999);
        const int pairings = number("pairings", 1, 2);
        if (kind == 2) invalid("has the kind of light 2; it must be 1, 3 or 4");
        (void)number("angles", ResponseTable::kAngles, ResponseTable::kAngles);

        // The length is checked before anything of that size is allocated.
        const auto pairs = static_cast<std::uint64_t>(order + 1) * static_cast<std::uint64_t>(order + 2) / 2;
        check_size(size_ >= pairs * kRowBytes, order);
        const LightLayout layout(order, static_cast<LightKind>(kind));
        const std::uint64_t bytes = layout.row_size() * kRowBytes * static_cast<std::uint64_t>(channels) *
                                    static_cast<std::uint64_t>(pairings);
        check_size(size_ == header.size() + bytes + kHashSize, order);
        std::vector<float> data(bytes / sizeof(float));
        in_.read(reinterpret_cast<char*>(data.data()), static_cast<std::streamsize>(bytes));
        const std::string hash = take(kHashSize);
        if (hash != ContentHash().add(header).add(bytes_of(std::span<const float>(data))).text())
            invalid("is damaged: its checksum differs");
        if (!all_finite(data)) invalid("has a value that is not finite");
        return {layout, ResponseTable(layout, channels, static_cast<std::size_t>(pairings), std::move(data))};
    }

private:
    static constexpr std::size_t kHashSize = 32;
    static constexpr std::uint32_t kMaxKeyBytes = 1 << 16;
    // Bytes of one pair of the layout, in one channel and pairing.
    static constexpr std::uint64_t kRowBytes = ResponseTable::kAngles * 4 * sizeof(float);

    [[noreturn]] void invalid(const std::string& what) const {
        throw Error(ErrorCode::invalid_file, name_ + ": " + what);
    }

    void check_size(bool right, int order) const {
        if (!right)
            invalid("has " + std::to_string(size_) + " bytes, another length than a table of order " +
                    std::to_string(order) + " has");
    }

    std::string take(std::size_t bytes) {
        std::string out(bytes, '\0');
        in_.read(out.data(), static_cast<std::streamsize>(bytes));
        if (!in_) invalid("is truncated");
        return out;
    }

    std::string read_header() {
        std::string header = take(kMagic.size() + 8);
        if (!header.starts_with(kMagic)) invalid("is no response table of Nicol");
        std::uint32_t found = 0;
        std::uint32_t key_size = 0;
        std::memcpy(&found, header.data() + kMagic.size(), 4);
        std::memcpy(&key_size, header.data() + kMagic.size() + 4, 4);
        if (found != kVersion)
            throw Error(ErrorCode::unsupported, name_ + ": has format version " + std::to_string(found) +
                                                    "; this build reads " + std::to_string(kVersion));
        if (key_size > kMaxKeyBytes) invalid("claims a key of " + std::to_string(key_size) + " bytes");
        key_ = take(key_size);
        return header + key_;
    }

    // Returns the number in " name=number" of the key. Throws unless it lies in `low` to `high`.
    int number(const std::string& name, int low, int high) const {
        const std::size_t at = key_.rfind(" " + name + "=");
        if (at == std::string::npos) invalid("does not say its " + name);
        const std::string digits = key_.substr(at + name.size() + 2, 6);
        int value = low - 1;
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (value < low || value > high) invalid("says " + name + "=" + digits + ", which is out of range");
        return value;
    }

    std::string name_;
    std::ifstream in_;
    std::uint64_t size_ = 0;
    std::string key_;
};

// Table and what went wrong with its file; a text is empty if nothing went wrong.
struct Cached {
    ResponseTable table;
    std::string unfit;        // reason why an existing file is not usable
    std::string not_written;  // reason why the table could not be written
};

Cached through_cache(const Material& material, const std::string& content, const LightLayout& layout,
                     int channels, const std::filesystem::path& folder, ResponseTable::KnownRows* known) {
    const int table_channels = ResponseTable::channels_for(material, channels);
    const std::size_t pairings = material.pairings();
    const CacheFile file(folder, kMagic, kVersion, key_of(content, layout, table_channels, pairings),
                         ".response");
    std::vector<float> data(ResponseTable::kAngles * 4 * pairings * layout.row_size() *
                            static_cast<std::size_t>(table_channels));
    const std::array parts{writable_bytes_of(std::span(data))};
    CacheFile::Outcome outcome = file.read(parts);
    if (outcome.state == CacheFile::State::complete && !all_finite(data)) {
        outcome = {CacheFile::State::unfit, "is damaged"};
    }
    if (outcome.state == CacheFile::State::complete) {
        return {ResponseTable(layout, table_channels, pairings, std::move(data)), {}, {}};
    }
    Cached built{ResponseTable(material, layout, channels, known), {}, {}};
    if (outcome.state == CacheFile::State::unfit) built.unfit = file.path().string() + ": " + outcome.reason;
    built.not_written = file.write(std::array{bytes_of(built.table.data())});
    return built;
}

}  // namespace

ResponseTable load_or_build(const Material& material, const LightLayout& layout, int channels,
                            const std::filesystem::path& folder, const CacheNotice& notice,
                            ResponseTable::KnownRows* known) {
    const std::string content = folder.empty() ? std::string() : material.content_key();
    if (content.empty()) return {material, layout, channels, known};
    Cached cached = through_cache(material, content, layout, channels, folder, known);
    if (notice) {
        if (!cached.unfit.empty()) notice(cached.unfit + "; the table is made anew");
        if (!cached.not_written.empty()) notice(cached.not_written);
    }
    return std::move(cached.table);
}

void store_response_table(const Material& material, const LightLayout& layout, int channels,
                          const std::filesystem::path& folder) {
    const Cached cached = through_cache(material, material.content_key(), layout, channels, folder, nullptr);
    if (!cached.not_written.empty()) throw Error(ErrorCode::write_failed, cached.not_written);
}

StoredResponse read_response_table(const std::filesystem::path& file) {
    return StoredTable(file).read();
}

}  // namespace nicol
