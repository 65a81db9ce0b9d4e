// SPDX-License-Identifier: MIT
// Tables of the cache: magic, version, length of the key, key, the table's numbers, and the hash of all that.
#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>
#include <string>

#include "files/content_hash.hpp"
#include "inspect_material.hpp"
#include "material/matrix_rows.hpp"

namespace nicol::capi {
namespace {

using std::filesystem::path;

constexpr std::size_t prefix_size = 16;
constexpr std::string_view magic("NICOLRT\0", 8);
constexpr std::uint32_t version = 1;
constexpr std::size_t hash_size = 32;
constexpr std::uint32_t longest_key = 1 << 16;

class ResponseReader {
public:
    explicit ResponseReader(const path& file) : name_(file.string()), in_(file, std::ios::binary) {
        if (!in_) throw Error(ErrorCode::file_not_found, name_ + ": cannot be opened");
        size_ = std::filesystem::file_size(file);
    }

    ResponseFile read() {
        std::string header = take(prefix_size);
        if (header.substr(0, magic.size()) != magic) invalid("is no response table of Nicol");
        std::uint32_t found_version = 0;
        std::uint32_t key_size = 0;
        std::memcpy(&found_version, header.data() + 8, 4);
        std::memcpy(&key_size, header.data() + 12, 4);
        if (found_version != version)
            throw Error(ErrorCode::unsupported, name_ + ": has format version " +
                                                    std::to_string(found_version) + "; this build reads " +
                                                    std::to_string(version));
        if (key_size > longest_key) invalid("claims a key of " + std::to_string(key_size) + " bytes");
        key_ = take(key_size);
        header += key_;
        const int order = number("order", 0, kMaxOrder);
        const int kind = number("kind", 1, 4);
        const int channels = number("channels", 1, NICOL_MAX_CHANNELS);
        if (kind == 2) invalid("has the kind of light 2; it must be 1, 3 or 4");
        (void)number("angles", ResponseTable::kAngles, ResponseTable::kAngles);

        // The length is checked before anything of that size is allocated.
        const std::uint64_t scalar =
            static_cast<std::uint64_t>(order + 1) * (static_cast<std::uint64_t>(order) + 2) / 2;
        const std::uint64_t spin = order < 2 ? 0 : psh_count(order) - 4;
        const std::uint64_t entries = scalar * (kind == 4 ? 2 : 1) + (kind == 1 ? 0 : spin);
        const std::uint64_t count =
            ResponseTable::kAngles * 4 * entries * static_cast<std::uint64_t>(channels);
        const std::uint64_t expected = header.size() + count * sizeof(float) + hash_size;
        if (size_ != expected)
            invalid("has " + std::to_string(size_) + " bytes; a table of this order has " +
                    std::to_string(expected));
        const LightLayout layout(order, static_cast<LightKind>(kind));
        std::vector<float> data(count);
        in_.read(reinterpret_cast<char*>(data.data()), static_cast<std::streamsize>(count * sizeof(float)));
        const std::string hash = take(hash_size);
        const std::span bytes(reinterpret_cast<const unsigned char*>(data.data()), count * sizeof(float));
        if (hash != ContentHash().add(header).add(bytes).text()) invalid("is damaged: its checksum differs");
        for (const float value : data)
            if (!std::isfinite(value)) invalid("has a value that is not finite");
        return {layout, ResponseTable(layout, channels, std::move(data))};
    }

private:
    [[noreturn]] void invalid(const std::string& what) const {
        throw Error(ErrorCode::invalid_file, name_ + ": " + what);
    }

    std::string take(std::size_t bytes) {
        std::string out(bytes, '\0');
        in_.read(out.data(), static_cast<std::streamsize>(bytes));
        if (!in_) invalid("is truncated");
        return out;
    }

    // " name=value" of the key; what describes the table stands last.
    int number(const std::string& name, int low, int high) const {
        const std::size_t at = key_.rfind(" " + name + "=");
        if (at == std::string::npos) invalid("does not say its " + name);
        const std::string digits = key_.substr(at + name.size() + 2, 6);
        const int value = std::isdigit(static_cast<unsigned char>(digits[0])) ? std::stoi(digits) : -1;
        if (value < low || value > high) invalid("says " + name + "=" + digits + ", which is out of range");
        return value;
    }

    std::string name_;
    std::ifstream in_;
    std::uint64_t size_ = 0;
    std::string key_;
};

}  // namespace

ResponseFile read_response_file(const path& file) {
    return ResponseReader(file).read();
}

std::vector<IsotropicMatrix> matrices_of(const ResponseFile& file) {
    const int order = file.layout.order();
    const LightLayout all(order, LightKind::full);
    const int channels = file.table.channels();
    std::vector<IsotropicMatrix> out(static_cast<std::size_t>(channels), IsotropicMatrix(order, order));
    std::vector<double> rows(4 * all.size());
    constexpr int last = ResponseTable::kAngles - 1;
    constexpr double step = std::numbers::pi / 2 / last;
    for (int angle = 0; angle <= last; ++angle) {
        // Simpson's rule over the zenith angle.
        const double simpson = step / 3 * (angle == 0 || angle == last ? 1 : angle % 2 == 1 ? 4 : 2);
        const double theta = angle * step;
        for (int c = 0; c < channels; ++c) {
            const std::span<const float> from = file.table.rows(angle, c);
            // A layout for less light is the beginning of the one for all.
            for (std::size_t p = 0; p < 4; ++p)
                for (std::size_t j = 0; j < file.layout.size(); ++j)
                    rows[p * all.size() + j] = static_cast<double>(from[p * file.layout.size() + j]);
            add_circle(out[static_cast<std::size_t>(c)], theta, simpson * std::sin(theta), all, rows);
        }
    }
    return out;
}

}  // namespace nicol::capi
