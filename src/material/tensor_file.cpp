// SPDX-License-Identifier: MIT
#include "material/tensor_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

#include "error.hpp"

namespace nicol {
namespace {

static_assert(std::endian::native == std::endian::little, "files are little-endian");
constexpr std::string_view kSignature("tensor_file\0", 12);
constexpr std::uint32_t kMaxFields = 1000;
constexpr std::uint16_t kMaxNameBytes = 1000;
constexpr std::uint16_t kMaxDimensions = 16;
constexpr std::array<std::uint64_t, 12> kTypeBytes{0, 1, 1, 2, 2, 4, 4, 8, 8, 2, 4, 8};

std::uint64_t bytes_of(TensorFile::Type type) {
    return kTypeBytes[static_cast<std::size_t>(type)];
}

}  // namespace

TensorFile::TensorFile(std::filesystem::path path, const FileSource& files)
    : path_(std::move(path)), file_(files.open(path_)) {
    const auto found = files.find(path_);
    if (!found || !file_)
        throw Error(ErrorCode::file_not_found, path_.string() + ": cannot be opened for reading");
    const std::uint64_t size = found->bytes;

    std::array<char, 12> head{};
    file_->read(head.data(), head.size());
    if (!*file_ || std::string_view(head.data(), head.size()) != kSignature)
        invalid("is no .pbsdf file: it must begin with \"tensor_file\"");
    const auto major = next<std::uint8_t>();
    const auto minor = next<std::uint8_t>();
    if (major != 1 || minor != 0)
        throw Error(ErrorCode::unsupported, path_.string() + ": has version " + std::to_string(major) + "." +
                                                std::to_string(minor) + "; it must be 1.0");
    const auto count = next<std::uint32_t>();
    if (count > kMaxFields)
        invalid("claims " + std::to_string(count) + " fields; it must have at most " +
                std::to_string(kMaxFields));
    for (std::uint32_t i = 0; i < count; ++i) {
        Field field = next_field(size);
        for (const Field& before : fields_)
            if (before.name == field.name) invalid("has field " + field.name + " twice");
        fields_.push_back(std::move(field));
    }
}

void TensorFile::invalid(const std::string& what) const {
    throw Error(ErrorCode::invalid_file, path_.string() + ": " + what);
}

template <class T>
T TensorFile::next() {
    std::array<char, sizeof(T)> bytes{};
    file_->read(bytes.data(), bytes.size());
    if (!*file_) invalid("is truncated within its list of fields");
    return std::bit_cast<T>(bytes);
}

TensorFile::Field TensorFile::next_field(std::uint64_t file_size) {
    Field field;
    const auto length = next<std::uint16_t>();
    if (length > kMaxNameBytes) invalid("has a field whose name is longer than 1000 bytes");
    field.name.resize(length);
    file_->read(field.name.data(), length);
    if (!*file_) invalid("is truncated within its list of fields");
    // Messages contain the name, so it must be printable.
    if (!std::ranges::all_of(field.name, [](char c) { return c > 32 && c < 127; }))
        invalid("has a field whose name is not plain ASCII");
    const auto dimensions = next<std::uint16_t>();
    if (dimensions > kMaxDimensions)
        invalid("field " + field.name + " has " + std::to_string(dimensions) +
                " dimensions; it must have at most " + std::to_string(kMaxDimensions));
    const auto type = next<std::uint8_t>();
    if (type < 1 || type > 11) invalid("field " + field.name + " has unknown type " + std::to_string(type));
    field.type = static_cast<Type>(type);
    field.offset = next<std::uint64_t>();
    for (std::uint16_t d = 0; d < dimensions; ++d) field.shape.push_back(next<std::uint64_t>());
    if (field.offset > file_size)
        invalid("field " + field.name + " begins at byte " + std::to_string(field.offset) +
                ", beyond the end of the file");
    const std::uint64_t room = (file_size - field.offset) / bytes_of(field.type);
    field.count = std::ranges::count(field.shape, 0u) > 0 ? 0 : 1;
    if (field.count == 0) return field;
    for (const std::uint64_t n : field.shape) {
        if (n > room / field.count)
            invalid("field " + field.name + " does not fit into the file; it may be truncated");
        field.count *= n;
    }
    return field;
}

const TensorFile::Field& TensorFile::field(std::string_view name,
                                           std::initializer_list<std::size_t> dimensions,
                                           std::initializer_list<Type> types) const {
    const auto found = std::ranges::find(fields_, name, &Field::name);
    if (found == fields_.end()) invalid("has no field " + std::string(name));
    if (std::ranges::find(dimensions, found->shape.size()) == dimensions.end())
        invalid("field " + found->name + " has " + std::to_string(found->shape.size()) +
                " dimensions; it must have " + std::to_string(*(dimensions.end() - 1)));
    if (std::ranges::find(types, found->type) == types.end())
        invalid("field " + found->name + " has numbers of type " +
                std::to_string(static_cast<int>(found->type)) + ", which is not what it must hold");
    return *found;
}

void TensorFile::read(const Field& field, std::uint64_t first, std::span<unsigned char> bytes) {
    file_->clear();
    file_->seekg(static_cast<std::streamoff>(field.offset + first));
    file_->read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!*file_) invalid("field " + field.name + " cannot be read to its end");
}

std::vector<double> TensorFile::values(const Field& field, std::uint64_t most) {
    if (field.count > most)
        invalid("field " + field.name + " has " + std::to_string(field.count) +
                " values; it must have at most " + std::to_string(most));
    const std::size_t width = bytes_of(field.type);
    std::vector<unsigned char> bytes(field.count * width);
    read(field, 0, bytes);
    std::vector<double> out;
    for (std::size_t at = 0; at < bytes.size(); at += width) {
        std::uint16_t u = 0;
        float f = 0;
        double d = 0;
        if (field.type == Type::u16) {
            std::memcpy(&u, &bytes[at], sizeof u);
            d = u;
        } else if (field.type == Type::f32) {
            std::memcpy(&f, &bytes[at], sizeof f);
            d = static_cast<double>(f);
        } else {
            std::memcpy(&d, &bytes[at], sizeof d);
        }
        out.push_back(d);
    }
    return out;
}

}  // namespace nicol
