#version 330 core
// Walls and lines: one colour, as much of it as they cover of a pixel.
uniform sampler2D cover;
uniform vec4 ink;

layout(location = 0) out vec4 color;

void main()
{
    float part = texelFetch(cover, ivec2(gl_FragCoord.xy), 0).r;
    if (part == 0.0) discard;
    color = vec4(ink.rgb, ink.a * part);
}
