// Line 2 has the version, line 4 an include with a mistake of its own.
#version 450 core
layout(location = 0) out vec4 colour;
#include "nested_bad.glsl"

void main() {
    colour = vec4(undeclared_in_main);
}
