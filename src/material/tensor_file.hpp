// SPDX-License-Identifier: MIT
// The container of measured materials: named arrays of numbers in one file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nicol {

/// Mitsuba 3's TensorFile. Only the directory is read at first.
class TensorFile {
public:
    enum class Type : std::uint8_t { u8 = 1, i8, u16, i16, u32, i32, u64, i64, f16, f32, f64 };
    struct Field {
        std::string name;
        Type type = Type::f32;
        std::uint64_t offset = 0;  ///< of the first value in the file
        std::vector<std::uint64_t> shape;
        std::uint64_t count = 0;  ///< product of the shape
    };

    /// Throws Error(file_not_found), or Error(invalid_file) naming file and field if malformed; every field
    /// is checked to lie inside the file. Error(unsupported) for another version.
    explicit TensorFile(std::filesystem::path path);

    /// The field called `name`. Throws Error(invalid_file) if it is not there, has another number of
    /// dimensions, or a type not in `types`.
    [[nodiscard]] const Field& field(std::string_view name, std::initializer_list<std::size_t> dimensions,
                                     std::initializer_list<Type> types) const;

    /// All values of a field of u16, f32 or f64 and at most `most` values (Error(invalid_file) above).
    [[nodiscard]] std::vector<double> values(const Field& field, std::uint64_t most);

    /// Bytes of a field from `first` on; throws Error(invalid_file) if the file was truncated meanwhile.
    void read(const Field& field, std::uint64_t first, std::span<unsigned char> bytes);

    [[noreturn]] void invalid(const std::string& what) const;

private:
    template <class T>
    T next();
    Field next_field(std::uint64_t file_size);

    std::filesystem::path path_;
    std::ifstream file_;
    std::vector<Field> fields_;
};

}  // namespace nicol
