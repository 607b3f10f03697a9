/* SPDX-License-Identifier: MIT */
/** @file isa.h
 *  The instruction sets that pair loops are compiled for: a source file *_pass.c once for each, named by SPH2D__ISA. */
#ifndef SPH2D_SIMD_ISA_H
#define SPH2D_SIMD_ISA_H

#include "sph2d/sim.h"

/** The set to use: for `auto` the widest that is available; auto (0) if the given one is not available. */
sph2d_isa sph2d__isa_choose(sph2d_isa wish);

/** The name of the copy of `name` in the instruction set of the source file. */
#define SPH2D__OF_ISA(name) SPH2D__OF_ISA_1(name, SPH2D__ISA)
#define SPH2D__OF_ISA_1(name, isa) SPH2D__OF_ISA_2(name, isa)
#define SPH2D__OF_ISA_2(name, isa) name##_##isa

/** Declares the copies of `name`, and `name`_find(isa), which returns the one for an instruction set. */
#ifdef SPH2D__ISA_X86
#define SPH2D__COPIES(type, name)                                                                                      \
    extern const type name##_baseline, name##_avx2, name##_avx512;                                                     \
    static inline const type *name##_find(sph2d_isa isa)                                                               \
    {                                                                                                                  \
        return isa == SPH2D_ISA_AVX512 ? &name##_avx512 : isa == SPH2D_ISA_AVX2 ? &name##_avx2 : &name##_baseline;     \
    }
#else
#define SPH2D__COPIES(type, name)                                                                                      \
    extern const type name##_baseline;                                                                                 \
    static inline const type *name##_find(sph2d_isa isa)                                                               \
    {                                                                                                                  \
        (void)isa;                                                                                                     \
        return &name##_baseline;                                                                                       \
    }
#endif

#endif
