// SPDX-License-Identifier: MIT
// Loads the XML and makes it safe to walk.
#include "scene/xml_document.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "scene/parameters.hpp"

namespace nicol::scene {
namespace {

constexpr std::uintmax_t max_file_size = std::uintmax_t{16} << 20;
/// A scene with everything nested has 5 levels.
constexpr int max_depth = 32;

std::string read_text(const std::filesystem::path& file) {
    std::error_code status;
    // A device or a pipe may never end.
    if (!std::filesystem::is_regular_file(file, status))
        throw Error(ErrorCode::file_not_found, file.string() + ": no such file");
    const auto size = std::filesystem::file_size(file, status);
    if (!status && size > max_file_size)
        throw Error(ErrorCode::unsupported,
                    file.string() + ": a scene file of more than 16 MiB; keep meshes in files of their own");
    std::ifstream in(file, std::ios::binary);
    if (!in || status) throw Error(ErrorCode::file_not_found, file.string() + ": cannot be read");
    std::string bytes(size, '\0');
    in.read(bytes.data(), static_cast<std::streamsize>(size));
    if (!in) throw Error(ErrorCode::file_not_found, file.string() + ": cannot be read to its end");
    return bytes;
}

}  // namespace

std::string in_quotes(std::string_view text) {
    std::string out = "\"";
    for (const char c : text.substr(0, 80)) {
        const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
        out += control ? '?' : c;
    }
    return out + (text.size() > 80 ? "...\"" : "\"");
}

/// One pass over all elements in the order of the file, which is the order in which parameters are defined
/// and used.
class XmlDocument::Walker : public pugi::xml_tree_walker {
public:
    Walker(XmlDocument& document, const SceneParameters& overrides)
        : parameters(overrides), document_(document) {}

    bool for_each(pugi::xml_node& node) override {
        if (depth() > max_depth)
            document_.fail(node, "elements nested more than " + std::to_string(max_depth) + " deep");
        if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata)
            document_.fail(node, "text " + in_quotes(node.value()) + " inside <" + node.parent().name() +
                                     ">; values go into attributes");
        if (node.type() != pugi::node_element) return true;
        for (pugi::xml_attribute attribute : node.attributes()) replace(node, attribute);
        if (std::string_view(node.name()) == "default") define(node);
        const std::string id = node.attribute("id").value();
        if (!id.empty() && std::string_view(node.name()) != "ref") {
            const auto [entry, is_new] = document_.ids_.try_emplace(id, node);
            if (!is_new)
                document_.fail(node, "id " + in_quotes(id) + " is taken by the element at " +
                                         document_.where(entry->second));
        }
        return true;
    }

    Parameters parameters;

private:
    void replace(pugi::xml_node node, pugi::xml_attribute attribute) {
        if (std::string_view(attribute.value()).find('$') == std::string_view::npos) return;
        try {
            attribute.set_value(parameters.replaced(attribute.value()).c_str());
        } catch (const std::invalid_argument& e) {
            document_.fail(node, e.what());
        }
    }

    void define(pugi::xml_node node) {
        const std::string name = node.attribute("name").value();
        if (name.empty() || !node.attribute("value"))
            document_.fail(node, "<default> needs a name and a value");
        parameters.add_default(name, node.attribute("value").value());
    }

    XmlDocument& document_;
};

XmlDocument::XmlDocument(const std::filesystem::path& file, const SceneParameters& parameters) : file_(file) {
    const std::string bytes = read_text(file);
    index_lines(bytes);
    const pugi::xml_parse_result result =
        document_.load_buffer(bytes.data(), bytes.size(), pugi::parse_default | pugi::parse_trim_pcdata);
    if (!result)
        throw Error(ErrorCode::invalid_file, place(result.offset, true) + ": " + result.description());
    check_scene();
    Walker walker(*this, parameters);
    document_.traverse(walker);
    walker.parameters.require_all_used(file.string());
}

void XmlDocument::check_scene() const {
    if (std::string_view(root().name()) != "scene")
        fail(root(), "the outermost element is <" + std::string(root().name()) +
                         ">; expected <scene version=\"3.0.0\">");
    const std::string_view version = root().attribute("version").value();
    if (version.empty()) fail(root(), "<scene> has no version; expected version=\"3.0.0\"");
    const std::string_view major = version.substr(0, version.find('.'));
    if (major != "2" && major != "3")
        fail(root(), "scene version " + in_quotes(version) + "; expected 2.x.x or 3.x.x of Mitsuba's format",
             ErrorCode::unsupported);
}

void XmlDocument::index_lines(std::string_view bytes) {
    line_starts_.push_back(0);
    for (std::size_t at = bytes.find('\n'); at != std::string_view::npos; at = bytes.find('\n', at + 1))
        line_starts_.push_back(static_cast<std::ptrdiff_t>(at + 1));
}

std::string XmlDocument::place(std::ptrdiff_t offset, bool with_column) const {
    const auto next = std::ranges::upper_bound(line_starts_, std::max<std::ptrdiff_t>(offset, 0));
    const std::ptrdiff_t line = next - line_starts_.begin();
    std::string text = file_.string() + ":" + std::to_string(line);
    if (with_column) text += ":" + std::to_string(std::max<std::ptrdiff_t>(offset, 0) - *(next - 1) + 1);
    return text;
}

pugi::xml_node XmlDocument::with_id(const std::string& id) const {
    const auto entry = ids_.find(id);
    return entry == ids_.end() ? pugi::xml_node() : entry->second;
}

std::filesystem::path XmlDocument::resolved(const std::string& filename) const {
    return (file_.parent_path() / filename).lexically_normal();
}

std::string XmlDocument::where(pugi::xml_node node) const {
    return place(node.offset_debug(), false);
}

void XmlDocument::fail(pugi::xml_node node, const std::string& message, ErrorCode code) const {
    throw Error(code, where(node) + ": " + message);
}

}  // namespace nicol::scene
