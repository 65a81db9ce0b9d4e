// SPDX-License-Identifier: MIT
// NumPy .npz archives: arrays of numbers by name.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "files/load_budget.hpp"

namespace nicol {

/// Array of numbers in C order: the last index runs fastest. An empty shape is a single number.
struct NpyArray {
    std::vector<std::size_t> shape;
    std::vector<double> values;
};

/// Default limit of an array's size: 1 GiB of numbers.
inline constexpr std::size_t kMaxNpyValues = std::size_t{1} << 27;

/// Returns the names in the archive without their ".npy", in the archive's order. Throws what
/// read_npz_member() throws.
[[nodiscard]] std::vector<std::string> npz_members(const std::filesystem::path& path,
                                                   const LoadBudget& budget = {});

/// Reads the array called `name` (without ".npy"): little-endian float32, float64, int32 or int64 in C order,
/// stored or deflated. Memory use is proportional to the actual data, whatever a header claims. Throws
/// Error(file_not_found); Error(unsupported) for other types, Fortran order, object arrays, encrypted members
/// or archives above 4 GiB; Error(invalid_file) that names file and member if the member is missing,
/// truncated, corrupt (CRC-32), has more than 32 dimensions or more than `most_values` numbers, or if its
/// sizes contradict each other. Values may be NaN or infinite; integers must fit a double exactly. Takes the
/// memory of the values from `budget` before they are read.
[[nodiscard]] NpyArray read_npz_member(const std::filesystem::path& path, std::string_view name,
                                       std::size_t most_values = kMaxNpyValues,
                                       const LoadBudget& budget = {});

/// Reads the single text called `name` (NumPy type U or S, ASCII, at most 1024 characters). Throws what
/// read_npz_member() throws.
[[nodiscard]] std::string read_npz_text(const std::filesystem::path& path, std::string_view name,
                                        const LoadBudget& budget = {});

/// Member to write: numbers (as float64) or one ASCII text.
struct NpzMember {
    std::string name;  ///< without ".npy"
    std::variant<NpyArray, std::string> content;
};

/// Writes the members uncompressed. Equal content gives equal bytes. The file appears under its name only
/// when it is complete. Throws Error(invalid_argument) for a shape that does not fit its values, a text that
/// is empty or not ASCII, a name that is empty or used twice, and sizes of 4 GiB; Error(write_failed) that
/// names the path.
void write_npz(const std::filesystem::path& path, std::span<const NpzMember> members);

}  // namespace nicol
