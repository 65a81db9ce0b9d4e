#version 450 core
layout(local_size_x = 32) in;
layout(std430, binding = 1) readonly buffer Directions { vec4 directions[]; };
layout(std430, binding = 2) writeonly buffer Result { vec2 result[]; };  // [direction][l*l + l + m], spin 0 and 2
uniform int order;
#include "spin_harmonics.glsl"

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= directions.length()) return;
    int first = i * (order + 1) * (order + 1);
    PshDegree at = psh_degree(directions[i].xyz);
    for (int m = 0; m <= order; ++m) {
        if (m > 0) psh_next_degree(at);
        PshHarmonics h = psh_harmonics(at);
        for (int l = m; l <= order; ++l) {
            if (l > m) psh_next_order(h);
            vec3 y = psh_values(h);
            int middle = first + l * l + l;
            result[middle + m] = y.xy;
            result[middle - m] = m == 0 ? y.xy : vec2(float(1 - 2 * (m & 1)) * y.x, y.z);
        }
    }
}
