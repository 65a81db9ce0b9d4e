// SPDX-License-Identifier: MIT
#include "import/other_file.hpp"

#include <array>
#include <string_view>

#include "files/suffix.hpp"

namespace nicol::scene {
namespace {

using namespace std::string_view_literals;

struct Beginning {
    std::string_view bytes;
    const char* kind;
};
constexpr std::array kBeginnings{Beginning{"\x89PNG"sv, "a PNG image"},
                                 Beginning{"\xff\xd8\xff"sv, "a JPEG image"},
                                 Beginning{"\x76\x2f\x31\x01"sv, "an OpenEXR image"},
                                 Beginning{"#?RADIANCE"sv, "a Radiance HDR image"},
                                 Beginning{"#?RGBE"sv, "a Radiance HDR image"},
                                 Beginning{"ply\n"sv, "a PLY mesh"},
                                 Beginning{"ply\r"sv, "a PLY mesh"},
                                 Beginning{"solid "sv, "an STL mesh"},
                                 Beginning{"BLENDER"sv, "a Blender file"},
                                 Beginning{"PK\3\4"sv, "an archive"},
                                 Beginning{"%PDF"sv, "a PDF"},
                                 Beginning{"\x1f\x8b"sv, "a compressed file"},
                                 Beginning{"glTF"sv, "a binary glTF file, whose name must end in .glb"}};

struct Suffix {
    std::string_view text;
    const char* kind;
};
constexpr std::array kSuffixes{Suffix{".obj", "an OBJ mesh"}, Suffix{".stl", "an STL mesh"},
                               Suffix{".ply", "a PLY mesh"}, Suffix{".serialized", "a Mitsuba mesh"}};

}  // namespace

std::string kind_of_other_file(const std::filesystem::path& file, const FileSource& files) {
    const auto in = files.open(file);
    if (!in) return {};
    std::array<char, 16> first{};
    in->read(first.data(), first.size());
    const std::string_view bytes(first.data(), static_cast<std::size_t>(in->gcount()));
    for (const Beginning& beginning : kBeginnings)
        if (bytes.starts_with(beginning.bytes)) return beginning.kind;
    const std::string suffix = suffix_of(file);
    for (const Suffix& known : kSuffixes)
        if (suffix == known.text) return known.kind;
    return {};
}

}  // namespace nicol::scene
