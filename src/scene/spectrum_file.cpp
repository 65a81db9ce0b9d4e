// SPDX-License-Identifier: MIT
#include "scene/spectrum_file.hpp"

#include <algorithm>
#include <vector>

#include "error.hpp"
#include "geometry/tokenizer.hpp"
#include "scene/values.hpp"

namespace nicol::scene {

std::string spectrum_value(const std::string& name, std::string_view bytes) {
    std::string_view rest = geometry::as_text(name, bytes);
    std::string out;
    double last = 0;
    std::size_t samples = 0;
    for (std::size_t line = 1; !rest.empty(); ++line) {
        const std::string_view whole = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(whole.size() + 1, rest.size()));
        geometry::Tokenizer tokens(name, whole, '#', line);
        const std::string_view wavelength = tokens.next();
        if (wavelength.empty()) continue;
        const std::string_view value = tokens.next();
        const std::optional<double> at = parsed_number(wavelength);
        if (!at || !parsed_number(value) || !tokens.next().empty())
            tokens.fail("expected a wavelength in nm and a value");
        if (!(*at > last)) tokens.fail("the wavelength is not above 0 and the one before");
        last = *at;
        ++samples;
        out.append(wavelength).append(":").append(value).append(" ");
    }
    if (samples < 2)
        throw Error(ErrorCode::invalid_file, name + ": " + std::to_string(samples) +
                                                 " wavelengths; expected two and more, with a value each");
    return out;
}

}  // namespace nicol::scene
