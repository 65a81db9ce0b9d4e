// SPDX-License-Identifier: MIT
// A mesh file in memory and the words in it, with the line each stands on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace nicol::geometry {

/// A whole file. Throws Error(file_not_found) unless `file` is a regular file that can be read.
[[nodiscard]] std::string read_bytes(const std::filesystem::path& file);

/// Throws Error(invalid_file) "name:line: message".
[[noreturn]] void fail_at(std::string_view name, std::size_t line, std::string_view message);

/// Cuts text at blanks and line ends. A word from a comment character to the end of its line is skipped.
class Words {
public:
    /// `comment` = 0: the text has no comments. `line` is the number of the text's first line.
    Words(std::string_view name, std::string_view text, char comment, std::size_t line = 1)
        : name_(name), text_(text), comment_(comment), line_(line) {}

    /// The next word, empty at the end of the text.
    std::string_view next();
    /// The next word; throws "the file ends where WHAT should be" at the end.
    std::string_view require(std::string_view what);
    /// The next word as a number a float can hold; throws, naming `what`, when it is none.
    float number(std::string_view what);
    /// The next word as a whole number in [0, max]; throws, naming `what`, when it is none.
    std::uint64_t count(std::string_view what, std::uint64_t max = UINT32_MAX);
    void skip_line();
    [[noreturn]] void fail(std::string_view message) const { fail_at(name_, line_, message); }

private:
    std::string_view name_;
    std::string_view text_;
    char comment_;
    std::size_t line_;
    std::size_t at_ = 0;
};

}  // namespace nicol::geometry
