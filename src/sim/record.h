/* SPDX-License-Identifier: MIT */
/** @file record.h
 *  The scalars of a run: clock, steering, energy balance, counters. All are part of the state, so that a resumed run
 *  has the same summary as one that was not interrupted. */
#ifndef SPH2D_SIM_RECORD_H
#define SPH2D_SIM_RECORD_H

#include <stdint.h>

/** Name, name in the state, exponents of metre, kilogram and second, meaning. */
#define SPH2D__RECORD_REALS(X)                                                                                         \
    X(time, "Time", 0, 0, 1, "simulated time")                                                                         \
    X(next_step, "NextTimeStep", 0, 0, 1, "length of the next step")                                                   \
    X(last_step, "LastTimeStep", 0, 0, 1, "length of the last step; 0 at the start")                                   \
    X(older_step, "OlderTimeStep", 0, 0, 1, "length of the step before the last; 0 if the scheme does not need it")    \
    X(speed, "LargestSpeed", 1, 0, -1, "largest speed of a particle")                                                  \
    X(mean_density, "MeanDensity", -3, 1, 0, "mean density of liquid that fills a closed domain; 0 in other scenes")   \
    X(gravity_x, "GravityX", 1, 0, -2, "gravity")                                                                      \
    X(gravity_y, "GravityY", 1, 0, -2, "gravity")                                                                      \
    X(pointer_x, "PointerX", 1, 0, 0, "position of the steering pointer")                                              \
    X(pointer_y, "PointerY", 1, 0, 0, "position of the steering pointer")                                              \
    X(pointer_radius, "PointerRadius", 1, 0, 0, "reach of the steering pointer")                                       \
    X(pointer_acceleration, "PointerAcceleration", 1, 0, -2, "strength of the steering pointer; 0 for none")           \
    X(energy_start, "EnergyStart", 1, 1, -2, "kinetic, potential and elastic energy at the start, per metre")          \
    X(energy_fed, "EnergyFed", 1, 1, -2, "energy of particles added less that of particles removed, per metre")        \
    X(energy_walls, "EnergyWalls", 1, 1, -2, "work of walls that move, on liquid and bodies, per metre")               \
    X(energy_forces, "EnergyForces", 1, 1, -2,                                                                         \
      "work of interactions, forces along periods, gaps, absorbers, per metre")                                        \
    X(energy_viscous, "EnergyViscous", 1, 1, -2, "energy dissipated by viscosity, per metre")                          \
    X(energy_diffused, "EnergyDiffused", 1, 1, -2,                                                                     \
      "elastic energy dissipated by diffusion, relaxation and resets of density, per metre")                           \
    X(energy_stopped, "EnergyStopped", 1, 1, -2, "energy lost by continuous collision and reflections, per metre")     \
    X(energy_contacts, "EnergyContacts", 1, 1, -2, "energy that contacts of bodies took, per metre")                   \
    X(energy_pressed, "EnergyPressed", 1, 1, -2, "energy dissipated by the pressure projection, per metre")            \
    X(work_pressed, "WorkPressed", 1, 1, -2,                                                                           \
      "work of the projection's pressure, less that of walls, since the last sample, per metre")                       \
    X(energy_elastic, "EnergyElastic", 1, 1, -2, "elastic energy at the last sample, per metre")                       \
    X(power_walls, "PowerWalls", 1, 1, -3, "power of walls that move at the last sample, per metre")                   \
    X(power_friction, "PowerFriction", 1, 1, -3, "power of their friction at the last sample, per metre")              \
    X(drives_time, "DrivesTime", 0, 0, 1, "time of the last sample of the power of walls and forces")                  \
    X(power_forces, "PowerForces", 1, 1, -3,                                                                           \
      "power of interactions and of forces along periods at the last sample, per metre")                               \
    X(power_viscous, "PowerViscous", 1, 1, -3, "power of viscosity on the liquid at the last sample, per metre")       \
    X(power_diffusion, "PowerDiffusion", 1, 1, -3, "power of density diffusion at the last sample, per metre")         \
    X(power_dissipated, "PowerDissipated", 1, 1, -3, "power of both at the last sample, per metre")                    \
    X(booked_time, "BookedTime", 0, 0, 1, "time of the last sample of dissipation")                                    \
    X(energy_held, "EnergyHeld", 1, 1, -2, "elastic energy at the start, of methods that sum density, per metre")      \
    X(energy_low, "EnergyLow", 1, 1, -2, "smallest energy so far, less energy and work added, per metre")              \
    X(energy_rise, "EnergyRise", 1, 1, -2,                                                                             \
      "largest rise of energy above an earlier time, less energy and work added, per metre")                           \
    X(energy_error, "EnergyError", 1, 1, -2, "error of the energy balance, per metre")                                 \
    X(error_low, "EnergyErrorLow", 1, 1, -2, "smallest error of the energy balance so far, per metre")                 \
    X(error_rise, "EnergyErrorRise", 1, 1, -2, "largest rise of the error above an earlier time, per metre")           \
    X(kinetic_max, "KineticMax", 1, 1, -2, "largest kinetic energy of the liquid so far, per metre")                   \
    X(momentum_error_x, "MomentumErrorX", 0, 1, -1, "momentum that came from nothing, per metre")                      \
    X(momentum_error_y, "MomentumErrorY", 0, 1, -1, "momentum that came from nothing, per metre")                      \
    X(momentum_rate_x, "MomentumRateX", 0, 1, -2, "rate of it at the last sample, per metre")                          \
    X(momentum_rate_y, "MomentumRateY", 0, 1, -2, "rate of it at the last sample, per metre")                          \
    X(momentum_time, "MomentumTime", 0, 0, 1, "time of the last sample of momentum")                                   \
    X(momentum_moved, "MomentumMoved", 0, 1, -1, "largest sum of the sizes of particles' momenta, per metre")          \
    X(momentum_worst, "MomentumWorst", 0, 1, -1, "largest momentum from nothing so far, per metre")                    \
    X(density_apart, "DensityApart", 0, 0, 0,                                                                          \
      "largest difference of reported and counted density inside the liquid, over rest density")                       \
    X(compression_max, "CompressionMax", 0, 0, 0, "largest compression so far")                                        \
    X(compression_p99, "CompressionP99Integral", 0, 0, 1, "99th percentile of compression, integrated over time")      \
    X(compression_mean, "CompressionMeanIntegral", 0, 0, 1, "mean compression, integrated over time")                  \
    X(sampled_time, "SampledTime", 0, 0, 1, "time that the two integrals cover")                                       \
    X(sample_time, "SampleTime", 0, 0, 1, "time of the last sample")                                                   \
    X(step_min, "TimeStepMin", 0, 0, 1, "shortest step so far")                                                        \
    X(step_max, "TimeStepMax", 0, 0, 1, "longest step so far")

#define SPH2D__RECORD_COUNTS(X)                                                                                        \
    X(steps, "Step", "steps taken")                                                                                    \
    X(particle_steps, "ParticleSteps", "particles advanced, summed over the steps")                                    \
    X(sample_step, "SampleStep", "step of an early sample of dissipation")                                             \
    X(next_id, "NextParticleID", "id of the next particle")                                                            \
    X(momentum_changes, "MomentumChanges",                                                                             \
      "particles added and removed before the last step; all bits: a program took some away since")                    \
    X(isa, "InstructionSet", "1 baseline, 2 avx2, 3 avx512")                                                           \
    X(next_limit, "NextLimit", "what limits the next step: acoustic, force, viscous, fixed")                           \
    X(short_steps, "ShortSteps", "consecutive steps that were near collapse")                                          \
    X(unconverged_row, "UnconvergedRow", "consecutive steps in which the pressure solver did not converge")            \
    X(fed, "Fed", "particles fed by sources")                                                                          \
    X(let_in, "LetIn", "particles that came into the reservoirs of openings")                                          \
    X(let_out, "LetOut", "particles that left the reservoirs of openings")                                             \
    X(blocked, "Blocked", "particles that sources could not feed for lack of space")                                   \
    X(drained, "Drained", "particles lost to drains")                                                                  \
    X(left_left, "LeftThroughLeft", "particles lost through the open left side")                                       \
    X(left_right, "LeftThroughRight", "particles lost through the open right side")                                    \
    X(left_bottom, "LeftThroughBottom", "particles lost through the open bottom side")                                 \
    X(left_top, "LeftThroughTop", "particles lost through the open top side")                                          \
    X(backstop_hits, "BackstopHits", "particles stopped by continuous collision with walls")                           \
    X(reflections, "Reflections", "reflections at boundary particles")                                                 \
    X(iterations, "Iterations", "iterations of the pressure solver, summed over the steps")                            \
    X(unconverged, "Unconverged", "steps in which the pressure solver did not converge")                               \
    X(limited_acoustic, "LimitedAcoustic", "steps limited by the speed of sound")                                      \
    X(limited_force, "LimitedForce", "steps limited by acceleration")                                                  \
    X(limited_viscous, "LimitedViscous", "steps limited by viscosity")                                                 \
    X(limited_fixed, "LimitedFixed", "steps of the length that the scene fixes")

typedef struct sph2d__record {
#define SPH2D__REAL_MEMBER(name, label, m, kg, s, text) double name;
    SPH2D__RECORD_REALS(SPH2D__REAL_MEMBER)
#undef SPH2D__REAL_MEMBER
#define SPH2D__COUNT_MEMBER(name, label, text) uint64_t name;
    SPH2D__RECORD_COUNTS(SPH2D__COUNT_MEMBER)
#undef SPH2D__COUNT_MEMBER
} sph2d__record;

#endif
