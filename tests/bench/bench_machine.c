/* SPDX-License-Identifier: MIT */
/** @file bench_machine.c
 *  Two limits of the machine: how many multiply-adds it does, and how fast it streams memory. */
#include <stdlib.h>
#include <time.h>

#include "bench.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

static double seconds(clockid_t id)
{
    struct timespec now;
    return clock_gettime(id, &now) == 0 ? (double)now.tv_sec + 1e-9 * (double)now.tv_nsec : 0;
}

double bench_wall(void)
{
    return seconds(CLOCK_MONOTONIC);
}

double bench_cpu(void)
{
    return seconds(CLOCK_PROCESS_CPUTIME_ID);
}

/* As many sums as hide the latency of one. */
enum { SUMS = 12, ROUNDS = 2000000 };

/** a b + c in SUMS sums of `lanes` doubles, ROUNDS times; returns something, so that it is done. */
#if defined(__x86_64__)
#define PEAK(name, features, vector, set, fma, first)                                                                  \
    __attribute__((target(features))) static double name(void)                                                         \
    {                                                                                                                  \
        vector sums[SUMS], b = set(0.999999), c = set(1e-6);                                                           \
        for (int k = 0; k < SUMS; ++k)                                                                                 \
            sums[k] = set((double)k);                                                                                  \
        for (int n = 0; n < ROUNDS; ++n)                                                                               \
            for (int k = 0; k < SUMS; ++k)                                                                             \
                sums[k] = fma(sums[k], b, c);                                                                          \
        double all = 0;                                                                                                \
        for (int k = 0; k < SUMS; ++k)                                                                                 \
            all += first(sums[k]);                                                                                     \
        return all;                                                                                                    \
    }
#define MULTIPLY_ADD(a, b, c) _mm_add_pd(_mm_mul_pd(a, b), c)
PEAK(peak_avx512, "avx512f", __m512d, _mm512_set1_pd, _mm512_fmadd_pd, _mm512_cvtsd_f64)
PEAK(peak_avx2, "avx2,fma", __m256d, _mm256_set1_pd, _mm256_fmadd_pd, _mm256_cvtsd_f64)
PEAK(peak_baseline, "sse2", __m128d, _mm_set1_pd, MULTIPLY_ADD, _mm_cvtsd_f64)

static double (*peak_of(sph2d_isa isa, int *lanes))(void)
{
    *lanes = isa == SPH2D_ISA_AVX512 ? 8 : isa == SPH2D_ISA_AVX2 ? 4 : 2;
    return isa == SPH2D_ISA_AVX512 ? peak_avx512 : isa == SPH2D_ISA_AVX2 ? peak_avx2 : peak_baseline;
}
#else
static double peak_plain(void)
{
    double sums[SUMS] = {0}, all = 0;
    for (int n = 0; n < ROUNDS; ++n)
        for (int k = 0; k < SUMS; ++k)
            sums[k] = sums[k] * 0.999999 + 1e-6;
    for (int k = 0; k < SUMS; ++k)
        all += sums[k];
    return all;
}

static double (*peak_of(sph2d_isa isa, int *lanes))(void)
{
    (void)isa;
    *lanes = 1;
    return peak_plain;
}
#endif

static double best(double a, double b)
{
    return a > b ? a : b;
}

enum { TRIES = 5 };

static double measure_flops(sph2d_isa isa, int threads)
{
    int lanes;
    double (*peak)(void) = peak_of(isa, &lanes);
    double most = 0;
    for (int k = 0; k < TRIES; ++k) {
        volatile double kept = 0;
        double begun = bench_wall();
#pragma omp parallel for num_threads(threads) schedule(static, 1)
        for (int t = 0; t < threads; ++t) {
            double value = peak();
            if (value < 0)
                kept = value;
        }
        most = best(most, 2.0 * lanes * SUMS * ROUNDS * threads / (bench_wall() - begun));
        (void)kept;
    }
    return most;
}

/* Doubles of an array: three of them are more than any cache holds. */
enum { STREAM = 12 * 1024 * 1024 };

static double measure_bandwidth(int threads)
{
    double *a = malloc(STREAM * sizeof *a), *b = malloc(STREAM * sizeof *b), *c = malloc(STREAM * sizeof *c);
    double most = 0;
    for (int k = -1; k < TRIES && a && b && c; ++k) { /* the first round touches the memory */
        double begun = bench_wall();
#pragma omp parallel for num_threads(threads) schedule(static)
        for (int i = 0; i < STREAM; ++i) {
            if (k < 0)
                b[i] = c[i] = i;
            a[i] = b[i] + 3 * c[i];
        }
        if (k >= 0)
            most = best(most, 3.0 * sizeof(double) * STREAM / (bench_wall() - begun));
    }
    free(a);
    free(b);
    free(c);
    return most;
}

bench_machine bench_machine_measure(sph2d_isa isa, int threads)
{
    return (bench_machine){measure_flops(isa, threads), measure_bandwidth(threads)};
}
