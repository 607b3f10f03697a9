/* SPDX-License-Identifier: MIT */
/** @file scene.h
 *  What a scene is: plain structs. SI units throughout; in two dimensions masses and forces are per metre of depth.
 *  H is the support radius, beyond which kernels are zero; the smoothing length h of the literature is H/2.
 *
 *      sph2d_scene scene = sph2d_scene_default();
 *      scene.domain = (sph2d_box){{0, 0}, {1, 1}};
 *      scene.spacing = 0.02;
 *      sph2d_block column = sph2d_block_default();
 *      column.shape.kind = SPH2D_SHAPE_BOX;
 *      column.shape.box = (sph2d_box){{0, 0}, {0.4, 0.6}};
 *      scene.blocks = &column;
 *      scene.block_count = 1;
 *
 *  Start from sph2d_scene_default(), set what you need, pass it to sph2d_sim_create(), which copies everything: lists
 *  and strings are borrowed from the caller and may be on the stack. A scene file has the same keys in the same
 *  structure (sph2d/key.h is the table of both), so that a C program and a file get the same checks and messages.
 *
 *  In fields documented with "0: derived" or "0: none" zero means that the value is not given. Words, such as wcsph and
 *  lattice, denote the enumerators of scene_words.h. */
#ifndef SPH2D_SCENE_H
#define SPH2D_SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "sph2d/export.h"
#include "sph2d/flow.h"
#include "sph2d/scene_words.h"
#include "sph2d/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A point, velocity or acceleration. */
typedef struct sph2d_vec2 {
    /** x to the right, y upwards. */
    double x, y;
} sph2d_vec2;

/** An axis-aligned rectangle, min < max in both directions [m]. */
typedef struct sph2d_box {
    /** Lower left and upper right corner. */
    sph2d_vec2 min, max;
} sph2d_box;

/** A circle, or the disc within it. */
typedef struct sph2d_circle {
    /** Centre [m]. */
    sph2d_vec2 center;

    /** Radius [m], > 0. */
    double radius;
} sph2d_circle;

/** A part of a circle, from one angle anticlockwise to another. */
typedef struct sph2d_arc {
    /** Centre [m]. */
    sph2d_vec2 center;

    /** Radius [m], > 0. */
    double radius;

    /** Angles from the x axis, anticlockwise [rad], from < to, less than a full turn apart. */
    double from, to;
} sph2d_arc;

/** A list of points. */
typedef struct sph2d_points {
    /** The points [m], borrowed. */
    const sph2d_vec2 *items;

    /** Number of points. */
    size_t count;
} sph2d_points;

/** How often an output is due. Give one of the two, or neither for no output. */
typedef struct sph2d_rate {
    /** Outputs per simulated second [1/s], >= 0; default 0: none. */
    double per_second;

    /** Simulated seconds between outputs [s], >= 0; default 0: none. */
    double every;
} sph2d_rate;

/** A closed shape or a line: a kind, and its field. Blocks, drains and bodies have closed ones. */
typedef struct sph2d_shape {
    /** Which of the fields below is used. */
    sph2d_shape_kind kind;

    /** A rectangle. */
    sph2d_box box;

    /** A circle. */
    sph2d_circle circle;

    /** The vertices of a polygon, 3 to 10000, closed automatically; the ends of a line; the points of a polyline, 2 or
     *  more. */
    sph2d_points points;

    /** A part of a circle: its centre is on its left. */
    sph2d_arc arc;

    /** A file and an id in it, `harbour.svg#quay`, borrowed; NULL once it is read. */
    const char *svg;
} sph2d_shape;

/** Boundary conditions at the four sides of the domain. */
typedef struct sph2d_boundary {
    /** The sides; default wall, wall, wall, open. */
    sph2d_side left, right, bottom, top;
} sph2d_boundary;

/** Tangential speeds of wall sides, like a lid or a belt [m/s]; default 0. */
typedef struct sph2d_side_speeds {
    /** Of the vertical sides, upwards. */
    double left, right;

    /** Of the horizontal sides, to the right. */
    double bottom, top;
} sph2d_side_speeds;

/** Slip or friction of wall sides of their own; default that of the scene. */
typedef struct sph2d_side_slips {
    /** The sides. */
    sph2d_wall_slip left, right, bottom, top;
} sph2d_side_slips;

/** A force towards a centre that grows with the distance: acceleration -rate^2 (x - center). */
typedef struct sph2d_central_force {
    /** Where it is zero [m]; default (0, 0). */
    sph2d_vec2 center;

    /** Rate B [1/s], >= 0; default 0: none. */
    double rate;
} sph2d_central_force;

/** Properties of a material, at 20 C unless its source says otherwise. */
typedef struct sph2d_material_data {
    /** Word of scene files, "water". */
    const char *name;

    /** Density [kg/m^3]. */
    double density;

    /** Dynamic viscosity [Pa s]; of Carreau's liquid that at rest, 0 for those of the other models but newtonian. */
    double dynamic_viscosity;

    /** Surface tension against air [N/m]; 0: no reliable value is known. */
    double surface_tension;

    /** Source of the values, with the temperature of those that are not at 20 C. */
    const char *source;

    /** How viscosity depends on the shear rate, and the numbers of that law, as in sph2d_fluid; 0 for those that are no
     *  part of it. */
    sph2d_rheology model;
    double consistency, index, yield_stress, infinite_viscosity, relaxation_time;

    /** In pictures, as sph2d_color_parse() reads it; NULL: as the look has water. */
    const char *color;
} sph2d_material_data;

/** The liquid. */
typedef struct sph2d_fluid {
    /** The material that a file names; its properties are in the fields below, as from sph2d_fluid_of(). One with a
     *  model keeps its dynamic viscosity, unless it is made newtonian with one of its own. Default none. */
    sph2d_material material;

    /** Rest density [kg/m^3], > 0; default 1000. */
    double density;

    /** Dynamic viscosity [Pa s], >= 0; default 0.001, of water. Of Carreau's liquid that at rest; of the other models
     *  but newtonian not used. */
    double dynamic_viscosity;

    /** How viscosity depends on the shear rate: wcsph with variational operators, constraint; default newtonian. */
    sph2d_rheology model;

    /** power_law, herschel_bulkley: K [Pa s^n], > 0; must be given. */
    double consistency;

    /** n, 0.1 to 3; less than 1 where liquid gets thinner as it is sheared; default 0: 1, for carreau it must be given. */
    double index;

    /** herschel_bulkley: the stress below which it does not flow [Pa], > 0; must be given. */
    double yield_stress;

    /** power_law, herschel_bulkley: slower shear than one over this, m [s], has a bounded viscosity, at most
     *  K m^(1-n) + m yield_stress; default 100 L/sqrt(2 E), L the smaller side of the domain and E the energy per mass
     *  that the scene has at the start: head, speed and pull. */
    double regularisation;

    /** carreau: the viscosity at a high shear rate [Pa s], >= 0; default 0. */
    double infinite_viscosity;

    /** carreau: one over the shear rate from which on it gets thinner [s], > 0; must be given. */
    double relaxation_time;

    /** Surface tension [N/m], >= 0; default 0: none. All methods but wcsph with fitted operators. Surfaces meet layered
     *  walls at a right angle; other walls are not wetted. */
    double surface_tension;

    /** Colour in pictures, "red" or "#ff0000" (sph2d_color_parse); default NULL: the material's, or that of the look. Where
     *  this, or a block, source or opening, has one, each particle keeps a colour of its own, the field "Colors". */
    const char *color;
} sph2d_fluid;

/** The solver and its parameters. A method rejects options that it does not have, unless they are at their default. */
typedef struct sph2d_method_options {
    /** The solver; default wcsph. */
    sph2d_method name;

    /** wcsph: discretisation of derivatives; default variational. */
    sph2d_operators operators;

    /** wcsph with variational operators, pcisph, constraint: the smoothing kernel; default wendland_c2. */
    sph2d_kernel kernel;

    /** wcsph, fitted operators: delta of delta-SPH, 0 to 1: density diffuses with delta h c0, where h = H/2 is the smoothing length;
     *  default 0.1. */
    double density_diffusion;

    /** muller: alpha, 0 to 1; the dynamic viscosity is at least alpha rho c0 H, since its pressure force does not
     *  conserve energy; default 0 means 0.1, with which energy does not grow. pcisph: adds the kinematic
     *  viscosity alpha h U / 8 (Monaghan 1992), h = H/2, U^2 = g h_0 + u^2/2 at the start, to what of the velocities around a particle is not
     *  linear (Frontiere, Raskin & Owen 2017); default 0 means 0.1, with which liquid at rest is still. */
    double artificial_viscosity;

    /** wcsph, fitted operators: strength of particle shifting over the standard one, 0 to 2; default 1. */
    double shifting;

    /** Intended compression rho/rho0 - 1, impacts excluded, 1e-6 to 0.9; default 0: the method's, muller 0.1, the
     *  others 0.01. Determines the sound speed: c0^2 = 2 (g h + U^2/2 + pull) / max_compression with h the height of
     *  the liquid above the lowest point that walls and obstacles at rest let it reach, U the largest speed at the
     *  start, of a source, of a wall, or that a body gets by springs that are stretched at the start, pull the
     *  strongest interaction's acceleration * radius / 2, and 2 for the overshoot after a release. pcisph keeps it in
     *  every step, and its sound speed is for a tenth of it. */
    double max_compression;

    /** Stiffness k in p = k (rho - rho0) [m^2/s^2], >= 0; default 0: derived as above. k = c0^2, except for muller,
     *  whose pair forces have half the stress: c0^2 = 0.443 k at H/dx = 2, as `check` prints, and the reported pressure
     *  is that of the stress. */
    double stiffness;

    /** Sound speed c0, instead of stiffness [m/s], >= 0; default 0: derived as above. */
    double sound_speed;

    /** Support radius over spacing, H/dx, 1.2 to 6; default 0: the method's, muller 2.0, wcsph 3.0 with variational
     *  and 2.5 with fitted operators; constraint 3.0; pcisph 2.4 with wendland_c2 (1.78 at least), 2.75 with
     *  wendland_c4 (2.04): neighbours must contribute a third of the density. */
    double support_ratio;

    /** Step limit: dt <= cfl H / (c0 + v_max), and without c0 for pcisph and constraint, 0.01 to 0.9,
     *  variational operators to 0.25, pcisph and constraint to dx/H; default 0: the method's, muller 0.4, wcsph 0.2 with
     *  variational operators (a step is up to five of these) and 0.25 with fitted ones, pcisph 0.4 dx/H, constraint
     *  0.8 dx/H (half of it where liquid fills its domain; a step is also at most dx/sqrt(head), the head that of the sound speed), hybrid 0.9: its step
     *  is cfl H / sqrt(2 head) throughout, the head that of the sound speed of other methods. */
    double cfl;

    /** A fixed step [s], >= 0; default 0: adaptive. */
    double time_step;

    /** constraint: tolerance of the solver, what may be left of its equations over their right side, both as the root of the
     *  sum of squares, 1e-12 to 0.1; default 0 means 5e-3. */
    double tolerance;

    /** pcisph, constraint: largest number of iterations in a step, 1 to 100000; default 1000. */
    uint64_t max_iterations;
} sph2d_method_options;

/** Random displacement of a block's particles: each coordinate by up to `amplitude` spacings, uniformly distributed. */
typedef struct sph2d_perturb {
    /** Largest displacement [spacings], 0 to 0.5; default 0. */
    double amplitude;

    /** Seed of the random numbers; default 1. */
    uint64_t seed;
} sph2d_perturb;

/** Velocity and pressure over a rectangular grid of places, whose lines may be any distances apart. Between them they are
 *  interpolated by cubics along x and y (Hermite's, with slopes of the polynomial through five points, fewer where the grid
 *  has fewer): cubic fields are exact, others to the fourth order, and their gradients are continuous. */
typedef struct sph2d_grid {
    /** A CSV file with columns x, y and any of vx, vy, pressure, its rows in any order, which only
     *  sph2d_scene_file_read() reads: a run is resumed without it. NULL: none. */
    const char *file;

    /** Grid lines [m], increasing, borrowed. */
    const double *x, *y;

    /** Their numbers, 2 at least; default 0: none. */
    size_t nx, ny;

    /** Velocity [m/s] and pressure [Pa] at (x[i], y[j]), in [j nx + i], borrowed; NULL: not given. */
    const double *vx, *vy, *pressure;
} sph2d_grid;

/** A particle of a snapshot. */
typedef struct sph2d_cloud_point {
    /** Position [m]. */
    double x, y;

    /** Velocity [m/s]. */
    double vx, vy;

    /** Pressure [Pa]. */
    double pressure;
} sph2d_cloud_point;

/** The liquid of another run. Between its particles velocity and pressure are interpolated by moving least squares within
 *  2.5 spacings, its own or the scene's, whichever is larger: quadratic fields are exact inside the liquid, linear ones on
 *  its surface. Where the particles do not determine a gradient, as beside a jet of one row, it is the mean by their
 *  weights (Shepard 1968). */
typedef struct sph2d_cloud {
    /** A snapshot, which only sph2d_scene_file_read() reads: a run is resumed without it. NULL: none. */
    const char *file;

    /** Its particles, borrowed. */
    const sph2d_cloud_point *items;

    /** Their number. */
    size_t count;

    /** Their spacing [m], > 0 if there are any. */
    double spacing;
} sph2d_cloud;

/** What liquid has at the start: one of these, or nothing. */
typedef struct sph2d_start {
    /** A known flow: its velocity is added, and with method wcsph the liquid starts at its pressure; default none. That of
     *  the first block that has one is what an `error` probe compares with. */
    sph2d_flow flow;

    /** Values over places; all of the liquid must lie within the grid. Without a pressure the liquid keeps its own. */
    sph2d_grid table;

    /** Another run's liquid. Where it has no particle within 2.5 spacings the liquid keeps its own velocity and
     *  pressure. */
    sph2d_cloud snapshot;

    /** The largest speed of the table or snapshot, for the sound speed [m/s], >= 0; default 0: that of its values, where
     *  they are known. */
    double top_speed;
} sph2d_start;

/** A region of liquid at the start. Its particles fill the shape, except for solids in it, within 0.2 % or half a
 *  particle: on a square lattice for boxes with or without cut-outs, if that has the right area and no lattice site is
 *  lost near a wall with layers; on a box's lattice stretched by at most 2 %, or another shape's lattice shifted, if no
 *  wall is near; otherwise packed: as many particles as the area holds relax away from edges and walls until a uniform
 *  pressure would exert no force on them. Near obstacles without layers lattices are not changed, and sites inside or
 *  closer than 0.7 spacings stay empty. */
typedef struct sph2d_block {
    /** Its area: box, disc or polygon; must be given. */
    sph2d_shape shape;

    /** Velocity at the start [m/s]; default (0, 0). */
    sph2d_vec2 velocity;

    /** A known flow, a table or a snapshot that it starts with, besides its velocity; default none. */
    sph2d_start start;

    /** Spacing of this block's particles [m], >= 0; default 0: the scene's. Particle mass is always that of the scene's
     *  spacing, so that with a smaller one the block starts compressed. */
    double spacing;

    /** Arrangement of its particles; default lattice; rings only for discs. */
    sph2d_arrangement arrangement;

    /** Random displacement of its particles; default none. */
    sph2d_perturb perturb;

    /** Colour of its particles, as sph2d_fluid has it; default NULL: the fluid's. */
    const char *color;
} sph2d_block;

/** A fluid particle at the start. */
typedef struct sph2d_particle {
    /** Position [m]. */
    double x, y;

    /** Velocity [m/s]. */
    double vx, vy;

    /** Density [kg/m^3], > 0; 0: that of the pressure by the scene's `start`, or else the rest density. muller computes
     *  its own. */
    double density;

    /** Colour, 0xRRGGBB as a number (sph2d_color_parse), up to 0xffffff; default 0: the fluid's, as in all scenes where
     *  nothing gives one. */
    double color;
} sph2d_particle;

/** Individual particles, besides those of blocks. Their mass is that of the scene's spacing. The sound speed is not
 *  derived from them: the method must give it. */
typedef struct sph2d_particles {
    /** A CSV file with columns x, y and perhaps vx, vy, density, color (defaults 0), which only sph2d_scene_file_read() reads: a run is resumed without it. NULL: none. */
    const char *file;

    /** The particles, borrowed. */
    const sph2d_particle *items;

    /** Number of particles. */
    size_t count;
} sph2d_particles;

/** A nozzle that emits rows of particles. Particles whose position is occupied are not emitted, and counted. */
typedef struct sph2d_source {
    /** Centre of the nozzle [m]; must be given. */
    sph2d_vec2 at;

    /** Direction of the jet, of any length but zero; default (0, -1). */
    sph2d_vec2 direction;

    /** Width of the nozzle [m], >= 0; at least one spacing is used; default 0. */
    double width;

    /** Speed of the jet [m/s], > 0; must be given. */
    double speed;

    /** Random variation of each velocity component, as a fraction of speed, 0 to 1; default 0. */
    double spread;

    /** Area of liquid per second [m^2/s], at most width * speed; default 0: width * speed. */
    double rate;

    /** When it opens and closes [s], >= 0; default 0 and 0: always open. */
    double start, stop;

    /** Seed of the random spread; default 1. */
    uint64_t seed;

    /** Colour of its liquid, as sph2d_fluid has it; default NULL: the fluid's. */
    const char *color;
} sph2d_source;

/** An area where particles are removed, and counted. */
typedef struct sph2d_drain {
    /** Its area: box, disc or polygon; must be given. */
    sph2d_shape shape;

    /** When it opens and closes [s], >= 0; default 0 and 0: always open. */
    double start, stop;
} sph2d_drain;

/** An absorbing end: near a side the velocity of the liquid decays, so that waves do not come back from it. The rate of
 *  decay grows from 0 at `length` from the side to `rate` there, as the square of the distance. Where the side has an
 *  opening only the velocity along the side decays, and a current goes on. Bodies are not held. */
typedef struct sph2d_absorber {
    /** The side, not periodic; must be given. */
    sph2d_side_name side;

    /** How far it reaches into the domain [m], > 0, best a wavelength or more; must be given. */
    double length;

    /** Rate of decay at the side [1/s], >= 0; default 0: 3 sqrt(g/length), 1.2 times the angular frequency of waves in
     *  deep water that are as long; twice that where the side has an opening. Must be given without gravity. */
    double rate;
} sph2d_absorber;

/** A point of a path: a position at a time. */
typedef struct sph2d_path_point {
    /** Time [s] and position [m]. */
    double t, x, y;
} sph2d_path_point;

/** A piecewise linear function of time, undefined before the first point and after the last. A single point holds
 *  always. */
typedef struct sph2d_path {
    /** The points, borrowed, with increasing times. */
    const sph2d_path_point *items;

    /** Number of points. */
    size_t count;
} sph2d_path;

/** Points (t, value) with increasing t, borrowed: straight lines between them, constant before and after. */
typedef struct sph2d_history {
    const sph2d_vec2 *items;
    size_t count;
} sph2d_history;

/** What an opening prescribes over time: at most one of these. */
typedef struct sph2d_opening_history {
    /** [m/s], [m^2/s], [Pa], [m]; default none. */
    sph2d_history velocity, flow_rate, pressure, level;

    /** Velocity into the domain over place and time: points (t, s, velocity) with s in x, the place along the side, y of
     *  left and right, x of bottom and top [m], and the velocity in y [m/s]; the same places, increasing and to both ends
     *  of the opening, at each of increasing times. Cubics between places (as of sph2d_grid), straight lines between times,
     *  constant before and after; default none. */
    sph2d_path profile;

    /** A CSV file with columns t and one of velocity, flow_rate, pressure, level, relative to the scene's file, or y (of
     *  bottom and top x) and velocity, for several times with t; read with the scene, where it becomes the list. NULL:
     *  none. */
    const char *file;
} sph2d_opening_history;

/** An opening: a part of a side that is a wall, through which liquid flows in or out; method wcsph, generalised walls;
 *  with fitted operators without a level or a free surface. Just one of velocity, flow_rate, pressure and level is given, by a number or over
 *  time, a velocity also over place and time. Behind it, outside the domain,
 *  is a reservoir, some support radii long, full of particles that move as prescribed: with velocity or flow_rate they
 *  have that velocity and the pressure of the liquid before them, with pressure that pressure and the velocity of the
 *  liquid before them, in either direction. Changes as fast as sound crosses the domain leave through the opening
 *  (Lastiwka, Basa & Quinlan 2009), slower ones meet what is prescribed. An opening with a velocity or flow rate into
 *  the domain is full from the start, others where liquid stands before them. The particles of reservoirs are among
 *  those of the run, of its energy and momentum. Where liquid fills the domain, pressure may fall below 0 without a
 *  void: there is no air to fill it. */
typedef struct sph2d_opening {
    /** Name for probes; default NULL: none. */
    const char *name;

    /** The side; must be given. */
    sph2d_side_name side;

    /** Its ends [m], y of left and right, x of bottom and top, from < to; default NAN: the ends of the side. */
    double from, to;

    /** Mean velocity into the domain, out of it if negative [m/s]; default NAN: not given. */
    double velocity;

    /** Area of liquid per second into the domain [m^2/s], the velocity times the width; default NAN: not given. */
    double flow_rate;

    /** How the velocity is distributed; default uniform. */
    sph2d_opening_profile profile;

    /** Time over which velocity or flow rate grow smoothly from nothing [s], >= 0; default 0. */
    double ramp;

    /** Pressure in the middle of the opening, hydrostatic from there, of liquid at rest outside: where it flows in,
     *  rho u^2/2 is taken from it (Bernoulli) [Pa]; default NAN: not given. */
    double pressure;

    /** Height y of the surface of liquid at rest outside [m], in place of the pressure; with gravity downwards. The
     *  opening is filled up to it, to whole spacings; where liquid flows in, to u^2/(2 g) less; default NAN: not
     *  given. */
    double level;

    /** One of them over time, in place of the number. */
    sph2d_opening_history history;

    /** With velocity or flow_rate, in the left or right side with gravity downwards: liquid does not fill the opening,
     *  but stands in it as high as before it, over a time in which sound crosses the domain and back; a flow rate is
     *  that of as much. The least depth is that at which its velocity is critical, sqrt(g depth), or half its width if
     *  that is less. Default off. */
    sph2d_switch free_surface;

    /** Colour of liquid that comes in through it, as sph2d_fluid has it; default NULL: the fluid's. */
    const char *color;
} sph2d_opening;

/** A point of a motion's path: where the body is at a time. */
typedef struct sph2d_pose_point {
    /** Time [s], displacement [m], and angle, anticlockwise [rad]. */
    double t, x, y, angle;
} sph2d_pose_point;

/** The path of a motion. */
typedef struct sph2d_pose_path {
    /** The points, borrowed, with increasing times. */
    const sph2d_pose_point *items;

    /** Number of points. */
    size_t count;
} sph2d_pose_path;

/** How a motion goes from one point of its path to the next. */
typedef enum sph2d_between {
    /** In straight lines; from a file: cubic. */
    SPH2D_BETWEEN_DEFAULT,

    /** In straight lines, at constant speed: the velocity jumps at the points. */
    SPH2D_BETWEEN_LINES,

    /** By cubic polynomials with continuous velocity and acceleration (a natural spline). */
    SPH2D_BETWEEN_CUBIC
} sph2d_between;

/** An oscillation of place and angle: amplitude (sin(2 pi frequency t + phase) - sin(phase)). */
typedef struct sph2d_swing {
    /** Amplitude of the displacement [m]; default (0, 0). */
    sph2d_vec2 amplitude;

    /** Amplitude of the angle, anticlockwise [rad]; default 0. */
    double angle;

    /** Frequency [1/s], >= 0; default 0. */
    double frequency;

    /** Phase [rad]; default 0: it starts at full speed; -pi/2: at rest. */
    double phase;
} sph2d_swing;

/** A prescribed motion: along a path, turning at a rate, swinging, or the sum of them; make one with
 *  sph2d_motion_default(). At a time t the body is displaced
 *  by d(t) from its place in the scene, and turned by an angle theta(t) about its centre:
 *
 *      d(t)     = path(t) + ramp(t) sum amplitude (sin(2 pi f t + phase) - sin(phase))       over all swings
 *      theta(t) = path's angle + the same sum of the swings' angles + rate * (integral of ramp)
 *
 *  The ramp rises from 0 at t = 0 to 1 at t = `ramp`, with continuous velocity and acceleration. */
typedef struct sph2d_motion {
    /** Displacements and angles at increasing times; before the first point and after the last it rests there; default
     *  none. */
    sph2d_pose_path path;

    /** A CSV file with columns t and any of x, y, angle, in place of the path, which only sph2d_scene_file_read() reads:
     *  it becomes the path. NULL: none. */
    const char *file;

    /** How it goes from one point to the next; default in straight lines, but by cubics if a file gives the points. */
    sph2d_between between;

    /** Rate at which it turns, anticlockwise [rad/s]; default 0. */
    double rate;

    /** An oscillation (sph2d_swing): amplitudes of the displacement [m] and the angle [rad], frequency [1/s], phase
     *  [rad]; default none. */
    sph2d_vec2 amplitude;
    double angle, frequency, phase;

    /** Further oscillations, borrowed; default none. */
    const sph2d_swing *swings;
    /** Number of these. */
    size_t swing_count;

    /** Time over which swings and the rate of turn grow to their full size [s], >= 0; default 0: at once. */
    double ramp;

    /** The point about which it turns, where the obstacle is in the scene [m]; default NaN, of sph2d_motion_default(): the
     *  centroid of the outline. */
    sph2d_vec2 center;
} sph2d_motion;

/** A wall of boundary particles. No particle passes it, at any speed. Heavy and reflecting ones are one particle thick
 *  and act on both sides. Generalised ones have layers of boundary particles with a total thickness of the support
 *  radius: closed outlines are solids, with layers inside, unless the liquid is inside (`liquid`): these are hollow, with
 *  layers around them; lines, polylines and arcs have the liquid on one side and the
 *  layers on the other, which no particle enters from behind either. */
typedef struct sph2d_obstacle {
    /** A name for probes: letters, digits, `_` and `-`, unique, not that of a side (left, right, bottom, top). Default
     *  NULL: none. */
    const char *name;

    /** Its line; must be given. */
    sph2d_shape shape;

    /** Lines, polylines and arcs with layers: on which side the liquid is; default auto. */
    sph2d_liquid_side liquid;

    /** Its motion; default: at rest. */
    sph2d_motion motion;

    /** Form of the wall. muller: heavy or reflect; the others: generalised; default: the
     *  method's. */
    sph2d_wall_form form;

    /** Reflect only: normal speed after over before, 0 to 1; default 0.5. */
    double restitution;

    /** Generalised only: slip or friction of liquid along it; default the scene's wall_slip. */
    sph2d_wall_slip slip;
} sph2d_obstacle;

/** A spring between a point of a body and a fixed point: a force along the line between the two, stiffness times its
 *  stretch plus damping times the rate of it. */
typedef struct sph2d_spring {
    /** The point of the body, where it is in the scene [m]; default NaN, of sph2d_spring_default(): the centre of mass. */
    sph2d_vec2 at;

    /** The fixed point [m]; must be given. */
    sph2d_vec2 to;

    /** Force over stretch, per metre of depth [N/m^2], >= 0; must be given. */
    double stiffness;

    /** Force over the rate of stretch [N s/m^2], >= 0; default 0. */
    double damping;

    /** Length without force [m], >= 0; default NaN: the distance of the two points in the scene. */
    double length;

    /** Whether it only pulls, like a rope or chain; default off. */
    sph2d_switch slack;
} sph2d_spring;

/** Which motions of a body are held at zero: off or on; default off. */
typedef struct sph2d_hold {
    /** Along x and y, of the centre of mass, and turning. */
    sph2d_switch x, y, angle;
} sph2d_hold;

/** What drives the turning of a body, or brakes it. */
typedef struct sph2d_motor {
    /** The angular velocity that it seeks, anticlockwise [rad/s]; default 0: a brake. */
    double rate;

    /** The largest torque by which it does so, per metre of depth [N], >= 0; default 0: none. */
    double torque;
} sph2d_motor;

/** A rigid body that the liquid moves, and that moves the liquid: a solid of boundary particles like a closed obstacle.
 *  Its mass, inertia and all forces are per metre of depth. Bodies meet each other and walls where the program has a
 *  solver for contacts (sph2d_sim_set_contacts()); the command has, and keeps a fifth of a spacing between them: a body
 *  drawn on a floor rises by that. Not with fitted operators. */
typedef struct sph2d_body {
    /** A name for probes, as of an obstacle; default NULL: none. */
    const char *name;

    /** A circle, box or polygon; must be given. */
    sph2d_shape shape;

    /** Density [kg/m^3], > 0; this or the mass must be given. Default 0: mass over area. */
    double density;

    /** Mass per metre of depth [kg/m], > 0; default 0: density times area. */
    double mass;

    /** Moment of inertia about the centre of mass, per metre of depth [kg m], > 0; default 0: that of an even density. */
    double inertia;

    /** Centre of mass in the scene [m]; default NaN, of sph2d_body_default(): the centroid. */
    sph2d_vec2 center;

    /** Velocity of the centre of mass at the start [m/s]; default (0, 0). */
    sph2d_vec2 velocity;

    /** Angular velocity at the start, anticlockwise [rad/s]; default 0. */
    double rate;

    /** Motions that are held at zero; default none. */
    sph2d_hold hold;

    /** Springs and moorings, borrowed; default none. */
    const sph2d_spring *springs;
    /** Number of these. */
    size_t spring_count;

    /** A motor or brake; default none. */
    sph2d_motor motor;

    /** Contacts: coefficient of dry friction, 0 to 10; default 0.3. Of two bodies the geometric mean counts. */
    double friction;

    /** Contacts: normal speed after over before, 0 to 1; default 0. Of two bodies the larger one counts. */
    double restitution;

    /** Generalised only: slip or friction of liquid along it; default the scene's wall_slip. */
    sph2d_wall_slip slip;
} sph2d_body;

/** Attraction to a moving point, or repulsion: acceleration * (1 - r/radius) inside `radius`. */
typedef struct sph2d_interaction {
    /** Position of the point; must be given. */
    sph2d_path path;

    /** Range [m], > 0; must be given. */
    double radius;

    /** Acceleration at the point [m/s^2]; positive attracts, negative repels. */
    double acceleration;
} sph2d_interaction;

/** A time series, written during the run. */
typedef struct sph2d_probe {
    /** File name without `.csv`: letters, digits, `_` and `-`, unique. */
    const char *name;

    /** What it measures; must be given. */
    sph2d_probe_kind kind;

    /** Position, for kinds at a point [m]; an elevation ignores y. force: the point about which the torque is taken,
     *  which moves with an obstacle that does. tracer: that particle is followed which is nearest to it, within a spacing,
     *  when first there is one. Default NaN: must be given for these; force: (0, 0). */
    sph2d_vec2 at;

    /** speed, pressure, elevation: points (t, x, y) of a way, in place of `at`: straight lines between them, at rest before
     *  the first and after the last [s, m, m]; default none. */
    sph2d_path path;

    /** force, work: the wall, an obstacle's or body's name or the word of a side of the domain; default NULL: all walls
     *  together; body: the body's name, which must be given; speed, pressure, elevation: an obstacle or body that takes
     *  `at`, where it is at the start, along, and turns the face of a gauge; default NULL: it rests.
     *  In corners of the domain forces along x are those of the left or right side, along y of the other one. */
    const char *on;

    /** pressure: diameter of the gauge's round face around `at`, over which pressure is averaged [m], >= 0; default 0,
     *  a point. */
    double size;

    /** pressure: direction of the face, of any length > 0; default (0, 1), vertical. */
    sph2d_vec2 along;

    /** pressure: 10 to 90 % rise time of the gauge, a first-order low-pass filter [s], >= 0; 0: no filter. Default NaN:
     *  4 h/c0, h the height from which the liquid can fall, the period of its slowest standing sound wave; 0 without
     *  gravity. */
    double rise_time;

    /** When it is sampled; must be given. */
    sph2d_rate rate;
} sph2d_probe;

/** Frames of a run: images. */
typedef struct sph2d_frames {
    /** When they are drawn; default: none. */
    sph2d_rate rate;

    /** Width and height [pixels], 16 to 16384 each; default 1280 x 720. */
    uint64_t size[2];

    /** A liquid surface or dots; default metaballs. */
    sph2d_style style;

    /** Shading of metaballs; default water. */
    sph2d_look look;

    /** What is behind the liquid; default opaque. */
    sph2d_background background;

    /** The part of the plane that is shown [m]; default all zero: the domain and its walls. */
    sph2d_box view;

    /** An obstacle or body, by its name, whose middle stays in the middle of the view; default NULL: the view rests. */
    const char *follow;

    /** Radius of a metaball or point [m], >= 0; default 0: 2 spacings (metaballs), half a spacing (points). */
    double radius;

    /** Quantity that colours them, "speed", "vorticity" or a field's name, "Pressures", "Densities"; default NULL: one
     *  colour. */
    const char *color;

    /** Values at the two ends of the colour bar; default (0, 0): for speed 0 to that of a fall over the whole height, or
     *  of what drives the liquid if that is faster; for Pressures 0 to the pressure below that height; for vorticity ten
     *  times that speed over the smaller side of the domain, to either side; for other fields the range of each frame. */
    sph2d_vec2 color_range;

    /** Arrows of the velocity on a square lattice: on or off; default off. */
    sph2d_switch arrows;

    /** Side of a square of that lattice [m], >= 0; default 0: a 32nd of the larger side of the view. */
    double arrow_spacing;

    /** Speed whose arrow is as long as two of these sides [m/s], >= 0; default 0: that of a fall over the whole height, or
     *  of what drives the liquid if that is faster. */
    double arrow_speed;

    /** Streamlines: evenly spaced lines along the velocity of the moment: on or off; default off. */
    sph2d_switch streamlines;

    /** Distance between them [m], >= 0; default 0: a 40th of the side of a square as large as the view. */
    double streamline_spacing;

    /** Quantity with lines where it is a multiple of isoline_step, "speed", "vorticity" or a field's name; default NULL: no
     *  lines. */
    const char *isolines;

    /** Difference from line to line, in the field's unit, >= 0; default 0: a round number, for about ten lines to what
     *  color_range has as its default. */
    double isoline_step;

    /** A strip below the picture with the scene's name, the time and a scale bar: on or off; default on. */
    sph2d_switch caption;
} sph2d_frames;

/** Snapshots of a run. */
typedef struct sph2d_snapshots {
    /** When they are written; default: none. */
    sph2d_rate rate;

    /** Deflate level 1 to 9; default 0: no filter. */
    uint64_t compress;
} sph2d_snapshots;

/** Duration and output of a run. */
typedef struct sph2d_run {
    /** End time [s], >= 0; default 1. */
    double until;

    /** HDF5 files. */
    sph2d_snapshots snapshots;

    /** Images. */
    sph2d_frames frames;

    /** A guard stops the run if energy rises without external work by more than this fraction of the scene's energy
     *  scale (sph2d_summary.energy_rise over energy_scale), 1e-6 to 1e9; default 0: 0.1. */
    double max_energy_rise;

    /** Known times of impacts: the mean compression excludes 0.05 s after each. */
    struct {
        /** The times [s], >= 0, borrowed; default none. */
        const double *items;

        /** Number of times. */
        size_t count;
    } impacts;
} sph2d_run;

/** A scene. Make one with sph2d_scene_default(). */
typedef struct sph2d_scene {
    /** Set by sph2d_scene_default(); detects other versions and uninitialised structs. */
    size_t struct_size;

    /** A name; default "scene". */
    const char *name;

    /** The rectangle that is simulated; must be given. */
    sph2d_box domain;

    /** Boundary conditions at its sides; default wall, wall, wall, open. */
    sph2d_boundary boundary;

    /** Form of the domain's wall sides; default: the method's. */
    sph2d_wall_form walls;

    /** Generalised walls: slip or friction of liquid along them; default free. */
    sph2d_slip wall_slip;

    /** The same of single sides; default that of all. */
    sph2d_side_slips side_slip;

    /** Smooth walls: slip length, the depth at which the extrapolated velocity is the wall's (Navier 1823) [m], >= 0;
     *  default 0. */
    double slip_length;

    /** Tangential speeds of sides that are not free-slip; default 0. */
    sph2d_side_speeds wall_speeds;

    /** Spring walls: damping over critical damping, 0 to 1; default 0.1. */
    double wall_damping;

    /** Gravity [m/s^2]; default (0, -9.81). */
    sph2d_vec2 gravity;

    /** Gravity in time, in place of `gravity`, which stays that of the potential energy: (t, gx, gy) with straight lines
     *  between, constant before and after; default none. */
    sph2d_path gravity_path;

    /** A CSV file with columns t and any of gx, gy, in place of the path, which only sph2d_scene_file_read() reads:
     *  it becomes the path. A component that it lacks is that of `gravity`. NULL: none. */
    const char *gravity_file;

    /** Motion of the tank: of the domain and all walls in it, about the centre of the domain by default. Positions,
     *  velocities and probes are those seen from the tank, in which the liquid starts; it feels gravity turned, and the
     *  tank's accelerations. A path is cubic. Default: at rest. */
    sph2d_motion motion;

    /** A force towards a centre that grows with the distance; default none. */
    sph2d_central_force central_force;

    /** Particle spacing dx [m], > 0; must be given. The mass of a particle is density dx^2 [kg/m]. */
    double spacing;

    /** The liquid; default water. */
    sph2d_fluid fluid;

    /** The solver and its parameters; default wcsph. */
    sph2d_method_options method;

    /** Liquid at the start; default none, as of all lists. */
    const sph2d_block *blocks;
    size_t block_count;

    /** Individual particles; default none. */
    sph2d_particles particles;

    /** What individual particles start with, besides their velocities. With a snapshot and no individual particles: the
     *  liquid of that snapshot, where it is in the domain and outside obstacles and blocks; as many particles as have its
     *  mass, on a square lattice, at the places that it covers most. Its sound speed must be given, as with individual
     *  particles; sph2d_scene_file_read() takes it from the snapshot if that is of the same method. Default none. */
    sph2d_start start;

    /** Nozzles that emit liquid. */
    const sph2d_source *sources;
    size_t source_count;

    /** Areas where liquid is removed. */
    const sph2d_drain *drains;
    size_t drain_count;

    /** Absorbing ends, where waves die out. */
    const sph2d_absorber *absorbers;
    size_t absorber_count;

    /** Openings, through which liquid flows in and out. */
    const sph2d_opening *openings;
    size_t opening_count;

    /** Walls of boundary particles, at rest or moving. */
    const sph2d_obstacle *obstacles;
    size_t obstacle_count;

    /** Bodies that the liquid moves. */
    const sph2d_body *bodies;
    size_t body_count;

    /** Attraction to moving points, or repulsion. */
    const sph2d_interaction *interactions;
    size_t interaction_count;

    /** Time series. */
    const sph2d_probe *probes;
    size_t probe_count;

    /** Duration and output. */
    sph2d_run run;
} sph2d_scene;

/** An empty scene with all defaults; then the items of its lists with theirs. */
SPH2D_API sph2d_scene sph2d_scene_default(void);
SPH2D_API sph2d_block sph2d_block_default(void);
SPH2D_API sph2d_source sph2d_source_default(void);
SPH2D_API sph2d_drain sph2d_drain_default(void);
SPH2D_API sph2d_absorber sph2d_absorber_default(void);
SPH2D_API sph2d_opening sph2d_opening_default(void);
SPH2D_API sph2d_obstacle sph2d_obstacle_default(void);
SPH2D_API sph2d_motion sph2d_motion_default(void);
SPH2D_API sph2d_body sph2d_body_default(void);
SPH2D_API sph2d_spring sph2d_spring_default(void);
SPH2D_API sph2d_interaction sph2d_interaction_default(void);
SPH2D_API sph2d_probe sph2d_probe_default(void);

/** Reads a colour into 0xRRGGBB: a name, or "#rrggbb" with six hexadecimal digits. False, with `rgb` as it was, for any
 *  other text or NULL. */
SPH2D_API bool sph2d_color_parse(const char *text, uint32_t *rgb);

/** The names of colours, from 0 on, those of CSS and `water`; NULL behind the last. Static storage. */
SPH2D_API const char *sph2d_color_name(size_t index);

/** The colour of a liquid, 0xRRGGBB: its own, or its material's. False, with `rgb` as it was, where there is none. */
SPH2D_API bool sph2d_fluid_color(const sph2d_fluid *fluid, uint32_t *rgb);

/** The table of materials, by sph2d_material; static storage. `count` may be NULL. */
SPH2D_API const sph2d_material_data *sph2d_materials(size_t *count);

/** A liquid with the density and viscosity of a material, or its model and the numbers of that, and no surface tension:
 *  set that if drops and jets are so small that it matters. The default liquid for material none. */
SPH2D_API sph2d_fluid sph2d_fluid_of(sph2d_material material);

/** Reports every error in the structs: ranges, conflicts, positions outside the domain. Overlaps of blocks are found
 *  when particles are placed (sph2d_scene_plan, sph2d_sim_create). Errors: SPH2D_SCENE, SPH2D_INVALID for NULL. */
SPH2D_API sph2d_status sph2d_scene_check(const sph2d_scene *scene, sph2d_report *report);

/** The centroid of a closed shape's area, or of a line of constant weight [m]; the origin for a shape without points, NaN for
 *  NULL. */
SPH2D_API sph2d_vec2 sph2d_shape_centroid(const sph2d_shape *shape);

/** The number of corners of a shape, and, where `corners` is not NULL, these, in the order of its line [m]: of an arc points
 *  along it, of a circle the corners of the regular polygon of its area, which are outside of it, both as many as pieces no
 *  longer than `spacing` [m] need. 0 for NULL, a `spacing` that is not above 0, and shapes without points. */
SPH2D_API size_t sph2d_shape_corners(const sph2d_shape *shape, double spacing, sph2d_vec2 *corners);

/** Seconds between outputs [s]; 0 for none. */
SPH2D_API double sph2d_rate_interval(sph2d_rate rate);

/** When output number `n` (0, 1, ...) is due [s]: n times the interval, without accumulated rounding errors. */
SPH2D_API double sph2d_rate_due(sph2d_rate rate, uint64_t n);

/** Size and derived parameters of a scene before it runs. */
typedef struct sph2d_plan {
    /** Fluid particles at the start. */
    size_t fluid_particles;

    /** Boundary particles. */
    size_t wall_particles;

    /** Lattice sites inside an obstacle, or too close to one without layers. */
    size_t places_left_free;

    /** Area of all blocks without the solids in them [m^2]. */
    double area_asked;

    /** Area of all blocks inside solid obstacles, where no liquid is placed [m^2]. */
    double area_left_out;

    /** The largest fraction of a block inside solid obstacles, 0 to 1. */
    double most_left_out;

    /** Index of that block. */
    size_t most_left_out_block;

    /** Area of the particles of all blocks, dx^2 each with the block's own spacing [m^2]. */
    double area_placed;

    /** Mass of a fluid particle per metre of depth [kg/m]. */
    double particle_mass;

    /** Support radius H [m]: kernels are zero beyond it. */
    double support_radius;

    /** Sound speed c0 [m/s]. */
    double sound_speed;

    /** Derivation of c0, with numbers. */
    char sound_speed_formula[160];

    /** Head g h + U^2/2 + pull [m^2/s^2], from which c0 is derived. */
    double head;

    /** Pressure of surface tension in the thinnest block, over density: sigma/(rho R) with R half of its smaller side, 0
     *  for blocks from side to side [m^2/s^2]. It does not count for c0. */
    double capillary_head;

    /** Peak compression of a full impact: U/c0 with U = sqrt(2 (head + capillary_head)). */
    double impact_compression;

    /** Length of the step at the start [s]. */
    double time_step;

    /** What limits it: "acoustic", "viscous", "force" or "fixed". */
    const char *time_step_limit;

    /** Number of steps to run.until, each of that length. */
    double steps;

    /** Memory at the start [bytes]. */
    double memory;

    /** Numbers of outputs to run.until. */
    double snapshots, frames;

    /** Snapshots on disk, uncompressed, with as many particles as at the start [bytes]. */
    double disk;

    /** What one more particle in all of them takes [bytes]. */
    double disk_of_particle;
} sph2d_plan;

/** Number of particles that the blocks, lists and sides of a valid scene need, without placing any: areas over those of a
 *  particle, and lengths of sides times layers; what obstacles take or add is not counted. 0 for NULL. */
SPH2D_API double sph2d_scene_particles(const sph2d_scene *scene);

/** Checks a scene, and whether this machine has memory for so many particles; places none. Errors: SPH2D_SCENE,
 *  SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_scene_fits(const sph2d_scene *scene, sph2d_report *report);

/** Checks a scene and places its particles to make its plan. Errors: SPH2D_SCENE, SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_scene_plan(const sph2d_scene *scene, sph2d_plan *plan, sph2d_report *report);

#ifdef __cplusplus
}
#endif
#endif
