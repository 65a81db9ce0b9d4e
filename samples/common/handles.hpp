// SPDX-License-Identifier: MIT
// The handles of nicol.hpp under their own names.
#pragma once

#include <nicol.hpp>

using nicol::check;
using nicol::Context;
using nicol::create;
using nicol::Environment;
using nicol::Framebuffer;
using nicol::Material;
using nicol::Mesh;
using nicol::Scene;
