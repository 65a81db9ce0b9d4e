// SPDX-License-Identifier: MIT
// A file is: magic, version, length of the key, key, the table's numbers, and the hash of all that as text.
#include "nicol/response_cache.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <system_error>
#include <vector>

#include "files/atomic_file.hpp"
#include "material/content_hash.hpp"
#include "material/key.hpp"
#include "nicol/error.hpp"

namespace nicol {
namespace {

using std::filesystem::path;

constexpr std::string_view magic("NICOLRT\0", 8);
// Raise it whenever the numbers of any table change.
constexpr std::uint32_t version = 1;
constexpr std::size_t hash_size = 32;

std::string header_of(const std::string& key) {
    std::string out(magic);
    const auto length = static_cast<std::uint32_t>(key.size());
    for (const std::uint32_t value : {version, length})
        out.append(reinterpret_cast<const char*>(&value), sizeof value);
    return out + key;
}

std::span<const unsigned char> bytes_of(std::span<const float> data) {
    return {reinterpret_cast<const unsigned char*>(data.data()), data.size_bytes()};
}

std::string hash_of(const std::string& header, std::span<const float> data) {
    return ContentHash().add(header).add(bytes_of(data)).text();
}

// The numbers of a file, or nothing and why in `reason`; an empty reason means that there is no file.
std::optional<std::vector<float>> read(const path& file, const std::string& header, std::size_t count,
                                       std::string& reason) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return {};
    reason = "cannot be read";
    if (!std::filesystem::is_regular_file(file, error)) return {};
    std::ifstream in(file, std::ios::binary);
    if (!in) return {};
    // The length says whether anything need be read or allocated.
    const std::uint64_t expected = header.size() + count * sizeof(float) + hash_size;
    reason = "has another length than such a table";
    if (std::filesystem::file_size(file, error) != expected || error) return {};
    std::string found(header.size(), '\0');
    in.read(found.data(), static_cast<std::streamsize>(found.size()));
    reason = "is of another version or another material";
    if (!in || found != header) return {};
    std::vector<float> data(count);
    in.read(reinterpret_cast<char*>(data.data()), static_cast<std::streamsize>(count * sizeof(float)));
    std::string hash(hash_size, '\0');
    in.read(hash.data(), hash_size);
    reason = "is damaged";
    if (!in || hash != hash_of(header, data)) return {};
    if (!std::ranges::all_of(data, [](float value) { return std::isfinite(value); })) return {};
    return data;
}

void write(const path& file, const std::string& header, std::span<const float> data) {
    std::filesystem::create_directories(file.parent_path());
    AtomicFile out(file);
    const std::string hash = hash_of(header, data);
    // A failed write stays on the FILE, where commit() finds it.
    std::fwrite(header.data(), 1, header.size(), out.handle());
    std::fwrite(data.data(), sizeof(float), data.size(), out.handle());
    std::fwrite(hash.data(), 1, hash.size(), out.handle());
    out.commit();
}

}  // namespace

ResponseTable load_or_build(const Material& material, const LightLayout& layout, int channels,
                            const path& folder, const CacheNotice& notice) {
    const std::string content = folder.empty() ? std::string() : material.content_key();
    if (content.empty()) return ResponseTable(material, layout, channels);
    const auto tell = [&notice](const path& file, const std::string& what) {
        if (notice) notice(file.string() + ": " + what);
    };
    const int table_channels = ResponseTable::channels_for(material, channels);
    const std::string header = header_of(Key(content)
                                             .add("order", layout.order())
                                             .add("kind", static_cast<double>(layout.kind()))
                                             .add("channels", table_channels)
                                             .add("angles", ResponseTable::kAngles)
                                             .text());
    const path file = folder / (ContentHash().add(header).text() + ".response");
    const std::size_t count =
        ResponseTable::kAngles * 4 * layout.size() * static_cast<std::size_t>(table_channels);
    std::string reason;
    if (std::optional<std::vector<float>> data = read(file, header, count, reason))
        return ResponseTable(layout, table_channels, std::move(*data));
    if (!reason.empty()) tell(file, reason + "; the table is made anew");

    ResponseTable table(material, layout, channels);
    try {
        write(file, header, table.data());
    } catch (const Error& error) {
        if (notice) notice(error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        tell(file, "cannot be written (" + error.code().message() + ")");
    }
    return table;
}

}  // namespace nicol
