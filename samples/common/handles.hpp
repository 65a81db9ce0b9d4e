// SPDX-License-Identifier: MIT
// Short names of the handles of nicol.hpp.
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
