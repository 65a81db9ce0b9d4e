// SPDX-License-Identifier: MIT
// Polarization elements of the C interface.
#pragma once

#include "nicol.h"
#include "polarization/element.hpp"

namespace nicol::capi {

/// Returns the element. Throws Error(invalid_argument) for NULL, a kind or an outline that does not exist;
/// other members are checked where the element is used.
PolarizationElement element_from(const nicol_polarization_element* element);

}  // namespace nicol::capi
