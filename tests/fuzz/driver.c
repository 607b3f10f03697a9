/* SPDX-License-Identifier: MIT */
/** @file driver.c
 *  Gives a harness the files named and inputs made from them, where no fuzzer's own driver is linked:
 *
 *      HARNESS [--seconds N | --inputs N] [--seed N] [--limit SECONDS] [--dir DIR] FILE...
 *
 *  With neither number it runs the files alone, as they are. The inputs are run by a child, which writes each to a
 *  file that both have mapped before it runs it; so one that crashes, takes too long or too much memory is known, and
 *  is saved in DIR with what was printed. Exits with 1 if there is one. */
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "../time_limits.h"
#include "dictionary.h"
#include "fuzz.h"
#include "mutate.h"

enum {
    BATCH = 1000,      /**< inputs of one child, so that memory lost in libraries does not add up */
    MAX_FINDINGS = 20, /**< of one session */
    MAX_MEGABYTES = 1024
};
#if defined(__SANITIZE_ADDRESS__)
enum { SANITIZED = 1 };
#else
enum { SANITIZED = 0 };
#endif

/** The input that is being run. */
typedef struct current {
    uint64_t number; /**< the files come first, then inputs made from them */
    size_t size;
    unsigned char bytes[MUTATE_MAX];
} current;

typedef struct session {
    const char *name, *dir;
    mutate_bytes *files;
    size_t file_count;
    uint64_t seed, inputs;
    double seconds;
    double limit; /**< of CPU time of an input [s] */
    double start;
    current *now;
    unsigned findings;
} session;

static void stop(const char *what, const char *name)
{
    fprintf(stderr, "fuzz: %s %s: %s\n", what, name, strerror(errno));
    exit(2);
}

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static mutate_bytes load(const char *path)
{
    FILE *in = fopen(path, "rb");
    mutate_bytes file = {.bytes = malloc(MUTATE_MAX)};
    if (!in || !file.bytes)
        stop("cannot read", path);
    file.size = fread(file.bytes, 1, MUTATE_MAX, in);
    fclose(in);
    unsigned char *fitting = realloc(file.bytes, file.size + 1);
    file.bytes = fitting ? fitting : file.bytes;
    return file;
}

/** Maps a file for the input that is being run. */
static current *map_current(const char *dir)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/current", dir);
    int fd = open(path, O_RDWR | O_CREAT | O_TRUNC, 0666);
    if (fd < 0 || ftruncate(fd, sizeof(current)) != 0)
        stop("cannot write", path);
    current *now = mmap(NULL, sizeof *now, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    if (now == MAP_FAILED)
        stop("cannot map", path);
    close(fd);
    return now;
}

/* ---- the child --------------------------------------------------------------------------------------------------- */

static bool is_over(const session *s, uint64_t number)
{
    if (number < s->file_count)
        return false;
    return s->seconds > 0 ? seconds() - s->start > s->seconds : number >= s->file_count + s->inputs;
}

static void make_input(session *s, uint64_t number)
{
    mutate_bytes input = {.bytes = s->now->bytes};
    if (number < s->file_count) {
        input.size = s->files[number].size;
        memcpy(input.bytes, s->files[number].bytes, input.size);
    } else {
        mutate(s->files, s->file_count, number + (s->seed << 40), &input);
    }
    s->now->size = input.size;
    s->now->number = number;
}

/** Signals end the child: SIGPROF for CPU time, SIGALRM for an input that waits, SIGXCPU is not used. */
static void limit_input(double limit)
{
    struct itimerval cpu = {.it_value = {(time_t)limit, (suseconds_t)(1e6 * (limit - (double)(time_t)limit))}};
    struct itimerval wall = {.it_value = {(time_t)(10 * limit) + 1, 0}};
    setitimer(ITIMER_PROF, &cpu, NULL);
    setitimer(ITIMER_REAL, &wall, NULL);
}

/** Too much memory is a fault, too. With a sanitizer, which needs its own, its settings are the limit. */
static void check_memory(void)
{
    struct rusage usage;
    if (!SANITIZED && getrusage(RUSAGE_SELF, &usage) == 0 && usage.ru_maxrss > MAX_MEGABYTES * 1024L)
        kill(getpid(), SIGUSR1);
}

static void run_batch(session *s, uint64_t first)
{
    if (chdir(s->dir) != 0)
        _exit(2);
    int log = open("log", O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0666);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    struct rlimit space = {4ull * MAX_MEGABYTES << 20, 4ull * MAX_MEGABYTES << 20}, none = {0, 0};
    if (!SANITIZED)
        setrlimit(RLIMIT_AS, &space);
    setrlimit(RLIMIT_CORE, &none);
    for (uint64_t i = first; i < first + BATCH && !is_over(s, i); ++i) {
        make_input(s, i);
        limit_input(s->limit);
        LLVMFuzzerTestOneInput(s->now->bytes, s->now->size);
        check_memory();
    }
    limit_input(0);
    exit(0); /* where a leak is found, too */
}

/* ---- the parent -------------------------------------------------------------------------------------------------- */

static const char *describe(int state)
{
    if (!WIFSIGNALED(state))
        return "fault"; /* of a sanitizer */
    switch (WTERMSIG(state)) {
    case SIGPROF:
        return "slow";
    case SIGALRM:
        return "waits";
    case SIGUSR1:
        return "memory";
    default:
        return "crash";
    }
}

static void save_finding(session *s, int state)
{
    char path[4096], log[4096], old_log[4096];
    int length = snprintf(path, sizeof path, "%s/%s-%s-%llu", s->dir, s->name, describe(state),
                          (unsigned long long)s->now->number);
    if (length < 0 || length + 5 > (int)sizeof path)
        return;
    snprintf(log, sizeof log, "%.4090s.log", path);
    snprintf(old_log, sizeof old_log, "%.4090s/log", s->dir);
    FILE *out = fopen(path, "wb");
    if (!out || fwrite(s->now->bytes, 1, s->now->size, out) != s->now->size || fclose(out) != 0)
        stop("cannot write", path);
    rename(old_log, log);
    ++s->findings;
    const bool slow = strcmp(describe(state), "slow") == 0, waits = strcmp(describe(state), "waits") == 0;
    if (slow || waits)
        printf("fuzz: %s: passed its limit of %g s %s; %s\n", path, waits ? 10 * s->limit + 1 : s->limit,
               waits ? "by the clock" : "of CPU time", LIMITS_HINT);
    else
        printf("fuzz: %s\n", path);
    fflush(stdout);
}

static void run(session *s)
{
    for (uint64_t next = 0; !is_over(s, next) && s->findings < MAX_FINDINGS;) {
        s->now->number = next;
        fflush(NULL);
        pid_t child = fork();
        if (child == 0)
            run_batch(s, next);
        int state = 0;
        if (child < 0 || waitpid(child, &state, 0) != child)
            stop("cannot run", s->name);
        if (state != 0)
            save_finding(s, state);
        next = s->now->number + 1;
    }
}

static double number_of(const char *text)
{
    char *end;
    double value = strtod(text, &end);
    if (end == text || *end != '\0' || !(value >= 0)) {
        fprintf(stderr, "fuzz: '%s' is not a number\n", text);
        exit(2);
    }
    return value;
}

int main(int argc, char **argv)
{
    const char *slash = strrchr(argv[0], '/');
    session s = {.name = slash ? slash + 1 : argv[0], .dir = ".", .seed = 1, .limit = 2, .start = seconds()};
    int i = 1;
    for (; i + 1 < argc && strncmp(argv[i], "--", 2) == 0; i += 2) {
        if (strcmp(argv[i], "--dir") == 0)
            s.dir = argv[i + 1];
        else if (strcmp(argv[i], "--seconds") == 0)
            s.seconds = number_of(argv[i + 1]);
        else if (strcmp(argv[i], "--inputs") == 0)
            s.inputs = (uint64_t)number_of(argv[i + 1]);
        else if (strcmp(argv[i], "--seed") == 0)
            s.seed = (uint64_t)number_of(argv[i + 1]);
        else if (strcmp(argv[i], "--limit") == 0)
            s.limit = number_of(argv[i + 1]) * limits_factor();
        else
            i = argc;
    }
    if (i >= argc) {
        fprintf(stderr, "usage: %s [--seconds N | --inputs N] [--seed N] [--limit SECONDS] [--dir DIR] FILE...\n",
                s.name);
        return 2;
    }
    s.file_count = (size_t)(argc - i);
    s.files = calloc(s.file_count, sizeof *s.files);
    if (!s.files)
        stop("no memory for", "the files");
    for (size_t k = 0; k < s.file_count; ++k)
        s.files[k] = load(argv[i + (int)k]);
    mkdir(s.dir, 0777);
    s.now = map_current(s.dir);
    dictionary_make();
    run(&s);
    printf("fuzz: %-9s %llu inputs, %.1f s, %u findings\n", s.name, (unsigned long long)s.now->number + 1,
           seconds() - s.start, s.findings);
    fflush(stdout);
    for (size_t k = 0; k < s.file_count; ++k)
        free(s.files[k].bytes);
    free(s.files);
    return s.findings > 0;
}
