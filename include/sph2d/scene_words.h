/* SPDX-License-Identifier: MIT */
/** @file scene_words.h
 *  The words of a scene: every choice that has a name in a scene file, as an enum, with its meaning. scene.h, which
 *  includes this file, has the fields that take them.
 *
 *      scene.boundary.top = SPH2D_SIDE_WALL;           boundary: {top: wall}
 *      scene.method.name = SPH2D_METHOD_PCISPH;        method: pcisph
 *      scene.method.kernel = SPH2D_KERNEL_WENDLAND_C4; method: {kernel: wendland_c4}
 *
 *  0 is the default of a word that has one, except for the top side of the domain (open) and the method (wcsph). Known flows are words, too; they are in flow.h. */
#ifndef SPH2D_SCENE_WORDS_H
#define SPH2D_SCENE_WORDS_H

#ifdef __cplusplus
extern "C" {
#endif

/** Boundary condition at a side of the domain. */
typedef enum sph2d_side {
    /** A wall, of the form that the scene gives. */
    SPH2D_SIDE_WALL = 0,

    /** Liquid may leave; it is simulated for one more domain width or height, then removed and counted. Walls adjacent
     *  to an open side extend as far. */
    SPH2D_SIDE_OPEN = 1,

    /** Particles that leave here enter at the opposite side, which must be periodic too; the period must be at least
     *  three support radii. */
    SPH2D_SIDE_PERIODIC = 2
} sph2d_side;

/** Forms of walls. */
typedef enum sph2d_wall_form {
    /** The method's: muller spring (obstacles heavy), the others generalised. */
    SPH2D_WALL_DEFAULT = 0,

    /** A spring along the normal within half a spacing of the side: muller, sides only. */
    SPH2D_WALL_SPRING = 1,

    /** One row of boundary particles, heavy enough to have rest density by themselves, which exert pressure: muller
     *  (sides 0.5 spacings outside). */
    SPH2D_WALL_HEAVY = 2,

    /** Boundary particles that reflect particles within one spacing; for large steps: muller. */
    SPH2D_WALL_REFLECT = 3,

    /** Layers of boundary particles: in wcsph with the liquid's pressure extrapolated hydrostatically (Adami, Hu &
     *  Adams 2012), in pcisph and constraint with the pressure of the liquid in front (Akinci et al. 2012). */
    SPH2D_WALL_GENERALISED = 4
} sph2d_wall_form;

/** Slip or friction at walls. */
typedef enum sph2d_slip {
    /** Free slip, no friction: for boundary layers thinner than the spacing, as of water in most scenes. */
    SPH2D_SLIP_FREE = 0,

    /** No slip: liquid at a wall moves with it. */
    SPH2D_SLIP_NONE = 1,

    /** Friction of a smooth wall by the law of the wall, for boundary layers thinner than the spacing: laminar, mu u/(y
     *  + slip_length), or turbulent, by viscosity, the speed u and the distance y of the liquid at the wall; none
     *  without viscosity. Only wcsph. */
    SPH2D_SLIP_SMOOTH = 2
} sph2d_slip;

/** Slip or friction at one wall. */
typedef enum sph2d_wall_slip {
    /** That of the scene, wall_slip. */
    SPH2D_WALL_SLIP_DEFAULT = 0,

    /** As SPH2D_SLIP_FREE, SPH2D_SLIP_NONE and SPH2D_SLIP_SMOOTH. */
    SPH2D_WALL_SLIP_FREE = 1,
    SPH2D_WALL_SLIP_NONE = 2,
    SPH2D_WALL_SLIP_SMOOTH = 3
} sph2d_wall_slip;

/** A side of the domain by itself. */
typedef enum sph2d_side_name {
    /** The vertical sides. */
    SPH2D_SIDE_NAME_LEFT = 0,
    SPH2D_SIDE_NAME_RIGHT = 1,

    /** The horizontal sides. */
    SPH2D_SIDE_NAME_BOTTOM = 2,
    SPH2D_SIDE_NAME_TOP = 3
} sph2d_side_name;

/** The velocity over the width of an opening, whose mean is given. */
typedef enum sph2d_opening_profile {
    /** The same everywhere. */
    SPH2D_OPENING_PROFILE_UNIFORM = 0,

    /** A parabola, 0 at both ends and 1.5 times the mean in the middle: flow between plates (Poiseuille's). */
    SPH2D_OPENING_PROFILE_PARABOLA = 1,

    /** The 1/7 power law on both sides of the middle, 8/7 of the mean there: turbulent flow between plates. */
    SPH2D_OPENING_PROFILE_TURBULENT = 2
} sph2d_opening_profile;

/** Methods, in the order of their values from 0 on: name, word of scene files.
 *
 *  muller      summation density, p = k (rho - rho0), symmetric pressure force: Mueller 2003 with two-dimensional
 *  kernel
 *              constants
 *  wcsph       weakly compressible with known errors: keeps energy and momentum, waves, splashes and bodies
 *  pcisph      predictive-corrective incompressible: pressure by prediction and correction, for stiff liquids with
 *  large
 *              steps (Solenthaler & Pajarola 2009)
 *  constraint  the operators of wcsph and one implicit solve over a step, for nearly incompressible liquid with large
 *              steps
 *  hybrid      particles with a pressure from a grid, for looking and playing: steps of some hundredth of a second
 *              (Raveendran, Wojtan & Turk 2011) */
#define SPH2D_METHOD_MAP(X)                                                                                            \
    X(MULLER, muller)                                                                                                  \
    X(WCSPH, wcsph)                                                                                                    \
    X(PCISPH, pcisph)                                                                                                  \
    X(CONSTRAINT, constraint)                                                                                          \
    X(HYBRID, hybrid)

/** The method. */
typedef enum sph2d_method {
#define SPH2D__METHOD_ENUM(name, word) SPH2D_METHOD_##name,
    SPH2D_METHOD_MAP(SPH2D__METHOD_ENUM)
#undef SPH2D__METHOD_ENUM
} sph2d_method;

/** Discretisation of derivatives in method wcsph. */
typedef enum sph2d_operators {
    /** A rate of density that is exact for linear velocities, and its transpose as force: for everything. Keeps momentum,
     *  and energy but for what it books as dissipated. */
    SPH2D_OPERATORS_VARIATIONAL = 0,

    /** Quadratic least-squares fits around each particle, of second order: for liquid that fills its domain, periodic
     *  or between walls. */
    SPH2D_OPERATORS_FITTED = 1
} sph2d_operators;

/** Smoothing kernels, in the order of their values from 0 on: name, word of scene files. */
#define SPH2D_KERNEL_MAP(X)                                                                                            \
    X(WENDLAND_C2, wendland_c2)                                                                                        \
    X(WENDLAND_C4, wendland_c4)

/** A smoothing kernel. */
typedef enum sph2d_kernel {
#define SPH2D__KERNEL_ENUM(name, word) SPH2D_KERNEL_##name,
    SPH2D_KERNEL_MAP(SPH2D__KERNEL_ENUM)
#undef SPH2D__KERNEL_ENUM
} sph2d_kernel;

#define SPH2D__KERNEL_ONE(name, word) +1
/** The number of kernels. */
enum { SPH2D_KERNEL_COUNT = SPH2D_KERNEL_MAP(SPH2D__KERNEL_ONE) };
#undef SPH2D__KERNEL_ONE

/** What a shape is: a closed one, which bounds an area, or a line. */
typedef enum sph2d_shape_kind {
    /** Not given: refused. */
    SPH2D_SHAPE_NONE = 0,

    /** A rectangle. */
    SPH2D_SHAPE_BOX,

    /** A circle, or the disc within it. */
    SPH2D_SHAPE_CIRCLE,

    /** Vertices, 3 to 10000, closed automatically, in either orientation, without self-intersection. */
    SPH2D_SHAPE_POLYGON,

    /** Two points. */
    SPH2D_SHAPE_LINE,

    /** Two points or more, open. */
    SPH2D_SHAPE_POLYLINE,

    /** A part of a circle, open. */
    SPH2D_SHAPE_ARC,

    /** A polygon or polyline in a drawing, which becomes one when sph2d_scene_file_read() reads it; else refused. */
    SPH2D_SHAPE_SVG
} sph2d_shape_kind;

/** On which side of an outline with layers the liquid is, for lines looking from the first point to the last. */
typedef enum sph2d_liquid_side {
    /** The side of blocks or sources: of those next to the line, or else of the nearest; left if there are none.
     *  Rejected if blocks are on both sides within the thickness of the layers. */
    SPH2D_LIQUID_AUTO = 0,

    /** On the left. */
    SPH2D_LIQUID_LEFT = 1,

    /** On the right. */
    SPH2D_LIQUID_RIGHT = 2,

    /** On both: the line becomes a solid as thick as its layers, half of it on either side; blocks leave that space
     *  empty. */
    SPH2D_LIQUID_BOTH = 3,

    /** Closed outlines: inside, the obstacle is hollow and its layers are around it. Liquid may be outside of these, too. */
    SPH2D_LIQUID_INSIDE = 4
} sph2d_liquid_side;

/** Liquids by name, at 20 C unless another temperature is named, and atmospheric pressure. */
typedef enum sph2d_material {
    /** None: density and viscosity are given. */
    SPH2D_MATERIAL_NONE = 0,

    /** Water. */
    SPH2D_MATERIAL_WATER = 1,

    /** Olive oil. */
    SPH2D_MATERIAL_OIL = 2,

    /** Glycerine without water. */
    SPH2D_MATERIAL_GLYCERINE = 3,

    /** Honey with 16 % water. */
    SPH2D_MATERIAL_HONEY = 4,

    /** Mercury. */
    SPH2D_MATERIAL_MERCURY = 5,

    /** Seawater of salinity 35. */
    SPH2D_MATERIAL_SEAWATER = 6,

    /** Ethanol without water. */
    SPH2D_MATERIAL_ETHANOL = 7,

    /** Gasoline, at 15.6 C. */
    SPH2D_MATERIAL_GASOLINE = 8,

    /** Whole milk. */
    SPH2D_MATERIAL_MILK = 9,

    /** Engine oil, SAE 30, at 15.6 C. */
    SPH2D_MATERIAL_ENGINE_OIL = 10,

    /** Basaltic lava near its vent, at 1050 to 1200 C. */
    SPH2D_MATERIAL_LAVA = 11,

    /** Human blood at 37 C: Carreau's liquid. */
    SPH2D_MATERIAL_BLOOD = 12,

    /** Molten milk chocolate: Bingham's liquid. */
    SPH2D_MATERIAL_CHOCOLATE = 13,

    /** Mud of silt and clay: Bingham's liquid. */
    SPH2D_MATERIAL_MUD = 14
} sph2d_material;

/** How the viscosity of a liquid depends on the shear rate (methods/terms/rheology.h has the equations). */
typedef enum sph2d_rheology {
    /** Not at all. */
    SPH2D_RHEOLOGY_NEWTONIAN,

    /** As a power of it: consistency, index. */
    SPH2D_RHEOLOGY_POWER_LAW,

    /** From one value at rest to another: dynamic_viscosity, infinite_viscosity, relaxation_time, index. */
    SPH2D_RHEOLOGY_CARREAU,

    /** It flows above a yield stress: yield_stress, consistency, index. Bingham's liquid with index 1. */
    SPH2D_RHEOLOGY_HERSCHEL_BULKLEY
} sph2d_rheology;

/** Off or on. */
typedef enum sph2d_switch { SPH2D_SWITCH_OFF = 0, SPH2D_SWITCH_ON = 1 } sph2d_switch;

/** Arrangement of a block's particles. */
typedef enum sph2d_arrangement {
    /** A square lattice where it fits, else packed (see sph2d_block). */
    SPH2D_ARRANGEMENT_LATTICE = 0,

    /** A disc of rings one spacing apart, as many as fit, for a smooth edge. */
    SPH2D_ARRANGEMENT_RINGS
} sph2d_arrangement;

/** Kinds of probes, in the order of their values from 0 on: name, word of scene files, its columns after `time`.
 *  Undefined values, as where there is no liquid, are NaN.
 *
 *  energy     kinetic and potential energy, the latter of gravity, central force, spring walls and surface tension;
 *             momentum; speed of the fastest particle; energy of compression; energy_error: error of the energy
 *             balance, over the scene's energy scale (sph2d_summary): positive for energy from nothing
 *  speed      of the liquid at a point, by sph2d_sim_sample(); neighbours: particles within the support radius
 *  pressure   the reading of a gauge at a point, 0 in air: sph2d_sim_sample(), averaged over its `size` and delayed by
 *             its `rise_time`, which has a default. With rise_time 0 and size 0 the sample itself, NaN in air
 *  elevation  y of the highest free surface on the vertical line through at.x, where liquid fills half of the kernel's
 *             area: from H/dx = 2.2 on, no isolated particle does. Liquid up to a closed top has the top's y
 *  extent     of the particles' positions
 *  axes       centre of mass; a, b: larger and smaller semi-axis of the filled ellipse with the particles' second
 *             moments about it; angle: of the larger one to the x axis, above -pi/2 to pi/2; a_x, a_y: semi-axes along
 *             x and y from <x^2> and <y^2> alone. Positions are not unwrapped across a periodic side
 *  quality    spacing_min, spacing_p1: smallest distance between two particles, and 1st percentile over particles of
 *             the distance to the nearest one, over the scene's spacing, H/dx at most; paired: fraction of particles
 *             with another nearer than half a spacing; density_rms, density_max: root mean square and largest absolute
 *             value of rho/rho0 - 1; mach: largest speed over c0; reported, counted: mean density inside the liquid
 *             over rest density, of the particles and by counting them per area
 *  momentum   angular_momentum: about the middle of the domain, anticlockwise; centre_x, centre_y: centre of mass
 *  error      difference from the exact solution that a block starts with, at the particles: speed_l1: mean
 *             error of |v| over mean exact |v|; vector_l1: the same of v; vector_max: largest error of v over the
 *             flow's speed U (a flow at rest: over the speed that its largest pressure could make); pressure_l1: mean
 *             error over mean exact |p|; pressure_rms: root mean square error over the largest exact |p|; kinetic:
 *             kinetic energy over the exact one, - 1
 *  volume     area that liquid covers, to a surface where half of a kernel is filled, and of particles by themselves,
 *             dx^2 each; placed: what the particles stand for at rest density. Reservoirs of openings do not count:
 *             placed changes by what openings let in, and sources and drains
 *  level      height up to which `volume` fills what the liquid can get to from where it is, below that height and
 *             without passing a wall: the mean level once it has settled. Closed obstacles take room, as they stand
 *             now; lines hold liquid. NaN unless gravity points straight down
 *  force      of the liquid on a wall, per metre of depth, at the time of the last forces: in all, and by pressure,
 *             friction, and contact (spring walls; particles that were stopped or reflected, over the step's length;
 *             not what bodies and walls do to each other in their contacts);
 *             torque: about `at`, anticlockwise; impulse, angular_impulse: of the force and torque since the last row,
 *             summed over all steps. With the impulse of gravity and of other forces they are the change of the
 *             liquid's momentum
 *  work       power of a wall on the liquid, and its work since the start; 0 for walls at rest
 *  body       place of a body's centre of mass, which periodic sides do not set back, the angle by which it has turned,
 *             its velocity; force of the liquid, with its pressure in gaps too thin for particles, and its torque about
 *             the centre of mass, in the mean over the last step; kinetic and potential energy of the body and its springs. By wcsph and muller vy of a body that
 *             rests on a floor is not 0 but -a dt/2, a being its weight less buoyancy over its mass, which the contacts
 *             of the next step undo (sph2d_body_state) */
#define SPH2D_PROBE_MAP(X)                                                                                             \
    X(ENERGY, energy,                                                                                                  \
      "kinetic [J/m],potential [J/m],momentum_x [kg/s],momentum_y [kg/s],particles,speed_max [m/s],elastic [J/m],"     \
      "energy_error")                                                                                                  \
    X(SPEED, speed, "vx [m/s],vy [m/s],speed [m/s],neighbours")                                                        \
    X(PRESSURE, pressure, "pressure [Pa],density [kg/m^3],neighbours")                                                 \
    X(ELEVATION, elevation, "elevation [m]")                                                                           \
    X(EXTENT, extent, "left [m],right [m],bottom [m],top [m]")                                                         \
    X(AXES, axes, "centre_x [m],centre_y [m],a [m],b [m],angle [rad],a_x [m],a_y [m],ab [m^2]")                        \
    X(QUALITY, quality, "spacing_min,spacing_p1,paired,density_rms,density_max,mach,reported,counted")                 \
    X(MOMENTUM, momentum, "momentum_x [kg/s],momentum_y [kg/s],angular_momentum [kg m/s],centre_x [m],centre_y [m]")   \
    X(ERROR, error, "speed_l1,vector_l1,vector_max,pressure_l1,pressure_rms,kinetic")                                  \
    X(VOLUME, volume, "volume [m^2],placed [m^2]")                                                                     \
    X(LEVEL, level, "level [m]")                                                                                       \
    X(FORCE, force,                                                                                                    \
      "fx [N/m],fy [N/m],torque [N],pressure_x [N/m],pressure_y [N/m],friction_x [N/m],friction_y [N/m],"              \
      "contact_x [N/m],contact_y [N/m],impulse_x [kg/s],impulse_y [kg/s],angular_impulse [kg m/s]")                    \
    X(WORK, work, "power [W/m],work [J/m]")                                                                            \
    X(BODY, body, "x [m],y [m],angle [rad],vx [m/s],vy [m/s],rate [rad/s],fx [N/m],fy [N/m],torque [N],energy [J/m]")  \
    X(OPENING, opening, "velocity [m/s],flow_rate [m^2/s],let_in [m^2],pressure [Pa],wet [m]")                         \
    X(TRACER, tracer, "x [m],y [m],vx [m/s],vy [m/s],pressure [Pa],particle")

/** What a probe measures. */
typedef enum sph2d_probe_kind {
#define SPH2D__PROBE_ENUM(name, word, columns) SPH2D_PROBE_##name,
    SPH2D_PROBE_MAP(SPH2D__PROBE_ENUM)
#undef SPH2D__PROBE_ENUM
} sph2d_probe_kind;

/** Style of a frame. */
typedef enum sph2d_style {
    /** A liquid surface. */
    SPH2D_STYLE_METABALLS = 0,

    /** A dot per particle. */
    SPH2D_STYLE_POINTS = 1
} sph2d_style;

/** Shading of metaballs. */
typedef enum sph2d_look {
    /** Blue water under light from the upper left, darker with depth. */
    SPH2D_LOOK_WATER = 0,

    /** One colour with a slightly darker edge. */
    SPH2D_LOOK_FLAT = 1,

    /** Translucent, with refracted light and highlights. */
    SPH2D_LOOK_GLASS = 2,

    /** A dark line on white paper, and lines of equal depth below the surface; for print. */
    SPH2D_LOOK_INK = 3
} sph2d_look;

/** What is behind the liquid. */
typedef enum sph2d_background {
    /** Light grey; white for look ink. */
    SPH2D_BACKGROUND_OPAQUE = 0,

    /** Nothing; captions and the colour bar are on opaque panels. */
    SPH2D_BACKGROUND_TRANSPARENT = 1
} sph2d_background;

#ifdef __cplusplus
}
#endif
#endif
