/* SPDX-License-Identifier: MIT */
/** @file hard_cases.c
 *  Puts methods through the hard cases, each in a process of its own, and prints a table: what was seen, what is asked,
 *  and the verdict. `known` is a miss that is listed, `WORSE` one that is more than 1.2 times what was seen then,
 *  `HOLDS` one that is listed and met: these two and `MISSED` make this fail. */
#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../../time_limits.h"
#include "cases.h"

static const char usage[] = "usage: hard_cases [--short] [--jobs N] [--csv] [--known FILE] [ID...]\n";
static const char *const method_names[METHODS] = {"muller", "wcsph", "fitted", "pcisph", "constraint"};

enum { NAME_SIZE = 160, MOST_MEASURES = 40, MOST_KNOWN = 400 };

typedef struct options {
    bool brief, csv;
    unsigned long jobs;
    const char *known;
    char **ids;
    size_t id_count;
} options;

/** A figure; NaN as a bound where it is not judged. */
typedef struct measure {
    char name[NAME_SIZE];
    double value, bound;
    const char *verdict;
} measure;

/** A case by a method. */
typedef struct row {
    const hard_case *what;
    case_method method;
    measure measures[MOST_MEASURES];
    size_t count;
    FILE *file;
    pid_t pid;
    bool done;
} row;

/** A miss that is listed: `cases|CASE METHOD|MEASURE|what was seen`, a number first. */
typedef struct known_miss {
    char row[32], name[NAME_SIZE];
    double seen;
    bool told;
} known_miss;

/* How much of what was seen a listed miss may be. */
static const double WORSE = 1.2;

static known_miss known[MOST_KNOWN];
static size_t known_count;

static _Noreturn void give_up(const char *what, const char *whom)
{
    fprintf(stderr, "hard_cases: %s %s\n", what, whom);
    exit(2);
}

// ---- in the process of a case ---------------------------------------------------------------------------------------

void tell(outcome *o, const char *name, double value, double bound)
{
    fprintf(o->file, "%s|%.17g|%.17g\n", name, value, bound);
    fflush(o->file);
}

void tell_only(outcome *o, const char *name, double value)
{
    tell(o, name, value, NAN);
}

void tell_of(outcome *o, const char *name, const char *which, double value, double bound)
{
    char both[NAME_SIZE];
    snprintf(both, sizeof both, "%s, %s", name, which);
    tell(o, both, value, bound);
}

/** Ten times the time that it should take, and a memory that no case needs: a case that hangs or grows is a miss. */
static void limit_itself(double seconds)
{
    const unsigned most = (unsigned)(20 + 10 * seconds) * limits_factor();
    const struct rlimit processor = {most, most + 1}, memory = {(rlim_t)4 << 30, (rlim_t)4 << 30};
    setrlimit(RLIMIT_CPU, &processor);
#ifndef __SANITIZE_ADDRESS__
    setrlimit(RLIMIT_DATA, &memory);
#endif
    (void)memory;
    alarm(10 * most);
}

static void start(row *r)
{
    r->file = tmpfile();
    if (r->file == NULL)
        give_up("no temporary file for", r->what->id);
    fflush(NULL);
    r->pid = fork();
    if (r->pid < 0)
        give_up("cannot start", r->what->id);
    if (r->pid > 0)
        return;
    limit_itself(r->what->seconds);
    outcome o = {r->file, r->method};
    r->what->run(&o);
    fputs("|end\n", r->file);
    exit(fclose(r->file) == 0 ? 0 : 3);
}

// ---- verdicts -------------------------------------------------------------------------------------------------------

static void read_known(const char *path)
{
    char line[1000];
    FILE *file = fopen(path, "r");
    if (file == NULL)
        give_up("cannot read", path);
    while (fgets(line, sizeof line, file)) {
        known_miss *k = &known[known_count];
        int length = 0;
        char *end;
        if (sscanf(line, "cases|%31[^|]|%159[^|]|%n", k->row, k->name, &length) != 2 || length == 0)
            continue;
        k->seen = strtod(line + length, &end);
        if (end == line + length)
            give_up("a line has no number in", path);
        if (++known_count == MOST_KNOWN)
            give_up("too many lines in", path);
    }
    fclose(file);
}

/** What was seen of a miss that is listed; NaN of others. */
static double known_value(const row *r, const char *name)
{
    char title[32];
    snprintf(title, sizeof title, "%s %s", r->what->id, method_names[r->method]);
    for (size_t i = 0; i < known_count; ++i)
        if (strcmp(known[i].row, title) == 0 && strcmp(known[i].name, name) == 0) {
            known[i].told = true;
            return known[i].seen;
        }
    return NAN;
}

static const char *verdict_on(double value, double bound, double seen)
{
    if (isnan(bound))
        return "";
    if (value <= bound)
        return isnan(seen) ? "ok" : "HOLDS";
    return isnan(seen) ? "MISSED" : value <= WORSE * seen ? "known" : "WORSE";
}

static void add(row *r, const char *name, double value, double bound)
{
    if (r->count == MOST_MEASURES)
        give_up("too many measures of", r->what->id);
    measure *m = &r->measures[r->count++];
    snprintf(m->name, sizeof m->name, "%s", name);
    m->value = value;
    m->bound = bound;
    m->verdict = verdict_on(value, bound, known_value(r, m->name));
}

/** Reads what a case told; its process has ended. */
static void collect(row *r, int status)
{
    char line[NAME_SIZE + 80];
    bool ended = false;
    rewind(r->file);
    while (fgets(line, sizeof line, r->file)) {
        char *value = strchr(line, '|'), *bound = value ? strchr(value + 1, '|') : NULL;
        ended = ended || strcmp(line, "|end\n") == 0;
        if (bound) {
            *value = '\0';
            add(r, line, strtod(value + 1, NULL), strtod(bound + 1, NULL));
        }
    }
    fclose(r->file);
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        const bool late = signal == SIGXCPU || signal == SIGALRM;
        if (late)
            fprintf(stderr, "hard_cases: %s by %s passed its limit of time%s; %s\n", r->what->id,
                    method_names[r->method], signal == SIGXCPU ? ", of the CPU" : " by the clock", LIMITS_HINT);
        add(r, late ? "out of time" : "crash by signal", signal, 0);
    } else if (!ended || WEXITSTATUS(status) != 0)
        add(r, "ended early with status", WEXITSTATUS(status), -1);
    r->done = true;
}

/** The worst verdict of a row's measures. */
static const char *verdict_of(const row *r)
{
    static const char *const worst[] = {"MISSED", "WORSE", "HOLDS", "known", "ok"};
    for (size_t k = 0; k < sizeof worst / sizeof *worst; ++k)
        for (size_t i = 0; i < r->count; ++i)
            if (strcmp(r->measures[i].verdict, worst[k]) == 0)
                return worst[k];
    return "MISSED"; // nothing was judged
}

// ---- tables ---------------------------------------------------------------------------------------------------------

static void print_row(const options *o, const row *r)
{
    if (o->csv) {
        for (size_t i = 0; i < r->count; ++i) {
            const measure *m = &r->measures[i];
            printf("%s,%s,\"%s\",%.6g,%.6g,%s\n", r->what->id, method_names[r->method], m->name, m->value, m->bound,
                   m->verdict);
        }
        return;
    }
    printf("| %s | %s | %s | ", r->what->id, r->what->what, method_names[r->method]);
    size_t printed = 0;
    for (size_t i = 0; i < r->count; ++i) {
        const measure *m = &r->measures[i];
        const char *mark = m->value <= m->bound || isnan(m->bound) ? "" : "**";
        if (m->value != 0 || m->bound != 0) // what did not happen, and must not, goes without saying
            printf("%s%s%s %.3g%s", printed++ > 0 ? "; " : "", mark, m->name, m->value, mark);
    }
    if (printed == 0)
        printf("none of %zu faults", r->count);
    printf(" | %s | %s |\n", r->what->criterion, verdict_of(r));
}

static bool is_asked(const options *o, const char *id)
{
    bool asked = o->id_count == 0;
    for (size_t i = 0; i < o->id_count; ++i) // a letter asks for all of its cases
        asked = asked || strcmp(o->ids[i], id) == 0 || (o->ids[i][1] == '\0' && o->ids[i][0] == id[0]);
    return asked;
}

static void print_studied(const options *o)
{
    for (size_t i = 0; i < studied_case_count && !o->brief && !o->csv; ++i) {
        const studied_case *s = &studied_cases[i];
        if (is_asked(o, s->id))
            printf("| %s | %s | | %s | | |\n", s->id, s->what, s->where);
    }
}

// ---- all of them ----------------------------------------------------------------------------------------------------

static size_t choose(const options *o, row **rows)
{
    const case_list *const letters[] = {&degenerate_cases, &place_cases,     &invariance_cases, &tension_cases,
                                        &wall_cases,       &stiffness_cases, &violent_cases};
    size_t count = 0;
    *rows = NULL;
    for (size_t l = 0; l < sizeof letters / sizeof *letters; ++l)
        for (size_t i = 0; i < letters[l]->count; ++i) {
            const hard_case *c = &letters[l]->items[i];
            for (case_method m = 0; m < METHODS; ++m) {
                if (!(c->methods >> m & 1) || !is_asked(o, c->id) || (o->brief && !(c->seconds < 1)))
                    continue;
                *rows = realloc(*rows, (count + 1) * sizeof **rows);
                if (*rows == NULL)
                    give_up("no memory for", c->id);
                (*rows)[count++] = (row){.what = c, .method = m};
            }
        }
    return count;
}

static void wait_for_one(row *rows, size_t started)
{
    int status = 0;
    const pid_t pid = waitpid(-1, &status, 0);
    if (pid < 0 && errno != EINTR)
        give_up("cannot wait for", "a case");
    for (size_t i = 0; i < started; ++i)
        if (pid > 0 && rows[i].pid == pid && !rows[i].done)
            collect(&rows[i], status);
}

static unsigned summarise(const options *o, const row *rows, size_t count)
{
    static const char *const verdicts[] = {"ok", "known", "MISSED", "WORSE", "HOLDS"};
    enum { VERDICTS = sizeof verdicts / sizeof *verdicts };
    unsigned counts[VERDICTS] = {0};
    for (size_t i = 0; i < count; ++i)
        for (int k = 0; k < VERDICTS; ++k)
            counts[k] += strcmp(verdict_of(&rows[i]), verdicts[k]) == 0;
    unsigned gone = 0;
    for (size_t i = 0; i < known_count && o->id_count == 0 && !o->brief; ++i)
        if (!known[i].told && ++gone)
            fprintf(stderr, "hard_cases: no measure '%s' of %s, which is listed\n", known[i].name, known[i].row);
    fprintf(stderr, "hard_cases: %zu rows: %u ok, %u known, %u MISSED, %u worse than listed, %u listed that hold\n",
            count, counts[0], counts[1], counts[2], counts[3], counts[4]);
    return counts[2] + counts[3] + counts[4] + gone;
}

static unsigned judge_all(const options *o)
{
    row *rows;
    const size_t count = choose(o, &rows);
    size_t started = 0, told = 0;
    puts(o->csv ? "case,method,measure,value,bound,verdict"
                : "| case | what | method | figures | criterion | verdict |\n|---|---|---|---|---|---|");
    while (told < count) {
        size_t running = 0;
        for (size_t i = told; i < started; ++i)
            running += !rows[i].done;
        if (running < o->jobs && started < count) {
            start(&rows[started++]);
            continue;
        }
        wait_for_one(rows, started);
        for (; told < started && rows[told].done; ++told) {
            print_row(o, &rows[told]);
            fflush(stdout);
        }
    }
    print_studied(o);
    const unsigned bad = summarise(o, rows, count);
    free(rows);
    return bad;
}

int main(int argc, char **argv)
{
    options o = {.jobs = 1, .ids = argv};
    for (int i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--short") == 0)
            o.brief = true;
        else if (strcmp(argv[i], "--csv") == 0)
            o.csv = true;
        else if (strcmp(argv[i], "--jobs") == 0 && i + 1 < argc)
            o.jobs = strtoul(argv[++i], NULL, 10);
        else if (strcmp(argv[i], "--known") == 0 && i + 1 < argc)
            o.known = argv[++i];
        else if (argv[i][0] == '-') {
            fputs(usage, stderr);
            return 2;
        } else
            argv[o.id_count++] = argv[i];
    }
    if (o.jobs < 1) {
        fputs(usage, stderr);
        return 2;
    }
    if (o.known)
        read_known(o.known);
    return judge_all(&o) > 0;
}
