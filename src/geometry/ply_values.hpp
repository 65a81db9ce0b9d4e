// SPDX-License-Identifier: MIT
// Sequential reader of the values of a PLY file.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "error.hpp"
#include "files/load_budget.hpp"
#include "geometry/ply_header.hpp"
#include "geometry/tokenizer.hpp"

namespace nicol::geometry::ply {

/// Reader of the values after the header, in order, text or binary.
class Values {
public:
    Values(std::string_view name, std::string_view bytes, const Header& header, const LoadBudget& budget)
        : name_(name),
          bytes_(bytes.substr(header.size)),
          format_(header.format),
          tokens_(name, bytes_, 0, header.lines + 1),
          budget_(budget) {}

    /// Returns the next value. `what()` names the value in error messages, for example "vertex 5 (0-based)".
    template <class Name>
    double next(Type type, const Name& what) {
        budget_.step(8);
        if (format_ == Format::text) return tokens_.number(what());
        return binary(type, what);
    }

    /// Returns the next value, which is not finite if the text is no finite number.
    template <class Name>
    double any(Type type, const Name& what) {
        budget_.step(8);
        if (format_ != Format::text) return binary(type, what);
        bool finite = true;
        const float value = tokens_.number_or_zero(what(), finite);
        return finite ? value : std::numeric_limits<double>::quiet_NaN();
    }

    /// Returns the next value as a count or an index: an integer from 0 to 2^32 - 1.
    template <class Name>
    std::uint64_t integer(Type type, const Name& what) {
        budget_.step(8);
        if (format_ == Format::text) return tokens_.count(what());
        const double value = next(type, what);
        if (!(value >= 0.0 && value == std::floor(value) && value <= 4294967295.0))
            fail(what() + " has a count or an index that is not a whole number from 0 up");
        return static_cast<std::uint64_t>(value);
    }

    [[noreturn]] void fail(const std::string& message) const {
        if (format_ == Format::text) tokens_.fail(message);
        throw Error(ErrorCode::invalid_file, std::string(name_) + ": " + message);
    }

private:
    template <class Name>
    double binary(Type type, const Name& what) {
        switch (type) {
            case Type::i8:
                return raw<std::int8_t>(what);
            case Type::u8:
                return raw<std::uint8_t>(what);
            case Type::i16:
                return raw<std::int16_t>(what);
            case Type::u16:
                return raw<std::uint16_t>(what);
            case Type::i32:
                return raw<std::int32_t>(what);
            case Type::u32:
                return raw<std::uint32_t>(what);
            case Type::f32:
                return raw<float>(what);
            case Type::f64:
                return raw<double>(what);
        }
        return 0.0;
    }

    template <class T, class Name>
    double raw(const Name& what) {
        if (bytes_.size() - at_ < sizeof(T)) fail("the file ends within " + what());
        std::array<char, sizeof(T)> bytes{};
        std::copy_n(bytes_.data() + at_, sizeof(T), bytes.data());
        at_ += sizeof(T);
        if ((format_ == Format::big) != (std::endian::native == std::endian::big))
            std::ranges::reverse(bytes);
        return static_cast<double>(std::bit_cast<T>(bytes));
    }

    std::string_view name_;
    std::string_view bytes_;
    Format format_;
    Tokenizer tokens_;
    const LoadBudget& budget_;
    std::size_t at_ = 0;
};

/// Skips a property of one row.
template <class Name>
void skip(Values& values, const Property& property, const Name& what) {
    const std::uint64_t count = property.length ? values.integer(*property.length, what) : 1;
    for (std::uint64_t i = 0; i < count; ++i) values.any(property.type, what);
}

}  // namespace nicol::geometry::ply
