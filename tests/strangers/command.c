/* SPDX-License-Identifier: MIT */
/* A scene by the command, as people run it: check, run, stop half-way, resume; all of it must agree with itself and
 * with a run in this process. */
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../time_limits.h"
#include "judge.h"

enum { PATH_SIZE = 600, TEXT_SIZE = 1 << 16, MOST_SECONDS = 60, EXIT_REJECTED = 65, EXIT_NO_INPUT = 66 };

/** How a command ended and what it said. */
typedef struct ending {
    int code; /**< exit status, or minus the signal */
    char out[TEXT_SIZE], err[TEXT_SIZE];
} ending;

static void read_text(const char *path, char text[TEXT_SIZE])
{
    FILE *file = fopen(path, "rb");
    size_t length = file ? fread(text, 1, TEXT_SIZE - 1, file) : 0;
    text[length] = '\0';
    if (file)
        fclose(file);
}

/** Becomes the command, for so many seconds of the processor at most. */
static void become(const char *const *arguments, const char *out, const char *err)
{
    const int to = open(out, O_WRONLY | O_CREAT | O_TRUNC, 0666), bad = open(err, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    const unsigned most = MOST_SECONDS * limits_factor();
    const struct rlimit limit = {most, most + 1};
    if (arguments[0] && to >= 0 && bad >= 0 && dup2(to, 1) >= 0 && dup2(bad, 2) >= 0 &&
        setrlimit(RLIMIT_CPU, &limit) == 0) {
        alarm(10 * most);
        execv(arguments[0], (char *const *)(uintptr_t)arguments);
    }
    _exit(127);
}

static void perform(const judge_request *p, const char *name, const char *const *arguments, ending *e)
{
    char out[PATH_SIZE], err[PATH_SIZE];
    snprintf(out, sizeof out, "%s/%s.out", p->folder, name);
    snprintf(err, sizeof err, "%s/%s.err", p->folder, name);
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0)
        become(arguments, out, err);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        ;
    e->code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    read_text(out, e->out);
    read_text(err, e->err);
}

/** What an earlier judgement left must not be taken for this one's. */
static void clear(const judge_request *p)
{
    char whole[PATH_SIZE], parts[PATH_SIZE];
    static ending e;
    snprintf(whole, sizeof whole, "%s/whole", p->folder);
    snprintf(parts, sizeof parts, "%s/parts", p->folder);
    perform(p, "clear", (const char *const[]){"/bin/rm", "-rf", whole, parts, NULL}, &e);
}

double number(const char *json, const char *key)
{
    char quoted[64];
    snprintf(quoted, sizeof quoted, "\"%s\": ", key);
    const char *at = strstr(json, quoted);
    return at ? strtod(at + strlen(quoted), NULL) : (double)NAN;
}

// ---- what is said --------------------------------------------------------------------------------------------------

/** Ends that are allowed: 0, and with a message that says why 1 (a guard), 65 or 66 (the input). */
static bool is_honest(const char *what, const ending *e, verdict *v)
{
    const bool error = strstr(e->err, "\"severity\": \"error\"") != NULL;
    const bool guard = strstr(e->err, "\"code\": \"R3") != NULL;
    const unsigned most = MOST_SECONDS * limits_factor();
    if (e->code == -SIGXCPU || e->code == -SIGALRM)
        verdict_fail(v, "time", "%s passed its limit of %u s %s; %s", what, e->code == -SIGXCPU ? most : 10 * most,
                     e->code == -SIGXCPU ? "of CPU time" : "by the clock", LIMITS_HINT);
    else if (e->code < 0)
        verdict_fail(v, "crash", "%s ended by signal %d", what, -e->code);
    else if (e->code != 0 && e->code != 1 && e->code != EXIT_REJECTED && e->code != EXIT_NO_INPUT)
        verdict_fail(v, "status", "%s ended with %d", what, e->code);
    else if ((e->code == 0) == error)
        verdict_fail(v, "status", "%s ended with %d and tells %s", what, e->code, error ? "an error" : "no error");
    else if (e->code == 1 && !guard)
        verdict_fail(v, "status", "%s ended with 1, and no guard says why", what);
    else
        return true;
    return false;
}

/** The first message of severity error, or the first of all. */
static void first_message(const ending *e, char text[200])
{
    const char *at = strstr(e->err, "\"severity\": \"error\"");
    at = strstr(at ? at : e->err, "\"message\": \"");
    snprintf(text, 200, "%.199s", at ? at + strlen("\"message\": \"") : "");
    text[strcspn(text, "\"\n")] = '\0';
}

/** What a run that went to its end tells about itself. */
static void judge_summary(const ending *checked, const ending *run, const library_run *library, verdict *v)
{
    static const char *const lost[] = {"drained", "left\": {\"left", "right", "bottom", "top"};
    const char *particles = strstr(run->out, "\"particles\": {");
    if (particles == NULL) {
        verdict_fail(v, "status", "the run prints no summary");
        return;
    }
    double gone = 0;
    for (size_t i = 0; i < sizeof lost / sizeof lost[0]; ++i)
        gone += number(particles, lost[i]);
    const double placed = number(checked->out, "particles"), fed = number(particles, "fed");
    const double now = number(particles, "now"), in = number(particles, "let_in"), out = number(particles, "let_out");
    if (now + gone + out != placed + fed + in)
        verdict_fail(v, "particles", "%g placed by check, %g fed, %g let in, %g out, %g lost, %g left now", placed, fed,
                     in, out, gone, now);
    const double error = number(run->out, "energy_error") / number(run->out, "energy_scale");
    if (library->opened && !(fabs(error) <= OPENED_BOUND))
        verdict_fail(v, "balance", "%.3g %% of the scene's energy is unaccounted for", 100 * error);
    static const char *const finite[] = {"compression_p99", "compression_mean", "compression_max",
                                         "energy_kinetic",  "energy_potential", "energy_change",
                                         "energy_bodies",   "energy_contacts",  "speed_max"};
    for (size_t i = 0; i < sizeof finite / sizeof finite[0]; ++i)
        if (!isfinite(number(run->out, finite[i])))
            verdict_fail(v, "finite", "the summary's %s is not a finite number", finite[i]);
    if (strstr(run->out, "\"end\": \"finished\"") == NULL || number(run->out, "time") < number(run->out, "until"))
        verdict_fail(v, "status", "the run ended with 0 before its end");
    if (fabs(number(run->out, "compression_max") - library->summary.compression_max) >
        1e-9 * (1 + library->summary.compression_max))
        verdict_fail(v, "compression", "the command tells a maximum of %g, the library %g",
                     number(run->out, "compression_max"), library->summary.compression_max);
    // A figure of the summary that has a bound is judged here, as
    //     if (!(fabs(number(run->out, "KEY")) <= KEY_BOUND)) verdict_fail(v, "KEY", ...
}

// ---- the same bits -------------------------------------------------------------------------------------------------

static bool same_array(const sph2d_array *a, const sph2d_array *b)
{
    if (!a->name || !b->name || strcmp(a->name, b->name) != 0 || a->count != b->count ||
        a->components != b->components || a->type != b->type)
        return false;
    const size_t size = a->type == SPH2D_F64 ? sizeof(double) : sizeof(uint64_t);
    for (unsigned c = 0; c < a->components; ++c)
        for (size_t i = 0; i < a->count; ++i)
            if (memcmp((const char *)a->data[c] + i * a->stride * size, (const char *)b->data[c] + i * b->stride * size,
                       size) != 0)
                return false;
    return true;
}

/** The first array of `a` that `b` does not have alike, or NULL; of the liquid alone where the outputs that were taken
 *  differ. */
static const char *difference(const sph2d_state *a, const sph2d_state *b, bool liquid_alone)
{
    for (size_t i = 0; i < a->array_count; ++i) {
        const sph2d_array *array = &a->arrays[i];
        bool same = liquid_alone && array->group != SPH2D_GROUP_FLUID;
        for (size_t j = 0; j < b->array_count && !same; ++j)
            same = array->group == b->arrays[j].group && same_array(array, &b->arrays[j]);
        if (!same)
            return array->name;
    }
    return NULL;
}

/** The last state of a run that came to its end. */
static sph2d_snapshot *last_state(const judge_request *p, const char *name)
{
    static const char *const files[] = {"checkpoint.h5", "snapshot_000001.h5"};
    sph2d_snapshot *snapshot = NULL;
    for (int i = 0; i < 2 && snapshot == NULL; ++i) {
        char path[PATH_SIZE];
        snprintf(path, sizeof path, "%s/%s/%s", p->folder, name, files[i]);
        if (sph2d_snapshot_read(path, &snapshot, NULL) != SPH2D_OK)
            snapshot = NULL;
    }
    return snapshot;
}

static void judge_bits(const judge_request *p, sph2d_sim *sim, verdict *v)
{
    sph2d_snapshot *whole = last_state(p, "whole"), *parts = last_state(p, "parts");
    if (whole == NULL || parts == NULL)
        verdict_fail(v, "bits", "no snapshot of the end in %s", whole ? "parts" : "whole");
    else {
        const sph2d_state a = sph2d_snapshot_state(whole), b = sph2d_snapshot_state(parts), c = sph2d_sim_state(sim);
        const char *name = difference(&a, &b, false);
        if (name)
            verdict_fail(v, "bits", "one thread, and two threads stopped half-way and resumed, differ in %s", name);
        name = difference(&c, &a, true);
        if (name)
            verdict_fail(v, "bits", "the command and the library differ in %s", name);
    }
    sph2d_snapshot_destroy(whole);
    sph2d_snapshot_destroy(parts);
}

// ---- the whole -----------------------------------------------------------------------------------------------------

bool read_scene(const judge_request *p, sph2d_scene_file **file)
{
    static char paths[MOST_CHANGES][CHANGE_SIZE];
    sph2d_override changes[MOST_CHANGES];
    for (size_t i = 0; i < p->change_count; ++i) {
        snprintf(paths[i], CHANGE_SIZE, "%s", p->changes[i]);
        paths[i][strcspn(paths[i], "=")] = '\0';
        changes[i] = (sph2d_override){paths[i], p->changes[i] + strcspn(p->changes[i], "=") + 1};
    }
    return sph2d_scene_file_read(p->scene, changes, p->change_count, file, NULL) == SPH2D_OK;
}

/** A list of arguments, closed by NULL. */
typedef struct arguments {
    const char *items[24 + 2 * MOST_CHANGES];
    size_t count;
} arguments;

static void add(arguments *a, const char *const *items)
{
    for (; *items; ++items)
        a->items[a->count++] = *items;
    a->items[a->count] = NULL;
}
#define ADD(a, ...) add(a, (const char *const[]){__VA_ARGS__, NULL})

static void add_changes(arguments *a, const judge_request *p)
{
    for (size_t i = 0; i < p->change_count; ++i)
        ADD(a, "-s", p->changes[i]);
}

/** Runs to the end on one thread, or, by a change of run.until, half-way on two. */
static void run_by_command(const judge_request *p, const char *snapshots, const char *stop, ending *e)
{
    char folder[PATH_SIZE];
    snprintf(folder, sizeof folder, "%s/%s", p->folder, stop ? "parts" : "whole");
    arguments a = {.count = 0};
    ADD(&a, p->command, "run", p->scene, "-o", folder, "-f", "--json", "--isa", p->isa, "--no-frames");
    add_changes(&a, p);
    ADD(&a, "-s", snapshots, "-j", stop ? "2" : "1");
    if (stop)
        ADD(&a, "-s", stop);
    perform(p, stop ? "half" : "whole", a.items, e);
}

/** A shorter run, and the rest of it. */
static void run_in_parts(const judge_request *p, const char *snapshots, double until, ending *e)
{
    char folder[PATH_SIZE], half[64], end[64];
    snprintf(folder, sizeof folder, "%s/parts", p->folder);
    snprintf(half, sizeof half, "run.until=%.17g", until / 2);
    snprintf(end, sizeof end, "run.until=%.17g", until);
    run_by_command(p, snapshots, half, e);
    arguments a = {.count = 0};
    ADD(&a, p->command, "resume", folder, "--json", "-j", "2", "--no-frames", "-s", end);
    if (e->code == 0)
        perform(p, "parts", a.items, e);
}

/** A scene that check refused: run refuses it, with the same words, and writes nothing. */
static void judge_refusal(const judge_request *p, const ending *checked, const ending *run, verdict *v)
{
    char folder[PATH_SIZE];
    struct stat info;
    snprintf(folder, sizeof folder, "%s/whole", p->folder);
    if (run->code != checked->code || strcmp(run->err, checked->err) != 0)
        verdict_fail(v, "agree", "check refuses with %d, run ends with %d or other words", checked->code, run->code);
    else if (stat(folder, &info) == 0)
        verdict_fail(v, "agree", "run refuses the scene and makes its folder all the same");
}

static library_run judge_accepted(const judge_request *p, const ending *checked, verdict *v)
{
    static ending run, parts;
    library_run library = {.started = false};
    sph2d_scene_file *file = NULL;
    sph2d_sim *sim = NULL;
    char snapshots[80], message[200];
    if (!read_scene(p, &file)) {
        verdict_fail(v, "agree", "check accepts what the library does not read");
        return library;
    }
    const double until = sph2d_scene_file_scene(file)->run.until;
    snprintf(snapshots, sizeof snapshots, "run.snapshots={every: %.17g}", until);
    run_by_command(p, snapshots, NULL, &run);
    first_message(&run, message);
    if (!is_honest("run", &run, v))
        ;
    else if (run.code != 0 && run.code != 1)
        verdict_fail(v, "agree", "check accepts the scene, run ends with %d: %s", run.code, message);
    else {
        library = judge_by_library(p, sph2d_scene_file_scene(file), v, &sim);
        const bool left =
            strstr(message, "the body has left the domain") != NULL; // by an open side: nothing else stops it
        const bool fell = foretells_fall(checked->err) && strstr(message, "faster than sound") != NULL;
        if (run.code == 1 && !left && !fell)
            verdict_fail(v, strstr(message, "energy came from nothing") ? "energy" : "guard",
                         "check accepts the scene, a guard stops it: %s", message);
        if (library.finished != (run.code == 0))
            verdict_fail(v, "agree", "the command ends with %d, the library %s", run.code,
                         library.finished  ? "runs to the end"
                         : library.started ? "is stopped"
                                           : "does not start");
        if (run.code == 0) {
            judge_summary(checked, &run, &library, v);
            judge_plan(checked->out, checked->err, sim, &library, v);
            run_in_parts(p, snapshots, until, &parts);
            if (is_honest("a run in parts", &parts, v) && parts.code != 0)
                verdict_fail(v, "bits", "a run in one goes to its end, one in parts ends with %d", parts.code);
            else if (parts.code == 0 && sim)
                judge_bits(p, sim, v);
        }
    }
    sph2d_sim_destroy(sim);
    sph2d_scene_file_destroy(file);
    return library;
}

/** What check foretells alone, by a run in this process. */
static library_run judge_foretold(const judge_request *p, const ending *checked, verdict *v)
{
    library_run library = {.started = false};
    sph2d_scene_file *file = NULL;
    sph2d_sim *sim = NULL;
    if (checked->code == 0 && read_scene(p, &file)) {
        library = judge_by_library(p, sph2d_scene_file_scene(file), v, &sim);
        judge_plan(checked->out, checked->err, sim, &library, v);
    } else
        verdict_fail(v, "plan", "the scene is refused");
    sph2d_sim_destroy(sim);
    sph2d_scene_file_destroy(file);
    return library;
}

library_run judge_scene(const judge_request *request, verdict *v)
{
    static ending checked, run;
    arguments a = {.count = 0};
    clear(request);
    ADD(&a, request->command, "check", request->scene, "--json", "--isa", request->isa);
    add_changes(&a, request);
    perform(request, "check", a.items, &checked);
    const library_run none = {.started = false};
    if (!is_honest("check", &checked, v))
        return none;
    if (v->only && strcmp(v->only, "plan") == 0)
        return judge_foretold(request, &checked, v);
    if (checked.code == 0)
        return judge_accepted(request, &checked, v);
    run_by_command(request, "run.snapshots={}", NULL, &run);
    judge_refusal(request, &checked, &run, v);
    return none;
}
