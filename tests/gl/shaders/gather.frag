#version 450 core
layout(location = 0) in vec2 uv;
layout(binding = 3) uniform sampler2D image;
layout(location = 0) out vec4 colour;

void main() { colour = texture(image, uv * SCALE); }
