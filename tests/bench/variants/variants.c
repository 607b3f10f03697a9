/* SPDX-License-Identifier: MIT */
/** @file variants.c
 *  variants [OPTION...]: times each way through the pairs in turn, round after round, and tells the least of each. */
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../bench.h"
#include "variants.h"

enum { MOST = 64, PASSES = 3 };

/* Sums of more than a hundred terms, each of a few roundings. */
static const double ROUND_OFF = 1e-11;

static const char usage[] = "Usage: variants [OPTION...]\n"
                            "Times ways through the pairs of particles: CPU nanoseconds a particle, one thread.\n"
                            "  -p, --particles N  about so many particles; default 16000\n"
                            "  -r, --rounds N     each way once in a round; default 20\n"
                            "  -w, --ways TEXT    those that have this in their names, and the library's\n"
                            "      --isa NAME     baseline, avx2, avx512; default avx2 where there is one\n";

/** What the command line asks for. */
typedef struct wishes {
    double particles;
    int rounds;
    const char *ways;
    sph2d_isa isa;
} wishes;

/** A way and what was measured of it. */
typedef struct row {
    const variant *way;
    double prepare, pass; /**< [s], the least */
    double error;
} row;

#define LIST(file, isa) VARIANTS_NAME(file, isa),
static const variant *const baseline[] = {VARIANTS_FILES(LIST, baseline) NULL};
#ifdef SPH2D__ISA_X86
static const variant *const avx2[] = {VARIANTS_FILES(LIST, avx2) NULL};
static const variant *const avx512[] = {VARIANTS_FILES(LIST, avx512) NULL};
#else
#define avx2 baseline
#define avx512 baseline
#endif

static int fault(const char *what, const char *value)
{
    fprintf(stderr, "variants: %s '%s'\n%s", what, value, usage);
    return 2;
}

static int read_number(double *to, double least, double most, const char *text)
{
    char *end;
    double number = strtod(text, &end);
    if (*end != '\0' || !(number >= least && number <= most))
        return fault("not a number in range:", text);
    *to = number;
    return 0;
}

static int read_isa(sph2d_isa *to, const char *name)
{
    for (int isa = SPH2D_ISA_BASELINE; isa <= SPH2D_ISA_AVX512; ++isa)
        if (strcmp(name, sph2d_isa_name((sph2d_isa)isa)) == 0 && sph2d_isa_available((sph2d_isa)isa)) {
            *to = (sph2d_isa)isa;
            return 0;
        }
    return fault("this machine has no instruction set", name);
}

static int read_options(wishes *w, int argc, char **argv)
{
    static const struct option longs[] = {{"particles", required_argument, NULL, 'p'},
                                          {"rounds", required_argument, NULL, 'r'},
                                          {"ways", required_argument, NULL, 'w'},
                                          {"isa", required_argument, NULL, 'i'},
                                          {"help", no_argument, NULL, 'h'},
                                          {NULL, 0, NULL, 0}};
    int id, code = 0;
    double rounds = w->rounds;
    while (code == 0 && (id = getopt_long(argc, argv, "p:r:w:h", longs, NULL)) != -1) {
        switch (id) {
        case 'p':
            code = read_number(&w->particles, 900, 1e7, optarg);
            break;
        case 'r':
            code = read_number(&rounds, 1, 1e6, optarg);
            break;
        case 'w':
            w->ways = optarg;
            break;
        case 'i':
            code = read_isa(&w->isa, optarg);
            break;
        case 'h':
            fputs(usage, stdout);
            exit(0);
        default:
            fputs(usage, stderr);
            code = 2;
        }
    }
    w->rounds = (int)rounds;
    return code == 0 && optind < argc ? fault("what is", argv[optind]) : code;
}

/** The ways that are asked for; the first is the library's. */
static size_t list_rows(const wishes *w, row rows[MOST])
{
    size_t count = 0;
    const variant *const *files = w->isa == SPH2D_ISA_AVX512 ? avx512 : w->isa == SPH2D_ISA_AVX2 ? avx2 : baseline;
    for (; *files; ++files)
        for (const variant *v = *files; v->name; ++v)
            if (count < MOST && (count == 0 || !w->ways || strstr(v->name, w->ways)))
                rows[count++] = (row){v, INFINITY, INFINITY, 0};
    return count;
}

/** Prepares, and returns the seconds that took. What a way needs in another form is copied before and after. */
static double prepare(field *f, const variant *v)
{
    if (v->packed)
        field_pack(f);
    double begun = bench_cpu();
    v->prepare(f, v);
    double taken = bench_cpu() - begun;
    if (v->packed)
        field_unpack(f);
    return taken;
}

/** Times a way once: particles are in its order already when it prepares for its next steps, of which the last has the
 *  most motion. */
static void time_row(field *f, row *r, bool check)
{
    const variant *v = r->way;
    int steps = steps_of(v);
    field_restart(f, v->mixed);
    prepare(f, v);
    field_move(f, steps);
    r->prepare = fmin(r->prepare, prepare(f, v));
    field_move(f, steps - 1);
    field_derive(f);
    if (v->packed)
        field_pack(f);
    for (int k = 0; k < PASSES; ++k) {
        double begun = bench_cpu();
        v->pass(f, v);
        r->pass = fmin(r->pass, bench_cpu() - begun);
    }
    if (check)
        r->error = field_error(f);
}

/** Prints a row of the table. False when its sums are wrong. */
static bool print_row(const row *r, const row *library, double particles)
{
    double unit = 1e9 / particles, before = r->prepare * unit / steps_of(r->way), pass = r->pass * unit;
    double base = (library->pass + library->prepare) * unit;
    bool good = r->error <= ROUND_OFF;
    printf("| %-48s | %6.1f | %6.1f | %6.1f | %5.2f | %7.0e |%s\n", r->way->name, pass, before, pass + before,
           (pass + before) / base, r->error, good ? "" : " WRONG");
    return good;
}

int main(int argc, char **argv)
{
    wishes w = {.particles = 16000, .rounds = 20};
    w.isa = sph2d_isa_available(SPH2D_ISA_AVX2) ? SPH2D_ISA_AVX2 : SPH2D_ISA_BASELINE;
    int code = read_options(&w, argc, argv);
    if (code != 0)
        return code;
    row rows[MOST];
    size_t count = list_rows(&w, rows);
    field f;
    field_create(&f, w.particles);
    for (int k = 0; k < w.rounds; ++k)
        for (size_t r = 0; r < count; ++r)
            time_row(&f, &rows[r], k == 0);
    printf("%zu particles, %s, one thread; CPU nanoseconds a particle, the least of %d rounds\n\n", f.store.count,
           sph2d_isa_name(w.isa), w.rounds);
    printf("| %-48s | pairs  | before | total  | ratio | error   |\n", "way");
    printf("|%s|---|---|---|---|---|\n", "---");
    for (size_t r = 0; r < count; ++r)
        code |= !print_row(&rows[r], &rows[0], (double)f.store.count);
    field_free(&f);
    return code;
}
