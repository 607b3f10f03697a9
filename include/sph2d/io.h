/* SPDX-License-Identifier: MIT */
/** @file io.h
 *  Files: scene files (YAML, so JSON too), snapshots (HDF5), time series and tables (CSV). Library libsph2d-io.
 *
 *      sph2d_scene_file *file = NULL;
 *      if (sph2d_scene_file_read("scene.yaml", NULL, 0, &file, &report) == SPH2D_OK)
 *          status = sph2d_sim_create(sph2d_scene_file_scene(file), NULL, &sim, &report);
 *      ...
 *      status = sph2d_snapshot_write(sim, file, 0, "now.h5", &report);
 *      sph2d_scene_file_destroy(file);
 *
 *  A file under its final name is always complete: files are written under another name, synced and renamed. HDF5 is
 *  not thread-safe, so only one thread at a time may be in this library. This library returns SPH2D_NOMEM when memory is
 *  short, but HDF5 and libfyaml, which it calls, do not survive each of their own failed allocations: they may end the
 *  process, with all files whole. */
#ifndef SPH2D_IO_H
#define SPH2D_IO_H

#include "sph2d/sph2d.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- scene files ------------------------------------------------------------------------------------------------- */

/** A scene that was read, with everything it points to. */
typedef struct sph2d_scene_file sph2d_scene_file;

/** A change of one key on top of a file: path `blocks[0].velocity`, value as YAML, `[1, 0]`. Borrowed strings. */
typedef struct sph2d_override {
    const char *path, *value;
} sph2d_override;

/** Reads and checks a scene file. Every fault is reported at once with file, line, column and source line. At most
 *  64 MiB are read. Errors: SPH2D_NOINPUT, SPH2D_SCENE, SPH2D_NOMEM. The caller owns *file (NULL after a failure). */
SPH2D_API sph2d_status sph2d_scene_file_read(const char *path, const sph2d_override *overrides, size_t override_count,
                                             sph2d_scene_file **file, sph2d_report *report);

/** The same from a file descriptor that is open, such as the standard input, a pipe or a socket, from where it stands to
 *  its end; it stays open. `name` is the name of the file in messages. Paths in the scene are relative to the folder in
 *  `name`; without a slash that is the folder of the process. */
SPH2D_API sph2d_status sph2d_scene_file_read_open(int descriptor, const char *name, const sph2d_override *overrides,
                                                  size_t override_count, sph2d_scene_file **file, sph2d_report *report);

/** The same from memory. `name` is the name of the file in messages; files that the scene names are not read: it is
 *  refused if they are of motions, gravity or openings, and no new run can be made of it if they are of what blocks start
 *  with. */
SPH2D_API sph2d_status sph2d_scene_file_parse(const char *text, size_t length, const char *name,
                                              const sph2d_override *overrides, size_t override_count,
                                              sph2d_scene_file **file, sph2d_report *report);

/** Frees a scene file and the scene in it; NULL is fine. */
SPH2D_API void sph2d_scene_file_destroy(sph2d_scene_file *file);

/** The scene, valid as long as the file. */
SPH2D_API const sph2d_scene *sph2d_scene_file_scene(const sph2d_scene_file *file);

/** The text as it was read, NUL-terminated, and the overrides on top of it; valid as long as the file. */
SPH2D_API const char *sph2d_scene_file_text(const sph2d_scene_file *file);
SPH2D_API const sph2d_override *sph2d_scene_file_overrides(const sph2d_scene_file *file, size_t *count);

/** A scene as YAML that reads as the same scene again: required keys and those that differ from their defaults, a few
 *  lines each. Writes at most `size` bytes with the terminating NUL to `out`, and returns the length of the whole text
 *  without it, like snprintf; 0 when memory is short. The name of a file of particles is written as it is in the scene.
 */
SPH2D_API size_t sph2d_scene_text(const sph2d_scene *scene, char *out, size_t size);

/** Completes a diagnostic about a key path (as from sph2d_sim_create) with file, line, column and source line. */
SPH2D_API void sph2d_scene_file_locate(const sph2d_scene_file *file, sph2d_diagnostic *diagnostic);

/* ---- snapshots --------------------------------------------------------------------------------------------------- */

/** Writes a simulation's fields and state. `file` is the scene file it came from, stored verbatim so that the snapshot
 *  suffices to resume; NULL for a scene built from structs. The same simulation gives the same bytes. `compress` is a
 *  deflate level, 0 for none. Errors: SPH2D_CANTCREAT, SPH2D_IO (an existing file is not changed), SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_snapshot_write(sph2d_sim *sim, const sph2d_scene_file *file, unsigned compress,
                                            const char *path, sph2d_report *report);

/** A snapshot that is written under a temporary name beside its own. */
typedef struct sph2d_snapshot_draft sph2d_snapshot_draft;

/** The first half of sph2d_snapshot_write(): writes everything under a temporary name, so that the simulation may go on
 *  while the rest waits for the disk. The caller owns *draft (NULL after a failure) and gives it to one of the next two.
 *  Errors: as sph2d_snapshot_write. */
SPH2D_API sph2d_status sph2d_snapshot_begin(sph2d_sim *sim, const sph2d_scene_file *file, unsigned compress,
                                            const char *path, sph2d_snapshot_draft **draft, sph2d_report *report);

/** The second half: syncs the file, gives it its name, and frees the draft, whatever the result. Any thread may call it,
 *  also while another one is in this library. Errors: SPH2D_IO (an existing file is not changed). */
SPH2D_API sph2d_status sph2d_snapshot_commit(sph2d_snapshot_draft *draft, sph2d_report *report);

/** Removes the temporary file, and frees the draft; NULL is fine. */
SPH2D_API void sph2d_snapshot_abort(sph2d_snapshot_draft *draft);

/** A snapshot that was read into memory. */
typedef struct sph2d_snapshot sph2d_snapshot;

/** General information about a snapshot. */
typedef struct sph2d_snapshot_info {
    /** Name of the scene. */
    const char *scene_name;

    /** Version of the program that wrote it. */
    const char *code_version;

    /** Method, "wcsph". */
    const char *method;

    /** Instruction set, "avx2". */
    const char *isa;

    /** The scene file, verbatim; NULL for a scene that was built from structs. */
    const char *scene_text;

    /** Simulated time [s]. */
    double time;

    /** Length of the next step [s]. */
    double time_step;

    /** Steps taken. */
    uint64_t steps;

    /** Domain [m]. */
    sph2d_box domain;

    /** Its sides. */
    sph2d_boundary boundary;

    /** Particle spacing dx [m]. */
    double spacing;

    /** Support radius H [m]. */
    double support_radius;

    /** Sound speed c0 [m/s]. */
    double sound_speed;

    /** The liquid, and frames of the run; their strings are valid as long as the snapshot. */
    sph2d_fluid fluid;
    sph2d_frames frames;
} sph2d_snapshot_info;

/** Reads a snapshot. Errors: SPH2D_NOINPUT, SPH2D_FORMAT (not HDF5, its checksum missing or wrong, incomplete, a field
 *  missing or misshapen, another version), SPH2D_NOMEM. The caller owns *snapshot (NULL after a failure). */
SPH2D_API sph2d_status sph2d_snapshot_read(const char *path, sph2d_snapshot **snapshot, sph2d_report *report);

/** The same for a file that another program has changed: its checksum is not checked and may be missing. HDF5 is not
 *  robust against files that are damaged in other ways, so the file must come from a source that is trusted. */
SPH2D_API sph2d_status sph2d_snapshot_read_unchecked(const char *path, sph2d_snapshot **snapshot, sph2d_report *report);

/** Frees a snapshot; NULL is fine. */
SPH2D_API void sph2d_snapshot_destroy(sph2d_snapshot *snapshot);

/** General information; strings are valid as long as the snapshot. */
SPH2D_API sph2d_snapshot_info sph2d_snapshot_get_info(const sph2d_snapshot *snapshot);

/** The whole state, for sph2d_sim_restore; borrowed, valid as long as the snapshot. */
SPH2D_API sph2d_state sph2d_snapshot_state(const sph2d_snapshot *snapshot);

/** One array by group and name, borrowed; NULL when there is none. */
SPH2D_API const sph2d_array *sph2d_snapshot_array(const sph2d_snapshot *snapshot, sph2d_group group, const char *name);

/** The scene it was written with, read again with its overrides and `more` on top, whose first replaces the last
 *  override if that is one of the same key. Errors: as sph2d_scene_file_parse,
 *  and SPH2D_FORMAT when it holds no scene text. */
SPH2D_API sph2d_status sph2d_snapshot_scene(const sph2d_snapshot *snapshot, const sph2d_override *more,
                                            size_t more_count, sph2d_scene_file **file, sph2d_report *report);

/* ---- time series ------------------------------------------------------------------------------------------------- */

/** A CSV file that grows row by row: a header line, then `time` and values with 17 significant digits. */
typedef struct sph2d_series sph2d_series;

/** Opens a series for writing. `columns` is the header after "time [s],". With `keep_rows` above 0 the file must exist
 *  with that header; it is truncated to so many rows and continued. Errors: SPH2D_CANTCREAT, SPH2D_FORMAT, SPH2D_IO. */
SPH2D_API sph2d_status sph2d_series_open(const char *path, const char *columns, uint64_t keep_rows,
                                         sph2d_series **series, sph2d_report *report);

/** Adds a row and flushes it. Errors: SPH2D_IO. */
SPH2D_API sph2d_status sph2d_series_append(sph2d_series *series, double time, const double *values, size_t count,
                                           sph2d_report *report);

/** Closes; NULL is fine. Errors: SPH2D_IO. */
SPH2D_API sph2d_status sph2d_series_close(sph2d_series *series, sph2d_report *report);

/* ---- tables ------------------------------------------------------------------------------------------------------ */

/** Columns of numbers from a CSV file. */
typedef struct sph2d_table sph2d_table;

/** A column to read. */
typedef struct sph2d_table_column {
    /** Its heading, with or without a unit: "x" finds "x [m]". */
    const char *name;

    /** The unit that it must have; NULL: any. */
    const char *unit;

    /** Whether the file may lack it. */
    bool optional;
} sph2d_table_column;

/** Reads columns of a CSV file, which may have others. Lines that start with # and empty ones are ignored, the first
 *  other line names the columns, empty cells and nan are NaN. At most ten million rows. Errors, with file, line and
 *  column: SPH2D_NOINPUT, SPH2D_FORMAT, SPH2D_NOMEM. The caller owns *table (NULL after a failure). */
SPH2D_API sph2d_status sph2d_table_read(const char *path, const sph2d_table_column *columns, size_t column_count,
                                        sph2d_table **table, sph2d_report *report);

/** Number of rows. */
SPH2D_API size_t sph2d_table_rows(const sph2d_table *table);

/** Whether the file has column `column` of those requested. */
SPH2D_API bool sph2d_table_has(const sph2d_table *table, size_t column);

/** A value; NaN if there is none. `row` and `column` count from 0 and must be in range. */
SPH2D_API double sph2d_table_value(const sph2d_table *table, size_t row, size_t column);

/** Completes a diagnostic with the file and the line of a row. NULL is fine. */
SPH2D_API void sph2d_table_locate(const sph2d_table *table, size_t row, sph2d_diagnostic *diagnostic);

/** Frees a table; NULL is fine. */
SPH2D_API void sph2d_table_destroy(sph2d_table *table);

/* ---- text files -------------------------------------------------------------------------------------------------- */

/** Writes a text file, completely or not at all. Errors: SPH2D_CANTCREAT, SPH2D_IO (an existing file is not changed),
 *  SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_text_write(const char *path, const char *text, size_t length, sph2d_report *report);

/** The version of the HDF5 library in use, "1.10.8". Static storage. */
SPH2D_API const char *sph2d_io_hdf5_version(void);

#ifdef __cplusplus
}
#endif
#endif
