// SPDX-License-Identifier: MIT
#include "scene_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string_view>

#include "common/failure.hpp"
#include "digest.hpp"

namespace fs = std::filesystem;

namespace {

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Failure(path.string() + ": cannot be read");
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string substituted(std::string value, const std::map<std::string, std::string>& defaults) {
    for (const auto& [name, text] : defaults) {
        const std::string variable = "$" + name;
        for (std::size_t at = 0; (at = value.find(variable, at)) != std::string::npos; at += text.size())
            value.replace(at, variable.size(), text);
    }
    return value;
}

/// Parts of a cube map are one light, and naming one of them is naming all.
std::vector<fs::path> companions(const fs::path& path) {
    const std::string stem = path.stem();
    const bool part = path.extension() == ".exr" && stem.size() > 3 &&
                      stem.substr(stem.size() - 3, 2) == "_s" && stem.back() >= '0' && stem.back() <= '3';
    if (!part) return {path};
    std::vector<fs::path> all;
    for (const char digit : {'0', '1', '2', '3'})
        all.push_back(path.parent_path() / (stem.substr(0, stem.size() - 1) + digit + ".exr"));
    return all;
}

/// The next text in quotes at or after `at`, which moves behind it; false where there is none.
bool next_quoted(std::string_view text, std::size_t& at, std::string& value) {
    at = text.find_first_of("\"'", at);
    const std::size_t end = at < text.size() ? text.find(text[at], at + 1) : std::string_view::npos;
    if (end == std::string_view::npos) return false;
    value = text.substr(at + 1, end - at - 1);
    at = end + 1;
    return true;
}

/// <default name="..." value="..."/>, in either order of the two.
void find_defaults(std::string_view text, std::map<std::string, std::string>& defaults) {
    for (std::size_t at = 0; (at = text.find("<default", at)) != std::string_view::npos;) {
        std::string first, second;
        const bool reversed = text.find("value", at) < text.find("name", at);
        if (!next_quoted(text, at, first) || !next_quoted(text, at, second)) return;
        if (reversed) std::swap(first, second);
        defaults.emplace(first, second);
    }
}

class Listing {
public:
    explicit Listing(const fs::path& scene) : folder_(scene.parent_path()) { add(scene, true); }
    [[nodiscard]] std::string digest() const { return hex(sha256(text_)); }

private:
    void add(const fs::path& path, bool scene) {
        std::error_code error;
        if (!fs::is_regular_file(path, error) || !seen_.insert(fs::weakly_canonical(path, error)).second)
            return;
        const std::string content = read(path);
        text_ += hex(sha256(content));
        if (!scene) return;
        find_defaults(content, defaults_);
        std::string value;
        for (std::size_t at = 0; next_quoted(content, at, value);) {
            const fs::path named = substituted(value, defaults_);
            for (const fs::path& place : {path.parent_path() / named, folder_ / named})
                for (const fs::path& file : companions(place)) add(file, file.extension() == ".xml");
        }
    }

    fs::path folder_;
    std::string text_;
    std::map<std::string, std::string> defaults_;
    std::set<fs::path> seen_;
};

}  // namespace

std::vector<fs::path> find_scenes(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> scenes;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        if (it->path().extension() == ".xml") scenes.push_back(it->path());
    if (error) throw Failure("--scenes: " + folder.string() + ": " + error.message());
    if (scenes.empty()) throw Failure("--scenes: " + folder.string() + ": holds no scene, no file *.xml");
    for (const fs::path& scene : scenes) {
        const std::string id = scene.stem();
        const bool plain = std::ranges::all_of(id, [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                   c == '_' || c == '-';
        });
        if (!plain || id.size() > 64 || id.front() == '.')
            throw Failure("--scenes: " + scene.string() +
                          ": the name must be of letters, digits, '.', '_' and '-', at most 64");
    }
    std::ranges::sort(scenes);
    return scenes;
}

std::string scene_digest(const fs::path& path) {
    return Listing(path).digest();
}
