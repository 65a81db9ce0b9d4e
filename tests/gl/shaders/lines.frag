// The fragment's own line numbers, read back as a colour.
#version 450 core
#include "nested.glsl"
layout(location = 0) out vec4 colour;

void main() { colour = vec4(__LINE__, nested_value(), WIDE, HIGH); }
