// SPDX-License-Identifier: MIT
// Loads the files of a scene and makes them safe to walk.
#include "import/xml_document.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "error.hpp"
#include "geometry/tokenizer.hpp"
#include "import/values.hpp"

namespace nicol::scene {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{16} << 20;
/// A scene with all elements nested has 6 levels.
constexpr int kMaxDepth = 32;
/// Mitsuba's limit.
constexpr std::size_t kMaxIncludeDepth = 15;
constexpr std::size_t kMaxFiles = 1000;
constexpr std::size_t kMaxFolders = 100;

bool is(pugi::xml_node node, std::string_view name) {
    return node.name() == name;
}

bool is_declaration(pugi::xml_node node) {
    return is(node, "default") || is(node, "path") || is(node, "alias") || is(node, "include");
}

/// The bytes of a file whose lines hold a wavelength in nm and a value, between blanks and # comments, as the
/// `value` of a <spectrum>. Throws Error(invalid_file) "name:line: message" unless it is two lines and more
/// by increasing wavelength.
std::string spectrum_value(const std::string& name, std::string_view bytes) {
    std::string_view rest = geometry::as_text(name, bytes);
    std::string out;
    double last = 0;
    std::size_t samples = 0;
    for (std::size_t line = 1; !rest.empty(); ++line) {
        const std::string_view whole = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(whole.size() + 1, rest.size()));
        geometry::Tokenizer tokens(name, whole, '#', line);
        const std::string_view wavelength = tokens.next();
        if (wavelength.empty()) continue;
        const std::string_view value = tokens.next();
        const std::optional<double> at = parsed_number(wavelength);
        if (!at || !parsed_number(value) || !tokens.next().empty())
            tokens.fail("expected a wavelength in nm and a value");
        if (!(*at > last)) tokens.fail("the wavelength is not above 0 and the one before");
        last = *at;
        ++samples;
        out.append(wavelength).append(":").append(value).append(" ");
    }
    if (samples < 2)
        throw Error(ErrorCode::invalid_file, name + ": " + std::to_string(samples) +
                                                 " wavelengths; expected two and more, with a value each");
    return out;
}

}  // namespace

struct XmlDocument::Source {
    Source(const std::filesystem::path& file, std::size_t& bytes_left, const LoadBudget& budget,
           pugi::xml_node included_by)
        : xml(file, bytes_left, budget), include(included_by), folders{file.parent_path()} {}

    XmlFile xml;
    pugi::xml_node include;  ///< null for the outermost file
    std::size_t depth = 0;
    std::vector<std::filesystem::path> folders;  ///< the first wins
};

/// One pass over all elements in the order of the file, which is the order in which parameters are defined
/// and used.
class XmlDocument::Walker : public pugi::xml_tree_walker {
public:
    explicit Walker(XmlDocument& document) : document_(document) {}

    bool for_each(pugi::xml_node& node) override {
        if (depth() > kMaxDepth)
            document_.fail(node, "elements nested more than " + std::to_string(kMaxDepth) + " deep");
        if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata)
            document_.fail(node, "text " + in_quotes(node.value()) + " inside " + tag(node.parent()) +
                                     "; values go into attributes");
        if (node.type() != pugi::node_element) return true;
        document_.budget_.step(64);
        for (pugi::xml_attribute attribute : node.attributes()) replace(node, attribute);
        if (is(node, "spectrum") && node.attribute("filename")) document_.read_spectrum(node);
        if (is_declaration(node)) {
            declare(node);
        } else if (!is(node, "ref") && (depth() > 0 || !is(node, "scene"))) {
            const std::string id = node.attribute("id").value();
            if (!id.empty()) document_.add_id(id, node, node);
        }
        return true;
    }

private:
    void replace(pugi::xml_node node, pugi::xml_attribute attribute) {
        if (std::string_view(attribute.value()).find('$') == std::string_view::npos) return;
        try {
            document_.replace_parameters(node, attribute);
        } catch (const std::out_of_range& e) {
            if (!inside_sampler(node)) document_.fail(node, e.what());
            document_.left_open_.push_back(node);
        } catch (const std::invalid_argument& e) {
            document_.fail(node, e.what());
        }
    }

    // A sampler may leave parameters open: what a picture shows does not depend on them.
    static bool inside_sampler(pugi::xml_node node) {
        while (node && !is(node, "sampler")) node = node.parent();
        return static_cast<bool>(node);
    }

    void declare(pugi::xml_node node) {
        if (node.first_child().type() == pugi::node_element)
            document_.fail(node, tag(node) + " has elements inside; expected none");
        if (is(node, "include")) return document_.include(node);
        if (is(node, "path")) return document_.add_folder(node);
        if (is(node, "alias")) return document_.add_alias(node);
        check_attributes(document_, node, {"name", "value"});
        const std::string name = node.attribute("name").value();
        if (name.empty() || !node.attribute("value"))
            document_.fail(node, "<default> needs a name and a value");
        try {
            document_.parameters_.add_default(name, node.attribute("value").value());
        } catch (const std::invalid_argument& e) {
            document_.fail(node, "<default>: " + std::string(e.what()));
        }
    }

    XmlDocument& document_;
};

XmlDocument::XmlDocument(const std::filesystem::path& file, const SceneParameters& parameters,
                         LoadBudget budget)
    : parameters_(parameters), budget_(std::move(budget)), bytes_left_(kMaxBytes), replaced_left_(kMaxBytes) {
    load(file, {});
    parameters_.require_all_used(file.string());
}

XmlDocument::~XmlDocument() = default;

std::vector<FileRecord> XmlDocument::files() const {
    std::vector<FileRecord> all;
    all.reserve(sources_.size());
    for (const auto& source : sources_) all.push_back(source->xml.record());
    all.insert(all.end(), spectra_.begin(), spectra_.end());
    return all;
}

void XmlDocument::load(const std::filesystem::path& file, pugi::xml_node include) {
    try {
        sources_.push_back(std::make_unique<Source>(file, bytes_left_, budget_, include));
    } catch (const Error& e) {
        throw Error(e.code(), e.what() + chain(include));
    }
    Source& source = *sources_.back();
    budget_.check_time(file);
    const pugi::xml_node outermost = source.xml.root();
    source_of_root_[outermost.root()] = &source;
    if (include) {
        const Source& parent = source_of(include);
        source.depth = parent.depth + 1;
        source.folders.insert(source.folders.end(), parent.folders.begin(), parent.folders.end());
        source_of_include_[include] = &source;
    } else if (!is(outermost, "scene")) {
        fail(outermost,
             "the outermost element is " + tag(outermost) + "; expected <scene version=\"3.0.0\">");
    }
    check_version(outermost);
    if (is(outermost, "scene")) check_attributes(*this, outermost, {"version", "type", "id", "name"});
    Walker walker(*this);
    outermost.parent().traverse(walker);
}

void XmlDocument::check_version(pugi::xml_node outermost) const {
    const std::string_view version = outermost.attribute("version").value();
    if (version.empty()) fail(outermost, tag(outermost) + " has no version; expected version=\"3.0.0\"");
    const std::string_view major = version.substr(0, version.find('.'));
    if (major != "2" && major != "3")
        fail(outermost,
             "scene version " + in_quotes(version) + "; expected 2.x.x or 3.x.x of Mitsuba's format",
             ErrorCode::unsupported);
}

void XmlDocument::include(pugi::xml_node node) {
    check_attributes(*this, node, {"filename", "name"});
    const std::string name = node.attribute("filename").value();
    if (name.empty()) fail(node, "<include> needs a filename");
    const std::filesystem::path file = resolved(node, name);
    const auto found = budget_.files().find(file);
    if (!found)
        fail(node, "<include> of " + in_quotes(file.string()) + ": no such file", ErrorCode::file_not_found);
    const Source* including = &source_of(node);
    if (including->depth == kMaxIncludeDepth)
        fail(node, "includes more than " + std::to_string(kMaxIncludeDepth) + " deep");
    if (sources_.size() == kMaxFiles)
        fail(node, "more than " + std::to_string(kMaxFiles) + " included files", ErrorCode::unsupported);
    for (const Source* open = including; open; open = open->include ? &source_of(open->include) : nullptr)
        if (const auto other = budget_.files().find(open->xml.path());
            other && other->identity == found->identity)
            fail(node, "<include> of " + in_quotes(name) + " goes in a circle");
    load(file, node);
}

void XmlDocument::add_folder(pugi::xml_node node) {
    check_attributes(*this, node, {"value"});
    if (!is(node.parent(), "scene"))
        fail(node, "<path> in " + tag(node.parent()) + "; it belongs in <scene>");
    const std::string name = node.attribute("value").value();
    const FileSource& files = budget_.files();
    const std::filesystem::path folder =
        resolved(node, name, [&](const std::filesystem::path& there) { return files.has_folder(there); });
    if (name.empty() || !files.has_folder(folder))
        fail(node, "<path>: " + in_quotes(name) + " is no folder", ErrorCode::file_not_found);
    std::vector<std::filesystem::path>& folders = source_of(node).folders;
    if (folders.size() > kMaxFolders)
        fail(node, "more than " + std::to_string(kMaxFolders) + " folders to look into",
             ErrorCode::unsupported);
    folders.insert(folders.begin(), folder);
}

void XmlDocument::read_spectrum(pugi::xml_node node) {
    check_attributes(*this, node, {"name", "id", "filename"});
    const std::string name = node.attribute("filename").value();
    const std::filesystem::path file = resolved(node, name);
    if (!budget_.files().find(file))
        fail(node, "<spectrum> of " + in_quotes(file.string()) + ": no such file", ErrorCode::file_not_found);
    if (spectra_.size() == kMaxFiles)
        fail(node, "more than " + std::to_string(kMaxFiles) + " spectra in files", ErrorCode::unsupported);
    const std::string bytes = read_text(file, bytes_left_, budget_);
    node.append_attribute("value") = spectrum_value(file.string(), bytes).c_str();
    node.remove_attribute("filename");
    if (std::ranges::find(spectra_, file, &FileRecord::path) == spectra_.end())
        spectra_.push_back(record_of(file, bytes));
}

void XmlDocument::replace_parameters(pugi::xml_node node, pugi::xml_attribute attribute) {
    budget_.step(std::string_view(attribute.value()).size() * 16);
    const std::string text = parameters_.replaced(attribute.value());
    if (text.size() > replaced_left_)
        fail(node, "more than 16 MiB of attributes once their parameters are replaced",
             ErrorCode::unsupported);
    replaced_left_ -= text.size();
    attribute.set_value(text.c_str());
}

void XmlDocument::add_alias(pugi::xml_node node) {
    check_attributes(*this, node, {"id", "as"});
    const std::string id = node.attribute("id").value(), as = node.attribute("as").value();
    if (as.empty()) fail(node, "<alias> needs an id and the name it goes by, as");
    const pugi::xml_node target = with_id(id);
    if (!target) fail(node, "<alias> of " + in_quotes(id) + ", an id that no element above has");
    add_id(as, node, target);
}

void XmlDocument::add_id(const std::string& id, pugi::xml_node node, pugi::xml_node target) {
    const auto [entry, is_new] = ids_.try_emplace(id, target);
    if (!is_new) fail(node, "id " + in_quotes(id) + " is taken by the element at " + where(entry->second));
}

XmlDocument::Source& XmlDocument::source_of(pugi::xml_node node) const {
    return *source_of_root_.at(node.root());
}

pugi::xml_node XmlDocument::root() const {
    return sources_.front()->xml.root();
}

std::vector<pugi::xml_node> XmlDocument::elements(pugi::xml_node node) const {
    std::vector<pugi::xml_node> found;
    append_elements(node, found);
    return found;
}

void XmlDocument::append_elements(pugi::xml_node node, std::vector<pugi::xml_node>& found) const {
    for (const pugi::xml_node child : node.children()) {
        if (child.type() != pugi::node_element) continue;
        if (!is_declaration(child)) {
            found.push_back(child);
        } else if (is(child, "include")) {
            const pugi::xml_node included = source_of_include_.at(child)->xml.root();
            if (is(included, "scene"))
                append_elements(included, found);
            else
                found.push_back(included);
        }
    }
}

pugi::xml_node XmlDocument::with_id(const std::string& id) const {
    const auto entry = ids_.find(id);
    return entry == ids_.end() ? pugi::xml_node() : entry->second;
}

std::filesystem::path XmlDocument::resolved(pugi::xml_node node, const std::string& filename) const {
    return resolved(node, filename, [this](const std::filesystem::path& there) {
        return budget_.files().find(there).has_value();
    });
}

template <class IsThere>
std::filesystem::path XmlDocument::resolved(pugi::xml_node node, const std::string& filename,
                                            IsThere is_there) const {
    const Source& source = source_of(node);
    for (const std::filesystem::path& folder : source.folders)
        if (is_there(folder / filename)) return (folder / filename).lexically_normal();
    return (source.xml.path().parent_path() / filename).lexically_normal();
}

std::string XmlDocument::where(pugi::xml_node node) const {
    const XmlFile& xml = source_of(node).xml;
    return xml.path().string() + ":" + std::to_string(xml.line(node));
}

std::string XmlDocument::chain(pugi::xml_node include) const {
    std::string text;
    while (include) {
        const Source& source = source_of(include);
        text += (text.empty() ? " (included by " : ", by ") + source.xml.path().filename().string() + ":" +
                std::to_string(source.xml.line(include));
        include = source.include;
    }
    return text.empty() ? text : text + ")";
}

void XmlDocument::fail(pugi::xml_node node, const std::string& message, ErrorCode code) const {
    throw Error(code, where(node) + ": " + message + chain(source_of(node).include));
}

}  // namespace nicol::scene
