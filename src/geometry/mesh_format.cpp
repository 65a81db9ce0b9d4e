// SPDX-License-Identifier: MIT
#include "geometry/mesh_format.hpp"

#include <algorithm>

#include "files/suffix.hpp"

namespace nicol {
namespace {

template <class Predicate>
const MeshFormat* find_format(const Predicate& wanted) {
    const std::span formats = mesh_formats();
    const auto format = std::ranges::find_if(formats, [&](const MeshFormat* f) { return wanted(*f); });
    return format == formats.end() ? nullptr : *format;
}

}  // namespace

std::string mesh_format_names() {
    std::string names;
    for (const MeshFormat* const format : mesh_formats())
        names += (names.empty() ? "" : ", ") + std::string(format->name);
    return names;
}

const MeshFormat* mesh_format_named(std::string_view name) {
    return find_format([&](const MeshFormat& format) { return format.name == name; });
}

const MeshFormat* mesh_format_of(const std::filesystem::path& file) {
    const std::string suffix = suffix_of(file);
    return suffix.empty() ? nullptr : mesh_format_named(std::string_view(suffix).substr(1));
}

const MeshFormat* mesh_format_of_content(std::string_view bytes) {
    return find_format([&](const MeshFormat& format) { return format.begins(bytes); });
}

}  // namespace nicol
