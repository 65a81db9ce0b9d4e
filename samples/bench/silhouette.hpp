// SPDX-License-Identifier: MIT
// How jagged outlines are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "stage.hpp"

/// The root mean square error of each recipe, in s0 over the pixels at outlines of instances, of an image of
/// size x size. The truth is the mean of 64 images of the first recipe, whose camera is jittered; outlines
/// are where these show different instances.
std::vector<double> silhouette_errors(const SceneSource& source, std::span<const Recipe> recipes,
                                      std::uint32_t size);
