/* SPDX-License-Identifier: MIT */
/** @file golden.c
 *  Runs a scene file by its own method and every other one that takes it, and every instruction set, for 200 steps with few
 *  particles, and prints hashes each time: golden [--own] SCENE.yaml NAME [STEPS PARTICLES THREADS...]; with --own by its own
 *  method alone. A line: name, method, instruction set, how it ended, steps, particles, hash of what particles carry, hash of
 *  what the summary counts. With several numbers of threads, also those whose hashes differ from the first's; the exit code
 *  is 1 then. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <sph2d/contacts.h>
#include <sph2d/device.h>
#include <sph2d/io.h>
#include <sph2d/state.h>

enum { MOST = 16 };

/* How each scene is run, and whether a number of threads has changed anything. */
static struct {
    int device;
    uint64_t steps;
    double particles;
    int threads[MOST], count;
    bool differs;
} wanted = {.steps = 200, .particles = 200, .threads = {1}, .count = 1};

/* What is laid on top of the scene; the first is the scene's own method. */
static const char *const methods[][2] = {{"own", NULL},
                                         {"hybrid", "hybrid"},
                                         {"muller", "{name: muller}"},
                                         {"wcsph", "{name: wcsph}"},
                                         {"fitted", "{name: wcsph, operators: fitted}"},
                                         {"pcisph", "{name: pcisph}"},
                                         {"constraint", "{name: constraint}"}};

static uint64_t mix(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * 0x9e3779b97f4a7c15U;
    return hash ^ hash >> 29;
}

/** Of an array's values; 0 when all are 0, so that a new array that nothing uses leaves all hashes as they are. */
static uint64_t hash_array(const sph2d_array *a)
{
    uint64_t hash = 0, any = 0;
    for (unsigned c = 0; c < a->components; ++c)
        for (size_t i = 0; i < a->count; ++i) {
            uint64_t word;
            memcpy(&word, (const char *)a->data[c] + 8 * i * a->stride, sizeof word);
            hash = mix(hash, word);
            any |= word;
        }
    return any ? hash : 0;
}

/** Of everything that particles carry, whatever the arrays are called and in whichever order they come. */
static uint64_t hash_particles(sph2d_sim *sim)
{
    sph2d_state state = sph2d_sim_state(sim);
    uint64_t hash = 0;
    for (size_t a = 0; a < state.array_count; ++a)
        if (state.arrays[a].group != SPH2D_GROUP_RUN)
            hash += hash_array(&state.arrays[a]);
    return hash;
}

static uint64_t hash_summary(const sph2d_sim *sim)
{
    sph2d_summary summary = sph2d_sim_summary(sim);
    uint64_t hash = 0;
    const double numbers[] = {
        summary.time,         summary.kinetic,      summary.potential,       summary.elastic,
        summary.energy_walls, summary.energy_error, summary.compression_max, summary.compression_p99};
    for (size_t n = 0; n < sizeof numbers / sizeof *numbers; ++n) {
        uint64_t word;
        memcpy(&word, &numbers[n], sizeof word);
        hash = mix(hash, word);
    }
    return mix(mix(hash, summary.iterations), summary.backstop_hits);
}

static void read_scene(const char *path, const char *method, double spacing, sph2d_scene_file **file)
{
    char text[32];
    sph2d_override on_top[2] = {{0}};
    size_t count = 0;
    snprintf(text, sizeof text, "%.9g", spacing);
    if (spacing > 0)
        on_top[count++] = (sph2d_override){"spacing", text};
    if (method)
        on_top[count++] = (sph2d_override){"method", method};
    sph2d_scene_file_read(path, on_top, count, file, NULL);
}

/** With about as many particles as are wanted, or as it is where it bears no other spacing. */
static void read_small(const char *path, const char *method, sph2d_scene_file **file)
{
    read_scene(path, method, 0, file);
    if (!*file || (wanted.device > 0 && sph2d_device_refuses(sph2d_scene_file_scene(*file))))
        return;
    const sph2d_scene *scene = sph2d_scene_file_scene(*file);
    sph2d_plan plan;
    if (sph2d_scene_plan(scene, &plan, NULL) != SPH2D_OK || plan.fluid_particles <= wanted.particles)
        return;
    double spacing = scene->spacing * sqrt((double)plan.fluid_particles / wanted.particles);
    sph2d_scene_file *small = NULL;
    read_scene(path, method, spacing, &small);
    if (small) {
        sph2d_scene_file_destroy(*file);
        *file = small;
    }
}

/** How a run ended, where, and the hashes. */
typedef struct outcome {
    sph2d_status status;
    uint64_t steps, particle_hash, summary_hash;
    size_t particles;
} outcome;

static outcome run(const sph2d_scene *scene, sph2d_isa isa, int threads, int device)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.isa = isa;
    options.threads = threads;
    options.device = device;
    options.same_bits = true;
    sph2d_sim *sim = NULL;
    sph2d_status status = sph2d_sim_create(scene, &options, &sim, NULL);
    sph2d_contacts_attach(sim);
    while (status == SPH2D_OK && sph2d_sim_steps(sim) < wanted.steps)
        status = sph2d_sim_step(sim, NULL);
    outcome o = {.status = status};
    if (sim)
        o = (outcome){status, sph2d_sim_steps(sim), hash_particles(sim), hash_summary(sim), sph2d_sim_fluid(sim).count};
    sph2d_sim_destroy(sim);
    return o;
}

static void print_outcome(const outcome *o)
{
    printf(" %s", sph2d_status_name(o->status));
    if (o->particles > 0 || o->steps > 0)
        printf(" %llu %zu %016llx %016llx", (unsigned long long)o->steps, o->particles,
               (unsigned long long)o->particle_hash, (unsigned long long)o->summary_hash);
}

static bool is_same(const outcome *a, const outcome *b)
{
    return a->status == b->status && a->steps == b->steps && a->particle_hash == b->particle_hash &&
           a->summary_hash == b->summary_hash;
}

/** The processor's baseline, and what a device did otherwise; nothing where no device takes the scene. */
static void run_on_device(const sph2d_scene *scene, const char *name, const char *method)
{
    if (sph2d_device_refuses(scene))
        return;
    const outcome first = run(scene, SPH2D_ISA_BASELINE, 1, 0), o = run(scene, SPH2D_ISA_BASELINE, 1, wanted.device);
    printf("%s %s", name, method);
    print_outcome(&first);
    if (!is_same(&o, &first)) {
        printf("; by the device");
        print_outcome(&o);
        wanted.differs = true;
    }
    putchar('\n');
}

/** By the first number of threads, and what the others did otherwise. */
static void run_and_print(const sph2d_scene *scene, sph2d_isa isa)
{
    outcome first = run(scene, isa, wanted.threads[0], 0);
    print_outcome(&first);
    for (int k = 1; k < wanted.count; ++k) {
        outcome o = run(scene, isa, wanted.threads[k], 0);
        if (is_same(&o, &first))
            continue;
        printf("; by %d threads", wanted.threads[k]);
        print_outcome(&o);
        wanted.differs = true;
    }
}

/** A line for each instruction set, none where the scene is refused, or has the method of `own`. */
static void run_all(const char *path, const char *name, const char *const method[2], const sph2d_scene_file *own)
{
    sph2d_scene_file *file = NULL;
    read_small(path, method[1], &file);
    const bool again = file && own &&
                       memcmp(&sph2d_scene_file_scene(file)->method, &sph2d_scene_file_scene(own)->method,
                              sizeof(sph2d_method_options)) == 0;
    if (wanted.device > 0 && file && !again)
        run_on_device(sph2d_scene_file_scene(file), name, method[0]);
    for (sph2d_isa isa = SPH2D_ISA_BASELINE; file && !again && wanted.device == 0 && isa <= SPH2D_ISA_AVX512; ++isa)
        if (sph2d_isa_available(isa)) {
            printf("%s %s %s", name, method[0], sph2d_isa_name(isa));
            run_and_print(sph2d_scene_file_scene(file), isa);
            putchar('\n');
        }
    sph2d_scene_file_destroy(file);
}

int main(int argc, char **argv)
{
    if (argc > 2 && strcmp(argv[1], "--device") == 0) {
        wanted.device = (int)strtol(argv[2], NULL, 10);
        argc -= 2;
        argv += 2;
    }
    const bool only_own = argc > 1 && strcmp(argv[1], "--own") == 0;
    argc -= only_own;
    argv += only_own;
    if (argc != 3 && (argc < 6 || argc > 5 + MOST)) {
        fputs("usage: golden [--device N] [--own] SCENE.yaml NAME [STEPS PARTICLES THREADS...]\n", stderr);
        return 2;
    }
    if (argc > 3) {
        wanted.steps = strtoull(argv[3], NULL, 10);
        wanted.particles = strtod(argv[4], NULL);
        wanted.count = argc - 5;
        for (int k = 0; k < wanted.count; ++k)
            wanted.threads[k] = (int)strtol(argv[5 + k], NULL, 10);
    }
    sph2d_scene_file *own = NULL;
    run_all(argv[1], argv[2], methods[0], NULL);
    read_scene(argv[1], NULL, 0, &own);
    for (size_t m = 1; m < sizeof methods / sizeof *methods && !only_own; ++m)
        run_all(argv[1], argv[2], methods[m], own);
    sph2d_scene_file_destroy(own);
    return wanted.differs;
}
