#version 330 core
// From the summed field to water: a soft threshold, the field as a height map, normals from its differences, light.
//
// Two heights are lit together. The field itself makes a rounded rim, as wide as a particle; it counts as flat where it
// is full, so that the lattice of the particles does not show. The depth, the field of much wider balls on a coarse grid,
// rises slowly behind the rim and gives the body its shape and its colour. Pixels run from the top left, y downwards.
uniform sampler2D field;
uniform sampler2D depth;
uniform float radius;       // R [px]
uniform float threshold;    // of the field: water
uniform float texel;        // side of a square of the depth's grid [px]
uniform float margin;       // how many of them lie beside the image
uniform float depth_inside; // the depth of a large body of water
uniform bool colored;       // by the particles' colours, which the field has, too

layout(location = 0) out vec4 color;

const float full = 0.36; // field from which the rim counts as flat
const vec3 shallow = vec3(0.30, 0.70, 0.88);
const vec3 deep = vec3(0.04, 0.36, 0.66);
const vec3 sky = vec3(0.10, 0.16, 0.18);
const vec3 to_light = normalize(vec3(-0.45, -0.75, 0.6));
const vec3 to_viewer = vec3(0.0, 0.0, 1.0);

float field_at(ivec2 pixel)
{
    return texelFetch(field, clamp(pixel, ivec2(0), textureSize(field, 0) - 1), 0).r;
}

// A dome: steep outside, flat where the field is full.
float rim(ivec2 pixel)
{
    float rest = 1.0 - min(field_at(pixel) / full, 1.0);
    return 1.0 - rest * rest;
}

// How much the rim rises to the right and down, from eight places around a pixel.
vec2 rim_rise(ivec2 here, int straight, int diagonal)
{
    float right = rim(here + ivec2(straight, 0)), left = rim(here - ivec2(straight, 0));
    float below = rim(here + ivec2(0, straight)), above = rim(here - ivec2(0, straight));
    float a = rim(here + ivec2(diagonal, diagonal)) - rim(here - ivec2(diagonal, diagonal));
    float b = rim(here + ivec2(diagonal, -diagonal)) - rim(here + ivec2(-diagonal, diagonal));
    return 0.25 * (vec2(right - left, below - above) + 0.7071 * vec2(a + b, a - b));
}

float depth_at(vec2 place)
{
    return textureLod(depth, place, 0.0).r / depth_inside;
}

// How much of a pixel is water: the field's slope tells over how many pixels it crosses the threshold.
float cover(ivec2 here, float f)
{
    vec2 slope = 0.5 * vec2(field_at(here + ivec2(1, 0)) - field_at(here - ivec2(1, 0)),
                            field_at(here + ivec2(0, 1)) - field_at(here - ivec2(0, 1)));
    float soft = 0.9 * max(length(slope), 1.0e-4);
    return smoothstep(threshold - soft, threshold + soft, f);
}

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy);
    float f = field_at(here);
    if (f < 0.4 * threshold) discard;

    vec2 grid = 1.0 / vec2(textureSize(depth, 0));
    vec2 place = (gl_FragCoord.xy / texel + margin) * grid;
    float right = depth_at(place + vec2(grid.x, 0.0)), left = depth_at(place - vec2(grid.x, 0.0));
    float below = depth_at(place + vec2(0.0, grid.y)), above = depth_at(place - vec2(0.0, grid.y));
    float inside = smoothstep(0.1, 1.0, 0.25 * (right + left + below + above));

    int straight = max(1, int(0.4 * radius + 0.51)); // .51: round radii are far from where this jumps
    int diagonal = max(1, int(0.4 * 0.7071 * radius + 0.51));
    vec2 rise = 1.1 * rim_rise(here, straight, diagonal) + 1.2 * vec2(right - left, below - above);
    vec3 normal = normalize(vec3(-rise, 0.8));

    float diffuse = 0.5 + 0.5 * dot(normal, to_light); // no side is quite dark: light comes through water
    float gloss = pow(max(dot(normal, normalize(to_light + to_viewer)), 0.0), 60.0);
    if (colored) { // little light, so that colours are those of the colour bar
        vec3 mean = texelFetch(field, here, 0).gba / f;
        color = vec4(mean * (0.74 + 0.3 * diffuse) + 0.12 * gloss, cover(here, f));
        return;
    }
    vec3 lit = mix(shallow, deep, inside) * (0.46 + 0.66 * diffuse) + sky * (1.0 - normal.z) + 0.22 * gloss;
    color = vec4(lit, cover(here, f));
}
