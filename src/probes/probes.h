/* SPDX-License-Identifier: MIT */
/** @file probes.h
 *  The kinds of probes. Each writes the values of its columns and returns how many; it reads the simulation only, and
 *  gives the same bits for any number of threads. */
#ifndef SPH2D_PROBES_PROBES_H
#define SPH2D_PROBES_PROBES_H

#include "sim/simulation.h"

typedef size_t sph2d__probe_kind(const sph2d_sim *sim, const sph2d_probe *probe, double *values);

/** Each kind's, in a file of its own or with its like. */
#define SPH2D__PROBE_DECLARE(name, word, columns) sph2d__probe_kind sph2d__probe_##word;
SPH2D_PROBE_MAP(SPH2D__PROBE_DECLARE)
#undef SPH2D__PROBE_DECLARE

/** The mean pressure on the face of a gauge now, and what the gauge that is probe `index` shows [Pa]. */
double sph2d__gauge_face(const sph2d_sim *sim, const sph2d_probe *probe);
double sph2d__gauge_shown(const sph2d_sim *sim, size_t index);

/** The ranges of liquid around a place, which is brought into the period; false where no particle is within reach. */
bool sph2d__sim_around(const sph2d_sim *sim, sph2d_vec2 *place, sph2d__ranges *ranges);

/** Lets gauges that take time show the pressure at the start, and follow it over a step of length dt (gauge.c). */
void sph2d__sim_start_gauges(sph2d_sim *sim);
void sph2d__sim_read_gauges(sph2d_sim *sim, double dt);

#endif
