/* SPDX-License-Identifier: MIT */
/** @file lanes_float.h
 *  Vectors of floats: what lanes.h declares for doubles, for files that are compiled with SPH2D__MIXED. */
#ifndef SPH2D_SIMD_LANES_FLOAT_H
#define SPH2D_SIMD_LANES_FLOAT_H

typedef float sph2d__real;

#if defined(__AVX512F__)
#include <immintrin.h>
#define SPH2D__LANES 16
typedef float sph2d__lanes __attribute__((vector_size(64)));

SPH2D__INLINE sph2d__lanes sph2d__lanes_sqrt(sph2d__lanes a)
{
    return (sph2d__lanes)_mm512_sqrt_ps((__m512)a);
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_max(sph2d__lanes a, sph2d__lanes b)
{
    return (sph2d__lanes)_mm512_max_ps((__m512)a, (__m512)b);
}
SPH2D__INLINE unsigned sph2d__lanes_which(sph2d__lanes a, double limit)
{
    return _mm512_cmp_ps_mask((__m512)a, _mm512_set1_ps((float)limit), _CMP_LT_OQ);
}
SPH2D__INLINE void sph2d__lanes_pack_index(uint32_t *to, uint32_t first, unsigned which)
{
    const __m512i count = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    __m512i index = _mm512_add_epi32(_mm512_set1_epi32((int)first), count);
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32((__mmask16)which, index));
}
SPH2D__INLINE void sph2d__lanes_pack(float *to, sph2d__lanes a, unsigned which)
{
    _mm512_storeu_ps(to, _mm512_maskz_compress_ps((__mmask16)which, (__m512)a));
}

#elif defined(__AVX__)
#include <immintrin.h>
#define SPH2D__LANES 8
typedef float sph2d__lanes __attribute__((vector_size(32)));

SPH2D__INLINE sph2d__lanes sph2d__lanes_sqrt(sph2d__lanes a)
{
    return (sph2d__lanes)_mm256_sqrt_ps((__m256)a);
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_max(sph2d__lanes a, sph2d__lanes b)
{
    return (sph2d__lanes)_mm256_max_ps((__m256)a, (__m256)b);
}
SPH2D__INLINE unsigned sph2d__lanes_which(sph2d__lanes a, double limit)
{
    return (unsigned)_mm256_movemask_ps(_mm256_cmp_ps((__m256)a, _mm256_set1_ps((float)limit), _CMP_LT_OQ));
}

#else
#define SPH2D__LANES 4
typedef float sph2d__lanes __attribute__((vector_size(16)));

SPH2D__INLINE sph2d__lanes sph2d__lanes_sqrt(sph2d__lanes a)
{
    return (sph2d__lanes){sqrtf(a[0]), sqrtf(a[1]), sqrtf(a[2]), sqrtf(a[3])};
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_max(sph2d__lanes a, sph2d__lanes b)
{
    return (sph2d__lanes){a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1], a[2] > b[2] ? a[2] : b[2],
                          a[3] > b[3] ? a[3] : b[3]};
}
SPH2D__INLINE unsigned sph2d__lanes_which(sph2d__lanes a, double limit)
{
    unsigned which = 0;
    for (int l = 0; l < SPH2D__LANES; ++l)
        which |= (unsigned)(a[l] < (float)limit) << l;
    return which;
}
#endif

#endif
