/* SPDX-License-Identifier: MIT */
/** @file isa.h
 *  The instruction sets that pair loops are compiled for: a source file *_pass.c once for each, named by SPH2D__ISA,
 *  those of method wcsph a second time for floats, named with _mixed. */
#ifndef SPH2D_SIMD_ISA_H
#define SPH2D_SIMD_ISA_H

#include "sph2d/sim.h"

/** The set to use: for `auto` the widest that is available; auto (0) if the given one is not available. */
sph2d_isa sph2d__isa_choose(sph2d_isa wish);

/** The name of the copy of `name` in the instruction set of the source file. */
#define SPH2D__OF_ISA(name) SPH2D__OF_ISA_1(name, SPH2D__ISA)
#define SPH2D__OF_ISA_1(name, isa) SPH2D__OF_ISA_2(name, isa)
#define SPH2D__OF_ISA_2(name, isa) name##_##isa

/** Declares the copies of `name`, and `name`_find(isa), which returns the one for an instruction set; `tail`, nothing
 *  or _mixed, is appended to all these names. */
#ifdef SPH2D__ISA_X86
#define SPH2D__COPIES(type, name, tail)                                                                                \
    extern const type name##_baseline##tail, name##_avx2##tail, name##_avx512##tail;                                   \
    static inline const type *name##_find##tail(sph2d_isa isa)                                                         \
    {                                                                                                                  \
        return isa == SPH2D_ISA_AVX512 ? &name##_avx512##tail                                                          \
               : isa == SPH2D_ISA_AVX2 ? &name##_avx2##tail                                                            \
                                       : &name##_baseline##tail;                                                       \
    }
#elif defined(SPH2D__SMALL) /* for pages: the copies for floats are those for doubles */
#define SPH2D__COPIES(type, name, tail)                                                                                \
    extern const type name##_baseline;                                                                                 \
    static inline const type *name##_find##tail(sph2d_isa isa)                                                         \
    {                                                                                                                  \
        (void)isa;                                                                                                     \
        return &name##_baseline;                                                                                       \
    }
#else
#define SPH2D__COPIES(type, name, tail)                                                                                \
    extern const type name##_baseline##tail;                                                                           \
    static inline const type *name##_find##tail(sph2d_isa isa)                                                         \
    {                                                                                                                  \
        (void)isa;                                                                                                     \
        return &name##_baseline##tail;                                                                                 \
    }
#endif

#endif
