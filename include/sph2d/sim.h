/* SPDX-License-Identifier: MIT */
/** @file sim.h
 *  A simulation: create it from a scene, advance it, read its particles, its errors and its speed.
 *
 *      sph2d_sim *sim = NULL;
 *      if (sph2d_sim_create(&scene, NULL, &sim, &report) != SPH2D_OK) ...;
 *      while (sph2d_sim_time(sim) < 1.0)
 *          if (sph2d_sim_step(sim, &report) != SPH2D_OK) ...;
 *      sph2d_view fluid = sph2d_sim_fluid(sim);
 *      sph2d_sim_destroy(sim);
 *
 *  A simulation may be used by one thread at a time; different simulations by different threads at the same time. A
 *  step is a parallel region of OpenMP: it runs on the calling thread and on those of OpenMP's runtime, which belong to
 *  the process and wait for the next region as OMP_WAIT_POLICY says. So OMP_NUM_THREADS, OMP_THREAD_LIMIT,
 *  OMP_PROC_BIND and OMP_PLACES mean what they mean in other programs, a call inside a parallel region of the caller
 *  takes one thread unless OMP_MAX_ACTIVE_LEVELS allows more, and beside other busy jobs OMP_WAIT_POLICY=passive is
 *  faster. A forked process may go on with its copy of a simulation. Where the system refuses a thread, OpenMP's
 *  runtime ends the process. Built by clang, steps on other threads of the host than that of main() take one thread, as
 *  LLVM's runtime may break down when those end. */
#ifndef SPH2D_SIM_H
#define SPH2D_SIM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "sph2d/machine.h"
#include "sph2d/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A simulation: its scene, its particles, its clock. */
typedef struct sph2d_sim sph2d_sim;

/** A memory allocator. */
typedef struct sph2d_allocator {
    /** Works like realloc, and like free for size 0; it also gets the old size. Blocks must be aligned to 64 bytes. */
    void *(*resize)(void *user, void *block, size_t old_size, size_t new_size);

    /** Passed to `resize`. */
    void *user;
} sph2d_allocator;

/** Options that are not part of the scene. Make one with sph2d_sim_options_default(). */
typedef struct sph2d_sim_options {
    /** Set by sph2d_sim_options_default(); detects other versions and uninitialised structs. */
    size_t struct_size;

    /** Number of threads, 1 to 1024; default 0: what OpenMP says for the calling thread (OMP_NUM_THREADS, else the
     *  processors that the process may use), at most one for 512 particles. */
    int threads;

    /** Instruction set; default auto. With a device it is baseline, and another one is refused. */
    sph2d_isa isa;

    /** The device that takes the steps, a number from 1 on in the list of sph2d_devices(); default 0: the processor. What it
     *  cannot do is refused (sph2d_device_refuses()). */
    int device;

    /** Whether only a device is taken that makes the same bits as the processor; default false. */
    bool same_bits;

    /** Memory allocator; default {NULL, NULL}: the C library's. */
    sph2d_allocator allocator;

    /** Whether each phase of a step is timed, for sph2d_sim_profile(); default false. */
    bool profile;
} sph2d_sim_options;

/** The default options. */
SPH2D_API sph2d_sim_options sph2d_sim_options_default(void);

/** Checks the scene, copies it, places its particles and evaluates the first forces. `options` and `report` may be
 *  NULL. The caller owns *sim, which is NULL after a failure. Errors: SPH2D_SCENE, SPH2D_INVALID, SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_sim_create(const sph2d_scene *scene, const sph2d_sim_options *options, sph2d_sim **sim,
                                        sph2d_report *report);

/** Frees a simulation; NULL is fine. */
SPH2D_API void sph2d_sim_destroy(sph2d_sim *sim);

/** Advances by one time step. Errors: SPH2D_GUARD when a guard stops the run (the state stays as it is, for a
 *  snapshot), SPH2D_NOMEM, SPH2D_DEVICE when a device fails. After an error every later call fails the same way.
 *
 *  After SPH2D_NOMEM the particles are in the middle of the step. All functions can still be called: fields, views,
 *  counts and sums tell what the particles are now, what depends on neighbours (samples, the number of neighbours,
 *  the energy of surface tension) is NaN, probes have no values, and there is no state and no snapshot. The same holds after SPH2D_DEVICE, with the particles as the
 *  processor last had them, and when a device is lost between steps. */
SPH2D_API sph2d_status sph2d_sim_step(sph2d_sim *sim, sph2d_report *report);

/** Whether a run shall take another step. It is called on the thread that called sph2d_sim_run(), and may look at the
 *  simulation, steer it and write it, but not destroy it. */
typedef bool sph2d_go_on(void *user, sph2d_sim *sim);

/** Takes steps for as long as `go_on` says so; it is asked before each of them. The same as single steps, but in one
 *  parallel region, whose threads need not meet at the end of every step: faster, most of all beside other jobs.
 *  `user` is passed on. Errors: as sph2d_sim_step(); a stopped simulation is not asked. */
SPH2D_API sph2d_status sph2d_sim_run(sph2d_sim *sim, sph2d_go_on *go_on, void *user, sph2d_report *report);

/** Simulated time [s]. */
SPH2D_API double sph2d_sim_time(const sph2d_sim *sim);

/** Steps taken. */
SPH2D_API uint64_t sph2d_sim_steps(const sph2d_sim *sim);

/** Length of the next step [s]. */
SPH2D_API double sph2d_sim_time_step(const sph2d_sim *sim);

/** The instruction set in use, never auto. */
SPH2D_API sph2d_isa sph2d_sim_isa(const sph2d_sim *sim);

/** The number of threads that the next step asks OpenMP for. */
SPH2D_API int sph2d_sim_threads(const sph2d_sim *sim);

/** Memory allocated [bytes]. */
SPH2D_API size_t sph2d_sim_memory(const sph2d_sim *sim);

/** The simulation's own copy of its scene, valid as long as the simulation. */
SPH2D_API const sph2d_scene *sph2d_sim_scene(const sph2d_sim *sim);

/** The plan of the scene when the simulation was created. */
SPH2D_API const sph2d_plan *sph2d_sim_plan(const sph2d_sim *sim);

/** Borrowed arrays with one value per particle, valid until the next call that changes the simulation. Sorting changes
 *  the order; `id` identifies a particle permanently. */
typedef struct sph2d_view {
    /** Number of particles. */
    size_t count;

    /** Position [m]. */
    const double *x, *y;

    /** Velocity [m/s]. */
    const double *vx, *vy;

    /** Acceleration [m/s^2]; NULL for walls. */
    const double *ax, *ay;

    /** Density [kg/m^3]. */
    const double *density;

    /** Pressure [Pa]. */
    const double *pressure;

    /** A particle's permanent number. */
    const uint64_t *id;
} sph2d_view;

/** The number of particles of the liquid, which sph2d_sim_fluid() has, too: but that fetches all of its arrays from a device. */
SPH2D_API size_t sph2d_sim_count(const sph2d_sim *sim);

/** The particles of the liquid. */
SPH2D_API sph2d_view sph2d_sim_fluid(const sph2d_sim *sim);

/** The boundary particles. */
SPH2D_API sph2d_view sph2d_sim_walls(const sph2d_sim *sim);

/** The liquid at a point. */
typedef struct sph2d_sample {
    /** Velocity [m/s]. */
    double velocity[2];

    /** Pressure [Pa]. */
    double pressure;

    /** Density [kg/m^3]. */
    double density;

    /** Number of particles within the support radius of the point. */
    double neighbours;
} sph2d_sample;

/** Values of the liquid at a point [m], of third order inside liquid: a quadratic polynomial is fitted to the particles
 *  within the support radius. If they do not determine it, or if its value exceeds theirs by more than their range, as
 *  near walls and surfaces, a linear fit is used, then their average. False if no particle is within the support
 *  radius: the values are then NaN. */
SPH2D_API bool sph2d_sim_sample(const sph2d_sim *sim, sph2d_vec2 at, sph2d_sample *out);

/* ---- steering while it runs -------------------------------------------------------------------------------------- */

/** Sets gravity [m/s^2] from the next step on; the change of potential counts as energy_fed. Errors: SPH2D_INVALID when
 *  not finite. */
SPH2D_API sph2d_status sph2d_sim_set_gravity(sph2d_sim *sim, sph2d_vec2 gravity);

/** Attracts liquid to a point (acceleration > 0) or repels it (< 0), like an interaction of the scene; acceleration 0
 *  ends it, and the radius may then be 0. Part of the state. Errors: SPH2D_INVALID when a value is not finite or out of
 *  range. */
SPH2D_API sph2d_status sph2d_sim_set_pointer(sph2d_sim *sim, sph2d_vec2 at, double radius, double acceleration);

/** Adds particles of liquid between steps, with their velocities and densities (0: rest density), where there is room:
 *  in the domain, 0.75 spacings from other particles and from walls, in no solid; those for which there is none are left
 *  out. `added`, which may be NULL, is how many were added. They count as `fed`, their energy as energy_fed.
 *  Errors: SPH2D_INVALID for NULL or values that are not finite (nothing is added then), SPH2D_NOMEM, SPH2D_GUARD after
 *  a guard has stopped the run. */
SPH2D_API sph2d_status sph2d_sim_add_particles(sph2d_sim *sim, const sph2d_particle *particles, size_t count,
                                               size_t *added);

/** Removes all particles of liquid in a shape between steps; `removed`, which may be NULL, is how many there were. They
 *  count as `drained`, their energy as energy_fed. Errors: SPH2D_INVALID for NULL, or a shape with values that are not
 *  finite, of no kind, or without area; SPH2D_NOMEM, SPH2D_GUARD after a guard has stopped the run. */
SPH2D_API sph2d_status sph2d_sim_remove_particles(sph2d_sim *sim, const sph2d_shape *shape, size_t *removed);

/* ---- bodies ------------------------------------------------------------------------------------------------------ */

/** Where a body is, and how it moves. */
typedef struct sph2d_body_state {
    /** Centre of mass [m]; of an obstacle the point about which it turns. */
    sph2d_vec2 center;

    /** Angle by which it has turned since the start, anticlockwise [rad]. */
    double angle;

    /** Velocity of that point [m/s]. By methods wcsph and muller contacts act on the velocity with which a body moves
     *  through a step, and half a step of its other forces is added at the end. So a body that rests on a floor, and
     *  does not move, has a velocity a dt/2 here, a being its weight less buoyancy over its mass: the contacts of the
     *  next step, which are not known yet, undo it. */
    sph2d_vec2 velocity;

    /** Angular velocity, anticlockwise [rad/s]. */
    double rate;

    /** Force of the liquid on a body, in the mean over the last step, per metre of depth [N/m]; 0 for obstacles. */
    sph2d_vec2 force;

    /** Its torque about the centre of mass [N]. */
    double torque;
} sph2d_body_state;

/** Body `index` of the scene; all NaN for a bad index. */
SPH2D_API sph2d_body_state sph2d_sim_body(const sph2d_sim *sim, size_t index);

/** Obstacle `index` of the scene, at the end of the last step; all NaN for a bad index. */
SPH2D_API sph2d_body_state sph2d_sim_obstacle(const sph2d_sim *sim, size_t index);

/** Sets the velocity and angular velocity of a body from the next step on, like a blow; motions that are held stay 0. The
 *  change of energy counts as energy_fed. Errors: SPH2D_INVALID for a bad index or a value that is not finite. */
SPH2D_API sph2d_status sph2d_sim_set_body_velocity(sph2d_sim *sim, size_t index, sph2d_vec2 velocity, double rate);

/** A body about to move, as a solver for contacts or an engine for rigid bodies sees it. */
typedef struct sph2d_contact_body {
    /** One over its mass, along x and y [m/kg], and over its moment of inertia [1/(kg m)]; 0 where the scene holds it. */
    double inverse_mass_x, inverse_mass_y, inverse_inertia;

    /** Centre of mass [m] and angle [rad]. */
    sph2d_vec2 center;
    double angle;

    /** Velocity and angular velocity with which it will move over the step, with all forces on it but those of contacts
     *  [m/s, rad/s]: what the solver changes. */
    sph2d_vec2 velocity;
    double rate;
} sph2d_contact_body;

/** Changes velocities of bodies that meet each other or walls, once per step of length dt [s], such that they do not
 *  overlap when each has moved by dt times its velocity. `sim` can be read: the scene has the outlines, and
 *  sph2d_sim_obstacle() says where walls that move are. What it returns other than SPH2D_OK ends the step. Results must
 *  follow from its arguments alone: a resumed run calls it with the same ones.
 *
 *  `wall_work` comes with zeros, one for each wall: the sides left, right, bottom, top, then the scene's obstacles.
 *  The solver adds to them the work that the wall does on bodies in this step, impulse on a body times the velocity of
 *  the wall where they touch [J/m]: part of energy_walls, and of the work that a probe of this wall measures. Walls at
 *  rest do none. What a solver does not tell is missing there: it makes energy_contacts negative, counts as
 *  energy_rise, from nothing, and may stop the run (SPH2D_GUARD). */
typedef sph2d_status sph2d_contact_solver(void *user, const sph2d_sim *sim, double dt, sph2d_contact_body *bodies,
                                          size_t count, double *wall_work);

/** Sets the solver for contacts of bodies, which is called with `user` in every step from the next one on; NULL: none,
 *  bodies then pass through each other and through walls. The kinetic energy that it takes, and the work of walls that
 *  it tells, count as energy_contacts.
 *  Errors: SPH2D_INVALID for NULL. */
SPH2D_API sph2d_status sph2d_sim_set_contacts(sph2d_sim *sim, sph2d_contact_solver *solver, void *user);

/* ---- outputs ----------------------------------------------------------------------------------------------------- */

/** The outputs of a scene. Probe p is SPH2D_OUTPUT_PROBE + p. */
enum { SPH2D_OUTPUT_SNAPSHOT = 0, SPH2D_OUTPUT_FRAME = 1, SPH2D_OUTPUT_PROBE = 2 };

/** Whether an output is due now: its time has come and it was not yet written. An output that is due more often than
 *  there are steps is written once per step and lags behind. */
SPH2D_API bool sph2d_sim_output_due(const sph2d_sim *sim, size_t output);

/** How many times an output was written: the number of the next file. Part of the state. */
SPH2D_API uint64_t sph2d_sim_output_count(const sph2d_sim *sim, size_t output);

/** Where outputs of probes of kind tracer found their particles, in the order of time. */
typedef struct sph2d_paths {
    /** Number of places. */
    size_t count;

    /** Their x and y, one after the other [m]. */
    const double *places;

    /** The probe of each. */
    const uint64_t *probes;
} sph2d_paths;

/** The places so far, valid until the next output; part of the state. Empty for NULL. */
SPH2D_API sph2d_paths sph2d_sim_paths(const sph2d_sim *sim);

/** Records that an output is written now; the impulses of a force probe begin anew, and the path of a tracer goes on. Call it before writing a snapshot,
 *  so that the snapshot's own state counts it. */
SPH2D_API void sph2d_sim_output_done(sph2d_sim *sim, size_t output);

/** Columns of a probe's rows after `time`, separated by commas, with units: "kinetic [J/m],...". Static storage. */
SPH2D_API const char *sph2d_probe_columns(sph2d_probe_kind kind);

/** The largest number of columns of a probe. */
#define SPH2D_PROBE_MAX_COLUMNS 12

/** Evaluates probe `index` of the scene now. Writes the values of its columns and returns how many; 0 for a bad index.
 *  Undefined values (no particle near) are NaN. 0 also when memory is short, as some kinds need it for a while. */
SPH2D_API size_t sph2d_sim_probe(const sph2d_sim *sim, size_t index, double values[SPH2D_PROBE_MAX_COLUMNS]);

/* ---- errors and speed -------------------------------------------------------------------------------------------- */

/** Totals and errors of the run so far. "compression" is rho/rho0 - 1 if positive, else 0. */
typedef struct sph2d_summary {
    /** Simulated time [s]. */
    double time;

    /** Steps taken, including those before a run was resumed. */
    uint64_t steps;

    /** Particles advanced, summed over the steps. */
    uint64_t particle_steps;

    /** Fluid particles now. */
    uint64_t particles;

    /** Compression: 99th percentile over particles, averaged over the time outside impacts. */
    double compression_p99;

    /** Compression: mean over particles, averaged over the time outside impacts. */
    double compression_mean;

    /** Largest compression of all particles and steps. */
    double compression_max;

    /** Energy now [J/m]; potential is that of gravity, 0 at the domain's corner min, of the central force, of spring
     *  walls, k d^2/2 per kilogram at depth d, and of surface tension. */
    double kinetic, potential;

    /** Energy of compression [J/m]: by the equation of state of methods wcsph, constraint and muller, with the first two
     *  also that of pairs that repel each other and of gravity that is less beside sides; with pcisph that of a start
     *  compressed beyond max_compression,
     *  until it has expanded. */
    double elastic;

    /** kinetic + potential + elastic at the start [J/m]. */
    double energy_start;

    /** Largest rise of energy above an earlier value, without external work: by sources, changes of gravity, moving
     *  walls, interactions, forces along periods [J/m]. NaN with fitted operators and moving walls, whose work they do
     *  not compute. */
    double energy_rise;

    /** Error of the energy balance at the last sample [J/m]: kinetic + potential + elastic - energy_start, minus
     *  external work, plus dissipation: positive for energy from nothing, negative for energy that was lost and is
     *  counted nowhere; NaN with fitted operators and moving obstacles. */
    double energy_error;

    /** Largest rise of energy_error above an earlier value [J/m]. */
    double energy_error_rise;

    /** Work of moving walls: on the liquid by pressure, friction and the swept test, and on bodies by contact [J/m]. */
    double energy_walls;

    /** Work of interactions, the pointer, gravity along periods, motors and dampers, of the pressure in gaps between
     *  bodies and walls that are too thin for particles, less what absorbing ends took [J/m]. */
    double energy_forces;

    /** Energy dissipated by viscosity, artificial viscosity, wall friction, dampers [J/m]. */
    double energy_viscous;

    /** Elastic energy dissipated by diffusion of density, its relaxation to its sum, and its reset to rest density in
     *  isolated particles [J/m]. */
    double energy_diffused;

    /** Energy removed by the swept test against walls at rest and by reflections [J/m]. */
    double energy_stopped;

    /** Kinetic and potential energy of the bodies now, and of their springs [J/m]; part of energy_start and energy_rise. */
    double bodies;

    /** Energy that contacts of bodies took, of that of the bodies and of the work of moving walls on them: impacts and
     *  dry friction [J/m]. It falls where a solver gives energy: libsph2d-contacts where it lifts a body that starts
     *  nearer to a floor than the clearance, by its weight times the way. */
    double energy_contacts;

    /** Energy dissipated by the pressures of method pcisph, with which impacts are inelastic: their
     *  work minus that of moving walls and the change of elastic energy, if below 0 [J/m]. */
    double energy_pressed;

    /** Scale of rise and error: (n m + mass of the bodies) (g h + U^2/2 + pull)/2 of the scene, with U but for springs,
     *  plus the energy of bodies' springs at the start, the elastic energy then of methods that sum density, and the
     *  surface energy of a round drop of its liquid [J/m]. */
    double energy_scale;

    /** Largest kinetic energy of the liquid so far [J/m]: errors that are small beside energy_scale may not be beside
     *  this. */
    double kinetic_max;

    /** Largest difference between the densities of sph2d_sim_densities(), sampled every 500th step; 0 if never defined.
     */
    double density_apart;

    /** Energy added by sources and changes of gravity minus that removed by drains and open sides [J/m]. */
    double energy_fed;

    /** Momentum of the liquid now [kg/s]. */
    double momentum[2];

    /** Momentum that came from nothing, neither from walls or bodies nor from external forces, now, and its largest size
     *  so far [kg/s], as seen in every step of methods pcisph and constraint, and in every 8th of others. What leaves it
     *  where particles come or go counts for one step. NaN with openings and with fitted operators, whose forces are not
     *  known. */
    double momentum_error[2], momentum_error_max;

    /** Largest sum of the sizes of the particles' momenta so far, to compare momentum_error_max with [kg/s]; 0 where
     *  that is NaN. */
    double momentum_moved;

    /** Speed of the fastest particle now [m/s]. */
    double speed_max;

    /** Particles nearer than 0.3 spacings to another now: pairs that act as one particle. */
    uint64_t paired;

    /** Particles emitted by sources, and those not emitted because their position was occupied. */
    uint64_t fed, blocked;

    /** Particles removed by drains. */
    uint64_t drained;

    /** Particles that came into the reservoirs of openings, and left them, at their ends. */
    uint64_t let_in, let_out;

    /** Particles lost through open sides: left, right, bottom, top. */
    uint64_t left_open[4];

    /** How often the swept test stopped a particle at a wall. */
    uint64_t backstop_hits;

    /** Immediate reflections at boundary particles. */
    uint64_t reflections;

    /** Iterations of the pressure solver, summed over the steps. */
    uint64_t iterations;

    /** Steps in which the pressure solver did not converge. */
    uint64_t unconverged;

    /** Steps limited by: acoustic, force, viscous limit, a fixed step. */
    uint64_t limited_by[4];

    /** Shortest and longest step [s]. */
    double time_step_min, time_step_max;

    /** Mean number of neighbours inside the support at the last sample, without the particle itself. */
    double neighbours;
} sph2d_summary;

/** The summary now. */
SPH2D_API sph2d_summary sph2d_sim_summary(const sph2d_sim *sim);

/** Mean density inside the liquid over rest density, and its volume. Inside are particles with liquid all around within
 *  5 spacings and no wall within 3; the densities are NaN if there are fewer than 20. */
typedef struct sph2d_densities {
    /** Mean of the particles' densities. */
    double reported;

    /** Mean number density of the particles times their mass, by a kernel of 3 spacings. */
    double counted;

    /** Area that the liquid covers, to a surface where half of a kernel is filled and of particles by themselves, over
     *  that of its particles at rest density; without reservoirs of openings. NaN without particles. */
    double covered;

    /** SPH2D_NOMEM if memory was short, and all are NaN; else SPH2D_OK. */
    sph2d_status status;
} sph2d_densities;

/** The densities now. It takes the time of a few steps, and memory meanwhile. */
SPH2D_API sph2d_densities sph2d_sim_densities(const sph2d_sim *sim);

/** The profile so far; zeros unless the option `profile` is set. Not part of the state. */
SPH2D_API sph2d_profile sph2d_sim_profile(const sph2d_sim *sim);

#ifdef __cplusplus
}
#endif
#endif
