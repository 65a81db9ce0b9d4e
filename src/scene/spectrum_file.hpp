// SPDX-License-Identifier: MIT
// Tables over the wavelength in text files, as Mitsuba's .spd.
#pragma once

#include <string>
#include <string_view>

namespace nicol::scene {

/// The bytes of a file whose lines hold a wavelength in nm and a value, between blanks and # comments, as the
/// `value` of a <spectrum>. Throws Error(invalid_file) "name:line: message" unless it is two lines and more
/// by increasing wavelength.
[[nodiscard]] std::string spectrum_value(const std::string& name, std::string_view bytes);

}  // namespace nicol::scene
