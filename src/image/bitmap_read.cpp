// SPDX-License-Identifier: MIT
#include "image/bitmap.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "files/file_error.hpp"
#include "files/read_bytes.hpp"
#include "files/suffix.hpp"
#include "image/color.hpp"
#include "image/jpeg.hpp"
#include "image/png.hpp"

namespace {

/// Exception for an allocation beyond the needs of stb_image's image: compressed data continue behind the
/// pixels.
struct MoreThanPixels {};

/// Owner of the memory that stb_image allocates on this thread while the object exists. The destructor frees
/// the memory. No block may be larger than `most_bytes`.
class StbMemory {
public:
    explicit StbMemory(std::size_t most_bytes) : most_bytes_(most_bytes) { current() = this; }
    ~StbMemory() {
        current() = nullptr;
        for (void* block : blocks_) std::free(block);
    }
    StbMemory(const StbMemory&) = delete;
    StbMemory& operator=(const StbMemory&) = delete;

    static void* allocate(void* old, std::size_t size) {
        if (size > current()->most_bytes_) throw MoreThanPixels();
        auto& blocks = current()->blocks_;
        // Nothing is allocated between a new block and its entry.
        auto entry = blocks.extract(old != nullptr ? blocks.find(old) : blocks.insert(nullptr).first);
        void* const block = std::realloc(old, size);
        if (block != nullptr) entry.value() = block;
        blocks.insert(std::move(entry));
        // stb_image would report a damaged file instead.
        if (block == nullptr) throw std::bad_alloc();
        return block;
    }
    static void release(void* block) {
        current()->blocks_.erase(block);
        std::free(block);
    }

private:
    static StbMemory*& current() {
        thread_local StbMemory* memory = nullptr;
        return memory;
    }
    std::size_t most_bytes_;
    std::unordered_set<void*> blocks_;
};

}  // namespace

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_ONLY_HDR
#define STBI_MAX_DIMENSIONS 32768
#define STBI_MALLOC(size) StbMemory::allocate(nullptr, size)
#define STBI_REALLOC(block, size) StbMemory::allocate(block, size)
#define STBI_FREE(block) StbMemory::release(block)
#include <stb/stb_image.h>

namespace nicol {
namespace {

using std::filesystem::path;

static_assert(STBI_MAX_DIMENSIONS == kMaxImageSide);

bool has_known_mark(std::string_view bytes) {
    constexpr std::array<std::string_view, 4> marks = {kPngSignature, "BM", "#?RADIANCE", "#?RGBE"};
    return std::ranges::any_of(marks, [&](std::string_view mark) { return bytes.starts_with(mark); });
}

/// Exception that ends reading at the end of a file, because stb_image would continue with zeros, in some
/// files forever.
struct Overrun {};

struct Source {
    std::string_view left;
    const LoadBudget& budget;

    [[nodiscard]] stbi_io_callbacks callbacks() const {
        return {.read =
                    [](void* self, char* to, int size) {
                        auto& [left, budget] = *static_cast<Source*>(self);
                        if (left.empty()) throw Overrun();
                        budget.step(static_cast<std::uint64_t>(size));
                        const std::size_t count = std::min(left.size(), static_cast<std::size_t>(size));
                        std::memcpy(to, left.data(), count);
                        left.remove_prefix(count);
                        return static_cast<int>(count);
                    },
                .skip =
                    [](void* self, int size) {
                        std::string_view& left = static_cast<Source*>(self)->left;
                        const auto wanted = static_cast<std::size_t>(std::max(size, 0));
                        if (wanted > left.size()) throw Overrun();
                        left.remove_prefix(wanted);
                    },
                .eof = [](void* self) { return static_cast<Source*>(self)->left.empty() ? 1 : 0; }};
    }
};

// Largest number of pixels that one byte can encode: pixels of one bit, deflated at the largest ratio.
constexpr std::size_t kMostPixelsOfByte = std::size_t{8} * 1032;

void check_size(const path& file, std::size_t bytes, int width, int height) {
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (width < 1 || height < 1) invalid_file(file, "has no pixels");
    if (width > kMaxImageSide || height > kMaxImageSide || pixels > kMaxImagePixels)
        unsupported_file(file, std::to_string(width) + " x " + std::to_string(height) + " pixels; at most " +
                                   std::to_string(kMaxImageSide) + " a side and " +
                                   std::to_string(kMaxImagePixels) + " in all");
    if (pixels / kMostPixelsOfByte > bytes)
        invalid_file(file, "is truncated: " + std::to_string(bytes) + " bytes cannot hold " +
                               std::to_string(width) + " x " + std::to_string(height) + " pixels");
}

/// Decodes with one of stb_image's functions. Returns the numbers, which stb_image keeps.
template <class Number>
std::span<const Number> decode(const path& file, std::string_view bytes, const LoadBudget& budget,
                               Bitmap& out,
                               Number* (*load)(const stbi_io_callbacks*, void*, int*, int*, int*, int)) {
    Source source{.left = bytes, .budget = budget};
    const stbi_io_callbacks callbacks = source.callbacks();
    const Number* const pixels = load(&callbacks, &source, &out.width, &out.height, &out.channels, 0);
    if (pixels == nullptr)
        invalid_file(file, std::string("is damaged or truncated (") + stbi_failure_reason() + ")");
    const std::size_t count = static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) *
                              static_cast<std::size_t>(out.channels);
    budget.check();
    return {pixels, count};
}

/// Sets the values to numbers that are divided by `one`.
template <class Number>
void set_values(std::span<const Number> numbers, float one, Bitmap& out) {
    out.values.reserve(numbers.size());
    for (const Number number : numbers) out.values.push_back(static_cast<float>(number) / one);
}

/// Returns the largest block that stb_image needs for an image: its pixels as floats; or its pixels of 16
/// bits with the bytes that PNG puts before each row, for which stb_image may reserve twice as many; or the
/// bytes of the file.
std::size_t largest_block(std::size_t bytes, int width, int height) {
    constexpr std::size_t slack = std::size_t{1} << 18;  // includes the largest palette of TGA
    return 2 * bytes + static_cast<std::size_t>(height) * (16 * static_cast<std::size_t>(width) + 64) + slack;
}

/// Takes the memory of an image's values from `budget`.
void take_values(const Bitmap& image, const LoadBudget& budget) {
    budget.take_memory(sizeof(float) * static_cast<std::uint64_t>(image.width) *
                       static_cast<std::uint64_t>(image.height) * static_cast<std::uint64_t>(image.channels));
    budget.check();
}

/// Removes the next number from a line and returns it; returns 0 if it is not a number above 0.
double take_factor(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value) || !(value > 0)) return 0;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return text.empty() || text.front() == ' ' || text.front() == '\t' || text.front() == '\r' ? value : 0;
}

/// Returns the factors by which programs have multiplied R, G and B: the product of all lines EXPOSURE= and
/// COLORCORR= before the first empty line. Radiance is the pixel divided by the factors. Throws
/// Error(invalid_file) that names the line if one is not a finite number above 0.
std::array<double, 3> radiance_factors(const path& file, std::string_view bytes) {
    std::array<double, 3> factors{1, 1, 1};
    for (int number = 1; !bytes.empty(); ++number) {
        std::string_view line = bytes.substr(0, bytes.find('\n'));
        bytes.remove_prefix(std::min(line.size() + 1, bytes.size()));
        if (line.empty() || line == "\r") break;
        const auto starts_with = [&line](std::string_view key) {
            const bool found = line.starts_with(key);
            if (found) line.remove_prefix(key.size());
            return found;
        };
        const bool exposure = starts_with("EXPOSURE=");
        if (!exposure && !starts_with("COLORCORR=")) continue;
        const double first = take_factor(line);
        const std::array<double, 3> found = exposure
                                                ? std::array{first, first, first}
                                                : std::array{first, take_factor(line), take_factor(line)};
        for (std::size_t c = 0; c < 3; ++c) {
            factors[c] *= found[c];
            if (!(factors[c] > 0) || !std::isfinite(factors[c]))
                invalid_file(file,
                             "line " + std::to_string(number) + ": " +
                                 (exposure ? "EXPOSURE is not a number" : "COLORCORR is not three numbers") +
                                 " above 0 that floats can be divided by");
        }
    }
    return factors;
}

/// Divides the values by the factors in the header.
void undo_exposure(const path& file, std::string_view bytes, Bitmap& out) {
    const std::array<double, 3> factors = radiance_factors(file, bytes);
    const auto channels = static_cast<std::size_t>(out.channels);
    for (std::size_t i = 0; i < out.values.size(); ++i) {
        const double value = static_cast<double>(out.values[i]) / factors[i % channels];
        if (!(value <= std::numeric_limits<float>::max()))
            invalid_file(file, "EXPOSURE and COLORCORR make a pixel larger than a float can be");
        out.values[i] = static_cast<float>(value);
    }
}

void read_header_by_stb(const path& file, std::string_view bytes, const LoadBudget& budget, Bitmap& out) {
    const StbMemory memory(largest_block(bytes.size(), 0, 0));
    Source head{.left = bytes, .budget = budget};
    const stbi_io_callbacks callbacks = head.callbacks();
    if (stbi_info_from_callbacks(&callbacks, &head, &out.width, &out.height, &out.channels) == 0)
        invalid_file(file, "has a header that is damaged, truncated, or of more than " +
                               std::to_string(kMaxImageSide) + " pixels a side");
    check_size(file, bytes.size(), out.width, out.height);
}

void read_by_stb(const path& file, std::string_view bytes, const LoadBudget& budget, Bitmap& out) {
    read_header_by_stb(file, bytes, budget, out);
    take_values(out, budget);
    const StbMemory memory(largest_block(bytes.size(), out.width, out.height));
    const auto* const data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(std::min<std::size_t>(bytes.size(), 1 << 20));
    if (stbi_is_hdr_from_memory(data, size) != 0) {
        out.linear = true;
        set_values(decode<float>(file, bytes, budget, out, stbi_loadf_from_callbacks), 1, out);
        undo_exposure(file, bytes, out);
    } else if (stbi_is_16_bit_from_memory(data, size) != 0) {
        set_values(decode<stbi_us>(file, bytes, budget, out, stbi_load_16_from_callbacks), 65535, out);
    } else {
        const std::span codes = decode<stbi_uc>(file, bytes, budget, out, stbi_load_from_callbacks);
        out.codes.assign(codes.begin(), codes.end());
    }
}

}  // namespace

Bitmap read_bitmap(const path& file, const LoadBudget& budget, BitmapValues values) {
    return read_bitmap(file, read_bytes(file, budget), budget, values);
}

Bitmap read_bitmap(const path& file, std::string_view bytes, const LoadBudget& budget, BitmapValues values) {
    if (bytes.empty()) invalid_file(file, "is empty");
    Bitmap out;
    if (is_jpeg(bytes)) {
        read_jpeg_header(file, bytes, out);
        check_size(file, bytes.size(), out.width, out.height);
        take_values(out, budget);
        read_jpeg_pixels(file, bytes, out);
        budget.check();
    } else {
        if (!has_known_mark(bytes) && suffix_of(file) != ".tga")
            unsupported_file(file,
                             "not an image of a known kind; expected PNG, JPEG, BMP, TGA or Radiance HDR");
        try {
            read_by_stb(file, bytes, budget, out);
        } catch (const Overrun&) {
            invalid_file(file, "is truncated");
        } catch (const MoreThanPixels&) {
            invalid_file(file, "is damaged: its compressed data are more than its pixels");
        }
    }
    if (values == BitmapValues::floats && !out.codes.empty()) {
        set_values(std::span<const std::uint8_t>(out.codes), 255, out);
        out.codes = {};
    }
    return out;
}

}  // namespace nicol
