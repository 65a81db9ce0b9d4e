#version 450 core
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Input { float source[]; };
layout(std430, binding = 1) writeonly buffer Output { float result[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(source.length())) result[i] = FACTOR * source[i];
}
