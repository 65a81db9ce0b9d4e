// SPDX-License-Identifier: MIT
#include "input_file.hpp"

#include "boundary.hpp"
#include "files/memory_files.hpp"
#include "import/file_kind.hpp"
#include "initialiser.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

std::string_view view_of(const void* bytes, std::uint64_t size, const char* owner) {
    if (size > 0) require(bytes, (std::string(owner) + "->bytes").c_str());
    return {static_cast<const char*>(bytes), size};
}

MemoryFiles::Resolve resolver(nicol_resolve_callback resolve, void* user) {
    if (resolve == nullptr) return {};
    return [resolve, user](const std::string& name) -> std::optional<std::string_view> {
        nicol_file_content content = NICOL_FILE_CONTENT_INIT;
        if (resolve(user, name.c_str(), &content) == 0) return std::nullopt;
        const auto given = read_struct(&content, nicol_file_content NICOL_FILE_CONTENT_INIT, "content");
        return view_of(given.bytes, given.byte_size, "content");
    };
}

}  // namespace

InputFile capi::input_file(const char* path, const LoadLimits& limits) {
    require(path, "path");
    return {path, limits};
}

InputFile capi::input_file(const nicol_memory_file* file, const LoadLimits& limits) {
    const auto given = read_struct(file, nicol_memory_file NICOL_MEMORY_FILE_INIT, "file");
    if (given.reserved != 0) refuse("file->reserved must be 0");
    const std::string_view bytes = view_of(given.bytes, given.byte_size, "file");
    std::filesystem::path name = given.name != nullptr ? given.name : "";
    if (!name.has_filename()) name /= "memory";
    if (!name.has_extension()) name += suffix_of_content(bytes);
    LoadLimits terms = limits;
    terms.files =
        std::make_shared<const MemoryFiles>(name, bytes, resolver(given.resolve, given.resolve_user));
    return {name, terms};
}

NICOL_INITIALISER(nicol_file_content, NICOL_FILE_CONTENT_INIT)
NICOL_INITIALISER(nicol_memory_file, NICOL_MEMORY_FILE_INIT)
