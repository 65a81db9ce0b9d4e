// SPDX-License-Identifier: MIT
// Container of measured materials: named arrays of numbers in one file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/file_source.hpp"

namespace nicol {

/// Reader of Mitsuba 3's TensorFile. The constructor reads only the list of fields.
class TensorFile {
public:
    enum class Type : std::uint8_t { u8 = 1, i8, u16, i16, u32, i32, u64, i64, f16, f32, f64 };
    struct Field {
        std::string name;
        Type type = Type::f32;
        std::uint64_t offset = 0;  ///< position of the first value in the file, bytes
        std::vector<std::uint64_t> shape;
        std::uint64_t count = 0;  ///< product of the shape
    };

    /// Opens a file. Throws Error(file_not_found), Error(invalid_file) that names file and field if malformed
    /// or if a field does not lie inside the file, and Error(unsupported) for another version.
    explicit TensorFile(std::filesystem::path path, const FileSource& files = file_system());

    /// Returns the field called `name`. Throws Error(invalid_file) if there is no such field, or if its
    /// number of dimensions is not in `dimensions` or its type not in `types`.
    [[nodiscard]] const Field& field(std::string_view name, std::initializer_list<std::size_t> dimensions,
                                     std::initializer_list<Type> types) const;

    /// Returns the values of a field of u16, f32 or f64. Throws Error(invalid_file) above `most` values.
    [[nodiscard]] std::vector<double> values(const Field& field, std::uint64_t most);

    /// Reads bytes of a field from `first` on. Throws Error(invalid_file) if the file has become too short.
    void read(const Field& field, std::uint64_t first, std::span<unsigned char> bytes);

    [[noreturn]] void invalid(const std::string& what) const;

private:
    template <class T>
    T next();
    Field next_field(std::uint64_t file_size);

    std::filesystem::path path_;
    std::unique_ptr<std::istream> file_;
    std::vector<Field> fields_;
};

}  // namespace nicol
