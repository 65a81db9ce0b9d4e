// SPDX-License-Identifier: MIT
// Checks of the structure of OpenEXR files by OpenEXR's C library, which allocates nothing by the sizes in a
// header. The C++ library allocates tables of any claimed size when it opens a file.
#include "image/exr_structure.hpp"

#include <openexr.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <istream>
#include <memory>
#include <new>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "error.hpp"
#include "files/file_error.hpp"
#include "image/stokes_image.hpp"

namespace nicol {
namespace {

using std::filesystem::path;

struct CloseContext {
    void operator()(exr_context_t context) const { exr_finish(&context); }
};

/// Reads a name or type in a header. Returns an empty text at the end of a header and at the end of the file.
std::string header_text(std::istream& in) {
    constexpr std::size_t longest = 255;
    std::string text;
    for (int c = in.get(); c > 0 && text.size() <= longest; c = in.get()) text += static_cast<char>(c);
    return text;
}

/// Returns the little-endian number at index `at`.
std::uint32_t number_at(std::string_view bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i)
        number |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    return number;
}

/// Reads a number; returns 0 at the end of the file.
std::uint32_t header_number(std::istream& in) {
    std::array<char, 4> bytes{};
    in.read(bytes.data(), bytes.size());
    return in ? number_at({bytes.data(), bytes.size()}, 0) : 0;
}

/// Sizes of the types whose values the C++ library reads without regard to the size stated before them.
constexpr std::array<std::pair<std::string_view, std::uint32_t>, 24> kSizes = {{{"box2f", 16},
                                                                                {"box2i", 16},
                                                                                {"chromaticities", 32},
                                                                                {"compression", 1},
                                                                                {"deepImageState", 1},
                                                                                {"double", 8},
                                                                                {"envmap", 1},
                                                                                {"float", 4},
                                                                                {"int", 4},
                                                                                {"keycode", 28},
                                                                                {"lineOrder", 1},
                                                                                {"m33d", 72},
                                                                                {"m33f", 36},
                                                                                {"m44d", 128},
                                                                                {"m44f", 64},
                                                                                {"rational", 8},
                                                                                {"tiledesc", 9},
                                                                                {"timecode", 8},
                                                                                {"v2d", 16},
                                                                                {"v2f", 8},
                                                                                {"v2i", 8},
                                                                                {"v3d", 24},
                                                                                {"v3f", 12},
                                                                                {"v3i", 12}}};

/// Returns whether a list of channels ends where its size says. Each channel is a name, a zero and 16 bytes,
/// and a zero ends the list.
bool is_whole_list(std::string_view bytes) {
    constexpr std::size_t of_channel = 17;
    for (;;) {
        const std::size_t name = bytes.find('\0');
        if (name == 0 || name == std::string_view::npos) return name == 0 && bytes.size() == 1;
        if (bytes.size() - name < of_channel) return false;
        bytes.remove_prefix(name + of_channel);
    }
}

/// Returns whether the bytes are whole texts, each after its length.
bool are_whole_texts(std::string_view bytes) {
    while (!bytes.empty()) {
        if (bytes.size() < 4 || number_at(bytes, 0) > bytes.size() - 4) return false;
        bytes.remove_prefix(4 + number_at(bytes, 0));
    }
    return true;
}

/// Returns whether the bytes are width, height and then four bytes per pixel.
bool is_whole_preview(std::string_view bytes) {
    return bytes.size() >= 8 && (bytes.size() - 8) % 4 == 0 &&
           std::uint64_t{number_at(bytes, 0)} * number_at(bytes, 4) == (bytes.size() - 8) / 4;
}

/// Returns whether a value of this type ends where its size says, so that the next attribute follows it.
/// Returns true for types that the library does not know.
bool is_whole(std::string_view type, std::string_view bytes) {
    const auto* const fixed =
        std::ranges::find(kSizes, type, &std::pair<std::string_view, std::uint32_t>::first);
    if (fixed != kSizes.end()) return bytes.size() == fixed->second;
    if (type == "chlist") return is_whole_list(bytes);
    if (type == "stringvector") return are_whole_texts(bytes);
    return type != "preview" || is_whole_preview(bytes);
}

/// Checks the attributes of all headers. No attribute may be larger than the rest of the file, because the C
/// library leaves out such attributes and the C++ library allocates the sizes that they claim. No value may
/// end elsewhere than its size says, because the C++ library would take other bytes for the next attribute
/// and its size. No attribute may occur twice in a header, because the two libraries take different values.
/// Other errors in the header are left to the libraries.
void check_attributes(const path& file, std::istream& in, std::uintmax_t file_size) {
    constexpr std::uint32_t magic = 20000630, several_parts_flag = 0x1000;
    if (header_number(in) != magic) return;
    const bool several_parts = (header_number(in) & several_parts_flag) != 0;
    // An empty name ends a header. The header of a further part may follow, or one more empty name.
    std::set<std::string> names;
    for (bool inside = true;;) {
        const std::string name = header_text(in);
        if (!in || (name.empty() && !(inside && several_parts))) return;
        inside = !name.empty();
        if (!inside) {
            names.clear();
            continue;
        }
        if (!names.insert(name).second) invalid_file(file, "the attribute \"" + name + "\" comes twice");
        const std::string type = header_text(in);
        const std::uint32_t size = header_number(in);
        if (!in) return;
        if (size > file_size - static_cast<std::uintmax_t>(in.tellg()))
            invalid_file(file, "the attribute \"" + name + "\" claims " + std::to_string(size) +
                                   " bytes, more than the rest of the file has");
        std::string value(size, '\0');
        in.read(value.data(), size);
        if (!is_whole(type, value)) {
            std::string message = "the attribute \"" + name + "\" claims " + std::to_string(size);
            message.append(" bytes, which its value, a ").append(type).append(", does not have");
            invalid_file(file, message);
        }
    }
}

/// Checks that every chunk of part 0 lies inside the file, at the offset in the table. Returns the bytes of
/// the largest chunk, decompressed, with all channels, including channels that are not read.
std::uint64_t check_chunks(const path& file, exr_const_context_t context, const exr_attr_box2i_t& window,
                           bool tiled, const LoadBudget& budget) {
    const auto require = [&](exr_result_t result) {
        if (result != EXR_ERR_SUCCESS)
            invalid_file(
                file, std::string("is damaged or truncated (") + exr_get_default_error_message(result) + ")");
    };
    exr_chunk_info_t chunk{};
    std::uint64_t largest = 0;
    const auto found = [&](exr_result_t result) {
        require(result);
        largest = std::max<std::uint64_t>(largest, chunk.unpacked_size);
        budget.step(256);
    };
    if (!tiled) {
        std::int32_t lines = 0;
        require(exr_get_scanlines_per_chunk(context, 0, &lines));
        if (lines < 1) invalid_file(file, "has no scan lines in a chunk");
        for (std::int64_t y = window.min.y; y <= window.max.y; y += lines)
            found(exr_read_scanline_chunk_info(context, 0, static_cast<int>(y), &chunk));
        return largest;
    }
    std::int32_t tile_width = 0;
    std::int32_t tile_height = 0;
    require(exr_get_tile_sizes(context, 0, 0, 0, &tile_width, &tile_height));
    if (tile_width < 1 || tile_height < 1) invalid_file(file, "has tiles without size");
    const int columns = (window.max.x - window.min.x) / tile_width + 1;
    const int rows = (window.max.y - window.min.y) / tile_height + 1;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) found(exr_read_tile_chunk_info(context, 0, x, y, 0, 0, &chunk));
    return largest;
}

/// Flag for a failed allocation of the C library on this thread, which the library does not always report.
thread_local bool lacked_memory = false;

/// Input of the C library, its user pointer.
struct Input {
    std::istream& stream;
    std::uintmax_t size;

    static std::int64_t read(exr_const_context_t, void* user, void* buffer, std::uint64_t size,
                             std::uint64_t offset, exr_stream_error_func_ptr_t) {
        std::istream& stream = static_cast<Input*>(user)->stream;
        stream.clear();
        stream.seekg(static_cast<std::streamoff>(offset));
        stream.read(static_cast<char*>(buffer), static_cast<std::streamsize>(size));
        return stream.gcount();
    }
    static std::int64_t total(exr_const_context_t, void* user) {
        return static_cast<std::int64_t>(static_cast<Input*>(user)->size);
    }
};

void check_structure(const path& file, std::istream& in, std::uintmax_t file_size, const LoadBudget& budget) {
    check_attributes(file, in, file_size);
    exr_context_initializer_t options = EXR_DEFAULT_CONTEXT_INITIALIZER;
    options.alloc_fn = [](std::size_t size) {
        void* const block = std::malloc(size);
        lacked_memory = lacked_memory || block == nullptr;
        return block;
    };
    options.free_fn = std::free;
    Input input{in, file_size};
    options.user_data = &input;
    options.read_fn = Input::read;
    options.size_fn = Input::total;
    options.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};
    exr_context_t context = nullptr;
    const exr_result_t opened = exr_start_read(&context, file.c_str(), &options);
    const std::unique_ptr<std::remove_pointer_t<exr_context_t>, CloseContext> closing(
        opened == EXR_ERR_SUCCESS ? context : nullptr);
    if (opened != EXR_ERR_SUCCESS)
        invalid_file(
            file, std::string("not a readable OpenEXR file (") + exr_get_default_error_message(opened) + ")");

    int parts = 0;
    exr_get_count(context, &parts);
    if (parts < 1) invalid_file(file, "has no parts");
    exr_storage_t storage{};
    if (exr_get_storage(context, 0, &storage) != EXR_ERR_SUCCESS)
        invalid_file(file, "part 0 has no storage type");
    if (storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED)
        throw Error(ErrorCode::unsupported,
                    file.string() + ": holds deep data; write it as flat scan lines or tiles");

    exr_attr_box2i_t window{};
    if (exr_get_data_window(context, 0, &window) != EXR_ERR_SUCCESS) invalid_file(file, "has no data window");
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1) invalid_file(file, "the data window is empty");
    if (width > kMaxImageSide || height > kMaxImageSide ||
        static_cast<std::size_t>(width * height) > kMaxImagePixels)
        invalid_file(file, "claims " + std::to_string(width) + " x " + std::to_string(height) +
                               " pixels; sides may be at most " + std::to_string(kMaxImageSide) +
                               " and pixels at most " + std::to_string(kMaxImagePixels));

    // All parts count, because opening the file makes the chunk tables of all of them. A chunk takes eight
    // bytes in the table and eight more at its head.
    std::uintmax_t chunks = 0;
    for (int part = 0; part < parts; ++part) {
        std::int32_t count = 0;
        if (exr_get_chunk_count(context, part, &count) != EXR_ERR_SUCCESS || count < 0)
            invalid_file(file, "part " + std::to_string(part) + " has no valid number of chunks");
        chunks += static_cast<std::uintmax_t>(count);
    }
    if (chunks > file_size / 16)
        invalid_file(file, "is truncated: " + std::to_string(file_size) + " bytes cannot hold the " +
                               std::to_string(chunks) + " chunks the header claims");
    budget.take_memory(check_chunks(file, context, window, storage == EXR_STORAGE_TILED, budget));
}

}  // namespace

void check_exr_structure(const path& file, std::istream& in, std::uintmax_t file_size,
                         const LoadBudget& budget) {
    lacked_memory = false;
    try {
        check_structure(file, in, file_size, budget);
    } catch (const Error&) {
        if (lacked_memory) throw std::bad_alloc();
        throw;
    }
}

}  // namespace nicol
