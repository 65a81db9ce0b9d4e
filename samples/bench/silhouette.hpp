// SPDX-License-Identifier: MIT
// Errors at the outlines of instances.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "stage.hpp"

/// Returns the root mean square error of each recipe, in s0 over the pixels at outlines of instances, of an
/// image of size x size. The truth is the mean of 64 images of the first recipe with a jittered camera;
/// outlines are the pixels in which these show different instances.
std::vector<double> silhouette_errors(const SceneSource& source, std::span<const Recipe> recipes,
                                      std::uint32_t size);
