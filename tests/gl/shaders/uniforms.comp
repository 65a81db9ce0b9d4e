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
    result[0] = float(an_int);
    result[1] = float(an_unsigned);
    result[2] = a_bool ? 1.0 : 0.0;
    result[3] = a_float;
    for (int i = 0; i < 2; ++i) result[4 + i] = a_vec2[i];
    for (int i = 0; i < 3; ++i) result[6 + i] = a_vec3[i];
    for (int i = 0; i < 4; ++i) result[9 + i] = a_vec4[i];
    for (int i = 0; i < 9; ++i) result[13 + i] = a_mat3[i / 3][i % 3];
    for (int i = 0; i < 16; ++i) result[22 + i] = a_mat4[i / 4][i % 4];
    for (int i = 0; i < 2; ++i) result[38 + i] = an_array[i];
    result[40] = nested_value();
}
