#version 330 core
// A triangle around a dot, a pixel wider for its soft edge.
layout(location = 0) in vec2 center; // [px], from the top left
layout(location = 1) in vec4 color;

uniform vec2 image_size; // [px]
uniform float radius;    // [px]

out vec2 place; // [px]
flat out vec4 tint;

const vec2 CORNERS[3] = vec2[](vec2(-1.7320509, -1.0), vec2(1.7320509, -1.0), vec2(0.0, 2.0));

void main()
{
    place = CORNERS[gl_VertexID % 3] * (radius + 1.0);
    tint = color;
    gl_Position = vec4((center + place) / image_size * 2.0 - 1.0, 0.0, 1.0);
}
