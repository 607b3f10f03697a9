/* SPDX-License-Identifier: MIT */
/** @file sph2d.h
 *  The solver: everything in libsph2d. Begin with a scene (sph2d/scene.h), make a simulation of it and step it
 *  (sph2d/sim.h); sph2d/status.h says how errors are reported. Files are sph2d/io.h and sph2d/study.h (libsph2d-io),
 *  studies sph2d/study_results.h (libsph2d-study), pictures sph2d/render.h (libsph2d-render); examples/embed.c is a
 *  whole program. */
#ifndef SPH2D_SPH2D_H
#define SPH2D_SPH2D_H

#include "sph2d/array.h"
#include "sph2d/field.h"
#include "sph2d/key.h"
#include "sph2d/method.h"
#include "sph2d/scene.h"
#include "sph2d/sim.h"
#include "sph2d/state.h"
#include "sph2d/status.h"
#include "sph2d/version.h"

#endif
