// SPDX-License-Identifier: MIT
#include "nicol/response_cache.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "files/cache_file.hpp"
#include "material/key.hpp"

namespace nicol {
namespace {

constexpr std::string_view magic("NICOLRT\0", 8);
// Raise it whenever the numbers of any table change.
constexpr std::uint32_t version = 1;

}  // namespace

ResponseTable load_or_build(const Material& material, const LightLayout& layout, int channels,
                            const std::filesystem::path& folder, const CacheNotice& notice) {
    const std::string content = folder.empty() ? std::string() : material.content_key();
    if (content.empty()) return ResponseTable(material, layout, channels);
    const int table_channels = ResponseTable::channels_for(material, channels);
    const CacheFile file(folder, magic, version,
                         Key(content)
                             .add("order", layout.order())
                             .add("kind", static_cast<double>(layout.kind()))
                             .add("channels", table_channels)
                             .add("angles", ResponseTable::kAngles)
                             .text(),
                         ".response");
    std::vector<float> data(ResponseTable::kAngles * 4 * layout.size() *
                            static_cast<std::size_t>(table_channels));
    const std::array parts{writable_bytes_of(std::span(data))};
    CacheFile::Outcome outcome = file.read(parts);
    if (outcome.state == CacheFile::State::complete &&
        !std::ranges::all_of(data, [](float value) { return std::isfinite(value); })) {
        outcome = {CacheFile::State::unfit, "is damaged"};
    }
    if (outcome.state == CacheFile::State::complete) {
        return ResponseTable(layout, table_channels, std::move(data));
    }
    if (outcome.state == CacheFile::State::unfit && notice) {
        notice(file.path().string() + ": " + outcome.reason + "; the table is made anew");
    }
    ResponseTable table(material, layout, channels);
    const std::string failure = file.write(std::array{bytes_of(table.data())});
    if (!failure.empty() && notice) notice(failure);
    return table;
}

}  // namespace nicol
