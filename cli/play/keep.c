/* SPDX-License-Identifier: MIT */
/** @file keep.c
 *  What play leaves behind: a scene with its snapshot, and a film or its frames. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

#include "game.h"

enum { NAMES = 1000 };

/* A folder that does not exist yet, NAME_000 and on; false with a message where none can be made. */
static bool make_folder(game *g, const char *name, char out[32])
{
    for (int k = 0; k < NAMES; ++k) {
        snprintf(out, 32, "%.20s_%03d", name, k);
        if (mkdir(out, 0777) == 0)
            return true;
        struct stat there;
        if (stat(out, &there) != 0)
            break;
    }
    game_tell(g, "cannot make a folder '%.20s_000' here", name);
    return false;
}

/* The name of a film that does not exist yet. */
static void name_film(char out[32])
{
    struct stat there;
    for (int k = 0; k < NAMES; ++k) {
        snprintf(out, 32, "film_%03d.mp4", k);
        if (stat(out, &there) != 0)
            return;
    }
}

/* Writes `scene.yaml` and `snapshot_000000.h5` into a folder, by which the run can be resumed. */
static sph2d_status save_into(live *l, const char *folder, sph2d_report *report)
{
    const sph2d_scene scene = live_scene(l);
    const size_t size = sph2d_scene_text(&scene, NULL, 0) + 1;
    char *text = size > 1 ? malloc(size) : NULL;
    if (!text)
        return SPH2D_NOMEM;
    sph2d_scene_text(&scene, text, size);
    char path[4096];
    sph2d_scene_file *file = NULL;
    snprintf(path, sizeof path, "%s/scene.yaml", folder);
    sph2d_status status = sph2d_text_write(path, text, size - 1, report);
    if (status == SPH2D_OK)
        status = sph2d_scene_file_parse(text, size - 1, path, NULL, 0, &file, report);
    snprintf(path, sizeof path, "%s/snapshot_000000.h5", folder);
    if (status == SPH2D_OK)
        status = sph2d_snapshot_write(l->sim, file, 0, path, report);
    sph2d_scene_file_destroy(file);
    free(text);
    return status;
}

void game_save(game *g)
{
    char folder[32];
    sph2d_report report = {0};
    if (!make_folder(g, "played", folder))
        return;
    const sph2d_status status = save_into(&g->live, folder, &report);
    game_tell_report(g, status, &report);
    if (status == SPH2D_OK)
        game_tell(g, "saved in '%s': scene.yaml, and a snapshot that 'sph2d resume %s' goes on from", folder, folder);
}

/* ---- films ------------------------------------------------------------------------------------------------------- */

/* Ends what is recorded, and tells what there is; the film may fail at its end. */
static void end_film(game *g)
{
    sph2d_report report = {0};
    const bool by_ffmpeg = g->film.path;
    const sph2d_status status = by_ffmpeg ? film_close(&g->film, &report) : SPH2D_OK;
    if (status != SPH2D_OK)
        game_tell_report(g, status, &report);
    else if (by_ffmpeg)
        game_tell(g, "'%s' has %u frames", g->recording, g->recorded);
    else
        game_tell(g, "%u frames in '%s': ffmpeg -framerate %d -i %s/frame_%%06d.png film.mp4", g->recorded,
                  g->recording, GAME_FILM_RATE, g->recording);
    g->recording[0] = '\0';
}

/* Begins a film, or without ffmpeg a folder of frames. */
static void begin_film(game *g, unsigned width, unsigned height)
{
    sph2d_report report = {0};
    const film_form form = {width, height, GAME_FILM_RATE, 1};
    name_film(g->recording);
    sph2d_status status = film_open(&g->film, g->recording, &form, &report);
    if (status == SPH2D_RENDER) {
        sph2d_report_clear(&report);
        status = make_folder(g, "film", g->recording) ? SPH2D_OK : SPH2D_CANTCREAT;
    }
    g->film_width = width;
    g->film_height = height;
    g->recorded = 0;
    g->next_frame = g->picture_time;
    if (status == SPH2D_OK)
        game_tell(g, "filming into '%s'; F ends it", g->recording);
    else
        g->recording[0] = '\0';
    if (report.count > 0)
        game_tell_report(g, status, &report);
}

void game_film(game *g)
{
    if (g->recording[0] != '\0')
        end_film(g);
    else
        g->films = !g->films;
}

void game_film_end(game *g)
{
    if (g->recording[0] != '\0')
        end_film(g);
}

static sph2d_status add_frame(game *g, sph2d_renderer *renderer, sph2d_report *report)
{
    sph2d_picture frame = g->picture;
    frame.notes = NULL;
    const sph2d_status status = sph2d_renderer_draw(renderer, &frame, report);
    if (status != SPH2D_OK)
        return status;
    if (g->film.path)
        return film_add(&g->film, sph2d_renderer_pixels(renderer), report);
    char path[64];
    snprintf(path, sizeof path, "%s/frame_%06u.png", g->recording, g->recorded);
    return sph2d_renderer_write_png(renderer, path, report);
}

void game_film_frame(game *g, sph2d_renderer *renderer, unsigned width, unsigned height)
{
    if (g->films)
        begin_film(g, width, height);
    g->films = false;
    if (g->recording[0] == '\0')
        return;
    if (width != g->film_width || height != g->film_height) {
        end_film(g); /* it has one size */
        return;
    }
    const double now = g->picture_time, each = g->rate / GAME_FILM_RATE;
    g->next_frame = fmin(g->next_frame, now + each); /* time went back */
    if (now < g->next_frame)
        return;
    sph2d_report report = {0};
    const sph2d_status status = add_frame(g, renderer, &report);
    g->recorded += status == SPH2D_OK;
    g->next_frame += each;
    if (status != SPH2D_OK) {
        film_abort(&g->film);
        g->recording[0] = '\0';
    }
    game_tell_report(g, status, &report);
}
