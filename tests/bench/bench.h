/* SPDX-License-Identifier: MIT */
/** @file bench.h
 *  How fast steps are, beside what the machine could do: scenes, rows of results, the machine's own limits. */
#ifndef SPH2D_TESTS_BENCH_H
#define SPH2D_TESTS_BENCH_H

#include <stdio.h>

#include <sph2d/device.h>
#include <sph2d/sph2d.h>

/** A scene of any number of particles. What one pair costs is counted by hand from the formulas of its method:
 *  additions, multiplications, divisions and roots, one each, over all sums of a step but those of a pressure solver.
 *  */
typedef struct bench_scene {
    const char *name, *text;
    double flops;   /**< of a pair and step */
    double doubles; /**< read of a neighbour and written of a particle, over all sums of a step */
    void (*make)(sph2d_scene *scene, sph2d_block *block, double particles);
} bench_scene;

extern const bench_scene bench_scenes[];
extern const size_t bench_scene_count;

/** What is measured. */
typedef struct bench_job {
    const bench_scene *scene;
    double particles;
    int threads;
    sph2d_isa isa;
    int device;      /**< that takes the steps, 0: the processor */
    int steps, runs; /**< steps of a run; the run that takes least counts */
} bench_job;

/** What came out. Times are of the best run [s]. */
typedef struct bench_row {
    bench_job job;
    size_t particles, memory;
    sph2d_isa isa;
    double wall, cpu, particle_steps;
    double neighbours;
    double carried; /**< c0 dt/dx, the mean over the steps */
    sph2d_profile profile;
    sph2d_summary summary;
    sph2d_device_use use; /**< of the device, over all runs */
} bench_row;

/** What a machine can do with so many threads. */
typedef struct bench_machine {
    double flops;     /**< fused multiply-adds of doubles, two each [1/s] */
    double bandwidth; /**< of a = b + s c over arrays that no cache holds [B/s] */
} bench_machine;

/** Measures a row. False with a message on stderr. */
bool bench_measure(const bench_job *job, bench_row *row);

/** Measures the machine, with the widest instruction set or a narrower one. */
bench_machine bench_machine_measure(sph2d_isa isa, int threads);

/** The same of a device. All zeros with a message on stderr where it cannot be had. */
bench_machine bench_machine_of_device(int device);

/** Seconds that pass, and that processors spend on this process. */
double bench_wall(void);
double bench_cpu(void);

/** Traversals of all pairs in a step, those of a pressure solver included. */
double bench_traversals(const bench_row *row);

/** Prints the heading, a row, in one of the forms. */
typedef enum bench_form { BENCH_TABLE, BENCH_CSV, BENCH_JSON } bench_form;
/** `device`: with what a device has done in a step. */
void bench_print_head(FILE *out, bench_form form, bool device);
void bench_print(FILE *out, bench_form form, const bench_row *row, const bench_machine *machine);

#endif
