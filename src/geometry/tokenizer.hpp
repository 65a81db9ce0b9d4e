// SPDX-License-Identifier: MIT
// Splitting the text of a mesh file into tokens, with line numbers for errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace nicol::geometry {

/// Throws Error(invalid_file) "name:line: message".
[[noreturn]] void fail_at(std::string_view name, std::size_t line, std::string_view message);

/// Without a byte order mark. Throws Error(unsupported) for UTF-16.
[[nodiscard]] std::string_view as_text(std::string_view name, std::string_view bytes);

/// Splits text at white space. Text from the comment character to the end of the line is skipped.
class Tokenizer {
public:
    /// `comment` 0: the format has no comments. `line` is the number of the text's first line.
    Tokenizer(std::string_view name, std::string_view text, char comment, std::size_t line = 1)
        : name_(name), text_(text), comment_(comment), line_(line) {}

    /// The next token, empty at the end of the text.
    std::string_view next();
    /// The next token; throws "the file ends where WHAT should be" at the end.
    std::string_view require(std::string_view what);
    /// The next token as a finite number in the range of float; throws, naming `what`, if it is not one.
    float number(std::string_view what);
    /// The same with other characters behind the number, which clear `whole`. Digits must not be among them:
    /// "0,5" is not 0.
    float number_at_start(std::string_view what, bool& whole);
    /// The next token as a number, 0 where it is no finite one, which clears `finite`. Throws for digits
    /// behind a number, as number_at_start().
    float number_or_zero(std::string_view what, bool& finite);
    /// The next token as an integer in [0, max]; throws, naming `what`, if it is not one.
    std::uint64_t count(std::string_view what, std::uint64_t max = UINT32_MAX);
    /// The tokens that are left on the line, which is passed over.
    [[nodiscard]] Tokenizer line();
    /// What is left of the line, which is passed over.
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
