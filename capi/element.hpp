// SPDX-License-Identifier: MIT
// Polarization elements of the C interface.
#pragma once

#include "nicol.h"
#include "polarization/element.hpp"

namespace nicol::capi {

/// Reads an element. Throws Error(invalid_argument) for NULL, a kind or an outline that does not exist; other
/// members are checked where the element is used.
nicol_polarization_element read_element(const nicol_polarization_element* element);

/// Returns an element that read_element() has read, without its textures.
PolarizationElement element_from(const nicol_polarization_element& given);

}  // namespace nicol::capi
