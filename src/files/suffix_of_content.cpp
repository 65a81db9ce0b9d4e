// SPDX-License-Identifier: MIT
#include "files/suffix_of_content.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace nicol {
namespace {

using namespace std::string_view_literals;

struct Beginning {
    std::string_view bytes;
    std::string_view suffix;
};

constexpr std::array kBeginnings{Beginning{"glTF"sv, ".glb"},
                                 Beginning{"\x89PNG"sv, ".png"},
                                 Beginning{"\xff\xd8\xff"sv, ".jpg"},
                                 Beginning{"\x76\x2f\x31\x01"sv, ".exr"},
                                 Beginning{"#?RADIANCE"sv, ".hdr"},
                                 Beginning{"#?RGBE"sv, ".hdr"},
                                 Beginning{"BM"sv, ".bmp"},
                                 Beginning{"PK\3\4"sv, ".npz"},
                                 Beginning{"tensor_file"sv, ".pbsdf"},
                                 Beginning{"\x1c\x04"sv, ".serialized"},
                                 Beginning{"ply\n"sv, ".ply"},
                                 Beginning{"ply\r"sv, ".ply"}};

// Beginnings of texts, after blanks. OFF files begin with letters for their extra data, such as COFF.
constexpr std::array kTexts{Beginning{"<"sv, ".xml"},     Beginning{"{"sv, ".gltf"},
                            Beginning{"OFF"sv, ".off"},   Beginning{"COFF"sv, ".off"},
                            Beginning{"NOFF"sv, ".off"},  Beginning{"STOFF"sv, ".off"},
                            Beginning{"CNOFF"sv, ".off"}, Beginning{"solid"sv, ".stl"}};

/// Returns whether the size of the content is the size that a binary STL file states.
bool is_binary_stl(std::string_view bytes) {
    constexpr std::size_t head = 84, triangle = 50;
    std::uint32_t count = 0;
    if (bytes.size() < head) return false;
    std::memcpy(&count, bytes.data() + head - sizeof count, sizeof count);
    return bytes.size() == head + std::uint64_t{count} * triangle;
}

}  // namespace

std::string_view suffix_of_content(std::string_view bytes) {
    for (const Beginning& beginning : kBeginnings)
        if (bytes.starts_with(beginning.bytes)) return beginning.suffix;
    if (is_binary_stl(bytes)) return ".stl";
    std::string_view text = bytes.starts_with("\xef\xbb\xbf") ? bytes.substr(3) : bytes;
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    for (const Beginning& beginning : kTexts)
        if (text.starts_with(beginning.bytes)) return beginning.suffix;
    constexpr std::size_t looked_at = 256;
    const bool is_text =
        !text.empty() && text.substr(0, looked_at).find_first_of("\0\1\2\3\4"sv) == std::string_view::npos;
    return is_text ? ".obj" : "";
}

}  // namespace nicol
