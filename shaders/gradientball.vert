#version 330 core
// A figure around a particle: a point sprite, or a triangle of three vertices where points are not as large.
layout(location = 0) in vec2 center; // [px] of the image, from the top left
layout(location = 1) in vec4 color;  // red, green, blue; opacity, or how much of a particle it is

uniform vec2 grid;      // columns and rows of the target [texels] ...
uniform float texel;    // ... which are so many pixels wide ...
uniform float margin;   // ... and begin so many texels beside the image
uniform float beyond;   // the viewport is larger than the target by these [texels]: centres outside count, too
uniform float reach;    // radius of the figure [texels]
uniform bool triangles;

flat out vec2 place; // of the particle [texels]
flat out vec4 tint;

const vec2 CORNERS[3] = vec2[](vec2(-1.7320509, -1.0), vec2(1.7320509, -1.0), vec2(0.0, 2.0));

void main()
{
    place = center / texel + margin;
    tint = color;
    vec2 corner = triangles ? CORNERS[gl_VertexID % 3] * reach : vec2(0.0);
    gl_PointSize = 2.0 * reach;
    gl_Position = vec4((place + corner + beyond) / (grid + 2.0 * beyond) * 2.0 - 1.0, 0.0, 1.0);
}
