/* SPDX-License-Identifier: MIT */
/** @file open.c
 *  The study to be done, and the scenes that come out of it. */
#include "parts.h"

#include <stdlib.h>
#include <string.h>

#include "../exit.h"
#include "../message.h"

/* ---- reading ----------------------------------------------------------------------------------------------------- */

static bool has_fault(const sph2d_report *report, sph2d_code code, const char *path)
{
    for (size_t i = 0; i < report->count; ++i)
        if (report->items[i].code == code && strcmp(report->items[i].path, path) == 0)
            return true;
    return false;
}

/* A scene has what no study has, and lacks what every study has. */
static bool is_scene(const sph2d_report *report)
{
    return has_fault(report, SPH2D_CODE_MISSING_KEY, "scene") && (has_fault(report, SPH2D_CODE_UNKNOWN_KEY, "domain") ||
                                                                  has_fault(report, SPH2D_CODE_UNKNOWN_KEY, "spacing"));
}

int study_open(cli_study *s)
{
    sph2d_status status = sph2d_study_file_read(s->path, &s->file, &s->report);
    if (status == SPH2D_SCENE && is_scene(&s->report)) {
        sph2d_report_clear(&s->report);
        status = sph2d_study_text_for_scene(s->path, s->options->overrides, s->options->override_count, &s->made,
                                            &s->report);
        if (status == SPH2D_OK)
            status = sph2d_study_file_parse(s->made, strlen(s->made), s->path, &s->file, &s->report);
    }
    if (status == SPH2D_OK)
        s->study = sph2d_study_file_study(s->file);
    return study_report(s, status);
}

/* ---- what is left for people ------------------------------------------------------------------------------------- */

/* The scene of a row, with what it is in its first lines. */
typedef struct cheapest {
    const cli_study *study;
    const char *name, *scene;
} cheapest;

static void put_cheapest(const void *what, FILE *out)
{
    const cheapest *c = what;
    char verdict[512], path[1024];
    snprintf(path, sizeof path, "%s", c->study->study->scene);
    for (char *control = path; *control != '\0'; ++control) /* a comment is one line */
        *control = (unsigned char)*control < 0x20 ? ' ' : *control;
    fprintf(out, "# %s with %s.\n# %s\n%s", path, c->name, study_verdict(c->study, verdict, sizeof verdict), c->scene);
}

static void put_made(const void *text, FILE *out)
{
    fputs(text, out);
}

int study_open_write(cli_study *s)
{
    int code = CLI_EXIT_SUCCESS;
    if (s->made && folder_holds(s->folder.path, "study.yaml"))
        message_detail("'%s/study.yaml' is there already and stays as it is", s->folder.path);
    else if (s->made)
        code = study_write(s, "study.yaml", put_made, s->made);
    const sph2d_study_row *row = sph2d_study_cheapest(s->results, s->target);
    char *scene = NULL;
    if (!row)
        return code;
    sph2d_status status = sph2d_study_run_scene_text(s->results, &row->run, &scene, &s->report);
    if (status == SPH2D_OK)
        code = study_first(code, study_write(s, "cheapest.yaml", put_cheapest, &(cheapest){s, row->run.name, scene}));
    else
        code = study_first(code, study_report(s, status));
    free(scene);
    return code;
}
