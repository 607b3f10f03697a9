#version 330 core
// The field of one metaball, r^4 - r^2 + 1/4 with r in units of R. It falls to zero at r^2 = 1/2 and would rise again
// beyond; blending sums it up over the particles.
//
// A texel holds the fields of two by two pixels, upper left, upper right, lower left, lower right: the same sums in a
// quarter of the texels take half the time in a software renderer.
flat in vec2 place; // [texels]
flat in vec4 tint;

uniform float unit;   // 1 over R [1/texels]
uniform float weight; // of a ball of opacity 1, in particles

layout(location = 0) out vec4 field;
#ifdef COLORED
layout(location = 1) out vec4 colors; // the colour times the field, and the field, in the middle of the four pixels
#endif

vec4 ball(vec4 s)
{
    vec4 fall = max(0.5 - s, 0.0);
    return weight * tint.a * fall * fall;
}

void main()
{
    vec2 r = (gl_FragCoord.xy - place) * unit;
    vec2 x = r.x + vec2(-0.25, 0.25) * unit, y = r.y + vec2(-0.25, 0.25) * unit;
    field = ball((x * x).xyxy + (y * y).xxyy);
#ifdef COLORED
    colors = vec4(tint.rgb, 1.0) * ball(vec4(dot(r, r)));
#endif
}
