// SPDX-License-Identifier: MIT
// Loads one XML file.
#include "import/xml_file.hpp"

#include <algorithm>
#include <new>

#include "error.hpp"
#include "files/read_bytes.hpp"

namespace nicol::scene {

std::string read_text(const std::filesystem::path& file, std::size_t& bytes_left, const LoadBudget& budget) {
    const auto found = budget.files().find(file);
    if (found && found->bytes > bytes_left)
        throw Error(ErrorCode::unsupported,
                    file.string() +
                        ": a scene of more than 16 MiB, includes counted; keep meshes in files of their own");
    std::string bytes = read_bytes(file, budget);
    bytes_left -= std::min(bytes.size(), bytes_left);
    return bytes;
}

namespace {

std::string harmless(std::string_view text, std::size_t most) {
    std::string out;
    for (const char c : text.substr(0, most)) {
        const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
        out += control ? '?' : c;
    }
    return out + (text.size() > most ? "..." : "");
}

}  // namespace

std::string in_quotes(std::string_view text) {
    return "\"" + harmless(text, 80) + "\"";
}

std::string tag(pugi::xml_node node) {
    return "<" + harmless(node.name(), 40) + ">";
}

XmlFile::XmlFile(const std::filesystem::path& file, std::size_t& bytes_left, const LoadBudget& budget)
    : file_(file) {
    const std::string bytes = read_text(file, bytes_left, budget);
    record_ = record_of(file, bytes);
    line_starts_.push_back(0);
    for (std::size_t at = bytes.find('\n'); at != std::string::npos; at = bytes.find('\n', at + 1))
        line_starts_.push_back(static_cast<std::ptrdiff_t>(at + 1));
    const pugi::xml_parse_result result = document_.load_buffer(
        bytes.data(), bytes.size(), pugi::parse_default | pugi::parse_trim_pcdata | pugi::parse_doctype);
    if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
    if (!result) {
        const std::ptrdiff_t at = line(result.offset);
        const std::ptrdiff_t column = result.offset - line_starts_[static_cast<std::size_t>(at - 1)] + 1;
        throw Error(ErrorCode::invalid_file, file_.string() + ":" + std::to_string(at) + ":" +
                                                 std::to_string(column) + ": " + result.description());
    }
    check_entities();
}

std::ptrdiff_t XmlFile::line(std::ptrdiff_t offset) const {
    return std::ranges::upper_bound(line_starts_, std::max<std::ptrdiff_t>(offset, 0)) - line_starts_.begin();
}

/// The parser would leave their references in the text as they stand.
void XmlFile::check_entities() const {
    for (const pugi::xml_node node : document_.children()) {
        if (node.type() != pugi::node_doctype) continue;
        constexpr std::string_view keyword = "<!ENTITY", blanks = " \t\r\n%";
        std::string_view text = node.value();
        const std::size_t at = text.find(keyword);
        if (at == std::string_view::npos) continue;
        text.remove_prefix(at + keyword.size());
        text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
        throw Error(ErrorCode::unsupported, file_.string() + ":" + std::to_string(line(node)) +
                                                ": <!DOCTYPE> declares the entity " +
                                                in_quotes(text.substr(0, text.find_first_of(blanks))) +
                                                "; entities are not supported, use <default> and $name");
    }
}

}  // namespace nicol::scene
