#version 450 core
layout(location = 0) in vec4 vertex_colour;
layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;

void main() {
    first = vertex_colour;
    second = vec4(gl_FragCoord.xyz, gl_FrontFacing ? 1.0 : -1.0);
}
