// SPDX-License-Identifier: MIT
// Scenes that clients send: their checks, and their form between the front process and its workers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// A file of an uploaded scene.
struct UploadedFile {
    std::string name;
    std::string bytes;
};

/// An uploaded scene. The first file is the scene; the others are those that it may name.
struct Upload {
    std::string id;  ///< "upload-" and digits of the digest of all files: equal scenes have equal ids
    std::vector<UploadedFile> files;
};

/// Returns whether a target is that of all scenes, which takes scenes, with or without a query.
bool is_path_of_scenes(std::string_view target);

/// Returns whether a request's first line asks to take a scene.
bool sends_scene(std::string_view request);

/// Throws Refusal (415) unless a body of this Content-Type can be a scene.
void require_upload_type(std::string_view content_type);

/// Returns the scene in a request's body: GLB, glTF, XML, or multipart/form-data whose parts are files by
/// their filename or name, the scene first. Throws Refusal: 415, and 400 for parts that are cut, too many or
/// without a name, and for names that are not relative, leave their folder, or come twice.
Upload parse_upload(std::string_view content_type, std::string_view body);

std::string pack(const Upload& upload);
/// Unpacks bytes of pack(). Returns false if they are not.
bool unpack(std::string_view bytes, Upload& upload);
