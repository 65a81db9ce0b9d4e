// SPDX-License-Identifier: MIT
#include "geometry/tokenizer.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "error.hpp"

namespace nicol::geometry {

std::string_view as_text(std::string_view name, std::string_view bytes) {
    if (bytes.starts_with("\xFE\xFF") || bytes.starts_with("\xFF\xFE"))
        throw Error(ErrorCode::unsupported, std::string(name) + ": UTF-16 text; save it as UTF-8");
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    return bytes;
}

void fail_at(std::string_view name, std::size_t line, std::string_view message) {
    throw Error(ErrorCode::invalid_file,
                std::string(name) + ":" + std::to_string(line) + ": " + std::string(message));
}

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

/// Returns a token in quotes, shortened and printable, because a token may be megabytes long or binary.
std::string in_quotes(std::string_view token) {
    std::string text = "\"";
    for (const char c : token.substr(0, 40)) text += c >= ' ' && c <= '~' ? c : '?';
    return text + (token.size() > 40 ? "...\"" : "\"");
}

struct Number {
    float value = 0;
    bool finite = false;  ///< the value is finite and in the range of float
    bool whole = false;   ///< nothing follows in the token
    bool broken = false;  ///< digits follow in the token: "0,5" is not 0
};

Number leading_number(std::string_view token) {
    const char* const end = token.data() + token.size();
    double value = 0.0;
    const auto [stop, error] = std::from_chars(token.data() + (token.front() == '+' ? 1 : 0), end, value);
    if (error != std::errc() || !(std::abs(value) <= std::numeric_limits<float>::max())) return {};
    std::string_view rest(stop, static_cast<std::size_t>(end - stop));
    rest = rest.substr(0, rest.find('#'));
    return {.value = static_cast<float>(value),
            .finite = true,
            .whole = stop == end,
            .broken = rest.find_first_of("0123456789") != std::string_view::npos};
}

}  // namespace

std::string_view Tokenizer::next() {
    while (at_ < text_.size()) {
        const char c = text_[at_];
        if (comment_ != 0 && c == comment_) {
            at_ = std::min(text_.find('\n', at_), text_.size());
            continue;
        }
        if (!is_blank(c)) break;
        if (c == '\n') ++line_;
        ++at_;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
}

std::string_view Tokenizer::require(std::string_view what) {
    const std::string_view token = next();
    if (token.empty()) fail("the file ends where " + std::string(what) + " should be");
    return token;
}

void Tokenizer::fail_number(std::string_view what, std::string_view token) const {
    fail(std::string(what) + " is " + in_quotes(token) +
         ", not a finite number a float can hold, with a point before its decimals");
}

float Tokenizer::number_at_start(std::string_view what, bool& whole) {
    const std::string_view token = require(what);
    const Number number = leading_number(token);
    if (!number.finite || number.broken) fail_number(what, token);
    if (!number.whole) whole = false;
    return number.value;
}

float Tokenizer::number(std::string_view what) {
    const std::string_view token = require(what);
    const Number number = leading_number(token);
    if (!number.finite || !number.whole) fail_number(what, token);
    return number.value;
}

float Tokenizer::number_or_zero(std::string_view what, bool& finite) {
    const std::string_view token = require(what);
    const Number number = leading_number(token);
    if (number.broken) fail_number(what, token);
    if (!number.finite) finite = false;
    return number.value;
}

std::uint64_t Tokenizer::count(std::string_view what, std::uint64_t max) {
    const std::string_view token = require(what);
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (error != std::errc() || end != token.data() + token.size() || value > max)
        fail(std::string(what) + " is " + in_quotes(token) + ", not a whole number from 0 to " +
             std::to_string(max));
    return value;
}

Tokenizer Tokenizer::line() {
    const std::size_t number = line_;
    return {name_, rest_of_line(), comment_, number};
}

std::string_view Tokenizer::rest_of_line() {
    const std::size_t begin = at_;
    at_ = std::min(text_.find('\n', at_), text_.size());
    return text_.substr(begin, at_ - begin);
}

}  // namespace nicol::geometry
