// SPDX-License-Identifier: MIT
#include "import/gltf_json.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "files/file_error.hpp"

namespace nicol::scene {
namespace {

constexpr std::array<std::string_view, 5> kLists = {"accessors", "animations", "buffers", "nodes", "skins"};
constexpr std::array<std::string_view, 6> kMembers = {
    "byteLength", "channels", "extensions", "sparse", "inverseBindMatrices", "uri"};

/// Returns a member of an object; a discarded value if the value is no object or has no such member.
const Json& member(const Json& value, const char* name) {
    static const Json absent(Json::value_t::discarded);
    if (!value.is_object()) return absent;
    const auto found = value.find(name);
    return found == value.end() ? absent : *found;
}

/// Returns whether a value is a whole number in the range of int, which tinygltf has for numbers of elements.
bool is_int(const Json& value) {
    constexpr double most = std::numeric_limits<int>::max();
    return value.is_number_integer() && value.get<double>() >= -most && value.get<double>() <= most;
}

void check_sparse(const Json& accessor, const std::filesystem::path& file, const std::string& where) {
    for (const char* part : {"indices", "values"}) {
        const Json& offset = member(member(member(accessor, "sparse"), part), "byteOffset");
        if (offset.is_discarded()) continue;
        if (!is_int(offset) || offset.get<double>() < 0)
            invalid_file(
                file, where + ": sparse." + part + ": byteOffset is not a whole number from 0 to 2147483647");
    }
}

void check_channels(const Json& animation, const std::filesystem::path& file, const std::string& where) {
    const Json& channels = member(animation, "channels");
    if (!channels.is_array()) return;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const Json& node = member(member(channels[i], "target"), "node");
        if (!node.is_discarded() && !is_int(node))
            invalid_file(file, where + ".channels[" + std::to_string(i) + "]: node is not a whole number");
    }
}

void check_skin(const Json& skin, const std::filesystem::path& file, const std::string& where) {
    const Json& matrices = member(skin, "inverseBindMatrices");
    if (!matrices.is_discarded() && !is_int(matrices))
        invalid_file(file, where + ": inverseBindMatrices is not a whole number");
}

void check_light(const Json& node, const std::filesystem::path& file, const std::string& where) {
    const Json& light = member(member(node, "extensions"), "KHR_lights_punctual");
    if (light.is_object() && !is_int(member(light, "light")))
        invalid_file(file, where + ": KHR_lights_punctual has no light; expected its number");
}

}  // namespace

Json gltf_members(std::string_view text, const LoadBudget& budget) {
    const auto keep = [](const Json& key, const auto& names) {
        // Json == text would make a value of the text, in a function that may not throw.
        return std::ranges::find(names, std::string_view(key.get_ref<const std::string&>())) != names.end();
    };
    return Json::parse(
        text,
        [&](int depth, Json::parse_event_t event, const Json& key) {
            budget.step(64);
            if (event != Json::parse_event_t::key) return true;
            return depth == 1 ? keep(key, kLists) : depth != 3 || keep(key, kMembers);
        },
        false);
}

std::vector<std::uint64_t> lengths_of_buffers(const Json& members) {
    std::vector<std::uint64_t> lengths;
    for (const Json& buffer : member(members, "buffers")) {
        const Json& uri = member(buffer, "uri");
        if (!uri.is_string() || uri.get_ref<const std::string&>().starts_with("data:")) continue;
        const Json& length = member(buffer, "byteLength");
        lengths.push_back(length.is_number_unsigned() ? length.get<std::uint64_t>() : 0);
    }
    return lengths;
}

void check_gltf_members(const Json& members, const std::filesystem::path& file) {
    const auto check_each = [&](const char* list, const auto& check) {
        const Json& elements = member(members, list);
        if (!elements.is_array()) return;
        for (std::size_t i = 0; i < elements.size(); ++i)
            check(elements[i], file, std::string(list) + "[" + std::to_string(i) + "]");
    };
    check_each("accessors", check_sparse);
    check_each("animations", check_channels);
    check_each("skins", check_skin);
    check_each("nodes", check_light);
}

}  // namespace nicol::scene
