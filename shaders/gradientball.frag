#version 330 core
// The field of one metaball, r^4 - r^2 + 1/4 with r in units of R. It falls to zero at r^2 = 1/2 and would rise again
// beyond; blending sums it up over the particles.
in vec2 place;
flat in float share;
flat in vec3 tint;

layout(location = 0) out vec4 field; // and the colour times the field, where the target has room for it

void main()
{
    float s = dot(place, place);
    float fall = min(s - 0.5, 0.0);
    field = share * fall * fall * vec4(1.0, tint);
}
