// SPDX-License-Identifier: MIT
// Reading and writing of coefficients of light in .npz files.
#include "light/psh_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "error.hpp"
#include "files/npz.hpp"
#include "image/stokes_image.hpp"

namespace nicol {
namespace {

using std::filesystem::path;

[[noreturn]] void invalid(const path& file, const std::string& what) {
    throw Error(ErrorCode::invalid_file, file.string() + ": coeff " + what);
}

std::string shape_text(const std::vector<std::size_t>& shape) {
    std::string text;
    for (const std::size_t n : shape) text += (text.empty() ? "[" : ", ") + std::to_string(n);
    return text.empty() ? "[]" : text + "]";
}

}  // namespace

PshVector read_psh_vector(const path& file, const LoadBudget& budget) {
    const std::string basis = read_npz_text(file, "sh_type", budget);
    if (basis != "REAL")
        throw Error(ErrorCode::unsupported, file.string() + ": sh_type is " + basis + "; it must be REAL");
    const std::string codomain = read_npz_text(file, "cod_type", budget);
    if (codomain != "POLAR4" && codomain != "SCALAR")
        throw Error(ErrorCode::unsupported,
                    file.string() + ": cod_type is " + codomain + "; it must be POLAR4 or SCALAR");
    const bool polar = codomain == "POLAR4";

    constexpr std::size_t most_values = std::size_t{4} * kMaxFileChannels * psh_count(kMaxOrder);
    const NpyArray array = read_npz_member(file, "coeff", most_values, budget);
    std::vector<std::size_t> shape = array.shape;
    const std::size_t inner = polar ? 2 : 1;  // axes after the channel's axis
    if (shape.size() == inner) shape.insert(shape.begin(), 1);
    if (shape.size() != inner + 1 || (polar && shape[2] != 4))
        invalid(file, "has shape " + shape_text(array.shape) + "; it must be [channel, (order + 1)^2" +
                          (polar ? ", 4]" : "]"));
    if (shape[0] < 1 || shape[0] > kMaxFileChannels)
        invalid(file, "has " + std::to_string(shape[0]) + " channels; there may be 1 to " +
                          std::to_string(kMaxFileChannels));
    const auto levels = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(shape[1]))));
    if (levels < 1 || levels > kMaxOrder + 1 || levels * levels != shape[1])
        invalid(file, "has " + std::to_string(shape[1]) +
                          " coefficients a channel; that must be (order + 1)^2, order at most " +
                          std::to_string(kMaxOrder));

    budget.take_memory(std::uint64_t{4 * sizeof(double)} * shape[0] * shape[1]);
    budget.check();
    PshVector result(static_cast<int>(levels) - 1, static_cast<int>(shape[0]));
    const std::span<double> data = result.data();
    const std::size_t step = polar ? 1 : 4;
    for (std::size_t i = 0; i < array.values.size(); ++i) {
        const double value = array.values[i];
        const std::size_t at = i * step;
        const std::size_t p = at % 4;
        const std::size_t index = at / 4 % shape[1];
        if (!std::isfinite(value)) invalid(file, "value " + std::to_string(i) + " is not finite");
        if ((p == 1 || p == 2) && index < psh_index(2, -2) && value != 0)
            invalid(file, "has s1 or s2 below l = 2, at coefficient " + std::to_string(index));
        data[at] = value;
    }
    return result;
}

void write_psh_vector(const path& file, const PshVector& coefficients) {
    if (coefficients.channels() < 1 || coefficients.channels() > kMaxFileChannels)
        throw Error(ErrorCode::invalid_argument,
                    "write_psh_vector: " + std::to_string(coefficients.channels()) +
                        " channels; there must be 1 to " + std::to_string(kMaxFileChannels));
    NpyArray array{{static_cast<std::size_t>(coefficients.channels()), psh_count(coefficients.order()), 4},
                   {}};
    array.values.assign(coefficients.data().begin(), coefficients.data().end());
    const std::array<NpzMember, 3> members = {
        NpzMember{"cod_type", "POLAR4"}, {"sh_type", "REAL"}, {"coeff", std::move(array)}};
    write_npz(file, members);
}

}  // namespace nicol
