/* SPDX-License-Identifier: MIT */
/** @file probes.h
 *  The kinds of probes. Each writes the values of its columns and returns their number. Probes do not change the
 *  simulation, and their values are the same bits for any number of threads. */
#ifndef SPH2D_PROBES_PROBES_H
#define SPH2D_PROBES_PROBES_H

#include "sim/simulation.h"

typedef size_t sph2d__probe_kind(const sph2d_sim *sim, const sph2d_probe *probe, double *values);

/** The functions of all kinds. */
#define SPH2D__PROBE_DECLARE(name, word, columns) sph2d__probe_kind sph2d__probe_##word;
SPH2D_PROBE_MAP(SPH2D__PROBE_DECLARE)
#undef SPH2D__PROBE_DECLARE

/** The present mean pressure on the face of a gauge, and the reading of the gauge that is probe `index` [Pa]. */
double sph2d__gauge_face(const sph2d_sim *sim, const sph2d_probe *probe);
double sph2d__gauge_reading(const sph2d_sim *sim, size_t index);

/** The ranges of liquid around a position, which is wrapped into the period; false if no particle is within reach. */
bool sph2d__sim_around(const sph2d_sim *sim, sph2d_vec2 *at, sph2d__ranges *ranges);

/** A probe's place now: `at`, carried along by the wall that it is on, or that of its path; and `along`, turned with it. */
sph2d_vec2 sph2d__probe_place(const sph2d_sim *sim, const sph2d_probe *probe, sph2d_vec2 *along);

/** Tracers (tracer.c): chooses particles for those that have none yet; counts an output of a probe; makes room for so many
 *  places, false when memory is short; frees them. */
void sph2d__tracers_choose(sph2d_sim *sim);
void sph2d__tracers_sampled(sph2d_sim *sim, size_t probe);
bool sph2d__tracers_reserve(sph2d_sim *sim, size_t count);
void sph2d__tracers_free(sph2d_sim *sim);

/** Initialise gauges with a rise time to the pressure at the start, and advance them by a step of length dt
 *  (gauge.c). */
void sph2d__sim_start_gauges(sph2d_sim *sim);
void sph2d__sim_read_gauges(sph2d_sim *sim, double dt);

#endif
