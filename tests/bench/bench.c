/* SPDX-License-Identifier: MIT */
/** @file bench.c
 *  bench [OPTION...]: times every scene in every wanted size, on every wanted number of threads and instruction set. */
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"

enum { MOST = 16 };

/** What the command line asks for. */
typedef struct wishes {
    const bench_scene *scenes[MOST];
    double sizes[MOST], threads[MOST];
    sph2d_isa isas[MOST];
    size_t scene_count, size_count, thread_count, isa_count;
    int steps, runs, device;
    bench_form form;
} wishes;

static const char usage[] =
    "Usage: bench [OPTION...]\n"
    "Times steps of scenes; CPU seconds are those of the best of some runs.\n"
    "  -s, --scenes NAME,...   which scenes; default all: wcsph, muller, pcisph,\n"
    "                          constraint, fitted\n"
    "  -p, --particles N,...   about so many particles; default 16000\n"
    "  -j, --threads N,...     default 1\n"
    "      --isa NAME,...      auto, baseline, avx2, avx512; default auto\n"
    "  -n, --steps N           steps of a run; default 400000 over the particles, 5 at least\n"
    "  -r, --runs N            default 5\n"
    "  -d, --device N          one of `sph2d devices`, with its launches, waits and transfers in a step;\n"
    "                          share of peak and memory are of what it does at most\n"
    "      --csv, --json       instead of a table\n";

static int fault(const char *what, const char *value)
{
    fprintf(stderr, "bench: %s '%s'\n%s", what, value, usage);
    return 2;
}

/** Cuts the next word off a list with commas; NULL at its end. */
static char *next_word(char **list)
{
    char *word = *list && **list ? *list : NULL;
    char *comma = word ? strchr(word, ',') : NULL;
    *list = comma ? comma + 1 : NULL;
    if (comma)
        *comma = '\0';
    return word;
}

static int read_scenes(wishes *w, char *list)
{
    for (char *word = next_word(&list); word; word = next_word(&list)) {
        size_t k = 0;
        while (k < bench_scene_count && strcmp(word, bench_scenes[k].name) != 0)
            ++k;
        if (k == bench_scene_count || w->scene_count == MOST)
            return fault("no such scene:", word);
        w->scenes[w->scene_count++] = &bench_scenes[k];
    }
    return 0;
}

static int read_numbers(double *numbers, size_t *count, double most, char *list)
{
    for (char *word = next_word(&list); word; word = next_word(&list)) {
        char *end;
        double number = strtod(word, &end);
        if (*end != '\0' || !(number >= 1 && number <= most) || *count == MOST)
            return fault("not a number in range:", word);
        numbers[(*count)++] = number;
    }
    return 0;
}

static int read_isas(wishes *w, char *list)
{
    for (char *word = next_word(&list); word; word = next_word(&list)) {
        int isa = SPH2D_ISA_AUTO;
        while (isa <= SPH2D_ISA_AVX512 && strcmp(word, sph2d_isa_name((sph2d_isa)isa)) != 0)
            ++isa;
        if (isa > SPH2D_ISA_AVX512 || !sph2d_isa_available((sph2d_isa)isa) || w->isa_count == MOST)
            return fault("this machine has no instruction set", word);
        w->isas[w->isa_count++] = (sph2d_isa)isa;
    }
    return 0;
}

static int read_options(wishes *w, int argc, char **argv)
{
    static const struct option longs[] = {{"scenes", required_argument, NULL, 's'},
                                          {"particles", required_argument, NULL, 'p'},
                                          {"threads", required_argument, NULL, 'j'},
                                          {"isa", required_argument, NULL, 'i'},
                                          {"steps", required_argument, NULL, 'n'},
                                          {"runs", required_argument, NULL, 'r'},
                                          {"device", required_argument, NULL, 'd'},
                                          {"csv", no_argument, NULL, 'c'},
                                          {"json", no_argument, NULL, 'J'},
                                          {"help", no_argument, NULL, 'h'},
                                          {NULL, 0, NULL, 0}};
    int id, code = 0;
    while (code == 0 && (id = getopt_long(argc, argv, "s:p:j:n:r:d:h", longs, NULL)) != -1) {
        double number = 0;
        size_t one = 0;
        switch (id) {
        case 's':
            code = read_scenes(w, optarg);
            break;
        case 'p':
            code = read_numbers(w->sizes, &w->size_count, 1e8, optarg);
            break;
        case 'j':
            code = read_numbers(w->threads, &w->thread_count, 1024, optarg);
            break;
        case 'i':
            code = read_isas(w, optarg);
            break;
        case 'd':
            code = read_numbers(&number, &one, 64, optarg);
            w->device = (int)number;
            break;
        case 'n':
        case 'r':
            code = read_numbers(&number, &one, 1e6, optarg);
            *(id == 'n' ? &w->steps : &w->runs) = (int)number;
            break;
        case 'c':
        case 'J':
            w->form = id == 'c' ? BENCH_CSV : BENCH_JSON;
            break;
        case 'h':
            fputs(usage, stdout);
            exit(0);
        default:
            fputs(usage, stderr);
            code = 2;
        }
    }
    return code == 0 && optind < argc ? fault("what is", argv[optind]) : code;
}

static void fill_defaults(wishes *w)
{
    if (w->scene_count == 0)
        for (; w->scene_count < bench_scene_count; ++w->scene_count)
            w->scenes[w->scene_count] = &bench_scenes[w->scene_count];
    if (w->size_count == 0)
        w->sizes[w->size_count++] = 16000;
    if (w->thread_count == 0)
        w->threads[w->thread_count++] = 1;
    if (w->isa_count == 0)
        w->isas[w->isa_count++] = SPH2D_ISA_AUTO;
    w->runs = w->runs > 0 ? w->runs : 5;
}

static int steps_for(const wishes *w, double particles)
{
    int steps = (int)(400000 / particles);
    return w->steps > 0 ? w->steps : steps > 5 ? steps : 5;
}

/** All scenes and sizes with one number of threads and one instruction set. */
static bool measure_all(const wishes *w, int threads, sph2d_isa isa)
{
    bool good = true;
    sph2d_isa widest = isa != SPH2D_ISA_AUTO                   ? isa
                       : sph2d_isa_available(SPH2D_ISA_AVX512) ? SPH2D_ISA_AVX512
                       : sph2d_isa_available(SPH2D_ISA_AVX2)   ? SPH2D_ISA_AVX2
                                                               : SPH2D_ISA_BASELINE;
    const bench_machine machine =
        w->device > 0 ? bench_machine_of_device(w->device) : bench_machine_measure(widest, threads);
    if (w->form == BENCH_TABLE && w->device > 0)
        printf("device %d: %.1f GFlop/s, %.1f GB/s\n", w->device, machine.flops / 1e9, machine.bandwidth / 1e9);
    else if (w->form == BENCH_TABLE)
        printf("%d threads, %s: %.1f GFlop/s, %.1f GB/s\n", threads, sph2d_isa_name(widest), machine.flops / 1e9,
               machine.bandwidth / 1e9);
    for (size_t p = 0; p < w->size_count; ++p)
        for (size_t k = 0; k < w->scene_count; ++k) {
            bench_job job = {w->scenes[k], w->sizes[p], threads, isa, w->device, steps_for(w, w->sizes[p]), w->runs};
            bench_row row;
            if (bench_measure(&job, &row))
                bench_print(stdout, w->form, &row, &machine);
            else
                good = false;
        }
    return good;
}

int main(int argc, char **argv)
{
    wishes w = {0};
    int code = read_options(&w, argc, argv);
    if (code != 0)
        return code;
    fill_defaults(&w);
    bench_print_head(stdout, w.form, w.device > 0);
    for (size_t t = 0; t < w.thread_count; ++t)
        for (size_t i = 0; i < w.isa_count; ++i)
            code |= !measure_all(&w, (int)w.threads[t], w.isas[i]);
    return code;
}
