/* SPDX-License-Identifier: MIT */
/** @file sim.h
 *  A simulation: make it from a scene, step it, look at its particles, ask for its errors and its speed.
 *
 *      sph2d_sim *sim = NULL;
 *      if (sph2d_sim_create(&scene, NULL, &sim, &report) != SPH2D_OK) ...;
 *      while (sph2d_sim_time(sim) < 1.0)
 *          if (sph2d_sim_step(sim, &report) != SPH2D_OK) ...;
 *      sph2d_view fluid = sph2d_sim_fluid(sim);
 *      sph2d_sim_destroy(sim);
 *
 *  A simulation may be used by one thread at a time; different simulations by different threads at the same time. A
 *  step is made by the thread that asks for it and by helpers of the simulation's own, which start when there is enough
 *  to do, take no signals, sleep from a tenth of a millisecond after the last loop, and end with the simulation. They
 *  are left out while they bring nothing, since other jobs have the processors or there is too little to do. A process
 *  that is forked off has none of them and steps alone. */
#ifndef SPH2D_SIM_H
#define SPH2D_SIM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "sph2d/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A simulation: its scene, its particles, its clock. */
typedef struct sph2d_sim sph2d_sim;

/** The instruction set of the pair loops. Results are the same bits for any number of threads, not across sets. */
typedef enum sph2d_isa {
    /** The widest that the processor and this build have. */
    SPH2D_ISA_AUTO = 0,

    /** What every processor of this kind has: SSE2 on x86-64. */
    SPH2D_ISA_BASELINE = 1,

    /** AVX2 and fused multiply-add, four doubles at a time. */
    SPH2D_ISA_AVX2 = 2,

    /** AVX-512, eight doubles at a time. */
    SPH2D_ISA_AVX512 = 3
} sph2d_isa;

/** Where memory comes from. */
typedef struct sph2d_allocator {
    /** Works like realloc, with size 0 for free; it gets the old size too. Blocks must be aligned to 64 bytes. */
    void *(*resize)(void *user, void *block, size_t old_size, size_t new_size);

    /** Handed to `resize` as it is. */
    void *user;
} sph2d_allocator;

/** What does not change the result. Make one with sph2d_sim_options_default(). */
typedef struct sph2d_sim_options {
    /** Set by sph2d_sim_options_default(); tells versions and uninitialised structs apart. */
    size_t struct_size;

    /** The most threads, 1 to 1024; default 0: as many as the process may use processors. */
    int threads;

    /** Instruction set; default auto. */
    sph2d_isa isa;

    /** Where memory comes from; default {NULL, NULL}: the C library. */
    sph2d_allocator allocator;

    /** Whether clocks are read at every phase of a step, for sph2d_sim_profile(); default false. */
    bool profile;
} sph2d_sim_options;

/** Options with every default of this page. */
SPH2D_API sph2d_sim_options sph2d_sim_options_default(void);

/** Name of an instruction set, "avx2"; static storage. */
SPH2D_API const char *sph2d_isa_name(sph2d_isa isa);

/** Whether this processor and this build have it. */
SPH2D_API bool sph2d_isa_available(sph2d_isa isa);

/** Checks the scene, copies it, places its particles and evaluates the first forces. `options` and `report` may be
 *  NULL. The caller owns *sim, which is NULL after a failure. Errors: SPH2D_SCENE, SPH2D_INVALID, SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_sim_create(const sph2d_scene *scene, const sph2d_sim_options *options, sph2d_sim **sim,
                                        sph2d_report *report);

/** Frees a simulation; NULL is fine. */
SPH2D_API void sph2d_sim_destroy(sph2d_sim *sim);

/** Advances by one time step. Errors: SPH2D_GUARD when a guard stops the run (the state stays as it is, for a
 *  snapshot), SPH2D_NOMEM. After an error every later call fails the same way. */
SPH2D_API sph2d_status sph2d_sim_step(sph2d_sim *sim, sph2d_report *report);

/** Simulated time [s]. */
SPH2D_API double sph2d_sim_time(const sph2d_sim *sim);

/** Steps taken. */
SPH2D_API uint64_t sph2d_sim_steps(const sph2d_sim *sim);

/** Length of the step that comes next [s]. */
SPH2D_API double sph2d_sim_time_step(const sph2d_sim *sim);

/** The instruction set in use, never auto. */
SPH2D_API sph2d_isa sph2d_sim_isa(const sph2d_sim *sim);

/** The most threads that share a step. */
SPH2D_API int sph2d_sim_threads(const sph2d_sim *sim);

/** Memory allocated [bytes]. */
SPH2D_API size_t sph2d_sim_memory(const sph2d_sim *sim);

/** The simulation's own copy of its scene, valid as long as the simulation. */
SPH2D_API const sph2d_scene *sph2d_sim_scene(const sph2d_sim *sim);

/** The plan of the scene as it stood when the simulation was made. */
SPH2D_API const sph2d_plan *sph2d_sim_plan(const sph2d_sim *sim);

/** Borrowed arrays of one value a particle, valid until the next call that changes the simulation. Sorting changes the
 *  order; `id` names a particle for ever. */
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

    /** A particle's number, for ever. */
    const uint64_t *id;
} sph2d_view;

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
 *  within the support radius. Where they do not carry it, or where it gives a value further beyond theirs than they are
 *  from each other, a linear one is taken, then their average: near walls and surfaces. False where no particle is
 *  within the support radius: then the values are NaN. */
SPH2D_API bool sph2d_sim_sample(const sph2d_sim *sim, sph2d_vec2 at, sph2d_sample *out);

/* ---- steering while it runs -------------------------------------------------------------------------------------- */

/** Sets gravity [m/s^2] from the next step on; the change of potential counts as energy_fed. Errors: SPH2D_INVALID when
 *  not finite. */
SPH2D_API sph2d_status sph2d_sim_set_gravity(sph2d_sim *sim, sph2d_vec2 gravity);

/** Pulls (acceleration > 0) or pushes (< 0) at a point, like an interaction of the scene; acceleration 0 ends it, and
 *  the radius may then be 0. Part of the state. Errors: SPH2D_INVALID when a value is not finite or out of range. */
SPH2D_API sph2d_status sph2d_sim_set_pointer(sph2d_sim *sim, sph2d_vec2 at, double radius, double acceleration);

/* ---- what is due ------------------------------------------------------------------------------------------------- */

/** The outputs that a scene can ask for. Probe p is SPH2D_OUTPUT_PROBE + p. */
enum { SPH2D_OUTPUT_SNAPSHOT = 0, SPH2D_OUTPUT_FRAME = 1, SPH2D_OUTPUT_PROBE = 2 };

/** Whether an output is due now: the clock has reached its due time and it was not yet taken. An output that is due
 *  more often than there are steps is taken once a step and lags behind. */
SPH2D_API bool sph2d_sim_output_due(const sph2d_sim *sim, size_t output);

/** How many of an output were taken: the number of the next file. Part of the state. */
SPH2D_API uint64_t sph2d_sim_output_count(const sph2d_sim *sim, size_t output);

/** Takes note that an output was written at this moment. Call it before writing a snapshot, so that the snapshot's own
 *  state knows of itself. */
SPH2D_API void sph2d_sim_output_done(sph2d_sim *sim, size_t output);

/** Columns of a probe's rows after `time`, separated by commas, with units: "kinetic [J/m],...". Static storage. */
SPH2D_API const char *sph2d_probe_columns(sph2d_probe_kind kind);

/** The most columns that a probe has. */
#define SPH2D_PROBE_MAX_COLUMNS 8

/** Evaluates probe `index` of the scene now. Writes the values of its columns and returns how many; 0 for a bad index.
 *  Values without meaning (no particle near) are NaN. */
SPH2D_API size_t sph2d_sim_probe(const sph2d_sim *sim, size_t index, double values[SPH2D_PROBE_MAX_COLUMNS]);

/* ---- errors and speed -------------------------------------------------------------------------------------------- */

/** What happened so far. "compression" is rho/rho0 - 1 where positive. */
typedef struct sph2d_summary {
    /** Simulated time [s]. */
    double time;

    /** Steps taken, over all sessions of a resumed run. */
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

    /** Energy now [J/m]; potential is that of gravity, 0 at the domain's corner min, of the central force, of the
     *  sides' springs, k d^2/2 a kilogram at depth d, and of the surface under tension. */
    double kinetic, potential;

    /** Energy of compression: by the equation of state of methods wcsph and muller; with constraint m c0^2 e^2/2 at the
     *  compression e that pressure holds; with pcisph what a start held beyond max_compression, until it expanded
     *  [J/m]. */
    double elastic;

    /** kinetic + potential + elastic at the start [J/m]. */
    double energy_start;

    /** How far energy ever rose above an earlier moment, less what was brought: by particles, new gravity, moving
     *  walls, interactions, forces along periods [J/m]. NaN with fitted operators and walls that move, whose work they
     *  do not tell. */
    double energy_rise;

    /** What does not add up: kinetic + potential + elastic - energy_start less what was brought, plus what dissipated,
     *  at the last look [J/m]; NaN with fitted operators and obstacles that move. */
    double energy_error;

    /** How far energy_error ever rose above an earlier moment [J/m]. */
    double energy_error_rise;

    /** Energy brought by walls that move, through pressure, friction and the swept test [J/m]. */
    double energy_walls;

    /** Energy brought by interactions, the pointer and gravity along periods [J/m]. */
    double energy_forces;

    /** Energy taken by viscosity, artificial viscosity, friction at walls, dampers [J/m]. */
    double energy_viscous;

    /** Elastic energy taken by diffusion of density [J/m]. */
    double energy_diffused;

    /** Energy taken by the swept test against walls at rest and by reflections [J/m]. */
    double energy_stopped;

    /** Energy taken by the pressures of methods pcisph and constraint, which let no liquid bounce: their work less that
     *  of moving walls and what is stored, where it is below 0 [J/m]. */
    double energy_pressed;

    /** What a rise and the error are measured by: n m (g h + U^2/2 + pull)/2 of the scene, and the surface of a round
     *  drop of its liquid under tension [J/m]. */
    double energy_scale;

    /** Largest difference of the densities of sph2d_sim_densities(), looked at in every 500th step; 0 where there was
     *  none. */
    double density_apart;

    /** Energy that sources and new gravity brought less what drains and open sides took [J/m]. */
    double energy_fed;

    /** Momentum of the liquid now [kg/s]. */
    double momentum[2];

    /** Speed of the fastest particle now [m/s]. */
    double speed_max;

    /** Particles that sources fed, and places that they found taken. */
    uint64_t fed, blocked;

    /** Particles lost to drains. */
    uint64_t drained;

    /** Particles lost through open sides: left, right, bottom, top. */
    uint64_t left_open[4];

    /** Times the swept test against walls had to hold a particle. */
    uint64_t backstop_hits;

    /** Immediate reflections at boundary particles. */
    uint64_t reflections;

    /** Iterations of the pressure solver, summed over the steps. */
    uint64_t iterations;

    /** Steps after which the pressure solver was not done. */
    uint64_t unconverged;

    /** Steps whose length was set by: acoustic, force, viscous limit, the scene. */
    uint64_t limited_by[4];

    /** Shortest and longest step [s]. */
    double time_step_min, time_step_max;

    /** Mean number of neighbours inside the support at the last sample, without the particle itself. */
    double neighbours;
} sph2d_summary;

/** What happened until now. */
SPH2D_API sph2d_summary sph2d_sim_summary(const sph2d_sim *sim);

/** Mean density inside the liquid over rest density. Inside is what has liquid all around it for 5 spacings, and no
 *  wall within 3; NaN where there are less than 20 such particles, and where memory is short. */
typedef struct sph2d_densities {
    /** The mean density that particles have. */
    double reported;

    /** The mean density by counting particles on the area, with a kernel of 3 spacings. */
    double counted;
} sph2d_densities;

/** The densities now. It counts all particles, which takes as long as a few steps do, and memory while it does. */
SPH2D_API sph2d_densities sph2d_sim_densities(const sph2d_sim *sim);

/** What a step spends its time on. */
typedef enum sph2d_phase {
    /** Kicks and drifts, and what holds particles on their ways. */
    SPH2D_PHASE_MOVE,

    /** Cells, and the order of particles that follows from them. */
    SPH2D_PHASE_SORT,

    /** Sums over the liquid around boundary particles. */
    SPH2D_PHASE_WALLS,

    /** Finding the neighbours that a pressure solver keeps, and density with them. */
    SPH2D_PHASE_SEARCH,

    /** Sums over neighbours for density or its rate. */
    SPH2D_PHASE_DENSITY,

    /** Sums over neighbours for accelerations. */
    SPH2D_PHASE_FORCES,

    /** A pressure solver. */
    SPH2D_PHASE_SOLVE,

    /** Sources and drains, guards, the next step's length, samples. */
    SPH2D_PHASE_BOOKKEEPING,

    /** The number of phases. */
    SPH2D_PHASE_COUNT
} sph2d_phase;

/** Name of a phase, "move", "sort", ...; static storage. */
SPH2D_API const char *sph2d_phase_name(sph2d_phase phase);

/** Where the time of the steps went, since the simulation was made. */
typedef struct sph2d_profile {
    /** Seconds that pass for everyone. */
    double wall[SPH2D_PHASE_COUNT];

    /** Seconds that processors spent on this process. */
    double cpu[SPH2D_PHASE_COUNT];

    /** Times that the phase began. */
    uint64_t calls[SPH2D_PHASE_COUNT];
} sph2d_profile;

/** The profile until now; zeros unless the options asked for it. Not a part of the state. */
SPH2D_API sph2d_profile sph2d_sim_profile(const sph2d_sim *sim);

#ifdef __cplusplus
}
#endif
#endif
