/* SPDX-License-Identifier: MIT */
/** @file machine.h
 *  What steps are made by, and where their time goes. */
#ifndef SPH2D_MACHINE_H
#define SPH2D_MACHINE_H

#include <stdbool.h>
#include <stdint.h>

#include "sph2d/export.h"

#ifdef __cplusplus
extern "C" {
#endif

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

/** Name of an instruction set, "avx2"; static storage. */
SPH2D_API const char *sph2d_isa_name(sph2d_isa isa);

/** Whether this processor and this build support it. */
SPH2D_API bool sph2d_isa_available(sph2d_isa isa);

/** The phases of a step. */
typedef enum sph2d_phase {
    /** Kicks and drifts, and collisions with walls. */
    SPH2D_PHASE_MOVE,

    /** Cells, and sorting the particles by them. */
    SPH2D_PHASE_SORT,

    /** Sums over the liquid around boundary particles. */
    SPH2D_PHASE_WALLS,

    /** Neighbour lists of a pressure solver, and density with them. */
    SPH2D_PHASE_SEARCH,

    /** Sums over neighbours for density or its rate. */
    SPH2D_PHASE_DENSITY,

    /** Sums over neighbours for accelerations. */
    SPH2D_PHASE_FORCES,

    /** A pressure solver. */
    SPH2D_PHASE_SOLVE,

    /** Sources and drains, guards, the length of the next step, samples. */
    SPH2D_PHASE_BOOKKEEPING,

    /** The number of phases. */
    SPH2D_PHASE_COUNT
} sph2d_phase;

/** Name of a phase, "move", "sort", ...; static storage. */
SPH2D_API const char *sph2d_phase_name(sph2d_phase phase);

/** Time of the steps by phase, since the simulation was created. */
typedef struct sph2d_profile {
    /** Wall time [s]. */
    double wall[SPH2D_PHASE_COUNT];

    /** CPU time of the process [s]. */
    double cpu[SPH2D_PHASE_COUNT];

    /** How often the phase was entered. */
    uint64_t calls[SPH2D_PHASE_COUNT];
} sph2d_profile;

#ifdef __cplusplus
}
#endif
#endif
