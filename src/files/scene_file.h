/* SPDX-License-Identifier: MIT */
/** @file scene_file.h
 *  Parses scenes from files and from snapshots. */
#ifndef SPH2D_FILES_SCENE_FILE_H
#define SPH2D_FILES_SCENE_FILE_H

#include "sph2d/io.h"

/** The text of a scene, and where the files come from that it names. */
typedef struct sph2d__scene_source {
    const char *text;
    size_t length;
    const char *name;        /**< in messages */
    bool with_files;         /**< the files are read */
    const sph2d_scene *kept; /**< or else has what they gave, but for particles, which are not needed; NULL: none has */
} sph2d__scene_source;

/** As sph2d_scene_file_parse(), for the public function `function`. */
sph2d_status sph2d__scene_file_parse(const sph2d__scene_source *source, const sph2d_override *overrides,
                                     size_t override_count, const char *function, sph2d_scene_file **file,
                                     sph2d_report *report);

#endif
