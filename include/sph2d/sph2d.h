/* SPDX-License-Identifier: MIT */
/** @file sph2d.h
 *  The solver: everything in libsph2d. Start with a scene (sph2d/scene.h), create a simulation from it and advance it
 *  (sph2d/sim.h); errors are reported as described in sph2d/status.h, which also says what functions do
 *  with NULL. Files: sph2d/io.h and sph2d/study.h
 *  (libsph2d-io); studies: sph2d/study_results.h (libsph2d-study); contacts of bodies: sph2d/contacts.h
 *  (libsph2d-contacts); images: sph2d/render.h (libsph2d-render).
 *  examples/embed.c is a complete program. */
#ifndef SPH2D_SPH2D_H
#define SPH2D_SPH2D_H

#include "sph2d/array.h"
#include "sph2d/device.h"
#include "sph2d/field.h"
#include "sph2d/key.h"
#include "sph2d/method.h"
#include "sph2d/scene.h"
#include "sph2d/shared.h"
#include "sph2d/sim.h"
#include "sph2d/state.h"
#include "sph2d/status.h"
#include "sph2d/version.h"

#endif
