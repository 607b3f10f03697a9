#version 330 core
// A round dot whose edge fades over one pixel.
flat in vec2 place; // [px]
flat in vec4 tint;

uniform float radius; // [px]

layout(location = 0) out vec4 color;

void main()
{
    float cover = clamp(radius + 0.5 - length(gl_FragCoord.xy - place), 0.0, 1.0);
    color = vec4(tint.rgb, tint.a * cover);
}
