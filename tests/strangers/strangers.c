/* SPDX-License-Identifier: MIT */
/* Random scenes, or given ones, each judged in a process of its own: a program that crashes fails its scene alone. */
#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "../time_limits.h"
#include "judge.h"
#include "random_scene.h"

enum { MOST_JOBS = 64, MOST_SECONDS = 600, LINE_SIZE = 1000, NAME_SIZE = 40 };

static const char usage[] =
    "strangers [--seeds A..B | --scene FILE...] [--set KEY=VALUE...] [--command sph2d] [--isa NAME] [--dir DIR]\n"
    "          [--jobs N] [--known FILE] [--only INVARIANT] [--print] [--library] [--unused]\n"
    "Writes small random scenes, one a seed, and judges them, or the scenes given, by invariants alone.\n"
    "  --known FILE   lines 'seed invariant reason': failures that are known. One that holds is an error, too.\n"
    "  --only NAME    judges by that invariant alone; `plan` needs a check and one run.\n"
    "  --print        writes the scenes of the seeds to the standard output, and does not run them.\n"
    "  --unused       prints the keys that none of the scenes given uses.\n"
    "  --library      runs in this process alone, without the command: for the figures of a long run.\n"
    "Each scene leaves a folder in DIR with verdict, figures.csv and what the command wrote and said.\n";

typedef struct options {
    const char *program, *command, *dir, *known, *only, *isa;
    unsigned long first, last;
    const char **scenes, **changes;
    size_t scene_count, change_count, jobs;
    bool print, library, unused;
} options;

/** A scene that is being judged, or was. */
typedef struct task {
    pid_t pid;
    bool done;
    int status;
    char name[NAME_SIZE], folder[LINE_SIZE], scene[LINE_SIZE];
} task;

/** Names of invariants that are known to fail, for one seed. */
typedef struct known_line {
    unsigned long seed;
    char invariant[NAME_SIZE];
    bool seen;
} known_line;
typedef struct known_list {
    known_line *items;
    size_t count;
} known_list;

void verdict_fail(verdict *v, const char *invariant, const char *format, ...)
{
    if (v->only && strcmp(v->only, invariant) != 0)
        return;
    va_list arguments;
    va_start(arguments, format);
    fprintf(v->file, "%s\t", invariant);
    vfprintf(v->file, format, arguments);
    fputc('\n', v->file);
    fflush(v->file);
    va_end(arguments);
}

static void give_up(const char *what, const char *name)
{
    fprintf(stderr, "strangers: %s '%s': %s\n", what, name, strerror(errno));
    exit(2);
}

static void make_folder(const char *path)
{
    if (mkdir(path, 0777) != 0 && errno != EEXIST)
        give_up("cannot make", path);
}

// ---- one scene -----------------------------------------------------------------------------------------------------

/** The library alone. */
static library_run judge_library(const judge_request *request, verdict *v)
{
    sph2d_scene_file *file = NULL;
    sph2d_sim *sim = NULL;
    library_run run = {.started = false};
    if (read_scene(request, &file))
        run = judge_by_library(request, sph2d_scene_file_scene(file), v, &sim);
    if (!run.started)
        verdict_fail(v, "start", "the scene is refused");
    else if (!run.finished)
        verdict_fail(v, "guard", "stopped at t = %g s", run.summary.time);
    sph2d_sim_destroy(sim);
    sph2d_scene_file_destroy(file);
    return run;
}

/** In a process of its own: judges, and leaves `verdict` and `figures.csv` in the folder. */
static void judge(const options *o, const task *t)
{
    char path[LINE_SIZE + 20];
    snprintf(path, sizeof path, "%s/verdict", t->folder);
    verdict v = {.file = fopen(path, "w"), .only = o->only};
    if (v.file == NULL)
        _exit(2);
    const unsigned most = MOST_SECONDS * limits_factor();
    const struct rlimit limit = {most, most + 1};
    setrlimit(RLIMIT_CPU, &limit);
    const judge_request request = {.command = o->command,
                                   .scene = t->scene,
                                   .folder = t->folder,
                                   .isa = o->isa,
                                   .changes = o->changes,
                                   .change_count = o->change_count};
    const library_run run = o->library ? judge_library(&request, &v) : judge_scene(&request, &v);
    fclose(v.file);
    snprintf(path, sizeof path, "%s/figures.csv", t->folder);
    FILE *file = fopen(path, "w");
    if (file == NULL)
        _exit(2);
    fputs("finished,particles,steps,energy_scale,energy_rise,rise_time,compression_p99,compression_mean,"
          "compression_max,packing,told_density,packing_p99,packing_max,left,drained,overlap,"
          "contacts_gave\n",
          file);
    const sph2d_summary *s = &run.summary;
    fprintf(file, "%d,%llu,%llu,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%llu,%llu,%.6g,%.6g\n", run.finished,
            (unsigned long long)s->particles, (unsigned long long)s->steps, run.scale, run.rise, run.since,
            s->compression_p99, s->compression_mean, s->compression_max, run.packing, run.density, run.p99, run.highest,
            (unsigned long long)s->left_open[0] + s->left_open[1] + s->left_open[2] + s->left_open[3],
            (unsigned long long)s->drained, run.overlap, run.taken);
    fclose(file);
    _exit(0);
}

static void start(const options *o, task *t, unsigned long number)
{
    if (o->scene_count > 0) {
        const char *slash = strrchr(o->scenes[number], '/');
        snprintf(t->name, sizeof t->name, "%s", slash ? slash + 1 : o->scenes[number]);
        t->name[strcspn(t->name, ".")] = '\0';
        snprintf(t->scene, sizeof t->scene, "%s", o->scenes[number]);
    } else
        snprintf(t->name, sizeof t->name, "%lu", o->first + number);
    snprintf(t->folder, sizeof t->folder, "%s/%s", o->dir, t->name);
    make_folder(t->folder);
    if (o->scene_count == 0) {
        snprintf(t->scene, sizeof t->scene, "%.900s/scene.yaml", t->folder);
        FILE *file = fopen(t->scene, "w");
        if (file == NULL)
            give_up("cannot write", t->scene);
        random_scene_write(o->first + number, file);
        if (fclose(file) != 0)
            give_up("cannot write", t->scene);
    }
    fflush(NULL);
    t->pid = fork();
    if (t->pid == 0)
        judge(o, t);
    if (t->pid < 0)
        give_up("cannot start", t->name);
}

// ---- what is known -------------------------------------------------------------------------------------------------

static known_list read_known(const char *path)
{
    known_list list = {NULL, 0};
    FILE *file = path ? fopen(path, "r") : NULL;
    if (path && file == NULL)
        give_up("cannot read", path);
    char line[LINE_SIZE];
    while (file && fgets(line, sizeof line, file)) {
        known_line item = {0};
        char *rest;
        item.seed = strtoul(line, &rest, 10);
        if (rest == line || sscanf(rest, "%39s", item.invariant) != 1)
            continue;
        known_line *items = realloc(list.items, (list.count + 1) * sizeof *items);
        if (items == NULL)
            give_up("no memory for", path);
        list.items = items;
        list.items[list.count++] = item;
    }
    if (file)
        fclose(file);
    return list;
}

static bool is_known(known_list *known, const options *o, unsigned long number, const char *invariant)
{
    for (size_t i = 0; i < known->count && o->scene_count == 0; ++i)
        if (known->items[i].seed == o->first + number && strcmp(known->items[i].invariant, invariant) == 0)
            return known->items[i].seen = true;
    return false;
}

// ---- what is reported --------------------------------------------------------------------------------------------------

/** The command that judges a scene once more. */
static void tell_again(const options *o, const task *t)
{
    printf("     scene %s; again: %s --command %s --isa %s --%s %s", t->scene, o->program, o->command, o->isa,
           o->scene_count > 0 ? "scene" : "seeds", o->scene_count > 0 ? t->scene : t->name);
    for (size_t i = 0; i < o->change_count; ++i)
        printf(" --set '%s'", o->changes[i]);
    puts(o->library ? " --library" : "");
}

/** Prints what failed, each invariant once, and how to see it again; returns how many were not known. */
static unsigned tell(const options *o, const task *t, unsigned long number, known_list *known)
{
    char path[LINE_SIZE + 20], line[LINE_SIZE], last[NAME_SIZE] = "";
    snprintf(path, sizeof path, "%s/verdict", t->folder);
    unsigned news = 0, all = 0;
    FILE *file = fopen(path, "r");
    while (file && fgets(line, sizeof line, file)) {
        line[strcspn(line, "\n")] = '\0';
        char *sentence = strchr(line, '\t');
        if (sentence == NULL)
            continue;
        *sentence++ = '\0';
        if (strcmp(line, last) == 0)
            continue;
        snprintf(last, sizeof last, "%.39s", line);
        const bool old = is_known(known, o, number, line);
        printf("%s %s\t%s\t%s\n", old ? "known" : "FAIL", t->name, line, sentence);
        news += !old;
        ++all;
    }
    if (file)
        fclose(file);
    if (t->status != 0) {
        const bool old = is_known(known, o, number, "crash");
        const bool late = WIFSIGNALED(t->status) && WTERMSIG(t->status) == SIGXCPU;
        printf("%s %s\tcrash\tthe library ends its program with %s %d%s\n", old ? "known" : "FAIL", t->name,
               WIFSIGNALED(t->status) ? "signal" : "status",
               WIFSIGNALED(t->status) ? WTERMSIG(t->status) : WEXITSTATUS(t->status),
               late ? ", at its limit of CPU time; " LIMITS_HINT : "");
        news += !old;
        ++all;
    }
    if (news > 0)
        tell_again(o, t);
    if (all == 0 && getenv("SPH2D_STRANGERS_VERBOSE"))
        printf("ok   %s\n", t->name);
    fflush(stdout);
    return news;
}

/** Known failures of these seeds that did not fail are good news, and must leave the list. */
static unsigned tell_cured(const options *o, const known_list *known)
{
    unsigned cured = 0;
    for (size_t i = 0; i < known->count; ++i) {
        const known_line *k = &known->items[i];
        if (o->scene_count > 0 || k->seed < o->first || k->seed > o->last || k->seen)
            continue;
        printf("FAIL %lu\t%s\tholds now: take the line out of %s\n", k->seed, k->invariant, o->known);
        ++cured;
    }
    return cured;
}

// ---- all scenes ----------------------------------------------------------------------------------------------------

/** Waits for one of the scenes that are being judged. */
static void wait_for_one(task *tasks, size_t started)
{
    int status = 0;
    const pid_t pid = waitpid(-1, &status, 0);
    if (pid < 0 && errno != EINTR)
        give_up("cannot wait for", "a scene");
    for (size_t i = 0; i < started; ++i)
        if (pid > 0 && tasks[i].pid == pid && !tasks[i].done) {
            tasks[i].done = true;
            tasks[i].status = status;
        }
}

static int judge_all(const options *o)
{
    const size_t count = o->scene_count > 0 ? o->scene_count : o->last - o->first + 1;
    task *tasks = calloc(count, sizeof *tasks);
    if (tasks == NULL)
        give_up("no memory for", "scenes");
    known_list known = read_known(o->known);
    size_t started = 0, told = 0;
    unsigned failed = 0, news = 0;
    while (told < count) {
        size_t running = 0;
        for (size_t i = told; i < started; ++i)
            running += !tasks[i].done;
        if (running < o->jobs && started < count) {
            start(o, &tasks[started], started);
            ++started;
            continue;
        }
        wait_for_one(tasks, started);
        for (; told < started && tasks[told].done; ++told) { // in their order
            const unsigned n = tell(o, &tasks[told], told, &known);
            news += n;
            failed += n > 0;
        }
    }
    const unsigned cured = tell_cured(o, &known);
    size_t old = 0;
    for (size_t i = 0; i < known.count; ++i)
        old += known.items[i].seen;
    printf("strangers: %zu scenes, %u fail by %u invariants, %zu failures are known, %u known ones hold now\n", count,
           failed, news, old, cured);
    free(known.items);
    free(tasks);
    return news + cured > 0;
}

static void read_seeds(const char *text, options *o)
{
    char *end = NULL;
    o->first = o->last = strtoul(text, &end, 10);
    if (strncmp(end, "..", 2) == 0)
        o->last = strtoul(end + 2, &end, 10);
    if (*end != '\0' || o->last < o->first) {
        fprintf(stderr, "strangers: seeds are A or A..B, not '%s'\n", text);
        exit(2);
    }
}

static void read_option(const char *name, const char *value, options *o)
{
    if (strcmp(name, "--seeds") == 0)
        read_seeds(value, o);
    else if (strcmp(name, "--scene") == 0)
        o->scenes[o->scene_count++] = value;
    else if (strcmp(name, "--set") == 0 && strlen(value) < CHANGE_SIZE && strchr(value, '=') &&
             o->change_count < MOST_CHANGES)
        o->changes[o->change_count++] = value;
    else if (strcmp(name, "--isa") == 0)
        o->isa = value;
    else if (strcmp(name, "--command") == 0)
        o->command = value;
    else if (strcmp(name, "--dir") == 0)
        o->dir = value;
    else if (strcmp(name, "--known") == 0)
        o->known = value;
    else if (strcmp(name, "--only") == 0)
        o->only = value;
    else if (strcmp(name, "--jobs") == 0)
        o->jobs = strtoul(value, NULL, 10);
    else {
        fputs(usage, stderr);
        exit(2);
    }
}

int main(int argc, char **argv)
{
    options o = {.program = argv[0], .command = "build/sph2d", .dir = "build/strangers", .isa = "baseline"};
    o.first = o.jobs = 1;
    o.last = 20;
    o.scenes = calloc((size_t)argc, sizeof *o.scenes);
    o.changes = calloc((size_t)argc, sizeof *o.changes);
    for (int i = 1; i < argc && o.scenes && o.changes; ++i) {
        if (strcmp(argv[i], "--print") == 0)
            o.print = true;
        else if (strcmp(argv[i], "--library") == 0)
            o.library = true;
        else if (strcmp(argv[i], "--unused") == 0)
            o.unused = true;
        else if (i + 1 < argc) {
            read_option(argv[i], argv[i + 1], &o);
            ++i;
        } else
            read_option("", "", &o);
    }
    if (o.jobs < 1 || o.jobs > MOST_JOBS || o.scenes == NULL || o.changes == NULL) {
        fputs(usage, stderr);
        free(o.scenes);
        free(o.changes);
        return 2;
    }
    int result = 0;
    if (o.unused)
        result = tell_unused(o.scenes, o.scene_count);
    else if (o.print)
        for (unsigned long seed = o.first; seed <= o.last; ++seed)
            random_scene_write(seed, stdout);
    else {
        make_folder(o.dir);
        result = judge_all(&o);
    }
    free(o.scenes);
    free(o.changes);
    return result;
}
