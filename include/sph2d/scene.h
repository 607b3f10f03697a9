/* SPDX-License-Identifier: MIT */
/** @file scene.h
 *  What a scene is: plain structs. SI units throughout; in two dimensions masses and forces are per metre of depth.
 *
 *  Start from sph2d_scene_default(), set what you need, hand it to sph2d_sim_create(), which copies everything: lists
 *  and strings are borrowed from the caller and may live on the stack. A scene file has the same keys in the same
 *  places (sph2d/key.h is the table of both), so a C program and a file get the same checks and the same sentences.
 *
 *  In fields documented with "0: derived" or "0: none" zero means that the value is not given. */
#ifndef SPH2D_SCENE_H
#define SPH2D_SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "sph2d/export.h"
#include "sph2d/flow.h"
#include "sph2d/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A point, velocity or acceleration. */
typedef struct sph2d_vec2 {
    double x, y;
} sph2d_vec2;

/** An axis-aligned rectangle, min < max in both directions [m]. */
typedef struct sph2d_box {
    sph2d_vec2 min, max;
} sph2d_box;

/** A disc or circle [m], radius > 0. */
typedef struct sph2d_disc {
    sph2d_vec2 center;
    double radius;
} sph2d_disc;

/** A list of points [m], borrowed. */
typedef struct sph2d_points {
    const sph2d_vec2 *items;
    size_t count;
} sph2d_points;

/** How often an output is due. Give one of the two, or neither for no output. */
typedef struct sph2d_rate {
    double per_second; /**< outputs per simulated second [1/s], >= 0; default 0: none */
    double every;      /**< simulated seconds between outputs [s], >= 0; default 0: none */
} sph2d_rate;

/** What closes a side of the domain. */
typedef enum sph2d_side {
    SPH2D_SIDE_WALL = 0,    /**< closed, by the form of wall that the scene names */
    SPH2D_SIDE_OPEN = 1,    /**< liquid may leave; it is followed for one more domain width or height, then removed and
                                 counted. Walls beside an open side go on for as far */
    SPH2D_SIDE_PERIODIC = 2 /**< what leaves here comes in at the opposite side, which must be periodic too; the period
                                 must hold three support radii */
} sph2d_side;

/** How walls push. */
typedef enum sph2d_wall_form {
    SPH2D_WALL_DEFAULT = 0, /**< the method's: muller spring (obstacles heavy), the others generalised */
    SPH2D_WALL_SPRING = 1,  /**< a spring along the normal within half a spacing of the side: muller, sides only */
    SPH2D_WALL_HEAVY = 2,   /**< fixed boundary particles, heavy enough to hold rest density alone, acting by pressure:
                                 muller (sides 0.5 spacings outside), pcisph, constraint (sides 0.68 by default) */
    SPH2D_WALL_REFLECT = 3, /**< boundary particles that reflect what comes within one spacing; for large steps */
    SPH2D_WALL_GENERALISED = 4 /**< layers of boundary particles: wcsph, where they take the liquid's pressure on with
                                  its weight (Adami, Hu & Adams 2012), and pcisph and constraint, where they count as
                                  liquid of the pressure in front (Akinci et al. 2012) */
} sph2d_wall_form;

/** Whether liquid slides along walls. */
typedef enum sph2d_slip {
    SPH2D_SLIP_FREE = 0,  /**< no friction: boundary layers thinner than the spacing, as of water in most scenes */
    SPH2D_SLIP_NONE = 1,  /**< liquid at a wall moves with it */
    SPH2D_SLIP_SMOOTH = 2 /**< friction of a smooth wall by the law of the wall, for boundary layers thinner than the
                               spacing: laminar, mu u/(y + slip_length), or turbulent, by viscosity, the speed u and
                               the distance y of the liquid at the wall; none without viscosity. wcsph alone */
} sph2d_slip;

/** What method pcisph keeps below max_compression in every step. */
typedef enum sph2d_criterion {
    SPH2D_CRITERION_MAX = 0, /**< the largest compression of a particle */
    SPH2D_CRITERION_MEAN = 1 /**< the mean over particles */
} sph2d_criterion;

/** Which solver moves the liquid. */
typedef enum sph2d_method {
    SPH2D_METHOD_MULLER = 0, /**< summation density, p = c0^2 (rho - rho0), symmetric pressure force: Mueller 2003 with
                                  two-dimensional kernel constants */
    SPH2D_METHOD_WCSPH = 1,  /**< weakly compressible with an error that is known: density by the continuity equation
                                  with diffusion, physical viscosity, particle shifting, generalised walls */
    SPH2D_METHOD_PCISPH = 2, /**< predictive-corrective incompressible: pressure by prediction and correction, for stiff
                                  liquids at large steps (Solenthaler & Pajarola 2009) */
    SPH2D_METHOD_CONSTRAINT = 3 /**< Constraint Fluids: summation density kept by constraints, for stiff liquids at
                                   large steps (Bodin, Lacoursiere & Servin 2011) */
} sph2d_method;

/** What pair loops of method wcsph compute with. The state and the integration are always in doubles. */
typedef enum sph2d_precision {
    SPH2D_PRECISION_DOUBLE = 0,
    SPH2D_PRECISION_MIXED = 1 /**< floats relative to the particles' surroundings: twice as many at a time */
} sph2d_precision;

/** How method wcsph takes derivatives. */
typedef enum sph2d_operators {
    SPH2D_OPERATORS_SYMMETRIC = 0, /**< kernel sums that conserve momentum: for free surfaces and impacts */
    SPH2D_OPERATORS_FITTED = 1     /**< quadratic least-squares fits around each particle, of second order: for liquid
                                        that fills its room, periodic or between walls */
} sph2d_operators;

/** Smoothing kernels of the symmetric operators, in the order of their values from 0 on: name, word of scene files. */
#define SPH2D_KERNEL_MAP(X)                                                                                            \
    X(WENDLAND_C2, wendland_c2)                                                                                        \
    X(WENDLAND_C4, wendland_c4)                                                                                        \
    X(WENDLAND_C6, wendland_c6)                                                                                        \
    X(CUBIC, cubic)                                                                                                    \
    X(QUINTIC, quintic)

typedef enum sph2d_kernel {
#define SPH2D__KERNEL_ENUM(name, word) SPH2D_KERNEL_##name,
    SPH2D_KERNEL_MAP(SPH2D__KERNEL_ENUM)
#undef SPH2D__KERNEL_ENUM
} sph2d_kernel;

#define SPH2D__KERNEL_ONE(name, word) +1
enum { SPH2D_KERNEL_COUNT = SPH2D_KERNEL_MAP(SPH2D__KERNEL_ONE) };
#undef SPH2D__KERNEL_ONE

/** How pressure follows from density in method wcsph. */
typedef enum sph2d_state_equation {
    SPH2D_STATE_LINEAR = 0, /**< p = c0^2 (rho - rho0) */
    SPH2D_STATE_TAIT = 1    /**< p = rho0 c0^2/7 ((rho/rho0)^7 - 1) */
} sph2d_state_equation;

/** The pair form of viscosity of the symmetric operators. */
typedef enum sph2d_viscosity_form {
    SPH2D_VISCOSITY_DEFAULT = 0, /**< morris where a block fills the whole domain and no side is open, else monaghan */
    SPH2D_VISCOSITY_MORRIS = 1,  /**< Morris, Fox & Zhu 1997: keeps linear momentum; the shear viscosity that is named,
                                      on a lattice, too. A free surface has no stress of its own: waves decay half as
                                      fast as they should, and a drop that turns is slowed down */
    SPH2D_VISCOSITY_MONAGHAN = 2 /**< Monaghan & Gingold 1983: keeps angular momentum too, and a free surface without
                                      stress (Colagrossi et al. 2011). Shear along the rows of a lattice finds 0.89 of
                                      the viscosity (wendland_c2, H/dx = 3), disordered liquid the whole */
} sph2d_viscosity_form;

/** What eddies smaller than the smoothing kernel do. */
typedef enum sph2d_turbulence {
    SPH2D_TURBULENCE_DEFAULT = 0,    /**< none with shifting 0, with artificial viscosity, and where a block fills the
                                          whole domain and no side is open; else smagorinsky */
    SPH2D_TURBULENCE_NONE = 1,       /**< nothing */
    SPH2D_TURBULENCE_SMAGORINSKY = 2 /**< Smagorinsky 1963: they add the kinematic viscosity (0.3 H)^2 |S|, with the
                                          support radius H and the rate of strain |S| = sqrt(2 S:S), in the form
                                          monaghan, against what of the velocities is not linear: smooth strain is
                                          left alone. What splashes leave of disorder among particles dies by it */
} sph2d_turbulence;

/** What density diffuses down in delta-SPH. */
typedef enum sph2d_diffusion_form {
    SPH2D_DIFFUSION_ANTUONO = 0,  /**< density less what its gradients around say (Antuono et al. 2010): exact wherever
                                       density is linear, at the price of the gradients */
    SPH2D_DIFFUSION_FOURTAKAS = 1 /**< density less that of a liquid at rest (Fourtakas et al. 2019): at rest in gravity
                                       and in a central force; the cheapest. No shifting, no tensile control */
} sph2d_diffusion_form;

/** The area of a block or drain. */
typedef enum sph2d_shape_kind {
    SPH2D_SHAPE_NONE = 0,
    SPH2D_SHAPE_BOX,
    SPH2D_SHAPE_DISC,
    SPH2D_SHAPE_POLYGON /**< closed by itself, 3 to 10000 points, without self-crossing */
} sph2d_shape_kind;

typedef struct sph2d_shape {
    sph2d_shape_kind kind;
    sph2d_box box;
    sph2d_disc disc;
    sph2d_points polygon;
} sph2d_shape;

/** The line of an obstacle. */
typedef enum sph2d_outline_kind {
    SPH2D_OUTLINE_NONE = 0,
    SPH2D_OUTLINE_LINE,     /**< two points */
    SPH2D_OUTLINE_POLYLINE, /**< two points or more, open */
    SPH2D_OUTLINE_CIRCLE,
    SPH2D_OUTLINE_BOX,
    SPH2D_OUTLINE_POLYGON /**< closed by itself, 3 to 10000 points either way round, without self-crossing: a solid */
} sph2d_outline_kind;

typedef struct sph2d_outline {
    sph2d_outline_kind kind;
    sph2d_points line;
    sph2d_points polyline;
    sph2d_disc circle;
    sph2d_box box;
    sph2d_points polygon;
} sph2d_outline;

/** On which side of a line or polyline with layers the liquid is, looking from its first point to its last. */
typedef enum sph2d_liquid_side {
    SPH2D_LIQUID_AUTO = 0, /**< where blocks or sources lie: next to the line, or else nearest to it; left without any.
                                Refused where blocks lie on both sides within the thickness of the layers */
    SPH2D_LIQUID_LEFT = 1,
    SPH2D_LIQUID_RIGHT = 2,
    SPH2D_LIQUID_BOTH = 3 /**< the line becomes a solid as thick as its layers, half of it on either side; blocks leave
                               that room free */
} sph2d_liquid_side;

/** What closes the four sides of the domain. */
typedef struct sph2d_boundary {
    sph2d_side left, right, bottom, top; /**< default: wall, wall, wall, open */
} sph2d_boundary;

/** How fast the surfaces of wall sides move along themselves, like a lid or a belt [m/s]; default 0. */
typedef struct sph2d_side_speeds {
    double left, right; /**< upwards */
    double bottom, top; /**< to the right */
} sph2d_side_speeds;

/** A force towards a centre that grows with the distance: acceleration -rate^2 (x - center). */
typedef struct sph2d_central_force {
    sph2d_vec2 center; /**< [m]; default (0, 0) */
    double rate;       /**< B [1/s], >= 0; default 0: none */
} sph2d_central_force;

/** Liquids that are known by name, at 20 C and the pressure of the air. */
typedef enum sph2d_material {
    SPH2D_MATERIAL_NONE = 0, /**< the liquid of the numbers */
    SPH2D_MATERIAL_WATER = 1,
    SPH2D_MATERIAL_OIL = 2, /**< olive oil */
    SPH2D_MATERIAL_GLYCERINE = 3,
    SPH2D_MATERIAL_HONEY = 4, /**< with 16 % water */
    SPH2D_MATERIAL_MERCURY = 5
} sph2d_material;

/** The numbers of a material. */
typedef struct sph2d_material_data {
    const char *name;
    double density;           /**< [kg/m^3] */
    double dynamic_viscosity; /**< [Pa s] */
    double surface_tension;   /**< against air [N/m]; 0: no sure value */
    const char *source;
} sph2d_material_data;

/** The liquid. */
typedef struct sph2d_fluid {
    sph2d_material material;  /**< which material's numbers a file asked for; they are in the fields below, where
                                 sph2d_fluid_of() puts them too. Default none */
    double density;           /**< rest density [kg/m^3], > 0; default 1000 */
    double dynamic_viscosity; /**< [Pa s], >= 0; default 0.001 (water) */
    double surface_tension;   /**< of the free surface [N/m], >= 0; default 0: none. All methods but wcsph with
                                 fitted operators. Surfaces meet layered walls at a right angle; other walls are not
                                 wetted */
} sph2d_fluid;

/** Off or on. */
typedef enum sph2d_switch { SPH2D_SWITCH_OFF = 0, SPH2D_SWITCH_ON = 1 } sph2d_switch;

/** The solver and its numbers. A method refuses what it does not have, but for the default. */
typedef struct sph2d_method_options {
    sph2d_method name;                   /**< default wcsph */
    sph2d_operators operators;           /**< wcsph; default symmetric */
    sph2d_precision precision;           /**< wcsph; default double */
    sph2d_kernel kernel;                 /**< wcsph with symmetric operators, pcisph, constraint; default wendland_c2 */
    sph2d_state_equation state_equation; /**< wcsph; default linear */
    sph2d_viscosity_form viscosity_form; /**< wcsph, symmetric operators */
    double density_diffusion;            /**< wcsph: delta of delta-SPH, 0 to 1: density diffuses with delta h c0, where
                                              h = H/2 is the smoothing length; default 0.1 */
    sph2d_diffusion_form diffusion_form; /**< wcsph, symmetric operators; default antuono */
    double artificial_viscosity;         /**< wcsph, symmetric operators: alpha of Monaghan 1992, 0 to 1; adds the
                                              kinematic viscosity alpha h c0 / 8; default 0. muller: dynamic viscosity
                                              is alpha rho c0 H at least, H the support radius, since its force has no
                                              energy to conserve; default 0 stands for 0.1, with which none is gained */
    sph2d_turbulence turbulence;         /**< wcsph, symmetric operators */
    double shifting;                     /**< wcsph: strength of particle shifting over the standard one, 0 to 2;
                                              default 1 */
    sph2d_switch tensile_control; /**< wcsph, symmetric operators: inside liquid under tension particles push each
                                       other apart all the same (Sun et al. 2018); momentum is then not kept to
                                       round-off; default on */
    double max_compression; /**< wanted rho/rho0 - 1, impacts apart, 1e-6 to 0.9; default 0: the method's, muller 0.1,
                                 the others 0.01. Gives the sound speed: c0^2 = 2 (g h + U^2/2 + pull) /
                                 max_compression with h the height of the liquid above the lowest place that walls and
                                 obstacles that stand let it get to, U its fastest start or source, pull the strongest
                                 interaction's acceleration * radius / 2, and 2 for the swing after a release. pcisph
                                 keeps it in every step, and its sound speed is for a tenth of it; constraint corrects
                                 particles beyond it one by one */
    double stiffness;       /**< k in p = k (rho - rho0) [m^2/s^2]; default 0: derived as above. k = c0^2, but for
                                 muller, whose pair force carries half of it: c0^2 = 0.443 k at H/dx = 2, as `check`
                                 prints, and the pressure that is reported is the one that is carried */
    double sound_speed;     /**< c0 [m/s] by itself, instead of stiffness; default 0: derived as above */
    double support_ratio;   /**< support radius over spacing, H/dx, 1.2 to 6; default 0: the method's, muller 2.0, wcsph
                                 3.0 with symmetric and 2.5 with fitted operators; pcisph and constraint 2.4 with
                                 wendland_c2 and cubic (1.78, 1.65 at least), 2.75 with wendland_c4 and quintic (2.04,
                                 2.02), 3.05 with wendland_c6 (2.27): neighbours are to have a third of the density */
    double cfl; /**< step limit: dt <= cfl H / (c0 + v_max), and without c0 for pcisph and constraint, 0.01 to 0.9;
                     default 0: the method's, muller 0.4, wcsph 0.3 with symmetric and 0.25 with fitted operators,
                     pcisph and constraint 0.4 dx/H */
    double time_step; /**< fixed step [s]; default 0: adaptive */
    double damping;   /**< constraint: steps within which a compression fades, n of SPOOK, >= 0; below 2 a rigid liquid
                           rings; default 2 */
    double tolerance; /**< constraint: mean compression, of either sign, that a step may leave to correct, 1e-12 to 0.1;
                           default 0: a hundredth of max_compression */
    sph2d_criterion criterion; /**< pcisph: what is kept below max_compression; default max */
    uint64_t min_iterations;   /**< pcisph: least iterations of a step, 1 to 100000; default 3 */
    uint64_t max_iterations;   /**< pcisph, constraint: most iterations of a step, 1 to 100000; default 1000 */
} sph2d_method_options;

/** Random displacement of a block's particles: each coordinate by up to `amplitude` spacings, evenly spread. */
typedef struct sph2d_perturb {
    double amplitude; /**< in spacings, 0 to 0.5; default 0 */
    uint64_t seed;    /**< default 1 */
} sph2d_perturb;

/** How a block's particles lie. */
typedef enum sph2d_arrangement {
    SPH2D_ARRANGEMENT_LATTICE = 0, /**< a square lattice where it fits, else packed (see sph2d_block) */
    SPH2D_ARRANGEMENT_RINGS        /**< a disc of rings one spacing apart, as many as fit, for a smooth edge */
} sph2d_arrangement;

/** A piece of liquid at the start. It fills its shape, but for the solids in it, within 0.2 % or half a particle: by a
 *  square lattice of boxes and what is cut out of it, where that has the area and loses no place beside a wall with
 *  layers; by a lattice of a box that is stretched by 2 % at most, or of another shape in the air that is shifted; or
 *  else packed: as many particles as the area holds
 *  move away from edges and walls until equal pressure would push none of them. Beside obstacles without layers
 *  lattices stay as they are, and places inside or closer than 0.7 spacings stay free. */
typedef struct sph2d_block {
    sph2d_shape shape;   /**< box, disc or polygon */
    sph2d_vec2 velocity; /**< at the start [m/s]; default (0, 0) */
    sph2d_flow start;    /**< adds the velocity of a known flow, and with method wcsph starts at its pressure; default
                            none.    That of the first block that has one is what an `error` probe compares with */
    double spacing; /**< between this block's particles [m]; default 0: the scene's. Particle mass is always that of
                         the scene's spacing, so a smaller one starts compressed */
    sph2d_arrangement arrangement; /**< default lattice; rings only for discs */
    sph2d_perturb perturb;
} sph2d_block;

/** A particle of the liquid at the start. */
typedef struct sph2d_particle {
    double x, y;    /**< [m] */
    double vx, vy;  /**< [m/s] */
    double density; /**< [kg/m^3], > 0; muller computes its own */
} sph2d_particle;

/** Particles one by one, besides those of blocks. Their mass is that of the scene's spacing. They do not tell the sound
 *  speed: the method must name it. */
typedef struct sph2d_particles {
    const char *file; /**< a CSV file with columns x, y and perhaps vx, vy, density (defaults 0 and the rest density),
                           which only sph2d_scene_file_read() reads: a run is resumed without it. NULL: none */
    const sph2d_particle *items;
    size_t count;
} sph2d_particles;

/** A nozzle: feeds in rows of particles. A place that is taken stays empty, and is counted. */
typedef struct sph2d_source {
    sph2d_vec2 at;        /**< centre of the nozzle [m] */
    sph2d_vec2 direction; /**< of the jet, any length but zero; default (0, -1) */
    double width;         /**< of the nozzle [m], >= 0; one spacing at least */
    double speed;         /**< of the jet [m/s], > 0 */
    double spread;        /**< random change of each velocity component, as a fraction of speed, 0 to 1; default 0 */
    double rate;          /**< area of liquid per second [m^2/s], at most width * speed; default 0: width * speed */
    double start, stop;   /**< [s]; default 0 and 0: from the start, for ever */
    uint64_t seed;        /**< of the random spread; default 1 */
} sph2d_source;

/** An area where liquid vanishes, and is counted. */
typedef struct sph2d_drain {
    sph2d_shape shape;
    double start, stop; /**< [s]; default 0 and 0: from the start, for ever */
} sph2d_drain;

/** A point of a path: where something is at a time. */
typedef struct sph2d_path_point {
    double t, x, y; /**< [s], [m], [m] */
} sph2d_path_point;

/** Straight lines between points in time; before the first and after the last there is nothing. A single point lasts
 *  for ever. */
typedef struct sph2d_path {
    const sph2d_path_point *items;
    size_t count;
} sph2d_path;

/** How an obstacle moves without turning: along a path, swinging, or both. Its displacement from where the scene puts
 *  it is path(t) + amplitude (sin(2 pi frequency t + phase) - sin(phase)). */
typedef struct sph2d_motion {
    sph2d_path path; /**< displacements [m]; before the first point and after the last it rests there; default none */
    sph2d_vec2 amplitude; /**< of the swing [m]; default (0, 0) */
    double frequency;     /**< of the swing [1/s], >= 0; default 0 */
    double phase;         /**< of the swing [rad]; default 0: it starts at full speed, -pi/2: at rest */
} sph2d_motion;

/** A wall of boundary particles. Nothing passes it, at any speed. Heavy and reflecting ones are one particle thick and
 *  work on both sides. Generalised ones have layers of boundary particles, together as thick as the support radius:
 *  closed outlines are solids, with layers inside; lines and polylines have the liquid on one side and the layers on
 *  the other, where nothing enters them from behind either. */
typedef struct sph2d_obstacle {
    sph2d_outline outline;
    sph2d_liquid_side liquid; /**< lines and polylines with layers: where the liquid is; default auto */
    sph2d_motion motion;      /**< default: none, it stands */
    sph2d_wall_form form;     /**< muller: heavy or reflect; wcsph: generalised or reflect; the others: all
                                   three; default: the method's */
    double restitution;       /**< reflect only: normal speed after over before, 0 to 1; default 0.5 */
} sph2d_obstacle;

/** A pull or push towards a moving point: acceleration * (1 - r/radius) inside `radius`. */
typedef struct sph2d_interaction {
    sph2d_path path;
    double radius;       /**< [m], > 0 */
    double acceleration; /**< at the point [m/s^2]; positive pulls, negative pushes */
} sph2d_interaction;

/** Kinds of probes, in the order of their values from 0 on: name, word of scene files, the columns that one writes behind
 *  `time`. Values without meaning, as where there is no liquid, are NaN.
 *
 *  energy     kinetic and potential energy, the latter of gravity, central force, springs of sides and surface; momentum;
 *             speed of the fastest particle; energy of compression; energy_error: what does not add up, over the
 *             scene's energy scale (sph2d_summary)
 *  speed      of the liquid at a point, by sph2d_sim_sample(); neighbours: particles within the support radius
 *  pressure   at a point, by sph2d_sim_sample(). With `size` or `rise_time` the pressure that a gauge of that kind shows,
 *             0 in air
 *  elevation  y of the highest free surface on the vertical line through at.x, where liquid fills half of what the kernel
 *             covers: from H/dx = 2.2 on, no lone particle does. Liquid up to a closed top has the top's y
 *  extent     of the particles' places
 *  axes       centre of mass; a, b: larger and smaller half axis of the filled ellipse that has the particles' second
 *             moments about it; angle: of the larger one to the x axis, above -pi/2 to pi/2; a_x, a_y: half axes along x
 *             and y from <x^2> and <y^2> alone. Places are taken as they are: not across a periodic side
 *  quality    spacing_min, spacing_p1: smallest distance between two particles, and 1st percentile over particles of the
 *             distance to the nearest one, over the scene's spacing, H/dx at most; paired: fraction of particles with
 *             another nearer than half a spacing; density_rms, density_max: root mean square and largest absolute value
 *             of rho/rho0 - 1; mach: largest speed over c0; reported, counted: mean density inside the liquid over rest
 *             density, as particles have it and by counting them on the area
 *  momentum   angular_momentum: about the middle of the domain, anticlockwise; centre_x, centre_y: centre of mass
 *  error      difference from the exact solution that a block starts with, at the particles' places: speed_l1: mean error
 *             of |v| over mean exact |v|; vector_l1: the same of v; vector_max: largest error of v over the flow's speed
 *             U (a flow at rest: over the speed that its largest pressure could make); pressure_l1: mean error over mean
 *             exact |p|; pressure_rms: root mean square error over the largest exact |p|; kinetic: kinetic energy over
 *             the exact one, - 1
 *  volume     area that liquid covers, to a surface where half of a kernel is filled, and of particles by themselves,
 *             dx^2 each; placed: what the particles stand for at rest density
 *  level      height up to which `volume` fills what the liquid can get to from where it is, below that height and without
 *             passing a wall: the mean level once it has settled. Closed obstacles take room, as they stand now; lines
 *             hold liquid. NaN unless gravity points straight down */
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
    X(LEVEL, level, "level [m]")

typedef enum sph2d_probe_kind {
#define SPH2D__PROBE_ENUM(name, word, columns) SPH2D_PROBE_##name,
    SPH2D_PROBE_MAP(SPH2D__PROBE_ENUM)
#undef SPH2D__PROBE_ENUM
} sph2d_probe_kind;

/** A time series, written while the run goes on. */
typedef struct sph2d_probe {
    const char *name; /**< file name without `.csv`: letters, digits, `_` and `-`, unique */
    sph2d_probe_kind kind;
    sph2d_vec2 at;    /**< [m]; for the kinds at a point; an elevation has no use for y */
    double size;      /**< pressure: diameter of the gauge's round face around `at`, over which pressure is averaged
                           [m], >= 0; default 0, a point */
    sph2d_vec2 along; /**< pressure: direction of the face, of any length > 0; default (0, 1), upright */
    double rise_time; /**< pressure: time in which the gauge goes from 10 to 90 % of a jump of pressure, as a low pass
                           of first order [s], >= 0; default 0, at once */
    sph2d_rate rate;  /**< must be given */
} sph2d_probe;

/** How a frame looks. */
typedef enum sph2d_style { SPH2D_STYLE_METABALLS = 0, SPH2D_STYLE_POINTS = 1 } sph2d_style;

/** Pictures of a run. */
typedef struct sph2d_frames {
    sph2d_rate rate;   /**< default: none */
    uint64_t size[2];  /**< width and height in pixels, 16 to 16384 each; default 1280 x 720 */
    sph2d_style style; /**< default metaballs */
    double radius;     /**< of a metaball or point [m]; default 0: 2 spacings (metaballs), half a spacing (points) */
    const char *color; /**< points: "speed" or a field's name, "Pressures", "Densities"; default NULL: one colour */
    sph2d_vec2 color_range; /**< values at the two ends of the colour bar; default (0, 0): those of each frame */
} sph2d_frames;

/** Snapshots of a run. */
typedef struct sph2d_snapshots {
    sph2d_rate rate;   /**< default: none */
    uint64_t compress; /**< deflate level 1 to 9; default 0: no filter */
} sph2d_snapshots;

/** How long, and what is written. */
typedef struct sph2d_run {
    double until; /**< simulated end [s], >= 0; default 1 */
    sph2d_snapshots snapshots;
    sph2d_frames frames;
    double max_energy_rise; /**< a guard stops the run where energy has come from nothing, by more than this part of the
                                 scene's energy scale (sph2d_summary.energy_rise over energy_scale), 1e-6 to 1e9;
                                 default 0: 0.1 */
    struct {
        const double *items;
        size_t count;
    } impacts; /**< times [s] of impacts that the author knows: the mean compression leaves out 0.05 s after each */
} sph2d_run;

/** A scene. Make one with sph2d_scene_default(). */
typedef struct sph2d_scene {
    size_t struct_size; /**< set by sph2d_scene_default(); tells versions and uninitialised structs apart */
    const char *name;   /**< for people; default "scene" */
    sph2d_box domain;   /**< must be given */
    sph2d_boundary boundary;
    sph2d_wall_form walls; /**< form of the domain's wall sides; default: the method's */
    sph2d_slip wall_slip;  /**< of generalised walls; default free */
    double slip_length; /**< of smooth walls: how far behind the surface the velocity comes to the wall's (Navier 1823)
                             [m], >= 0; default 0 */
    sph2d_side_speeds wall_speeds;     /**< of sides that are not free-slip; default 0 */
    double wall_damping;               /**< spring walls: damping over critical damping, 0 to 1; default 0.1 */
    sph2d_vec2 gravity;                /**< [m/s^2]; default (0, -9.81) */
    sph2d_central_force central_force; /**< default none */
    double spacing; /**< between particles, dx [m], > 0; must be given. Particle mass is density dx^2 */
    sph2d_fluid fluid;
    sph2d_method_options method;
    const sph2d_block *blocks;
    size_t block_count;
    sph2d_particles particles; /**< default none */
    const sph2d_source *sources;
    size_t source_count;
    const sph2d_drain *drains;
    size_t drain_count;
    const sph2d_obstacle *obstacles;
    size_t obstacle_count;
    const sph2d_interaction *interactions;
    size_t interaction_count;
    const sph2d_probe *probes;
    size_t probe_count;
    sph2d_run run;
} sph2d_scene;

/** A scene with every default of this page, and nothing in it. */
SPH2D_API sph2d_scene sph2d_scene_default(void);
SPH2D_API sph2d_block sph2d_block_default(void);
SPH2D_API sph2d_source sph2d_source_default(void);
SPH2D_API sph2d_drain sph2d_drain_default(void);
SPH2D_API sph2d_obstacle sph2d_obstacle_default(void);
SPH2D_API sph2d_interaction sph2d_interaction_default(void);
SPH2D_API sph2d_probe sph2d_probe_default(void);

/** The table of materials, by sph2d_material; static storage. */
SPH2D_API const sph2d_material_data *sph2d_materials(size_t *count);
/** A liquid with the density and viscosity of a material, and no surface tension: name that where drops and jets are so
 *  small that it matters. The default liquid for none. */
SPH2D_API sph2d_fluid sph2d_fluid_of(sph2d_material material);

/** Finds every fault that the structs alone show: ranges, conflicts, places outside the domain. Overlaps of blocks are
 *  found when particles are placed (sph2d_scene_plan, sph2d_sim_create). Returns SPH2D_OK or SPH2D_SCENE. */
SPH2D_API sph2d_status sph2d_scene_check(const sph2d_scene *scene, sph2d_report *report);

/** Seconds between outputs [s]; 0 for none. */
SPH2D_API double sph2d_rate_interval(sph2d_rate rate);
/** When output number `n` (0, 1, ...) is due [s]: n times the interval without accumulated rounding. */
SPH2D_API double sph2d_rate_due(sph2d_rate rate, uint64_t n);

/** What a scene will be, before it runs. */
typedef struct sph2d_plan {
    size_t fluid_particles; /**< at the start */
    size_t wall_particles;
    size_t places_left_free;       /**< lattice places inside an obstacle, or too close to one without layers */
    double area_asked;             /**< of all blocks without the solids in them [m^2] */
    double area_left_out;          /**< of all blocks, inside solid obstacles, where no liquid is placed [m^2] */
    double most_left_out;          /**< the largest part of a block that is so, 0 to 1 */
    size_t most_left_out_block;    /**< index of that block */
    double area_placed;            /**< dx^2 of each of their particles, by the block's own spacing [m^2] */
    double particle_mass;          /**< [kg/m] */
    double support_radius;         /**< H [m]: kernels are zero beyond it */
    double sound_speed;            /**< c0 [m/s] */
    char sound_speed_formula[160]; /**< how c0 came about, with its numbers */
    double head;                   /**< g h + U^2/2 + pull [m^2/s^2], from which c0 is derived */
    double impact_compression;     /**< U/c0 with U = sqrt(2 head): what a full impact may reach for a moment */
    double time_step;              /**< that speed and sound allow at the start [s] */
    const char *time_step_limit;   /**< "acoustic", "viscous", "force" or "fixed" */
    double steps;                  /**< to run.until at that step */
    double memory;                 /**< bytes, at the start */
    double snapshots, frames;      /**< numbers of outputs to run.until */
    double disk;                   /**< bytes of snapshots, uncompressed */
} sph2d_plan;

/** Checks a scene and places its particles to tell what it will be. Errors: SPH2D_SCENE, SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_scene_plan(const sph2d_scene *scene, sph2d_plan *plan, sph2d_report *report);

#ifdef __cplusplus
}
#endif
#endif
