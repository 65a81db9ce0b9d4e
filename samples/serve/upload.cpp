// SPDX-License-Identifier: MIT
#include "upload.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

#include "digest.hpp"
#include "field.hpp"
#include "message.hpp"
#include "problem.hpp"
#include "query.hpp"

namespace {

constexpr std::size_t kMostFiles = 1000, kMostNameBytes = 255, kMostHeaderBytes = 4096,
                      kMostBoundaryBytes = 70;
constexpr std::size_t kIdDigits = 16;
constexpr std::string_view kLineEnd = "\r\n";

/// Media types of a scene in one file, and the name that says its format; octet-stream: the content says it.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kTypes = {
    {{"model/gltf-binary", "scene.glb"},
     {"model/gltf+json", "scene.gltf"},
     {"application/json", "scene.gltf"},
     {"application/xml", "scene.xml"},
     {"text/xml", "scene.xml"},
     {"application/octet-stream", "scene"},
     {"multipart/form-data", ""}}};

[[noreturn]] void refuse(int status, const std::string& detail) {
    throw Refusal({.status = status, .detail = detail});
}

/// Returns the value before the first ';'.
std::string main_value(std::string_view field) {
    return lower_case(take_part(field, ';'));
}

/// Returns a parameter such as boundary=x or filename="a b" of a header field, unquoted.
std::optional<std::string> parameter_of(std::string_view field, std::string_view wanted) {
    for (std::size_t at = field.find(';'); at < field.size();) {
        const std::size_t equals = field.find('=', ++at);
        if (equals == std::string_view::npos) return {};
        const std::string name = lower_case(trimmed(field.substr(at, equals - at)));
        std::string value;
        at = equals + 1;
        if (at < field.size() && field[at] == '"') {
            for (++at; at < field.size() && field[at] != '"'; ++at) {
                if (field[at] == '\\' && at + 1 < field.size()) ++at;
                value += field[at];
            }
            if (at == field.size()) return {};
            at = std::min(field.find(';', at), field.size());
        } else {
            const std::size_t end = std::min(field.find(';', at), field.size());
            value = trimmed(field.substr(at, end - at));
            at = end;
        }
        if (name == wanted) return value;
    }
    return {};
}

/// Throws Refusal unless the name is relative and stays in its folder.
void check_name(std::string_view name) {
    bool good = !name.empty() && name.size() <= kMostNameBytes && name.front() != '/' && name.back() != '/' &&
                std::ranges::none_of(name, [](char c) {
                    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\';
                });
    for (std::string_view rest = name; good && !rest.empty();) {
        const std::string_view part = rest.substr(0, rest.find('/'));
        good = !part.empty() && part != "." && part != "..";
        rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    }
    if (!good)
        refuse(
            400,
            "A part's name is not that of a file: it must be relative, without '..', of at most 255 bytes.");
}

/// Returns the name of a part: filename, or else name, of its Content-Disposition.
std::string name_of_part(std::string_view header) {
    while (!header.empty()) {
        const std::string_view line = header.substr(0, header.find(kLineEnd));
        header.remove_prefix(std::min(line.size() + kLineEnd.size(), header.size()));
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos || lower_case(line.substr(0, colon)) != "content-disposition")
            continue;
        for (const char* const parameter : {"filename", "name"})
            if (auto name = parameter_of(line.substr(colon + 1), parameter)) return *name;
    }
    refuse(400, "A part has no Content-Disposition with a filename or a name.");
}

std::vector<UploadedFile> parts_of(std::string_view content_type, std::string_view body) {
    const std::optional<std::string> boundary = parameter_of(content_type, "boundary");
    if (!boundary || boundary->empty() || boundary->size() > kMostBoundaryBytes)
        refuse(400, "multipart/form-data has no boundary of 1 to 70 characters.");
    const std::string delimiter = "\r\n--" + *boundary;
    const auto cut = [] { refuse(400, "The multipart body is cut, or its boundary is another one."); };
    // The first delimiter may come without a line before it.
    if (body.starts_with(std::string_view(delimiter).substr(kLineEnd.size())))
        body.remove_prefix(delimiter.size() - kLineEnd.size());
    else if (const std::size_t at = body.find(delimiter); at != std::string_view::npos)
        body.remove_prefix(at + delimiter.size());
    else
        cut();
    std::vector<UploadedFile> files;
    std::set<std::string> names;
    while (!body.starts_with("--")) {
        const std::size_t line = body.find(kLineEnd);
        if (line == std::string_view::npos || !trimmed(body.substr(0, line)).empty()) cut();
        body.remove_prefix(line);
        constexpr std::string_view end_of_header = "\r\n\r\n";
        const std::size_t header = body.substr(0, kMostHeaderBytes).find(end_of_header);
        const std::size_t end = body.find(delimiter, header == std::string_view::npos ? 0 : header + 2);
        if (header == std::string_view::npos || end == std::string_view::npos) cut();
        if (files.size() == kMostFiles)
            refuse(400, "There are more than " + std::to_string(kMostFiles) + " parts.");
        UploadedFile& file = files.emplace_back();
        file.name = name_of_part(body.substr(0, header));
        check_name(file.name);
        if (!names.insert(file.name).second) refuse(400, "Two parts have one name.");
        const std::size_t first = std::min(header + end_of_header.size(), end);
        file.bytes = body.substr(first, end - first);
        body.remove_prefix(end + delimiter.size());
    }
    if (files.empty()) refuse(400, "There are no parts; the first must be the scene.");
    return files;
}

}  // namespace

bool is_path_of_scenes(std::string_view target) {
    const std::string_view path = target.substr(0, target.find('?'));
    return path == "/v1/scenes" || path == "/scenes";
}

bool sends_scene(std::string_view request) {
    constexpr std::string_view method = "POST ";
    if (!request.starts_with(method)) return false;
    request.remove_prefix(method.size());
    return is_path_of_scenes(origin_form(request.substr(0, request.find_first_of(" \r"))));
}

void require_upload_type(std::string_view content_type) {
    const std::string type = main_value(content_type);
    if (std::ranges::find(kTypes, type, [](const auto& known) { return known.first; }) != kTypes.end())
        return;
    std::string all;
    for (const auto& known : kTypes) all += (all.empty() ? "" : ", ") + std::string(known.first);
    refuse(415, "A scene's Content-Type is one of " + all + ".");
}

Upload parse_upload(std::string_view content_type, std::string_view body) {
    require_upload_type(content_type);
    const std::string type = main_value(content_type);
    const auto known = std::ranges::find(kTypes, type, [](const auto& one) { return one.first; });
    Upload upload;
    if (known->second.empty())
        upload.files = parts_of(content_type, body);
    else
        upload.files.push_back({.name = std::string(known->second), .bytes = std::string(body)});
    if (upload.files.front().bytes.empty()) refuse(400, "The scene is empty.");
    upload.id = "upload-" + hex(sha256(pack(upload))).substr(0, kIdDigits);
    return upload;
}

std::string pack(const Upload& upload) {
    std::string bytes;
    put_text(bytes, upload.id);
    for (const UploadedFile& file : upload.files) {
        put_text(bytes, file.name);
        put_text(bytes, file.bytes);
    }
    return bytes;
}

bool unpack(std::string_view bytes, Upload& upload) {
    upload = {};
    if (!take_text(bytes, upload.id)) return false;
    while (!bytes.empty()) {
        UploadedFile& file = upload.files.emplace_back();
        if (!take_text(bytes, file.name) || !take_text(bytes, file.bytes)) return false;
    }
    return !upload.files.empty();
}
