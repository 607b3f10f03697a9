#version 330 core
// From the summed field to a liquid: a soft threshold, the field as a height map, and one of the looks WATER, FLAT, GLASS
// and INK, which is defined above.
//
// Two heights are lit together. The field itself makes a rounded rim, as wide as a particle; it counts as flat where it
// is full, so that the lattice of the particles does not show. The depth, the field of much wider balls on a coarse grid,
// rises slowly behind the rim and gives the body its shape and its colour. Pixels run from the top left, y downwards.
//
// Where INSIDE is defined, the field is full and even, so that there is no rim.
uniform sampler2D field;    // of two by two pixels each
uniform sampler2D colors;   // the particles' colours times the field, and the field, in the middle of these
uniform sampler2D depth;    // how much it rises over two squares of its grid to the right and down, and its mean
uniform sampler2D walls;    // their cover
uniform float radius;       // R [px]
uniform float threshold;    // of the field: water
uniform float line_width;   // [px]
uniform float texel;        // side of a square of the depth's grid [px]
uniform float margin;       // how many of them lie beside the image
uniform ivec2 last;         // column and row of pixels
uniform bool colored;       // by the particles' colours: of values or, where `tint` says so, of the liquid
uniform vec4 tint;          // the colour of all liquid, and whether liquid has colours
uniform bool charted;       // look INK: with lines of equal depth

layout(location = 0) out vec4 color;

const float full = 0.36; // field from which the rim counts as flat
const vec3 to_light = normalize(vec3(-0.45, -0.75, 0.6));
const vec3 to_viewer = vec3(0.0, 0.0, 1.0);

// How much the depth rises to the right and down, and its mean.
vec3 depth_around()
{
    return textureLod(depth, (gl_FragCoord.xy / texel + margin) / vec2(textureSize(depth, 0)), 0.0).rgb;
}

// The mean colour of the particles.
vec3 mean_color()
{
    vec4 sum = textureLod(colors, 0.5 * gl_FragCoord.xy / vec2(textureSize(colors, 0)), 0.0);
    return sum.rgb / max(sum.a, 1.0e-4);
}

// That, or the colour of all liquid, or what the look has.
vec3 plain_color(vec3 own)
{
    return colored ? mean_color() : tint.a > 0.0 ? tint.rgb : own;
}

#ifdef INSIDE

float field_at(ivec2 pixel)
{
    return 1.0;
}

vec2 rim_rise(ivec2 here)
{
    return vec2(0.0);
}

vec2 field_rise(ivec2 here)
{
    return vec2(0.0);
}

float cover(float f, vec2 rise)
{
    return 1.0;
}

vec2 surface(float f, vec2 rise)
{
    return vec2(1.0e4, 1.0);
}

#else

float field_at(ivec2 pixel)
{
    pixel = clamp(pixel, ivec2(0), last);
    vec4 four = texelFetch(field, pixel >> 1, 0);
    vec2 two = (pixel.y & 1) == 0 ? four.xy : four.zw;
    return (pixel.x & 1) == 0 ? two.x : two.y;
}

// A dome: steep outside, flat where the field is full.
float rim(ivec2 pixel)
{
    float rest = 1.0 - min(field_at(pixel) / full, 1.0);
    return 1.0 - rest * rest;
}

// How much the rim rises to the right and down, from eight places around a pixel.
vec2 rim_rise(ivec2 here)
{
    int straight = max(1, int(0.4 * radius + 0.51)); // .51: round radii are far from where this jumps
    int diagonal = max(1, int(0.4 * 0.7071 * radius + 0.51));
    float right = rim(here + ivec2(straight, 0)), left = rim(here - ivec2(straight, 0));
    float below = rim(here + ivec2(0, straight)), above = rim(here - ivec2(0, straight));
    float a = rim(here + ivec2(diagonal, diagonal)) - rim(here - ivec2(diagonal, diagonal));
    float b = rim(here + ivec2(diagonal, -diagonal)) - rim(here + ivec2(-diagonal, diagonal));
    return 0.25 * (vec2(right - left, below - above) + 0.7071 * vec2(a + b, a - b));
}

// How much the field rises over a pixel to the right and down.
vec2 field_rise(ivec2 here)
{
    return 0.5 * vec2(field_at(here + ivec2(1, 0)) - field_at(here - ivec2(1, 0)),
                      field_at(here + ivec2(0, 1)) - field_at(here - ivec2(0, 1)));
}

// How much of a pixel is water: the field's slope tells over how many pixels it crosses the threshold.
float cover(float f, vec2 rise)
{
    float soft = 0.9 * max(length(rise), 1.0e-4);
    return smoothstep(threshold - soft, threshold + soft, f);
}

#ifndef WATER

float wall_at(vec2 place)
{
    return texelFetch(walls, clamp(ivec2(place), ivec2(0), textureSize(walls, 0) - 1), 0).r;
}

// How far the surface is, by the field's slope [px], and 1 where it is free, 0 where it lies at a wall.
vec2 surface(float f, vec2 rise)
{
    float slope = max(length(rise), 1.0e-4);
    float far = max((f - threshold) / slope, 0.0);
    vec2 beyond = gl_FragCoord.xy - rise / slope * (min(far, 0.5 * radius) + 1.5);
    float wall = max(wall_at(beyond), wall_at(beyond - rise / slope * max(0.12 * radius, 1.0)));
    return vec2(far, 1.0 - wall);
}

#endif

#endif

#ifdef WATER

const vec3 shallow = vec3(0.30, 0.70, 0.88);
const vec3 deep = vec3(0.04, 0.36, 0.66);
const vec3 sky = vec3(0.10, 0.16, 0.18);

vec4 look(ivec2 here, float f)
{
    vec3 around = depth_around();
    float inside = smoothstep(0.1, 1.0, around.z);
    vec3 normal = normalize(vec3(-1.1 * rim_rise(here) - 1.2 * around.xy, 0.8));
    float diffuse = 0.5 + 0.5 * dot(normal, to_light); // no side is quite dark: light comes through water
    float gloss = pow(max(dot(normal, normalize(to_light + to_viewer)), 0.0), 60.0);
    float covered = cover(f, field_rise(here));
    if (colored && tint.a == 0.0) // little light, so that colours are those of the colour bar
        return vec4(mean_color() * (0.74 + 0.3 * diffuse) + 0.12 * gloss, covered);
    vec3 high = shallow, low = deep, edge = sky * (1.0 - normal.z);
    if (tint.a > 0.0) { // darker at the rim, so that milk is seen on paper
        vec3 plain = plain_color(deep);
        high = mix(plain, vec3(1.0), 0.2);
        low = 0.85 * plain;
        edge = -0.5 * (1.0 - normal.z) * plain;
    }
    vec3 lit = mix(high, low, inside) * (0.46 + 0.66 * diffuse) + edge + 0.22 * gloss;
    return vec4(lit, covered);
}

#endif

#ifdef FLAT

const vec3 paint = vec3(0.17, 0.51, 0.81);

vec4 look(ivec2 here, float f)
{
    vec2 rise = field_rise(here), border = surface(f, rise);
    float edge = border.y * clamp(line_width + 0.5 - border.x, 0.0, 1.0);
    return vec4(plain_color(paint) * (1.0 - 0.3 * edge), cover(f, rise));
}

#endif

#ifdef GLASS

const vec3 thin = vec3(0.48, 0.79, 0.90);
const vec3 thick = vec3(0.16, 0.56, 0.74);
const vec3 shade = vec3(0.05, 0.34, 0.50);

// Light that comes in at the upper left is bent and gathers at the other side; the rim mirrors what is around it.
vec4 look(ivec2 here, float f)
{
    vec3 around = depth_around();
    vec2 rise = field_rise(here), border = surface(f, rise);
    float inside = smoothstep(0.1, 1.0, around.z);
    vec3 normal = normalize(vec3(-1.6 * border.y * rim_rise(here) - 1.2 * around.xy, 0.8));
    vec3 bent = refract(-to_viewer, normal, 0.75);
    float gathered = dot(bent.xy, to_light.xy); // below 0 at the side of the light
    float mirrored = pow(1.0 - normal.z, 2.0);
    float gloss = pow(max(dot(normal, normalize(to_light + to_viewer)), 0.0), 90.0);
    bool own = !colored && tint.a == 0.0;
    vec3 plain = plain_color(mix(thin, thick, inside));
    vec3 dark = own ? shade : 0.4 * plain;
    vec3 lit = gathered < 0.0 ? mix(plain, dark, -1.4 * gathered) : mix(plain, vec3(1.0), 1.1 * gathered);
    float edge = border.y * clamp(0.6 * line_width + 0.5 - border.x, 0.0, 1.0);
    lit = mix(lit, vec3(1.0), 0.35 * mirrored) * (1.0 - 0.3 * edge) + gloss;
    float opaque = mix(own ? 0.6 : 0.9, 0.9, max(max(inside, edge), max(gloss, mirrored)));
    return vec4(clamp(lit, 0.0, 1.0), cover(f, rise) * opaque);
}

#endif

#ifdef INK

const vec3 ink = vec3(0.08, 0.10, 0.14);

// How much of a line, which is where `value` is a level, covers the pixel; `change` is that over a pixel.
float level_line(float value, float level, float change, float wide)
{
    return clamp(0.5 * wide + 0.5 - abs(value - level) / max(change, 1.0e-4), 0.0, 1.0);
}

vec4 look(ivec2 here, float f)
{
    vec3 around = depth_around();
    vec2 rise = field_rise(here), border = surface(f, rise);
    float wide = line_width;
    float line = border.y * clamp(wide + 0.5 - border.x, 0.0, 1.0);
    float change = 0.5 * length(around.xy) / texel;
    float below = 0.0;
    for (int k = 0; k < 4 && charted; ++k) { // ever thinner lines along the surface, as on old charts
        float part = float(k) / 4.0;
        below = max(below, (0.75 - 0.6 * part) * level_line(around.z, 0.66 + 0.32 * part, change, 0.5 * wide));
    }
    vec3 paper = plain_color(mix(vec3(1.0), vec3(0.86, 0.91, 0.95), around.z));
    return vec4(mix(paper, ink, max(line, below)), cover(f, rise));
}

#endif

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy);
    float f = field_at(here);
#ifndef INSIDE
    if (f < 0.4 * threshold) discard;
#endif
    color = look(here, f);
}
