#version 330 core
// A square around a dot, a pixel wider for its soft edge.
layout(location = 0) in vec2 center; // [px], from the top left
layout(location = 1) in vec4 color;

uniform vec2 image_size; // [px]
uniform float radius;    // [px]

out vec2 place; // [px]
flat out vec4 tint;

void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    place = corner * (radius + 1.0);
    tint = color;
    gl_Position = vec4((center + place) / image_size * 2.0 - 1.0, 0.0, 1.0);
}
