/* SPDX-License-Identifier: MIT */
/** @file apart.h
 *  How far method hybrid moves particles apart, in C and in OpenCL C. */
#ifndef SPH2D_SCENE_APART_H
#define SPH2D_SCENE_APART_H

#include "base/address.h"

/** Method hybrid finds the order of particles at places moved by up to this, each by its number [spacings]: particles at one
 *  point would have no direction apart, and lines of a block's lattice that is drawn out stay lines, with slits between them.
 *  With 0.01 some slits are left, with 0.03 none, but liquid at rest moves by a twentieth more (docs/notes/hybrid.md). */
SPH2D__FIXED double SPH2D__APART = 0.02;

#endif
