#version 330 core
// A triangle around the disc of a particle, as far as its field reaches.
layout(location = 0) in vec2 center;  // [px], from the top left
layout(location = 1) in vec4 color;
layout(location = 2) in float weight; // in particles

uniform vec2 image_size; // [px]
uniform float radius;    // R [px]

out vec2 place; // in units of R
flat out float share;
flat out vec3 tint;

const float REACH = 0.70710678; // the field ends at R / sqrt 2
const vec2 CORNERS[3] = vec2[](vec2(-1.7320509, -1.0), vec2(1.7320509, -1.0), vec2(0.0, 2.0));

void main()
{
    place = CORNERS[gl_VertexID % 3] * REACH;
    share = weight;
    tint = color.rgb;
    gl_Position = vec4((center + place * radius) / image_size * 2.0 - 1.0, 0.0, 1.0);
}
