#version 330 core
// Walls: one colour, as much of it as they cover of a pixel.
uniform sampler2D cover;

layout(location = 0) out vec4 color;

const vec3 wall = vec3(0.36, 0.345, 0.34);

void main()
{
    float part = texelFetch(cover, ivec2(gl_FragCoord.xy), 0).r;
    if (part == 0.0) discard;
    color = vec4(wall, part);
}
