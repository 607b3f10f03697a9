#version 330 core
// A square around a particle, as far as its field reaches. Corner 0 to 3 of a strip, from the number of the vertex.
layout(location = 0) in vec2 center; // [px], from the top left

uniform vec2 image_size; // [px]
uniform float radius;    // R [px]

out vec2 place; // in units of R

const float REACH = 0.70710678; // the field ends at R / sqrt 2

void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    place = corner * REACH;
    gl_Position = vec4((center + place * radius) / image_size * 2.0 - 1.0, 0.0, 1.0);
}
