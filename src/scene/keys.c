/* SPDX-License-Identifier: MIT */
/** @file keys.c
 *  The table of scene keys, used by the reader, the range checks, `sph2d init` and the key reference. */
#include "sph2d/key.h"

#include <math.h>

#include "sph2d/method.h"

/* Macros for the columns of a row. */
#define AT(type, member) .offset = offsetof(type, member)
#define ANY .min = -SPH2D_LARGEST, .max = SPH2D_LARGEST
#define ABOVE_0 .min = SPH2D_SMALLEST, .max = SPH2D_LARGEST
#define FROM_0 .min = 0, .max = SPH2D_LARGEST
#define SEED .min = 0, .max = INFINITY
#define BETWEEN(low, high) .min = (low), .max = (high)
#define BETWEEN_OR_0(low, high) .min = (low), .max = (high), .zero_is_unset = true
#define LIST_AT(type, member, counter) AT(type, member), .count_offset = offsetof(type, counter)
#define CHOICE(type, member, value) .choice_offset = offsetof(type, member), .choice = (value)
#define KEYS(name, type, fill)                                                                                         \
    static const sph2d_keys name##_keys = {name##_items, sizeof name##_items / sizeof name##_items[0], sizeof(type),   \
                                           fill}
#define DEFAULT(type)                                                                                                  \
    static void type##_set(void *out)                                                                                  \
    {                                                                                                                  \
        *(sph2d_##type *)out = sph2d_##type##_default();                                                               \
    }

DEFAULT(scene)
DEFAULT(block)
DEFAULT(source)
DEFAULT(drain)
DEFAULT(absorber)
DEFAULT(opening)
DEFAULT(obstacle)
DEFAULT(body)
DEFAULT(spring)
DEFAULT(interaction)
DEFAULT(probe)

static void swing_set(void *out)
{
    *(sph2d_swing *)out = (sph2d_swing){.phase = 0};
}

static const char *const side_words[] = {"wall", "open", "periodic", NULL};
static const char *const side_name_words[] = {"left", "right", "bottom", "top", NULL};
static const char *const profile_words[] = {"uniform", "parabola", "turbulent", NULL};
static const char *const wall_words[] = {"default", "spring", "heavy", "reflect", "generalised", NULL};
static const char *const slip_words[] = {"free", "none", "smooth", NULL};
static const char *const wall_slip_words[] = {"default", "free", "none", "smooth", NULL};

/* In the order of sph2d_flow_kind. */
static const char *const flow_words[] = {"none",          "still",  "taylor_green", "gresho", "poiseuille", "couette",
                                         "standing_wave", "strain", "rotation",     "patch",  "drop",       NULL};
#define METHOD_WORD(name, word) #word,
static const char *const method_words[] = {SPH2D_METHOD_MAP(METHOD_WORD) NULL};
static const char *const arrangement_words[] = {"lattice", "rings", NULL};
static const char *const switch_words[] = {"off", "on", NULL};
static const char *const operator_words[] = {"variational", "fitted", NULL};
#define KERNEL_WORD(name, word) #word,
static const char *const kernel_words[] = {SPH2D_KERNEL_MAP(KERNEL_WORD) NULL};
#define PROBE_WORD(name, word, columns) #word,
static const char *const probe_words[] = {SPH2D_PROBE_MAP(PROBE_WORD) NULL};
static const char *const material_words[] = {"none",     "water",     "oil",      "glycerine", "honey",      "mercury",
                                             "seawater", "ethanol",   "gasoline", "milk",      "engine_oil", "lava",
                                             "blood",    "chocolate", "mud",      NULL};
static const char *const between_words[] = {"default", "lines", "cubic", NULL};
static const char *const rheology_words[] = {"newtonian", "power_law", "carreau", "herschel_bulkley", NULL};
static const char *const liquid_words[] = {"auto", "left", "right", "both", "inside", NULL};
static const char *const style_words[] = {"metaballs", "points", NULL};
static const char *const background_words[] = {"opaque", "transparent", NULL};
static const char *const look_words[] = {"water", "flat", "glass", "ink", NULL};

static const sph2d_key box_items[] = {
    {"min", SPH2D_KEY_POINT, true, AT(sph2d_box, min), ANY, .unit = "m", .text = "lower left corner"},
    {"max", SPH2D_KEY_POINT, true, AT(sph2d_box, max), ANY, .unit = "m", .text = "upper right corner"},
};
KEYS(box, sph2d_box, NULL);

static const sph2d_key circle_items[] = {
    {"center", SPH2D_KEY_POINT, true, AT(sph2d_circle, center), ANY, .unit = "m", .text = "centre"},
    {"radius", SPH2D_KEY_NUMBER, true, AT(sph2d_circle, radius), ABOVE_0, .unit = "m", .text = "radius"},
};
KEYS(circle, sph2d_circle, NULL);

static const sph2d_key arc_items[] = {
    {"center", SPH2D_KEY_POINT, true, AT(sph2d_arc, center), ANY, .unit = "m", .text = "centre"},
    {"radius", SPH2D_KEY_NUMBER, true, AT(sph2d_arc, radius), ABOVE_0, .unit = "m", .text = "radius"},
    {"from", SPH2D_KEY_NUMBER, true, AT(sph2d_arc, from), ANY, .unit = "rad",
     .text = "angle of the first end, from the x axis anticlockwise"},
    {"to", SPH2D_KEY_NUMBER, true, AT(sph2d_arc, to), ANY, .unit = "rad",
     .text = "angle of the last end, less than a full turn above `from`"},
};
KEYS(arc, sph2d_arc, NULL);

/* The closed shapes, as keys of a block, drain, obstacle or body. */
// clang-format off
#define SHAPE(type)                                                                                                    \
    {"box", SPH2D_KEY_GROUP, false, AT(type, shape.box), CHOICE(type, shape.kind, SPH2D_SHAPE_BOX),                    \
     .keys = &box_keys, .unit = "", .text = "a rectangle"},                                                            \
    {"circle", SPH2D_KEY_GROUP, false, AT(type, shape.circle), CHOICE(type, shape.kind, SPH2D_SHAPE_CIRCLE),           \
     .also = "disc", .keys = &circle_keys, .unit = "", .text = "a circle, or the disc within it; `disc` says the same"}, \
    {"polygon", SPH2D_KEY_POINTS, false, LIST_AT(type, shape.points.items, shape.points.count), ANY,                   \
     CHOICE(type, shape.kind, SPH2D_SHAPE_POLYGON), .unit = "m", .text = "corners, 3 or more, closed by itself"},      \
    {"svg", SPH2D_KEY_TEXT, false, AT(type, shape.svg), CHOICE(type, shape.kind, SPH2D_SHAPE_SVG), .unit = "",         \
     .text = "FILE.svg#ID: the outline with that id of a drawing, whose page is as wide as the domain and stands on its " \
             "bottom"}
// clang-format on

/* The colour of liquid. */
#define COLOR(type, otherwise, what)                                                                                   \
    {                                                                                                                  \
        "color", SPH2D_KEY_TEXT, false, AT(type, color), .unit = "", .default_text = (otherwise), .text = (what)       \
    }

static const sph2d_key start_items[] = {
    {"flow", SPH2D_KEY_WORD, false, AT(sph2d_start, flow.kind), .words = flow_words, .unit = "", .default_text = "none",
     .text = "a known flow"},
    {"speed", SPH2D_KEY_NUMBER, false, AT(sph2d_start, flow.speed), ANY, .unit = "m/s", .default_text = "0",
     .text = "its speed U"},
    {"length", SPH2D_KEY_NUMBER, false, AT(sph2d_start, flow.length), FROM_0, .unit = "m", .default_text = "0",
     .text = "its length L: period, radius, side, distance of walls"},
    {"depth", SPH2D_KEY_NUMBER, false, AT(sph2d_start, flow.depth), FROM_0, .unit = "m", .default_text = "0",
     .text = "standing_wave: of the liquid at rest"},
    {"center", SPH2D_KEY_POINT, false, AT(sph2d_start, flow.center), ANY, .unit = "m", .default_text = "[0, 0]",
     .text = "its centre; still: a point of the surface"},
    {"table", SPH2D_KEY_TEXT, false, AT(sph2d_start, table.file), .unit = "", .default_text = "none",
     .text = "in place of a flow: a CSV file with columns x, y and any of vx, vy, pressure, on a rectangular grid"},
    {"snapshot", SPH2D_KEY_TEXT, false, AT(sph2d_start, snapshot.file), .unit = "", .default_text = "none",
     .text = "in place of a flow: a snapshot of another run, of any spacing"},
    {"top_speed", SPH2D_KEY_NUMBER, false, AT(sph2d_start, top_speed), FROM_0, .unit = "m/s",
     .default_text = "the largest there",
     .text = "of a table or snapshot: the speed that the sound speed is chosen for"},
};
KEYS(start, sph2d_start, NULL);

static const sph2d_key perturb_items[] = {
    {"amplitude", SPH2D_KEY_NUMBER, false, AT(sph2d_perturb, amplitude), BETWEEN(0, 0.5), .unit = "spacings",
     .default_text = "0", .text = "largest displacement of a coordinate"},
    {"seed", SPH2D_KEY_COUNT, false, AT(sph2d_perturb, seed), SEED, .unit = "", .default_text = "1",
     .text = "of the random numbers"},
};
KEYS(perturb, sph2d_perturb, NULL);

static const sph2d_key block_items[] = {
    SHAPE(sph2d_block),
    {"velocity", SPH2D_KEY_POINT, false, AT(sph2d_block, velocity), ANY, .unit = "m/s", .default_text = "[0, 0]",
     .text = "at the start"},
    {"spacing", SPH2D_KEY_NUMBER, false, AT(sph2d_block, spacing), FROM_0, .unit = "m", .default_text = "the scene's",
     .text = "between this block's particles; their mass stays that of the scene's spacing, so a smaller one starts "
             "compressed, "
             "wcsph by 10 % at most"},
    {"start", SPH2D_KEY_GROUP, false, AT(sph2d_block, start), .keys = &start_keys, .unit = "", .default_text = "none",
     .text = "a known flow, a table or a snapshot that it starts with"},
    COLOR(sph2d_block, "the fluid's", "of its particles"),
    {"arrangement", SPH2D_KEY_WORD, false, AT(sph2d_block, arrangement), .words = arrangement_words, .unit = "",
     .default_text = "lattice", .text = "arrangement of the particles; rings, for discs, have a smooth edge"},
    {"perturb", SPH2D_KEY_GROUP, false, AT(sph2d_block, perturb), .keys = &perturb_keys, .unit = "",
     .default_text = "none", .text = "random displacement of the particles"},
};
KEYS(block, sph2d_block, block_set);

static const sph2d_key source_items[] = {
    {"at", SPH2D_KEY_POINT, true, AT(sph2d_source, at), ANY, .unit = "m", .text = "centre of the nozzle"},
    {"direction", SPH2D_KEY_POINT, false, AT(sph2d_source, direction), ANY, .unit = "", .default_text = "[0, -1]",
     .text = "of the jet, of any length"},
    {"width", SPH2D_KEY_NUMBER, false, AT(sph2d_source, width), FROM_0, .unit = "m", .default_text = "0: one particle",
     .text = "of the nozzle"},
    {"speed", SPH2D_KEY_NUMBER, true, AT(sph2d_source, speed), ABOVE_0, .unit = "m/s", .text = "of the jet"},
    {"spread", SPH2D_KEY_NUMBER, false, AT(sph2d_source, spread), BETWEEN(0, 1), .unit = "", .default_text = "0",
     .text = "random part of each velocity component, as a fraction of speed"},
    {"rate", SPH2D_KEY_NUMBER, false, AT(sph2d_source, rate), FROM_0, .unit = "m^2/s", .default_text = "width * speed",
     .text = "area of liquid per second"},
    {"start", SPH2D_KEY_NUMBER, false, AT(sph2d_source, start), FROM_0, .unit = "s", .default_text = "0",
     .text = "when it opens"},
    {"stop", SPH2D_KEY_NUMBER, false, AT(sph2d_source, stop), FROM_0, .unit = "s", .default_text = "never",
     .text = "when it closes"},
    {"seed", SPH2D_KEY_COUNT, false, AT(sph2d_source, seed), SEED, .unit = "", .default_text = "1",
     .text = "of the random spread"},
    COLOR(sph2d_source, "the fluid's", "of its liquid"),
};
KEYS(source, sph2d_source, source_set);

static const sph2d_key drain_items[] = {
    SHAPE(sph2d_drain),
    {"start", SPH2D_KEY_NUMBER, false, AT(sph2d_drain, start), FROM_0, .unit = "s", .default_text = "0",
     .text = "when it opens"},
    {"stop", SPH2D_KEY_NUMBER, false, AT(sph2d_drain, stop), FROM_0, .unit = "s", .default_text = "never",
     .text = "when it closes"},
};
KEYS(drain, sph2d_drain, drain_set);

static const sph2d_key absorber_items[] = {
    {"side", SPH2D_KEY_WORD, true, AT(sph2d_absorber, side), .words = side_name_words, .unit = "",
     .text = "at which waves die out"},
    {"length", SPH2D_KEY_NUMBER, true, AT(sph2d_absorber, length), ABOVE_0, .unit = "m",
     .text = "how far it reaches into the domain, best a wavelength or more"},
    {"rate", SPH2D_KEY_NUMBER, false, AT(sph2d_absorber, rate), FROM_0, .unit = "1/s",
     .default_text = "3 sqrt(g/length), with an opening 6",
     .text = "of decay of the velocity at the side, from 0 at the other end as the square of the distance"},
};
KEYS(absorber, sph2d_absorber, absorber_set);

#define HISTORY(name, unit_text)                                                                                       \
    {                                                                                                                  \
#name, SPH2D_KEY_POINTS, false, LIST_AT(sph2d_opening_history, name.items, name.count), ANY,                   \
            .unit = "s, " unit_text, .default_text = "none",                                                           \
            .text = "[t, " #name "] points with straight lines between, constant before and after"                     \
    }

static const sph2d_key opening_history_items[] = {
    HISTORY(velocity, "m/s"),
    HISTORY(flow_rate, "m^2/s"),
    HISTORY(pressure, "Pa"),
    HISTORY(level, "m"),
    {"profile", SPH2D_KEY_PATH, false, LIST_AT(sph2d_opening_history, profile.items, profile.count), ANY,
     .unit = "s, m, m/s", .default_text = "none",
     .text = "[t, s, velocity] points, s the place along the side, y or x: the same places at each time, with cubics "
             "between, and straight lines between times"},
    {"file", SPH2D_KEY_TEXT, false, AT(sph2d_opening_history, file), .unit = "", .default_text = "none",
     .text = "a CSV file with columns t and one of velocity, flow_rate, pressure, level, or y (x of bottom and top), "
             "velocity and perhaps t: that list"},
};
KEYS(opening_history, sph2d_opening_history, NULL);

static const sph2d_key opening_items[] = {
    {"name", SPH2D_KEY_TEXT, false, AT(sph2d_opening, name), .unit = "", .default_text = "none",
     .text = "by which probes refer to it"},
    {"side", SPH2D_KEY_WORD, true, AT(sph2d_opening, side), .words = side_name_words, .unit = "",
     .text = "the side in which it is, a wall"},
    {"from", SPH2D_KEY_NUMBER, false, AT(sph2d_opening, from), ANY, .nan_is_unset = true, .unit = "m",
     .default_text = "the end of the side", .text = "its lower end, or left end"},
    {"to", SPH2D_KEY_NUMBER, false, AT(sph2d_opening, to), ANY, .nan_is_unset = true, .unit = "m",
     .default_text = "the end of the side", .text = "its upper end, or right end"},
    {"velocity", SPH2D_KEY_NUMBER, false, AT(sph2d_opening, velocity), ANY, .nan_is_unset = true, .unit = "m/s",
     .default_text = "none", .text = "mean velocity into the domain; negative: out of it"},
    {"flow_rate", SPH2D_KEY_NUMBER, false, AT(sph2d_opening, flow_rate), ANY, .nan_is_unset = true, .unit = "m^2/s",
     .default_text = "none", .text = "area of liquid per second into the domain, in place of velocity"},
    {"profile", SPH2D_KEY_WORD, false, AT(sph2d_opening, profile), .words = profile_words, .unit = "",
     .default_text = "uniform",
     .text = "velocity over the width: parabola is 0 at both ends, 1.5 times the mean in the middle; turbulent follows "
             "the 1/7 power law from both"},
    {"ramp", SPH2D_KEY_NUMBER, false, AT(sph2d_opening, ramp), FROM_0, .unit = "s", .default_text = "0",
     .text = "time over which velocity or flow_rate grow smoothly from nothing"},
    {"pressure", SPH2D_KEY_NUMBER, false, AT(sph2d_opening, pressure), ANY, .nan_is_unset = true, .unit = "Pa",
     .default_text = "none",
     .text = "pressure in its middle, hydrostatic from there, in place of velocity: liquid flows in or out"},
    {"level", SPH2D_KEY_NUMBER, false, AT(sph2d_opening, level), ANY, .nan_is_unset = true, .unit = "m",
     .default_text = "none", .text = "height y of the surface of still liquid outside, in place of velocity"},
    {"history", SPH2D_KEY_GROUP, false, AT(sph2d_opening, history), .keys = &opening_history_keys, .unit = "",
     .default_text = "none", .text = "one of velocity, flow_rate, pressure, level over time, in place of the number"},
    {"free_surface", SPH2D_KEY_WORD, false, AT(sph2d_opening, free_surface), .words = switch_words, .unit = "",
     .default_text = "off",
     .text = "with velocity or flow_rate: liquid stands in it as high as before it, with air above"},
    COLOR(sph2d_opening, "the fluid's", "of liquid that comes in through it"),
};
KEYS(opening, sph2d_opening, opening_set);

#define SWING(type)                                                                                                    \
    {"amplitude",                                                                                                      \
     SPH2D_KEY_POINT,                                                                                                  \
     false,                                                                                                            \
     AT(type, amplitude),                                                                                              \
     ANY,                                                                                                              \
     .unit = "m",                                                                                                      \
     .default_text = "[0, 0]",                                                                                         \
     .text = "of an oscillation: amplitude (sin(2 pi frequency t + phase) - sin(phase))"},                             \
        {"angle",                                                                                                      \
         SPH2D_KEY_NUMBER,                                                                                             \
         false,                                                                                                        \
         AT(type, angle),                                                                                              \
         ANY,                                                                                                          \
         .unit = "rad",                                                                                                \
         .default_text = "0",                                                                                          \
         .text = "amplitude of its angle, anticlockwise"},                                                             \
        {"frequency",                                                                                                  \
         SPH2D_KEY_NUMBER,                                                                                             \
         false,                                                                                                        \
         AT(type, frequency),                                                                                          \
         FROM_0,                                                                                                       \
         .unit = "1/s",                                                                                                \
         .default_text = "0",                                                                                          \
         .text = "of the oscillation"},                                                                                \
    {                                                                                                                  \
        "phase", SPH2D_KEY_NUMBER, false, AT(type, phase), ANY, .unit = "rad", .default_text = "0",                    \
                                                                .text = "of the oscillation; -1.5708 starts at rest"   \
    }

static const sph2d_key swing_items[] = {SWING(sph2d_swing)};
KEYS(swing, sph2d_swing, swing_set);

static const sph2d_key motion_items[] = {
    {"path", SPH2D_KEY_POSES, false, LIST_AT(sph2d_motion, path.items, path.count), ANY, .unit = "s, m, m, rad",
     .default_text = "none",
     .text = "[t, x, y] displacements, or [t, x, y, angle] with angles, anticlockwise; at rest before and after"},
    {"file", SPH2D_KEY_TEXT, false, AT(sph2d_motion, file), .unit = "", .default_text = "none",
     .text = "a CSV file with columns t and any of x, y, angle: the path"},
    {"between", SPH2D_KEY_WORD, false, AT(sph2d_motion, between), .words = between_words, .unit = "",
     .default_text = "lines; from a file cubic",
     .text = "how it goes from one point of the path to the next: in straight lines, or by cubics without jumps of "
             "velocity and acceleration"},
    {"rate", SPH2D_KEY_NUMBER, false, AT(sph2d_motion, rate), ANY, .unit = "rad/s", .default_text = "0",
     .text = "at which it turns, anticlockwise"},
    SWING(sph2d_motion),
    {"swings", SPH2D_KEY_LIST, false, LIST_AT(sph2d_motion, swings, swing_count), .keys = &swing_keys, .unit = "",
     .default_text = "none", .text = "further oscillations, added up"},
    {"ramp", SPH2D_KEY_NUMBER, false, AT(sph2d_motion, ramp), FROM_0, .unit = "s", .default_text = "0",
     .text = "time over which oscillations and the rate grow smoothly to their full size"},
    {"center", SPH2D_KEY_POINT, false, AT(sph2d_motion, center), ANY, .nan_is_unset = true, .unit = "m",
     .default_text = "the outline's centroid", .text = "the point about which it turns, before it moves"},
};
KEYS(motion, sph2d_motion, NULL);

static const sph2d_key obstacle_items[] = {
    {"name", SPH2D_KEY_TEXT, false, AT(sph2d_obstacle, name), .unit = "", .default_text = "none",
     .text = "for probes: letters, digits, _ and -"},
    SHAPE(sph2d_obstacle),
    {"line", SPH2D_KEY_POINTS, false, LIST_AT(sph2d_obstacle, shape.points.items, shape.points.count), ANY,
     CHOICE(sph2d_obstacle, shape.kind, SPH2D_SHAPE_LINE), .unit = "m", .text = "its two ends"},
    {"polyline", SPH2D_KEY_POINTS, false, LIST_AT(sph2d_obstacle, shape.points.items, shape.points.count), ANY,
     CHOICE(sph2d_obstacle, shape.kind, SPH2D_SHAPE_POLYLINE), .unit = "m", .text = "points, 2 or more, open"},
    {"arc", SPH2D_KEY_GROUP, false, AT(sph2d_obstacle, shape.arc), CHOICE(sph2d_obstacle, shape.kind, SPH2D_SHAPE_ARC),
     .keys = &arc_keys, .unit = "", .text = "a part of a circle, anticlockwise, open; its centre is on its left"},
    {"liquid", SPH2D_KEY_WORD, false, AT(sph2d_obstacle, liquid), .words = liquid_words, .unit = "",
     .default_text = "auto",
     .text =
         "which side of a line, polyline or arc with layers is wet, seen from its first point; auto: where blocks and "
         "sources lie; both: a solid of the layers' thickness, centred on the line; inside: a hollow circle, box or "
         "polygon with its layers around it"},
    {"form", SPH2D_KEY_WORD, false, AT(sph2d_obstacle, form), .words = wall_words, .unit = "",
     .default_text = "the method's",
     .text = "heavy (muller), generalised (not muller): repels by pressure; reflect (muller): reverses "
             "velocities, for large steps"},
    {"restitution", SPH2D_KEY_NUMBER, false, AT(sph2d_obstacle, restitution), BETWEEN(0, 1), .unit = "",
     .default_text = "0.5", .text = "reflect: ratio of normal speeds after and before"},
    {"slip", SPH2D_KEY_WORD, false, AT(sph2d_obstacle, slip), .words = wall_slip_words, .unit = "",
     .default_text = "the scene's wall_slip", .feature = SPH2D_FEATURE_WALL_SLIP,
     .text = "generalised: free slip, no slip (none), or friction by the law of the wall (smooth)"},
    {"motion", SPH2D_KEY_GROUP, false, AT(sph2d_obstacle, motion), .keys = &motion_keys, .unit = "",
     .default_text = "none", .text = "how it moves"},
};
KEYS(obstacle, sph2d_obstacle, obstacle_set);

static const sph2d_key spring_items[] = {
    {"at", SPH2D_KEY_POINT, false, AT(sph2d_spring, at), ANY, .nan_is_unset = true, .unit = "m",
     .default_text = "the centre of mass", .text = "point of the body, where it starts"},
    {"to", SPH2D_KEY_POINT, true, AT(sph2d_spring, to), ANY, .unit = "m", .text = "the fixed point"},
    {"stiffness", SPH2D_KEY_NUMBER, true, AT(sph2d_spring, stiffness), FROM_0, .unit = "N/m^2",
     .text = "force over stretch, per metre of depth"},
    {"damping", SPH2D_KEY_NUMBER, false, AT(sph2d_spring, damping), FROM_0, .unit = "N s/m^2", .default_text = "0",
     .text = "force over the rate of stretch"},
    {"length", SPH2D_KEY_NUMBER, false, AT(sph2d_spring, length), FROM_0, .nan_is_unset = true, .unit = "m",
     .default_text = "as in the scene", .text = "length without force"},
    {"slack", SPH2D_KEY_WORD, false, AT(sph2d_spring, slack), .words = switch_words, .unit = "", .default_text = "off",
     .text = "whether it only pulls, like a rope or chain"},
};
KEYS(spring, sph2d_spring, spring_set);

static const sph2d_key hold_items[] = {
    {"x", SPH2D_KEY_WORD, false, AT(sph2d_hold, x), .words = switch_words, .unit = "", .default_text = "off",
     .text = "whether the centre of mass does not move along x"},
    {"y", SPH2D_KEY_WORD, false, AT(sph2d_hold, y), .words = switch_words, .unit = "", .default_text = "off",
     .text = "the same along y"},
    {"angle", SPH2D_KEY_WORD, false, AT(sph2d_hold, angle), .words = switch_words, .unit = "", .default_text = "off",
     .text = "whether the body does not turn"},
};
KEYS(hold, sph2d_hold, NULL);

static const sph2d_key motor_items[] = {
    {"rate", SPH2D_KEY_NUMBER, false, AT(sph2d_motor, rate), ANY, .unit = "rad/s", .default_text = "0: a brake",
     .text = "the angular velocity that it seeks, anticlockwise"},
    {"torque", SPH2D_KEY_NUMBER, false, AT(sph2d_motor, torque), FROM_0, .unit = "N", .default_text = "0",
     .text = "the largest torque by which it does so, per metre of depth"},
};
KEYS(motor, sph2d_motor, NULL);

static const sph2d_key body_items[] = {
    {"name", SPH2D_KEY_TEXT, false, AT(sph2d_body, name), .unit = "", .default_text = "none",
     .text = "for probes: letters, digits, _ and -"},
    SHAPE(sph2d_body),
    {"density", SPH2D_KEY_NUMBER, false, AT(sph2d_body, density), BETWEEN_OR_0(SPH2D_SMALLEST, SPH2D_LARGEST),
     .unit = "kg/m^3", .default_text = "mass over area", .text = "density; this or the mass must be given"},
    {"mass", SPH2D_KEY_NUMBER, false, AT(sph2d_body, mass), BETWEEN_OR_0(SPH2D_SMALLEST, SPH2D_LARGEST), .unit = "kg/m",
     .default_text = "density times area", .text = "mass per metre of depth"},
    {"inertia", SPH2D_KEY_NUMBER, false, AT(sph2d_body, inertia), BETWEEN_OR_0(SPH2D_SMALLEST, SPH2D_LARGEST),
     .unit = "kg m", .default_text = "of an even density",
     .text = "moment of inertia about the centre of mass, per metre of depth"},
    {"center", SPH2D_KEY_POINT, false, AT(sph2d_body, center), ANY, .nan_is_unset = true, .unit = "m",
     .default_text = "the centroid", .text = "centre of mass, where it starts"},
    {"velocity", SPH2D_KEY_POINT, false, AT(sph2d_body, velocity), ANY, .unit = "m/s", .default_text = "[0, 0]",
     .text = "of the centre of mass at the start"},
    {"rate", SPH2D_KEY_NUMBER, false, AT(sph2d_body, rate), ANY, .unit = "rad/s", .default_text = "0",
     .text = "at which it turns at the start, anticlockwise"},
    {"hold", SPH2D_KEY_GROUP, false, AT(sph2d_body, hold), .keys = &hold_keys, .unit = "", .default_text = "none",
     .text = "motions of the centre of mass that are held at zero; a hinge elsewhere is a stiff spring of length 0"},
    {"springs", SPH2D_KEY_LIST, false, LIST_AT(sph2d_body, springs, spring_count), .keys = &spring_keys, .unit = "",
     .default_text = "none", .text = "springs and moorings to fixed points"},
    {"motor", SPH2D_KEY_GROUP, false, AT(sph2d_body, motor), .keys = &motor_keys, .unit = "", .default_text = "none",
     .text = "what drives its turning, or brakes it"},
    {"friction", SPH2D_KEY_NUMBER, false, AT(sph2d_body, friction), BETWEEN(0, 10), .unit = "", .default_text = "0.3",
     .text = "contacts with walls and bodies: coefficient of dry friction"},
    {"restitution", SPH2D_KEY_NUMBER, false, AT(sph2d_body, restitution), BETWEEN(0, 1), .unit = "",
     .default_text = "0", .text = "contacts: ratio of normal speeds after and before"},
    {"slip", SPH2D_KEY_WORD, false, AT(sph2d_body, slip), .words = wall_slip_words, .unit = "",
     .default_text = "the scene's wall_slip", .feature = SPH2D_FEATURE_WALL_SLIP,
     .text = "generalised: free slip, no slip (none), or friction by the law of the wall (smooth)"},
};
KEYS(body, sph2d_body, body_set);

static const sph2d_key interaction_items[] = {
    {"path", SPH2D_KEY_PATH, true, LIST_AT(sph2d_interaction, path.items, path.count), ANY, .unit = "s, m, m",
     .text = "[t, x, y] points with straight lines between; a single one applies at all times"},
    {"radius", SPH2D_KEY_NUMBER, true, AT(sph2d_interaction, radius), ABOVE_0, .unit = "m", .text = "of its range"},
    {"acceleration", SPH2D_KEY_NUMBER, true, AT(sph2d_interaction, acceleration), ANY, .unit = "m/s^2",
     .text = "at the point, falling to 0 at radius; positive pulls, negative pushes"},
};
KEYS(interaction, sph2d_interaction, interaction_set);

#define RATE(type, member)                                                                                             \
    {"per_second",                                                                                                     \
     SPH2D_KEY_NUMBER,                                                                                                 \
     false,                                                                                                            \
     AT(type, member.per_second),                                                                                      \
     FROM_0,                                                                                                           \
     .unit = "1/s",                                                                                                    \
     .default_text = "none",                                                                                           \
     .text = "outputs per simulated second"},                                                                          \
    {                                                                                                                  \
        "every", SPH2D_KEY_NUMBER, false, AT(type, member.every), FROM_0, .unit = "s", .default_text = "none",         \
                                                                          .text = "simulated seconds between outputs"  \
    }

static const sph2d_key probe_items[] = {
    {"name", SPH2D_KEY_TEXT, true, AT(sph2d_probe, name), .unit = "",
     .text = "of its file NAME.csv: letters, digits, _ and -"},
    {"kind", SPH2D_KEY_WORD, true, AT(sph2d_probe, kind), .words = probe_words, .unit = "",
     .text =
         "of all liquid: energy, momentum, extent, axes, volume, level, quality of the particles; at a point: "
         "speed, pressure, elevation of the surface; of walls: force, work; body; opening; of one particle: tracer"},
    {"at", SPH2D_KEY_POINT, false, AT(sph2d_probe, at), ANY, .nan_is_unset = true, .unit = "m",
     .default_text = "force [0, 0], else must be given",
     .text =
         "position, for the kinds at a point; tracer: the particle nearest to it is followed; force: the point about "
         "which the torque is taken, moving with the obstacle"},
    {"path", SPH2D_KEY_PATH, false, LIST_AT(sph2d_probe, path.items, path.count), ANY, .unit = "s, m, m",
     .default_text = "none",
     .text = "speed, pressure, elevation: [t, x, y] points of its way in place of `at`, with straight lines between"},
    {"on", SPH2D_KEY_TEXT, false, AT(sph2d_probe, on), .unit = "", .default_text = "all walls",
     .text = "force, work: an obstacle's or body's name, or left, right, bottom, top; body, opening: its "
             "name; speed, pressure, elevation: of an obstacle or body that takes `at` along"},
    {"size", SPH2D_KEY_NUMBER, false, AT(sph2d_probe, size), FROM_0, .unit = "m", .default_text = "0, a point",
     .text = "pressure: diameter of the gauge's round face, over which pressure is averaged"},
    {"along", SPH2D_KEY_POINT, false, AT(sph2d_probe, along), ANY, .unit = "", .default_text = "[0, 1]",
     .text = "pressure: direction of that face"},
    {"rise_time", SPH2D_KEY_NUMBER, false, AT(sph2d_probe, rise_time), FROM_0, .nan_is_unset = true, .unit = "s",
     .default_text = "4 h/c0, h the height of the liquid",
     .text = "pressure: rise time of the gauge from 10 to 90 % of a step; 0: what the particles have"},
    RATE(sph2d_probe, rate),
};
KEYS(probe, sph2d_probe, probe_set);

static const sph2d_key snapshots_items[] = {
    RATE(sph2d_snapshots, rate),
    {"compress", SPH2D_KEY_COUNT, false, AT(sph2d_snapshots, compress), BETWEEN(0, 9), .unit = "", .default_text = "0",
     .text = "deflate level; 0 writes plain data"},
};
KEYS(snapshots, sph2d_snapshots, NULL);

static const sph2d_key frames_items[] = {
    RATE(sph2d_frames, rate),
    {"size", SPH2D_KEY_COUNTS2, false, AT(sph2d_frames, size), BETWEEN(16, 16384), .unit = "pixels",
     .default_text = "[1280, 720]", .text = "width and height"},
    {"style", SPH2D_KEY_WORD, false, AT(sph2d_frames, style), .words = style_words, .unit = "",
     .default_text = "metaballs", .text = "a liquid surface, or a dot for each particle"},
    {"look", SPH2D_KEY_WORD, false, AT(sph2d_frames, look), .words = look_words, .unit = "", .default_text = "water",
     .text = "of metaballs: lit water, one flat colour, translucent glass, or ink on white paper"},
    {"background", SPH2D_KEY_WORD, false, AT(sph2d_frames, background), .words = background_words, .unit = "",
     .default_text = "opaque", .text = "of the images; transparent: their pixels have alpha, texts a light halo"},
    {"view", SPH2D_KEY_GROUP, false, AT(sph2d_frames, view), .keys = &box_keys, .unit = "",
     .default_text = "the domain and its walls", .text = "the part of the plane that is shown"},
    {"follow", SPH2D_KEY_TEXT, false, AT(sph2d_frames, follow), .unit = "", .default_text = "none",
     .text = "name of an obstacle or body that stays in the middle of the view"},
    {"radius", SPH2D_KEY_NUMBER, false, AT(sph2d_frames, radius), FROM_0, .unit = "m",
     .default_text = "2 spacings (metaballs), half a spacing (points)", .text = "of a metaball or point"},
    {"color", SPH2D_KEY_TEXT, false, AT(sph2d_frames, color), .unit = "", .default_text = "one colour",
     .text = "the field to colour by: speed, vorticity, Pressures, Densities"},
    {"color_range", SPH2D_KEY_POINT, false, AT(sph2d_frames, color_range), ANY, .unit = "",
     .default_text = "from the scene's height for speed, vorticity and Pressures, else the 1st and 99th "
                     "percentile of what each frame shows",
     .text = "values at the two ends of the colour bar"},
    {"arrows", SPH2D_KEY_WORD, false, AT(sph2d_frames, arrows), .words = switch_words, .unit = "",
     .default_text = "off", .text = "arrows of the velocity on a square lattice"},
    {"arrow_spacing", SPH2D_KEY_NUMBER, false, AT(sph2d_frames, arrow_spacing), FROM_0, .unit = "m",
     .default_text = "a 32nd of the larger side of the view", .text = "side of a square of that lattice"},
    {"arrow_speed", SPH2D_KEY_NUMBER, false, AT(sph2d_frames, arrow_speed), FROM_0, .unit = "m/s",
     .default_text = "from the scene's height", .text = "speed whose arrow is as long as two of these sides"},
    {"streamlines", SPH2D_KEY_WORD, false, AT(sph2d_frames, streamlines), .words = switch_words, .unit = "",
     .default_text = "off", .text = "evenly spaced lines along the velocity of the moment"},
    {"streamline_spacing", SPH2D_KEY_NUMBER, false, AT(sph2d_frames, streamline_spacing), FROM_0, .unit = "m",
     .default_text = "a 40th of the side of a square as large as the view", .text = "distance between these lines"},
    {"isolines", SPH2D_KEY_TEXT, false, AT(sph2d_frames, isolines), .unit = "", .default_text = "none",
     .text = "a field with lines of equal values: speed, vorticity, Pressures, Densities"},
    {"isoline_step", SPH2D_KEY_NUMBER, false, AT(sph2d_frames, isoline_step), FROM_0, .unit = "",
     .default_text = "a round number, for about ten lines", .text = "its difference from line to line"},
    {"caption", SPH2D_KEY_WORD, false, AT(sph2d_frames, caption), .words = switch_words, .unit = "",
     .default_text = "on", .text = "name, time and a scale bar below the picture"},
};
KEYS(frames, sph2d_frames, NULL);

static const sph2d_key run_items[] = {
    {"until", SPH2D_KEY_NUMBER, false, AT(sph2d_run, until), FROM_0, .unit = "s", .default_text = "1",
     .text = "simulated time at the end"},
    {"snapshots", SPH2D_KEY_GROUP, false, AT(sph2d_run, snapshots), .keys = &snapshots_keys, .unit = "",
     .default_text = "none", .text = "HDF5 files"},
    {"frames", SPH2D_KEY_GROUP, false, AT(sph2d_run, frames), .keys = &frames_keys, .unit = "", .default_text = "none",
     .text = "PNG images"},
    {"max_energy_rise", SPH2D_KEY_NUMBER, false, AT(sph2d_run, max_energy_rise), BETWEEN_OR_0(1e-6, 1e9), .unit = "",
     .default_text = "0.1", .text = "bound of the energy guard: energy from nothing over the scene's energy scale"},
    {"impacts", SPH2D_KEY_NUMBERS, false, LIST_AT(sph2d_run, impacts.items, impacts.count), FROM_0, .unit = "s",
     .default_text = "none", .text = "times of known impacts; the mean compression leaves out 0.05 s after each"},
};
KEYS(run, sph2d_run, NULL);

static const sph2d_key boundary_items[] = {
    {"left", SPH2D_KEY_WORD, false, AT(sph2d_boundary, left), .words = side_words, .unit = "", .default_text = "wall",
     .text = "left side"},
    {"right", SPH2D_KEY_WORD, false, AT(sph2d_boundary, right), .words = side_words, .unit = "", .default_text = "wall",
     .text = "right side"},
    {"bottom", SPH2D_KEY_WORD, false, AT(sph2d_boundary, bottom), .words = side_words, .unit = "",
     .default_text = "wall", .text = "bottom side"},
    {"top", SPH2D_KEY_WORD, false, AT(sph2d_boundary, top), .words = side_words, .unit = "", .default_text = "open",
     .text = "top side"},
};
KEYS(boundary, sph2d_boundary, NULL);

static const sph2d_key wall_speeds_items[] = {
    {"left", SPH2D_KEY_NUMBER, false, AT(sph2d_side_speeds, left), ANY, .unit = "m/s", .default_text = "0",
     .text = "upwards"},
    {"right", SPH2D_KEY_NUMBER, false, AT(sph2d_side_speeds, right), ANY, .unit = "m/s", .default_text = "0",
     .text = "upwards"},
    {"bottom", SPH2D_KEY_NUMBER, false, AT(sph2d_side_speeds, bottom), ANY, .unit = "m/s", .default_text = "0",
     .text = "to the right"},
    {"top", SPH2D_KEY_NUMBER, false, AT(sph2d_side_speeds, top), ANY, .unit = "m/s", .default_text = "0",
     .text = "to the right"},
};
KEYS(wall_speeds, sph2d_side_speeds, NULL);

#define SIDE_SLIP(side)                                                                                                \
    {                                                                                                                  \
#side, SPH2D_KEY_WORD, false, AT(sph2d_side_slips, side),                                                      \
            .words = wall_slip_words, .unit = "", .default_text = "the scene's wall_slip",                             \
            .feature = SPH2D_FEATURE_WALL_SLIP, .text = #side " side"                                                  \
    }

static const sph2d_key side_slip_items[] = {SIDE_SLIP(left), SIDE_SLIP(right), SIDE_SLIP(bottom), SIDE_SLIP(top)};
KEYS(side_slip, sph2d_side_slips, NULL);

static const sph2d_key central_force_items[] = {
    {"center", SPH2D_KEY_POINT, false, AT(sph2d_central_force, center), ANY, .unit = "m", .default_text = "[0, 0]",
     .text = "where it is zero"},
    {"rate", SPH2D_KEY_NUMBER, false, AT(sph2d_central_force, rate), FROM_0, .unit = "1/s", .default_text = "0",
     .text = "B in the acceleration -B^2 (x - center)"},
};
KEYS(central_force, sph2d_central_force, NULL);

static void set_material(void *fluid)
{
    sph2d_fluid *f = fluid;
    *f = sph2d_fluid_of(f->material);
}

static const sph2d_key fluid_items[] = {
    {"material", SPH2D_KEY_WORD, false, AT(sph2d_fluid, material), .words = material_words, .unit = "",
     .default_text = "none", .stands_alone = true, .preset = set_material,
     .text =
         "its density and viscosity, or the model of one that has no single viscosity, unless they are given; short "
         "form `fluid: water`; `help materials` lists the values"},
    {"density", SPH2D_KEY_NUMBER, false, AT(sph2d_fluid, density), ABOVE_0, .unit = "kg/m^3", .default_text = "1000",
     .text = "rest density"},
    {"dynamic_viscosity", SPH2D_KEY_NUMBER, false, AT(sph2d_fluid, dynamic_viscosity), FROM_0, .unit = "Pa s",
     .default_text = "0.001", .text = "water 0.001, oil 0.08, honey 19"},
    {"surface_tension", SPH2D_KEY_NUMBER, false, AT(sph2d_fluid, surface_tension), FROM_0, .unit = "N/m",
     .default_text = "0", .feature = SPH2D_FEATURE_SURFACE_TENSION, .text = "of the free surface"},
    {"model", SPH2D_KEY_WORD, false, AT(sph2d_fluid, model), .words = rheology_words, .unit = "",
     .default_text = "newtonian", .feature = SPH2D_FEATURE_RHEOLOGY,
     .text = "how viscosity depends on the shear rate; herschel_bulkley with index 1 is Bingham's liquid"},
    {"consistency", SPH2D_KEY_NUMBER, false, AT(sph2d_fluid, consistency), FROM_0, .unit = "Pa s^n",
     .default_text = "none", .text = "of power_law and herschel_bulkley, which need one above 0: stress K rate^n"},
    {"index", SPH2D_KEY_NUMBER, false, AT(sph2d_fluid, index), BETWEEN_OR_0(0.1, 3), .unit = "", .default_text = "1",
     .text = "n; below 1 for liquid that gets thinner as it is sheared"},
    {"yield_stress", SPH2D_KEY_NUMBER, false, AT(sph2d_fluid, yield_stress), FROM_0, .unit = "Pa",
     .default_text = "none", .text = "of herschel_bulkley, which needs one above 0: below it liquid does not flow"},
    {"regularisation", SPH2D_KEY_NUMBER, false, AT(sph2d_fluid, regularisation), FROM_0, .unit = "s",
     .default_text = "100 L/sqrt(2 E), L the smaller side, E the energy per mass",
     .text = "m: slower shear than 1/m has a bounded viscosity, at most K m^(1-n) + m yield_stress"},
    {"infinite_viscosity", SPH2D_KEY_NUMBER, false, AT(sph2d_fluid, infinite_viscosity), FROM_0, .unit = "Pa s",
     .default_text = "0", .text = "of carreau, at high shear rates; dynamic_viscosity is that at rest"},
    {"relaxation_time", SPH2D_KEY_NUMBER, false, AT(sph2d_fluid, relaxation_time), FROM_0, .unit = "s",
     .default_text = "none", .text = "of carreau: one over the shear rate from which on it gets thinner"},
    COLOR(sph2d_fluid, "the material's",
          "in pictures: a name, red or orange, or \"#ff8000\"; where one is given, here or below, each particle keeps "
          "its own"),
};
KEYS(fluid, sph2d_fluid, NULL);

static const sph2d_key method_items[] = {
    {"name", SPH2D_KEY_WORD, false, AT(sph2d_method_options, name), .words = method_words, .unit = "",
     .default_text = "wcsph", .stands_alone = true, .text = "the solver; short form `method: wcsph`"},
    {"operators", SPH2D_KEY_WORD, false, AT(sph2d_method_options, operators), .words = operator_words, .unit = "",
     .default_text = "variational", .feature = SPH2D_FEATURE_OPERATORS,
     .text = "variational: for everything; fitted is of second order, for liquid that fills its domain"},
    {"kernel", SPH2D_KEY_WORD, false, AT(sph2d_method_options, kernel), .words = kernel_words, .unit = "",
     .default_text = "wendland_c2", .feature = SPH2D_FEATURE_KERNEL, .text = "the smoothing kernel"},
    {"density_diffusion", SPH2D_KEY_NUMBER, false, AT(sph2d_method_options, density_diffusion), BETWEEN(0, 1),
     .unit = "", .default_text = "0.1", .feature = SPH2D_FEATURE_DENSITY_DIFFUSION,
     .text = "delta; the diffusivity of density is delta c0 H/2"},
    {"artificial_viscosity", SPH2D_KEY_NUMBER, false, AT(sph2d_method_options, artificial_viscosity), BETWEEN(0, 1),
     .unit = "", .default_text = "0.1", .feature = SPH2D_FEATURE_ARTIFICIAL_VISCOSITY,
     .text = "alpha; pcisph adds the viscosity alpha sqrt(g h) H/16, h the scene's head, to what of "
             "velocities is not linear; that of muller is alpha rho c0 H at least"},
    {"shifting", SPH2D_KEY_NUMBER, false, AT(sph2d_method_options, shifting), BETWEEN(0, 2), .unit = "",
     .default_text = "1", .feature = SPH2D_FEATURE_SHIFTING,
     .text = "strength of particle shifting over the standard one"},
    {"max_compression", SPH2D_KEY_NUMBER, false, AT(sph2d_method_options, max_compression), BETWEEN_OR_0(1e-6, 0.9),
     .unit = "", .default_text = "muller 0.1, else 0.01",
     .text = "target of rho/rho0 - 1, except in impacts; determines the sound speed"},
    {"stiffness", SPH2D_KEY_NUMBER, false, AT(sph2d_method_options, stiffness), FROM_0, .unit = "m^2/s^2",
     .default_text = "from max_compression",
     .text = "k in p = k (rho - rho0); c0^2 = k, for muller times the factor of its pair force"},
    {"sound_speed", SPH2D_KEY_NUMBER, false, AT(sph2d_method_options, sound_speed), FROM_0, .unit = "m/s",
     .default_text = "from max_compression", .text = "c0, instead of stiffness"},
    {"support_ratio", SPH2D_KEY_NUMBER, false, AT(sph2d_method_options, support_ratio), BETWEEN_OR_0(1.2, 6),
     .unit = "",
     .default_text =
         "muller 2.0, wcsph 3.0 (variational) or 2.5 (fitted), constraint 3.0, pcisph 2.4 or, with wendland_c4, 2.75",
     .text = "support radius over spacing, H/dx; pcisph needs 1.78, with wendland_c4 2.04, fitted "
             "at most 3 for flows with little viscosity, hybrid 2 to 2.6"},
    {"cfl", SPH2D_KEY_NUMBER, false, AT(sph2d_method_options, cfl), BETWEEN_OR_0(0.01, 0.9), .unit = "",
     .default_text =
         "muller 0.4, wcsph 0.2 (variational) or 0.25 (fitted), hybrid 0.9, constraint 0.8 dx/H, pcisph 0.4 dx/H",
     .text = "step limit: dt <= cfl H / (c0 + v_max); pcisph and constraint without c0 and at most "
             "dx/H, variational operators at most 0.25, whose steps are up to five of these"},
    {"time_step", SPH2D_KEY_NUMBER, false, AT(sph2d_method_options, time_step), FROM_0, .unit = "s",
     .default_text = "adaptive", .text = "a fixed step"},
    {"tolerance", SPH2D_KEY_NUMBER, false, AT(sph2d_method_options, tolerance), BETWEEN_OR_0(1e-12, 0.1), .unit = "",
     .default_text = "0.005", .feature = SPH2D_FEATURE_TOLERANCE,
     .text = "what may be left of a step's equations, over their right side"},
    {"max_iterations", SPH2D_KEY_COUNT, false, AT(sph2d_method_options, max_iterations), BETWEEN(1, 100000), .unit = "",
     .default_text = "1000", .feature = SPH2D_FEATURE_MAX_ITERATIONS, .text = "maximum number of iterations per step"},
};
KEYS(method, sph2d_method_options, NULL);

#define LIST(word, member, singular, meaning)                                                                          \
    {                                                                                                                  \
        word, SPH2D_KEY_LIST, false, LIST_AT(sph2d_scene, member, singular##_count),                                   \
            .keys = &singular##_keys, .unit = "", .default_text = "none", .text = meaning                              \
    }

static const sph2d_key scene_items[] = {
    {"name", SPH2D_KEY_TEXT, false, AT(sph2d_scene, name), .unit = "", .default_text = "scene",
     .text = "title of the scene"},
    {"domain", SPH2D_KEY_GROUP, true, AT(sph2d_scene, domain), .keys = &box_keys, .unit = "",
     .text = "the simulated rectangle"},
    {"boundary", SPH2D_KEY_GROUP, false, AT(sph2d_scene, boundary), .keys = &boundary_keys, .unit = "",
     .text = "kinds of its sides"},
    {"walls", SPH2D_KEY_WORD, false, AT(sph2d_scene, walls), .words = wall_words, .unit = "",
     .default_text = "muller spring, else generalised", .text = "form of the sides that are walls"},
    {"wall_slip", SPH2D_KEY_WORD, false, AT(sph2d_scene, wall_slip), .words = slip_words, .unit = "",
     .default_text = "free", .feature = SPH2D_FEATURE_WALL_SLIP,
     .text = "generalised walls: free slip, no slip (none), or friction by the law of the wall (smooth)"},
    {"side_slip", SPH2D_KEY_GROUP, false, AT(sph2d_scene, side_slip), .keys = &side_slip_keys, .unit = "",
     .default_text = "none", .text = "slip of single sides, in place of wall_slip; obstacles have `slip`"},
    {"slip_length", SPH2D_KEY_NUMBER, false, AT(sph2d_scene, slip_length), FROM_0, .unit = "m", .default_text = "0",
     .text = "smooth walls: slip length, distance behind the wall where the velocity equals the wall's"},
    {"wall_speeds", SPH2D_KEY_GROUP, false, AT(sph2d_scene, wall_speeds), .keys = &wall_speeds_keys, .unit = "",
     .default_text = "none", .text = "tangential speeds of sides, unless free-slip"},
    {"wall_damping", SPH2D_KEY_NUMBER, false, AT(sph2d_scene, wall_damping), BETWEEN(0, 1), .unit = "",
     .default_text = "0.1", .text = "spring walls: damping over critical damping"},
    {"gravity", SPH2D_KEY_POINT, false, AT(sph2d_scene, gravity), ANY, .unit = "m/s^2", .default_text = "[0, -9.81]",
     .text = "acceleration"},
    {"gravity_path", SPH2D_KEY_PATH, false, LIST_AT(sph2d_scene, gravity_path.items, gravity_path.count), ANY,
     .unit = "s, m/s^2, m/s^2", .default_text = "none",
     .text =
         "gravity in time in place of `gravity`: [t, gx, gy] points with straight lines between, constant before and "
         "after"},
    {"gravity_file", SPH2D_KEY_TEXT, false, AT(sph2d_scene, gravity_file), .unit = "", .default_text = "none",
     .text =
         "a CSV file with columns t and any of gx, gy: the gravity_path; one that is not there is that of `gravity`"},
    {"motion", SPH2D_KEY_GROUP, false, AT(sph2d_scene, motion), .keys = &motion_keys, .unit = "",
     .default_text = "none",
     .text =
         "of the tank with all in it: positions, velocities and probes are those seen from the tank; a path is cubic"},
    {"central_force", SPH2D_KEY_GROUP, false, AT(sph2d_scene, central_force), .keys = &central_force_keys, .unit = "",
     .default_text = "none", .text = "a pull towards a centre, proportional to distance"},
    {"spacing", SPH2D_KEY_NUMBER, true, AT(sph2d_scene, spacing), ABOVE_0, .unit = "m", .text = "between particles"},
    {"fluid", SPH2D_KEY_GROUP, false, AT(sph2d_scene, fluid), .keys = &fluid_keys, .unit = "", .text = "the liquid"},
    {"method", SPH2D_KEY_GROUP, false, AT(sph2d_scene, method), .keys = &method_keys, .unit = "",
     .text = "the solver and its parameters"},
    LIST("blocks", blocks, block, "liquid at the start"),
    {"particles", SPH2D_KEY_TEXT, false, AT(sph2d_scene, particles.file), .unit = "", .default_text = "none",
     .text =
         "a CSV file of particles: x, y, optionally vx, vy, density, color (a number, 65536 red + 256 green + blue)"},
    {"start", SPH2D_KEY_GROUP, false, AT(sph2d_scene, start), .keys = &start_keys, .unit = "", .default_text = "none",
     .text = "what these particles start with; with a snapshot and no particles: the liquid of the snapshot"},
    LIST("sources", sources, source, "nozzles that emit liquid"),
    LIST("drains", drains, drain, "areas that remove liquid"),
    LIST("absorbers", absorbers, absorber, "ends where waves die out, so that they do not come back"),
    LIST("openings", openings, opening, "parts of sides through which liquid flows in or out, wcsph"),
    LIST("obstacles", obstacles, obstacle, "walls of boundary particles, fixed or moving"),
    LIST("bodies", bodies, body,
         "rigid bodies that the liquid moves; contacts keep them a fifth of a spacing from walls and each other, so "
         "that one drawn on a floor rises by that"),
    LIST("interactions", interactions, interaction, "pull or push at a moving point"),
    LIST("probes", probes, probe, "time series"),
    {"run", SPH2D_KEY_GROUP, false, AT(sph2d_scene, run), .keys = &run_keys, .unit = "",
     .text = "duration and outputs"},
};
KEYS(scene, sph2d_scene, scene_set);

const sph2d_keys *sph2d_scene_keys(void)
{
    return &scene_keys;
}
