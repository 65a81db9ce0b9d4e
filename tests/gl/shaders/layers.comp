#version 450 core
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) writeonly uniform image2DArray layers;

void main() { imageStore(layers, ivec3(gl_GlobalInvocationID), vec4(gl_GlobalInvocationID, 1.0)); }
