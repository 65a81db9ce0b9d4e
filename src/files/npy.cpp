// SPDX-License-Identifier: MIT
// Reading of NumPy headers, which are Python dictionaries in text. Only the three keys that NumPy writes are
// accepted.
#include "files/npy.hpp"

#include <array>
#include <cctype>
#include <limits>

#include "error.hpp"

namespace nicol {
namespace {

constexpr std::size_t kMaxHeaderBytes = 1 << 16;
constexpr std::size_t kMaxDimensions = 32;

class HeaderParser {
public:
    HeaderParser(const std::string& text, const std::string& member) : text_(text), member_(member) {}

    NpyHeader parse() {
        NpyHeader header;
        unsigned keys = 0;
        expect('{');
        while (!accept('}')) {
            const std::string key = quoted();
            expect(':');
            if (key == "descr") {
                if (peek() == '[')
                    throw Error(ErrorCode::unsupported,
                                member_ + " holds records; it must hold plain numbers");
                header.type = quoted();
                keys |= 1;
            } else if (key == "fortran_order") {
                header.fortran_order = boolean();
                keys |= 2;
            } else if (key == "shape") {
                header.shape = tuple();
                keys |= 4;
            } else {
                invalid();
            }
            if (!accept(',') && peek() != '}') invalid();
        }
        if (keys != 7 || peek() != '\0') invalid();
        return header;
    }

private:
    [[noreturn]] void invalid() const {
        throw Error(ErrorCode::invalid_file, member_ + " has a malformed NumPy header near character " +
                                                 std::to_string(at_) +
                                                 "; it must say descr, fortran_order and shape");
    }

    char peek() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool accept(char c) {
        if (peek() != c) return false;
        ++at_;
        return true;
    }
    void expect(char c) {
        if (!accept(c)) invalid();
    }

    std::string quoted() {
        const char quote = peek();
        if (quote != '\'' && quote != '"') invalid();
        const std::size_t end = text_.find(quote, at_ + 1);
        if (end == std::string::npos) invalid();
        std::string word = text_.substr(at_ + 1, end - at_ - 1);
        at_ = end + 1;
        return word;
    }

    bool boolean() {
        peek();
        for (const bool value : {false, true}) {
            const std::string word = value ? "True" : "False";
            if (text_.compare(at_, word.size(), word) != 0) continue;
            at_ += word.size();
            return value;
        }
        invalid();
    }

    std::vector<std::size_t> tuple() {
        std::vector<std::size_t> shape;
        expect('(');
        while (!accept(')')) {
            shape.push_back(number());
            if (shape.size() > kMaxDimensions) invalid();
            if (!accept(',') && peek() != ')') invalid();
        }
        return shape;
    }

    std::size_t number() {
        if (std::isdigit(static_cast<unsigned char>(peek())) == 0) invalid();
        std::size_t value = 0;
        for (; at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0; ++at_) {
            if (value > (std::numeric_limits<std::size_t>::max() - 9) / 10)
                throw Error(ErrorCode::invalid_file, member_ + " claims a dimension beyond 2^64");
            value = 10 * value + static_cast<std::size_t>(text_[at_] - '0');
        }
        return value;
    }

    const std::string& text_;
    const std::string& member_;
    std::size_t at_ = 0;
};

}  // namespace

std::size_t NpyHeader::count(const std::string& member, std::size_t most) const {
    std::size_t product = 1;
    bool empty = false;
    for (const std::size_t n : shape) empty = empty || n == 0;
    if (empty) return 0;
    for (const std::size_t n : shape) {
        if (n > most / product)
            throw Error(ErrorCode::invalid_file,
                        member + " claims more than " + std::to_string(most) + " values");
        product *= n;
    }
    return product;
}

NpyHeader read_npy_header(ZipStream& stream, const std::string& member) {
    std::array<unsigned char, 12> head{};
    stream.read(std::span(head).first(10));
    constexpr std::array<unsigned char, 6> magic = {0x93, 'N', 'U', 'M', 'P', 'Y'};
    if (!std::equal(magic.begin(), magic.end(), head.begin()))
        throw Error(ErrorCode::invalid_file, member + " is not a NumPy array");
    if (head[6] < 1 || head[6] > 3)
        throw Error(ErrorCode::unsupported,
                    member + " has NumPy format version " + std::to_string(head[6]) + "; it must be 1 to 3");
    std::size_t length = head[8] + 256u * head[9];
    if (head[6] > 1) {
        stream.read(std::span(head).subspan(10, 2));
        length += 65536u * (head[10] + 256u * head[11]);
    }
    if (length > kMaxHeaderBytes)
        throw Error(ErrorCode::invalid_file,
                    member + " has a header of more than " + std::to_string(kMaxHeaderBytes) + " bytes");
    std::string text(length, '\0');
    stream.read({reinterpret_cast<unsigned char*>(text.data()), text.size()});
    return HeaderParser(text, member).parse();
}

}  // namespace nicol
