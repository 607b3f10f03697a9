/* SPDX-License-Identifier: MIT */
/** @file parts.c
 *  Calls of each library that it is linked with, which take each other's types and what those need: scenes, drawings and
 *  snapshots are read, pictures drawn. None of these files is there. */
#include <stdio.h>
#include <string.h>

#include <sph2d/contacts.h>
#include <sph2d/io.h>
#include <sph2d/study_results.h>
#ifdef WITH_render
#include <sph2d/render.h>
#endif

int main(void)
{
    if (strcmp(sph2d_version(), SPH2D_VERSION) != 0 || sph2d_contacts_attach(NULL) == SPH2D_OK)
        return 1;
    sph2d_scene_file *scene = NULL;
    sph2d_snapshot *snapshot = NULL;
    sph2d_study_file *study = NULL;
    sph2d_study_record_free(NULL);
    if (sph2d_scene_file_read("none.yaml", NULL, 0, &scene, NULL) != SPH2D_NOINPUT ||
        sph2d_snapshot_read("none.h5", &snapshot, NULL) != SPH2D_NOINPUT ||
        sph2d_study_file_read("none.yaml", &study, NULL) != SPH2D_NOINPUT)
        return 2;
#ifdef WITH_render
    sph2d_render_options options = sph2d_render_options_default();
    sph2d_renderer *renderer = NULL;
    options.gl = "none";
    if (sph2d_renderer_create(&options, &renderer, NULL) == SPH2D_OK)
        return 3;
#endif
    return puts(sph2d_io_hdf5_version()) < 0;
}
