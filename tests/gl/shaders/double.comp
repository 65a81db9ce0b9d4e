#version 450 core
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Input { float source[]; };
layout(std430, binding = 1) writeonly buffer Output { float result[]; };
layout(rgba32f, binding = 2) uniform image2D image;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(source.length())) result[i] = FACTOR * source[i];
    if (i == 0u) imageStore(image, ivec2(1, 0), vec4(1.0, 2.0, 3.0, 4.0));
}
