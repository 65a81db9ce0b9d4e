// SPDX-License-Identifier: MIT
// Embedded shader texts: look-up, definitions, and file names in compiler messages.
#include "gl/shader_source.hpp"

#include <algorithm>
#include <regex>

#include "error.hpp"

namespace nicol::gl {
namespace {

bool is_identifier(std::string_view name) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    return !name.empty() && letter(name.front()) &&
           std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || digit(c); });
}

/// Returns the file names of the lines "//@ n name" that begin the text, by n; the source's own name if there
/// are no such lines.
std::vector<std::string> file_table(const ShaderSource& source) {
    constexpr std::string_view mark = "//@ ";
    std::vector<std::string> files;
    std::string_view rest = source.text;
    while (rest.starts_with(mark)) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        const std::size_t name = line.find(' ', mark.size());
        files.emplace_back(line.substr(std::min(name, line.size() - 1) + 1));
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    }
    if (files.empty()) files.emplace_back(source.file);
    return files;
}

}  // namespace

ShaderSource embedded_shader(std::string_view file) {
    std::string known;
    for (const ShaderSource& shader : embedded_shaders()) {
        if (shader.file == file) return shader;
        known += (known.empty() ? "" : ", ") + std::string(shader.file);
    }
    throw Error(ErrorCode::invalid_argument,
                "there is no embedded shader \"" + std::string(file) + "\"; there are " + known);
}

std::string with_defines(const ShaderSource& source, std::span<const Define> defines) {
    const std::string name(source.file);
    // #version starts a line; only comments may precede it.
    std::size_t version = 0;
    while (!source.text.substr(version).starts_with("#version")) {
        version = source.text.find('\n', version);
        if (version == std::string_view::npos)
            throw Error(ErrorCode::invalid_argument, name + ": a shader needs a line #version 450 core");
        ++version;
    }
    const std::size_t end = std::min(source.text.find('\n', version), source.text.size());
    std::string text(source.text.substr(0, end));
    text += '\n';
    for (const Define& define : defines) {
        if (!is_identifier(define.name) || define.name.starts_with("GL_") ||
            define.name.find("__") != std::string::npos)
            throw Error(ErrorCode::invalid_argument,
                        name + ": \"" + define.name + "\" cannot be defined: not a free GLSL identifier");
        if (define.value.find_first_of(std::string_view("\n\r\\\0", 4)) != std::string::npos)
            throw Error(ErrorCode::invalid_argument,
                        name + ": the value of " + define.name + " has a line break, a backslash or a NUL");
        text += "#define " + define.name + ' ' + define.value + '\n';
    }
    // Embedded text has a #line here; other text needs one to continue its own line count.
    if (!defines.empty() && !source.text.substr(end).starts_with("\n#line ")) {
        const auto lines =
            std::count(source.text.begin(), source.text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
        text += "#line " + std::to_string(lines + 2) + " 0\n";
    }
    if (end < source.text.size()) text += source.text.substr(end + 1);
    return text;
}

std::string with_file_names(const ShaderSource& source, std::string_view log) {
    const std::vector<std::string> files = file_table(source);
    // Mesa and Intel write "0:12(5): error", NVIDIA "0(12) : error", AMD "ERROR: 0:12: ".
    static const std::regex message(R"(^((?:ERROR|WARNING):\s*)?(\d+)(?::(\d+)(?:\(\d+\))?|\((\d+)\))\s*:)");
    std::string text;
    std::size_t begin = 0;
    while (begin < log.size()) {
        const std::size_t end = std::min(log.find('\n', begin), log.size());
        const std::string line(log.substr(begin, end - begin));
        std::smatch match;
        // Numbers too long for a file index are left unchanged.
        const bool found = std::regex_search(line, match, message) && match.length(2) < 6;
        const std::size_t file = found ? std::stoul(match[2]) : files.size();
        if (file < files.size())
            text += match[1].str() + files[file] + ':' +
                    (match[3].matched ? match[3].str() : match[4].str()) + ':' + match.suffix().str();
        else
            text += line;
        text += '\n';
        begin = end + 1;
    }
    return text;
}

}  // namespace nicol::gl
