// SPDX-License-Identifier: MIT
// Tokenizer for the text of mesh files, with line numbers for errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace nicol::geometry {

/// Throws Error(invalid_file) with the message "name:line: message".
[[noreturn]] void fail_at(std::string_view name, std::size_t line, std::string_view message);

/// Returns the bytes without a byte order mark. Throws Error(unsupported) for UTF-16.
[[nodiscard]] std::string_view as_text(std::string_view name, std::string_view bytes);

/// Tokenizer that splits text at white space. It skips text from the comment character to the end of the
/// line.
class Tokenizer {
public:
    /// Takes `comment` 0 for a format without comments. `line` is the number of the text's first line.
    Tokenizer(std::string_view name, std::string_view text, char comment, std::size_t line = 1)
        : name_(name), text_(text), comment_(comment), line_(line) {}

    /// Returns the next token, empty at the end of the text.
    std::string_view next();
    /// Returns the next token; throws "the file ends where WHAT should be" at the end.
    std::string_view require(std::string_view what);
    /// Returns the next token as a finite number in the range of float; throws, naming `what`, if it is not
    /// one.
    float number(std::string_view what);
    /// Returns the number at the start of the next token, as number() does. Other characters behind the
    /// number clear `whole`; digits among them are an error, because "0,5" is not 0.
    float number_at_start(std::string_view what, bool& whole);
    /// Returns the next token as a number, or 0 if it is no finite number, which clears `finite`. Throws for
    /// digits behind a number, as number_at_start() does.
    float number_or_zero(std::string_view what, bool& finite);
    /// Returns the next token as an integer in [0, max]; throws, naming `what`, if it is not one.
    std::uint64_t count(std::string_view what, std::uint64_t max = UINT32_MAX);
    /// Returns the remaining tokens of the line and skips to the next line.
    [[nodiscard]] Tokenizer line();
    /// Returns the rest of the line and skips it.
    std::string_view rest_of_line();
    [[noreturn]] void fail(std::string_view message) const { fail_at(name_, line_, message); }

private:
    [[noreturn]] void fail_number(std::string_view what, std::string_view token) const;

    std::string_view name_;
    std::string_view text_;
    char comment_;
    std::size_t line_;
    std::size_t at_ = 0;
};

}  // namespace nicol::geometry
