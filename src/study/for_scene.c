/* SPDX-License-Identifier: MIT */
/** @file for_scene.c
 *  A study for a scene that has none. */
#define _XOPEN_SOURCE 700 /* realpath */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/null.h"
#include "base/number.h"
#include "sph2d/study_results.h"

/** A text in YAML's quotes. */
static void put_quoted(FILE *out, const char *text)
{
    putc('"', out);
    for (; *text; ++text)
        fprintf(out, "%s%c", *text == '"' || *text == '\\' ? "\\" : "", *text);
    putc('"', out);
}

/** How much stiffer or softer: whatever the scene itself says it with. */
static void put_stiffness(FILE *out, const sph2d_method_options *method)
{
    double standard = sph2d_method_of(method)->max_compression;
    double compression = method->max_compression > 0 ? method->max_compression : standard;
    if (method->sound_speed > 0)
        fprintf(out, "  method.sound_speed: [%.4g, %.15g]\n", method->sound_speed / 2, method->sound_speed);
    else if (method->stiffness > 0)
        fprintf(out, "  method.stiffness: [%.4g, %.15g]\n", method->stiffness / 4, method->stiffness);
    else
        fprintf(out, "  method.max_compression: [%.4g, %.15g]\n", fmin(4 * compression, 0.9), compression);
}

static const sph2d_probe *find_probe(const sph2d_scene *scene, sph2d_probe_kind kind)
{
    for (size_t i = 0; i < scene->probe_count; ++i)
        if (scene->probes[i].kind == kind)
            return &scene->probes[i];
    return NULL;
}

/** By the exact solution where the scene starts with one, else by its kinetic energy over time. */
static void put_measure(FILE *out, const sph2d_probe *exact, const sph2d_probe *energy)
{
    if (exact)
        fprintf(out, "  - {name: speed L1, probe: %s, column: speed_l1, take: max, expect: 0, order: true}\n",
                exact->name);
    else
        fprintf(out,
                "  - {name: kinetic energy, probe: %s, column: kinetic, finest: true, norm: mean, relative: true, "
                "order: true}\n",
                energy ? energy->name : "energy");
}

static void put_study(FILE *out, const char *path, const sph2d_scene *scene, const sph2d_override *overrides,
                      size_t override_count)
{
    const sph2d_probe *exact = find_probe(scene, SPH2D_PROBE_ERROR), *energy = find_probe(scene, SPH2D_PROBE_ENERGY);
    const char *before = "\nruns:\n  - name: scene\n    set: {", *after = "";
    double dx = scene->spacing;
    fprintf(out, "# What the error of a scene costs: made by sph2d study, to be changed at will.\nscene: ");
    put_quoted(out, path);
    for (size_t i = 0; i < override_count; ++i, before = ", ", after = "}") {
        fputs(before, out);
        put_quoted(out, overrides[i].path);
        fprintf(out, ": %s", overrides[i].value);
    }
    if (!exact && !energy) {
        fprintf(out, "%sprobes: [{name: energy, kind: energy, every: %.4g}]", before, scene->run.until / 100);
        after = "}";
    }
    fprintf(out, "%s\nvary:\n  spacing: [%.4g, %.4g, %.15g]\n", after, 2 * dx, sqrt(2) * dx, dx);
    put_stiffness(out, &scene->method);
    fprintf(out, "refine:\n  - {set: {spacing: %.4g}}\nmeasures:\n", dx / sqrt(2));
    put_measure(out, exact, energy);
    fprintf(out, "repeat: 1\n");
}

/** Room for the text: what is quoted may double, the rest is shorter than a page. */
static size_t room_for(const char *path, const sph2d_scene *scene, const sph2d_override *overrides, size_t count)
{
    const size_t page = 4096;
    const sph2d_probe *exact = find_probe(scene, SPH2D_PROBE_ERROR), *energy = find_probe(scene, SPH2D_PROBE_ENERGY);
    size_t room = page + 2 * strlen(path) + (exact ? strlen(exact->name) : 0) + (energy ? strlen(energy->name) : 0);
    for (size_t i = 0; i < count; ++i)
        room += 8 + 2 * strlen(overrides[i].path) + strlen(overrides[i].value);
    return room;
}

/** NULL when memory is short. Into a buffer with room for all of it: when open_memstream cannot grow, glibc 2.36 drops a
 *  part of the text, and neither ferror nor fclose tells. */
static char *make_text(const char *path, const sph2d_scene *scene, const sph2d_override *overrides,
                       size_t override_count)
{
    sph2d__c_locale locale;
    char *absolute = realpath(path, NULL);
    size_t room = absolute ? room_for(absolute, scene, overrides, override_count) : 0;
    char *text = absolute ? malloc(room) : NULL;
    FILE *out = text ? fmemopen(text, room, "w") : NULL;
    bool whole = out && sph2d__c_locale_begin(&locale);
    if (whole) {
        put_study(out, absolute, scene, overrides, override_count);
        sph2d__c_locale_end(&locale);
    }
    whole = out && fflush(out) == 0 && !ferror(out) && whole;
    whole = out && fclose(out) == 0 && whole;
    free(absolute);
    if (whole)
        return text;
    free(text);
    return NULL;
}

sph2d_status sph2d_study_text_for_scene(const char *path, const sph2d_override *overrides, size_t override_count,
                                        char **text, sph2d_report *report)
{
    if (!text)
        return sph2d__null(report, __func__, "text");
    *text = NULL;
    if (!path)
        return sph2d__null(report, __func__, "path");
    sph2d_scene_file *file;
    size_t first = report ? report->count : 0;
    sph2d_status status = sph2d_scene_file_read(path, overrides, override_count, &file, report);
    if (status != SPH2D_OK)
        return status;
    if (report)
        report->count = first; /* rows tell the warnings */
    *text = make_text(path, sph2d_scene_file_scene(file), overrides, override_count);
    sph2d_scene_file_destroy(file);
    return *text ? SPH2D_OK : SPH2D_NOMEM;
}
