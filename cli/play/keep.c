/* SPDX-License-Identifier: MIT */
/** @file keep.c
 *  What play leaves behind: a scene with its snapshot, and the frames of a film. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

#include "game.h"

/* A folder that does not exist yet, NAME_000 and on; false with a message where none can be made. */
static bool make_folder(game *g, const char *name, char out[32])
{
    for (int k = 0; k < 1000; ++k) {
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

void game_film(game *g)
{
    if (g->recording[0] != '\0') {
        game_tell(g, "%u frames in '%s': ffmpeg -framerate %d -i %s/frame_%%06d.png film.mp4", g->recorded,
                  g->recording, GAME_FILM_RATE, g->recording);
        g->recording[0] = '\0';
    } else if (make_folder(g, "film", g->recording)) {
        g->recorded = 0;
        g->next_frame = sph2d_sim_time(g->live.sim);
        game_tell(g, "filming into '%s'; F ends it", g->recording);
    } else {
        g->recording[0] = '\0';
    }
}

void game_film_frame(game *g, sph2d_renderer *renderer)
{
    const double now = g->picture_time, each = g->rate / GAME_FILM_RATE;
    g->next_frame = fmin(g->next_frame, now + each); /* time went back */
    if (g->recording[0] == '\0' || now < g->next_frame)
        return;
    sph2d_report report = {0};
    char path[64];
    snprintf(path, sizeof path, "%s/frame_%06u.png", g->recording, g->recorded);
    sph2d_picture frame = g->picture;
    frame.notes = NULL;
    sph2d_status status = sph2d_renderer_draw(renderer, &frame, &report);
    if (status == SPH2D_OK)
        status = sph2d_renderer_write_png(renderer, path, &report);
    g->recorded += status == SPH2D_OK;
    g->next_frame += each;
    if (status != SPH2D_OK)
        g->recording[0] = '\0';
    game_tell_report(g, status, &report);
}
