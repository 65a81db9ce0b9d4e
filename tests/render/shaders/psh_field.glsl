layout(std430, binding = 0) readonly buffer Coefficients { vec4 coefficients[]; };  // [index][channel]
layout(std430, binding = 1) readonly buffer Directions { vec4 directions[]; };
uniform int order;

#define PSH_COEFFICIENT(channel, index) coefficients[(index) * CHANNELS + (channel)]
#include "spin_harmonics.glsl"
