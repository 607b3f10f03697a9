/* SPDX-License-Identifier: MIT */
/** @file lanes.h
 *  Vectors of doubles with the width of the instruction set that the including file is compiled for; with SPH2D__MIXED
 *  of floats, twice as many (lanes_float.h). sph2d__real is the type of their elements.
 *
 *  Arithmetic operators work on them (an extension of GCC and Clang); the functions below add what the language lacks.
 *  A loop over lanes in plain C would be equivalent, but compilers unroll so short a loop before they try to vectorise
 *  it: the force pass took 4 times the instructions. */
#ifndef SPH2D_SIMD_LANES_H
#define SPH2D_SIMD_LANES_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#define SPH2D__INLINE static inline __attribute__((always_inline))
/** Lane l of a vector; devices have one (src/device/clc). */
#define SPH2D__LANE(a, l) ((a)[l])

#if defined(SPH2D__MIXED)
#include "simd/lanes_float.h"
#else
typedef double sph2d__real;

#if defined(__AVX512F__)
#include <immintrin.h>
#define SPH2D__LANES 8
typedef double sph2d__lanes __attribute__((vector_size(64)));
typedef float sph2d__float2 __attribute__((vector_size(64)));
/** Records of four floats, a vector for each of their members. */
typedef struct sph2d__four {
    sph2d__lanes a, b, c, d;
} sph2d__four;

SPH2D__INLINE sph2d__lanes sph2d__lanes_sqrt(sph2d__lanes a)
{
    return (sph2d__lanes)_mm512_sqrt_pd((__m512d)a);
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_max(sph2d__lanes a, sph2d__lanes b)
{
    return (sph2d__lanes)_mm512_max_pd((__m512d)a, (__m512d)b);
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_min(sph2d__lanes a, sph2d__lanes b)
{
    return (sph2d__lanes)_mm512_min_pd((__m512d)a, (__m512d)b);
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_below(sph2d__lanes a, double limit, sph2d__lanes yes, sph2d__lanes no)
{
    __mmask8 below = _mm512_cmp_pd_mask((__m512d)a, _mm512_set1_pd(limit), _CMP_LT_OQ);
    return (sph2d__lanes)_mm512_mask_mov_pd((__m512d)no, below, (__m512d)yes);
}
SPH2D__INLINE unsigned sph2d__lanes_which(sph2d__lanes a, double limit)
{
    return _mm512_cmp_pd_mask((__m512d)a, _mm512_set1_pd(limit), _CMP_LT_OQ);
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_gather(const double *from, const uint32_t *index)
{
    return (sph2d__lanes){from[index[0]], from[index[1]], from[index[2]], from[index[3]],
                          from[index[4]], from[index[5]], from[index[6]], from[index[7]]};
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_gather_late(const double *from, const uint32_t *index)
{
    return (sph2d__lanes)_mm512_i32gather_pd(_mm256_loadu_si256((const __m256i_u *)index), from, 8);
}
SPH2D__INLINE sph2d__float2 sph2d__float2_of(sph2d__lanes x, sph2d__lanes y)
{
    const __m512i order = _mm512_setr_epi32(0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
    __m512 low = _mm512_castps256_ps512(_mm512_cvtpd_ps((__m512d)x));
    return (sph2d__float2)_mm512_permutex2var_ps(low, order, _mm512_castps256_ps512(_mm512_cvtpd_ps((__m512d)y)));
}
SPH2D__INLINE sph2d__lanes sph2d__float2_x(sph2d__float2 p)
{
    return (sph2d__lanes)_mm512_cvtps_pd((__m256)_mm512_cvtepi64_epi32((__m512i)p));
}
SPH2D__INLINE sph2d__lanes sph2d__float2_y(sph2d__float2 p)
{
    return (sph2d__lanes)_mm512_cvtps_pd((__m256)_mm512_cvtepi64_epi32(_mm512_srli_epi64((__m512i)p, 32)));
}
SPH2D__INLINE sph2d__lanes sph2d__floats_load(const float *from)
{
    return (sph2d__lanes)_mm512_cvtps_pd(_mm256_loadu_ps(from));
}
SPH2D__INLINE void sph2d__floats_store(float *to, sph2d__lanes a)
{
    _mm256_storeu_ps(to, _mm512_cvtpd_ps((__m512d)a));
}
SPH2D__INLINE sph2d__four sph2d__four_of_rows(__m512 low, __m512 high)
{
    const __m512i order = _mm512_setr_epi32(0, 4, 8, 12, 16, 20, 24, 28, 0, 0, 0, 0, 0, 0, 0, 0),
                  one = _mm512_set1_epi32(1), b = _mm512_add_epi32(order, one), c = _mm512_add_epi32(b, one),
                  d = _mm512_add_epi32(c, one);
    return (sph2d__four){
        (sph2d__lanes)_mm512_cvtps_pd(_mm512_castps512_ps256(_mm512_permutex2var_ps(low, order, high))),
        (sph2d__lanes)_mm512_cvtps_pd(_mm512_castps512_ps256(_mm512_permutex2var_ps(low, b, high))),
        (sph2d__lanes)_mm512_cvtps_pd(_mm512_castps512_ps256(_mm512_permutex2var_ps(low, c, high))),
        (sph2d__lanes)_mm512_cvtps_pd(_mm512_castps512_ps256(_mm512_permutex2var_ps(low, d, high)))};
}
SPH2D__INLINE __m512 sph2d__four_rows(const float *from, const uint32_t *index)
{
    __m512 rows = _mm512_castps128_ps512(_mm_loadu_ps(from + 4 * (size_t)index[0]));
    rows = _mm512_insertf32x4(rows, _mm_loadu_ps(from + 4 * (size_t)index[1]), 1);
    rows = _mm512_insertf32x4(rows, _mm_loadu_ps(from + 4 * (size_t)index[2]), 2);
    return _mm512_insertf32x4(rows, _mm_loadu_ps(from + 4 * (size_t)index[3]), 3);
}
SPH2D__INLINE sph2d__four sph2d__four_gather(const float *from, const uint32_t *index)
{
    return sph2d__four_of_rows(sph2d__four_rows(from, index), sph2d__four_rows(from, index + 4));
}
SPH2D__INLINE sph2d__four sph2d__four_load(const float *from)
{
    return sph2d__four_of_rows(_mm512_loadu_ps(from), _mm512_loadu_ps(from + 16));
}
SPH2D__INLINE void sph2d__four_store(float *to, sph2d__four v)
{
    const __m512d ab = (__m512d)sph2d__float2_of(v.a, v.b), cd = (__m512d)sph2d__float2_of(v.c, v.d);
    _mm512_storeu_ps(to, (__m512)_mm512_permutex2var_pd(ab, _mm512_setr_epi64(0, 8, 1, 9, 2, 10, 3, 11), cd));
    _mm512_storeu_ps(to + 16, (__m512)_mm512_permutex2var_pd(ab, _mm512_setr_epi64(4, 12, 5, 13, 6, 14, 7, 15), cd));
}
SPH2D__INLINE void sph2d__lanes_pack_index(uint32_t *to, uint32_t first, unsigned which)
{
    __m256i index = _mm256_add_epi32(_mm256_set1_epi32((int)first), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    _mm256_storeu_si256((__m256i_u *)to, _mm256_maskz_compress_epi32((__mmask8)which, index));
}
SPH2D__INLINE void sph2d__lanes_pack(double *to, sph2d__lanes a, unsigned which)
{
    _mm512_storeu_pd(to, _mm512_maskz_compress_pd((__mmask8)which, (__m512d)a));
}

#elif defined(__AVX__)
#include <immintrin.h>
#define SPH2D__LANES 4
typedef double sph2d__lanes __attribute__((vector_size(32)));
typedef float sph2d__float2 __attribute__((vector_size(32)));
typedef struct sph2d__four {
    sph2d__lanes a, b, c, d;
} sph2d__four;

SPH2D__INLINE sph2d__lanes sph2d__lanes_sqrt(sph2d__lanes a)
{
    return (sph2d__lanes)_mm256_sqrt_pd((__m256d)a);
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_max(sph2d__lanes a, sph2d__lanes b)
{
    return (sph2d__lanes)_mm256_max_pd((__m256d)a, (__m256d)b);
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_min(sph2d__lanes a, sph2d__lanes b)
{
    return (sph2d__lanes)_mm256_min_pd((__m256d)a, (__m256d)b);
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_below(sph2d__lanes a, double limit, sph2d__lanes yes, sph2d__lanes no)
{
    __m256d below = _mm256_cmp_pd((__m256d)a, _mm256_set1_pd(limit), _CMP_LT_OQ);
    return (sph2d__lanes)_mm256_blendv_pd((__m256d)no, (__m256d)yes, below);
}
SPH2D__INLINE unsigned sph2d__lanes_which(sph2d__lanes a, double limit)
{
    return (unsigned)_mm256_movemask_pd(_mm256_cmp_pd((__m256d)a, _mm256_set1_pd(limit), _CMP_LT_OQ));
}
SPH2D__INLINE sph2d__lanes sph2d__lanes_gather(const double *from, const uint32_t *index)
{
    return (sph2d__lanes){from[index[0]], from[index[1]], from[index[2]], from[index[3]]};
}
SPH2D__INLINE sph2d__float2 sph2d__float2_of(sph2d__lanes x, sph2d__lanes y)
{
    __m128 fx = _mm256_cvtpd_ps((__m256d)x), fy = _mm256_cvtpd_ps((__m256d)y);
    return (sph2d__float2)_mm256_set_m128(_mm_unpackhi_ps(fx, fy), _mm_unpacklo_ps(fx, fy));
}
SPH2D__INLINE sph2d__lanes sph2d__float2_x(sph2d__float2 p)
{
    __m128 low = _mm256_castps256_ps128((__m256)p), high = _mm256_extractf128_ps((__m256)p, 1);
    return (sph2d__lanes)_mm256_cvtps_pd(_mm_shuffle_ps(low, high, _MM_SHUFFLE(2, 0, 2, 0)));
}
SPH2D__INLINE sph2d__lanes sph2d__float2_y(sph2d__float2 p)
{
    __m128 low = _mm256_castps256_ps128((__m256)p), high = _mm256_extractf128_ps((__m256)p, 1);
    return (sph2d__lanes)_mm256_cvtps_pd(_mm_shuffle_ps(low, high, _MM_SHUFFLE(3, 1, 3, 1)));
}

SPH2D__INLINE sph2d__lanes sph2d__floats_load(const float *from)
{
    return (sph2d__lanes)_mm256_cvtps_pd(_mm_loadu_ps(from));
}
SPH2D__INLINE void sph2d__floats_store(float *to, sph2d__lanes a)
{
    _mm_storeu_ps(to, _mm256_cvtpd_ps((__m256d)a));
}
SPH2D__INLINE sph2d__four sph2d__four_of_rows(__m128 a, __m128 b, __m128 c, __m128 d)
{
    _MM_TRANSPOSE4_PS(a, b, c, d);
    return (sph2d__four){(sph2d__lanes)_mm256_cvtps_pd(a), (sph2d__lanes)_mm256_cvtps_pd(b),
                         (sph2d__lanes)_mm256_cvtps_pd(c), (sph2d__lanes)_mm256_cvtps_pd(d)};
}
SPH2D__INLINE sph2d__four sph2d__four_gather(const float *from, const uint32_t *index)
{
    return sph2d__four_of_rows(_mm_loadu_ps(from + 4 * (size_t)index[0]), _mm_loadu_ps(from + 4 * (size_t)index[1]),
                               _mm_loadu_ps(from + 4 * (size_t)index[2]), _mm_loadu_ps(from + 4 * (size_t)index[3]));
}
SPH2D__INLINE sph2d__four sph2d__four_load(const float *from)
{
    return sph2d__four_of_rows(_mm_loadu_ps(from), _mm_loadu_ps(from + 4), _mm_loadu_ps(from + 8),
                               _mm_loadu_ps(from + 12));
}
SPH2D__INLINE void sph2d__four_store(float *to, sph2d__four v)
{
    __m128 a = _mm256_cvtpd_ps((__m256d)v.a), b = _mm256_cvtpd_ps((__m256d)v.b), c = _mm256_cvtpd_ps((__m256d)v.c),
           d = _mm256_cvtpd_ps((__m256d)v.d);
    _MM_TRANSPOSE4_PS(a, b, c, d);
    _mm_storeu_ps(to, a);
    _mm_storeu_ps(to + 4, b);
    _mm_storeu_ps(to + 8, c);
    _mm_storeu_ps(to + 12, d);
}

#else
#define SPH2D__LANES 2
typedef double sph2d__lanes __attribute__((vector_size(16)));
typedef float sph2d__float2 __attribute__((vector_size(16)));
typedef struct sph2d__four {
    sph2d__lanes a, b, c, d;
} sph2d__four;

/** Square root of each lane. */
SPH2D__INLINE sph2d__lanes sph2d__lanes_sqrt(sph2d__lanes a)
{
    return (sph2d__lanes){sqrt(a[0]), sqrt(a[1])};
}
/** The larger of the two in each lane; b where a is NaN. */
SPH2D__INLINE sph2d__lanes sph2d__lanes_max(sph2d__lanes a, sph2d__lanes b)
{
    return (sph2d__lanes){a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1]};
}
/** The smaller of the two in each lane; b where a is NaN. */
SPH2D__INLINE sph2d__lanes sph2d__lanes_min(sph2d__lanes a, sph2d__lanes b)
{
    return (sph2d__lanes){a[0] < b[0] ? a[0] : b[0], a[1] < b[1] ? a[1] : b[1]};
}
/** `yes` in lanes where a is below the limit, `no` in the others. */
SPH2D__INLINE sph2d__lanes sph2d__lanes_below(sph2d__lanes a, double limit, sph2d__lanes yes, sph2d__lanes no)
{
    return (sph2d__lanes){a[0] < limit ? yes[0] : no[0], a[1] < limit ? yes[1] : no[1]};
}
/** A bit for each lane that is below the limit, the first lane's the lowest. */
SPH2D__INLINE unsigned sph2d__lanes_which(sph2d__lanes a, double limit)
{
    return (a[0] < limit) | (unsigned)(a[1] < limit) << 1;
}
/** from[index[l]] in lane l. */
SPH2D__INLINE sph2d__lanes sph2d__lanes_gather(const double *from, const uint32_t *index)
{
    return (sph2d__lanes){from[index[0]], from[index[1]]};
}
/** Floats of the lanes of two vectors, side by side. */
SPH2D__INLINE sph2d__float2 sph2d__float2_of(sph2d__lanes x, sph2d__lanes y)
{
    return (sph2d__float2){(float)x[0], (float)y[0], (float)x[1], (float)y[1]};
}
/** A vector by floats, and rounded to them. */
SPH2D__INLINE sph2d__lanes sph2d__floats_load(const float *from)
{
    return (sph2d__lanes){(double)from[0], (double)from[1]};
}
SPH2D__INLINE void sph2d__floats_store(float *to, sph2d__lanes a)
{
    to[0] = (float)a[0];
    to[1] = (float)a[1];
}
/** Four vectors by records of four floats: those that `index` names, or those at `from`. */
SPH2D__INLINE sph2d__four sph2d__four_gather(const float *from, const uint32_t *index)
{
    const float *p = from + 4 * (size_t)index[0], *q = from + 4 * (size_t)index[1];
    return (sph2d__four){{(double)p[0], (double)q[0]},
                         {(double)p[1], (double)q[1]},
                         {(double)p[2], (double)q[2]},
                         {(double)p[3], (double)q[3]}};
}
SPH2D__INLINE sph2d__four sph2d__four_load(const float *from)
{
    return sph2d__four_gather(from, (const uint32_t[2]){0, 1});
}
/** Records of four vectors, rounded to floats. */
SPH2D__INLINE void sph2d__four_store(float *to, sph2d__four v)
{
    for (int l = 0; l < SPH2D__LANES; ++l) {
        const float row[4] = {(float)v.a[l], (float)v.b[l], (float)v.c[l], (float)v.d[l]};
        memcpy(to + 4 * l, row, sizeof row);
    }
}
/** The first of each pair, and the second. */
SPH2D__INLINE sph2d__lanes sph2d__float2_x(sph2d__float2 p)
{
    return (sph2d__lanes){p[0], p[2]};
}
SPH2D__INLINE sph2d__lanes sph2d__float2_y(sph2d__float2 p)
{
    return (sph2d__lanes){p[1], p[3]};
}
#endif

#ifndef __AVX512F__
/** The same, for short computations: by one instruction if there is a fast one. The computation then waits for all
 *  lanes: a sum of two products takes 2/3 of the time, a kernel 3 times as long. */
SPH2D__INLINE sph2d__lanes sph2d__lanes_gather_late(const double *from, const uint32_t *index)
{
    return sph2d__lanes_gather(from, index);
}
#endif

/** Pairs of floats stored in the space of doubles: one gather loads both. */
SPH2D__INLINE sph2d__float2 sph2d__float2_load(const double *from)
{
    sph2d__float2 p;
    memcpy(&p, from, sizeof p);
    return p;
}
SPH2D__INLINE void sph2d__float2_store(double *to, sph2d__float2 p)
{
    memcpy(to, &p, sizeof p);
}
/** The two of each pair exchanged. */
SPH2D__INLINE sph2d__float2 sph2d__float2_swapped(sph2d__float2 p)
{
    typedef unsigned long long words __attribute__((vector_size(sizeof p)));
    words w = (words)p;
    return (sph2d__float2)(w >> 32 | w << 32);
}
SPH2D__INLINE sph2d__float2 sph2d__float2_gather(const double *from, const uint32_t *index)
{
    return (sph2d__float2)sph2d__lanes_gather_late(from, index);
}

/** A float twice, in the space of a double; and its value. */
static inline double sph2d__splat(double a)
{
    const float both[2] = {(float)a, (float)a};
    double kept;
    memcpy(&kept, both, sizeof kept);
    return kept;
}
static inline double sph2d__splat_value(double kept)
{
    float a;
    memcpy(&a, &kept, sizeof a);
    return a;
}

#endif /* SPH2D__MIXED */

#ifndef __AVX512F__
/** Writes those of first, first + 1, ... whose bits are set contiguously; up to a whole block is written. */
SPH2D__INLINE void sph2d__lanes_pack_index(uint32_t *to, uint32_t first, unsigned which)
{
#if SPH2D__LANES >= 4
    typedef uint32_t four __attribute__((vector_size(16)));
    static const four places[16] = {{0}, {0},    {1},    {0, 1},    {2},    {0, 2},    {1, 2},    {0, 1, 2},
                                    {3}, {0, 3}, {1, 3}, {0, 1, 3}, {2, 3}, {0, 2, 3}, {1, 2, 3}, {0, 1, 2, 3}};
    for (unsigned l = 0; l < SPH2D__LANES; l += 4) {
        const unsigned some = which >> l & 15;
        const four index = places[some] + (first + l);
        memcpy(to, &index, sizeof index);
        to += __builtin_popcount(some);
    }
#else
    for (int l = 0; l < SPH2D__LANES; ++l) {
        *to = first + (uint32_t)l;
        to += which >> l & 1;
    }
#endif
}
/** Writes the lanes whose bits are set contiguously; up to a whole block is written. */
SPH2D__INLINE void sph2d__lanes_pack(sph2d__real *to, sph2d__lanes a, unsigned which)
{
    for (int l = 0; l < SPH2D__LANES; ++l) {
        *to = a[l];
        to += which >> l & 1;
    }
}
#endif

/** From a slot of a neighbour list to the next: particles/neighbours.h. */
#define SPH2D__STRIDE SPH2D__LANES

/** The same in all lanes. */
SPH2D__INLINE sph2d__lanes sph2d__lanes_all(double a)
{
    return (sph2d__real)a - (sph2d__lanes){0}; /* a + 0 would be an addition, as -0 + 0 is 0 */
}

/** The values at `from`, of any alignment. */
SPH2D__INLINE sph2d__lanes sph2d__lanes_load(const sph2d__real *from)
{
    sph2d__lanes a;
    memcpy(&a, from, sizeof a);
    return a;
}

/** Writes the lanes at `to`, of any alignment. */
SPH2D__INLINE void sph2d__lanes_store(sph2d__real *to, sph2d__lanes a)
{
    memcpy(to, &a, sizeof a);
}

/** `a` in lanes where left > right, 0 in the others. */
SPH2D__INLINE sph2d__lanes sph2d__lanes_where(sph2d__lanes left, sph2d__lanes right, sph2d__lanes a)
{
    typedef int64_t bits __attribute__((vector_size(sizeof(sph2d__lanes))));
    return (sph2d__lanes)((bits)(left > right) & (bits)a);
}

#endif
