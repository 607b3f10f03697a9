/* SPDX-License-Identifier: MIT */
/** @file isa.c
 *  The instruction sets that this processor supports. */
#include "simd/isa.h"

const char *sph2d_isa_name(sph2d_isa isa)
{
    switch (isa) {
    case SPH2D_ISA_AUTO:
        return "auto";
    case SPH2D_ISA_BASELINE:
        return "baseline";
    case SPH2D_ISA_AVX2:
        return "avx2";
    case SPH2D_ISA_AVX512:
        return "avx512";
    }
    return "unknown";
}

bool sph2d_isa_available(sph2d_isa isa)
{
    switch (isa) {
    case SPH2D_ISA_AUTO:
    case SPH2D_ISA_BASELINE:
        return true;
#ifdef SPH2D__ISA_X86
    case SPH2D_ISA_AVX2:
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case SPH2D_ISA_AVX512:
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl");
#else
    case SPH2D_ISA_AVX2:
    case SPH2D_ISA_AVX512:
        return false;
#endif
    }
    return false;
}

sph2d_isa sph2d__isa_choose(sph2d_isa wish)
{
    if (wish != SPH2D_ISA_AUTO)
        return sph2d_isa_available(wish) ? wish : SPH2D_ISA_AUTO;
    if (sph2d_isa_available(SPH2D_ISA_AVX512))
        return SPH2D_ISA_AVX512;
    return sph2d_isa_available(SPH2D_ISA_AVX2) ? SPH2D_ISA_AVX2 : SPH2D_ISA_BASELINE;
}
