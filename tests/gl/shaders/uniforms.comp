#version 450 core
#include "nested.glsl"
#include "nested.glsl"
layout(local_size_x = 1) in;
layout(std430, binding = 0) writeonly buffer Output { float result[]; };
uniform int an_int;
uniform uint an_unsigned;
uniform bool a_bool;
uniform float a_float;
uniform vec2 a_vec2;
uniform vec3 a_vec3;
uniform vec4 a_vec4;
uniform mat3 a_mat3;
uniform mat4 a_mat4;
uniform float an_array[2];

void main() {
    int at = 0;
    result[at++] = float(an_int);
    result[at++] = float(an_unsigned);
    result[at++] = a_bool ? 1.0 : 0.0;
    result[at++] = a_float;
    for (int i = 0; i < 2; ++i) result[at++] = a_vec2[i];
    for (int i = 0; i < 3; ++i) result[at++] = a_vec3[i];
    for (int i = 0; i < 4; ++i) result[at++] = a_vec4[i];
    for (int i = 0; i < 9; ++i) result[at++] = a_mat3[i / 3][i % 3];
    for (int i = 0; i < 16; ++i) result[at++] = a_mat4[i / 4][i % 4];
    for (int i = 0; i < 2; ++i) result[at++] = an_array[i];
    result[at++] = nested_value();
}
