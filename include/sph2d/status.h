/* SPDX-License-Identifier: MIT */
/** @file status.h
 *  Status codes, and reports that say what failed, where, and what to do.
 *
 *  A function that can fail returns an sph2d_status and takes an sph2d_report, which may be NULL. The report belongs to
 *  the caller, needs no destruction, never allocates, and collects every diagnostic of the call:
 *
 *      sph2d_report report = {0};
 *      if (sph2d_sim_create(&scene, NULL, &sim, &report) != SPH2D_OK)
 *          for (size_t i = 0; i < report.count; ++i) fprintf(stderr, "%s\n", report.items[i].message);
 *
 *  NULL, in all headers: a pointer may be NULL only where its description says so. Elsewhere a function answers NULL
 *  without reading or writing anything else, by what it returns:
 *
 *  - a status: SPH2D_INVALID with a message in the report; a pointer to what it makes is set to NULL;
 *  - nothing: it does nothing, so that NULL can be destroyed, freed, cleared and completed;
 *  - a pointer: NULL; a text that it writes: an empty one, and its length 0;
 *  - a value: false, 0 or a struct of zeros; NaN if it says that this is what is not known.
 *
 *  Pointers inside structs follow the same rule if their list has a count above 0. */
#ifndef SPH2D_STATUS_H
#define SPH2D_STATUS_H

#include <stddef.h>

#include "sph2d/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Kinds of errors: name, value, sentence. The values are part of the ABI. */
#define SPH2D_STATUS_MAP(X)                                                                                            \
    X(OK, 0, "success")                                                                                                \
    X(INVALID, 1, "invalid argument")                                                                                  \
    X(NOMEM, 2, "out of memory")                                                                                       \
    X(SCENE, 3, "scene rejected")                                                                                      \
    X(GUARD, 4, "simulation stopped by a guard")                                                                       \
    X(NOINPUT, 5, "input missing or unreadable")                                                                       \
    X(FORMAT, 6, "file content rejected")                                                                              \
    X(CANTCREAT, 7, "output cannot be created")                                                                        \
    X(IO, 8, "reading or writing failed")                                                                              \
    X(RENDER, 9, "rendering unavailable")                                                                              \
    X(DEVICE, 10, "a device failed")

/** How a call ended: SPH2D_OK or a kind of error. */
typedef enum sph2d_status {
#define SPH2D__STATUS_ENUM(name, value, text) SPH2D_##name = (value),
    SPH2D_STATUS_MAP(SPH2D__STATUS_ENUM)
#undef SPH2D__STATUS_ENUM
} sph2d_status;

/** Stable codes of single diagnostics: name, printed code, what kind of fault it is. The man page lists them. */
#define SPH2D_CODE_MAP(X)                                                                                              \
    X(GENERAL, "G000", "anything without a code of its own")                                                           \
    X(SYNTAX, "S100", "the scene is not well-formed YAML")                                                             \
    X(UNKNOWN_KEY, "S101", "a key that no scene has")                                                                  \
    X(DUPLICATE_KEY, "S102", "a key given twice")                                                                      \
    X(WRONG_TYPE, "S103", "a value of the wrong type")                                                                 \
    X(OUT_OF_RANGE, "S104", "a number outside its range, NaN or infinite")                                             \
    X(MISSING_KEY, "S105", "a key that must be given")                                                                 \
    X(CONFLICT, "S106", "keys or values that exclude each other")                                                      \
    X(OUTSIDE, "S107", "something lies outside the domain")                                                            \
    X(OVERLAP, "S108", "two things lie on each other")                                                                 \
    X(NO_PARTICLES, "S109", "the scene has no particle and no source")                                                 \
    X(TOO_MANY, "S110", "more particles or boundary particles than memory can hold")                                   \
    X(UNSUPPORTED, "S111", "a feature that is not supported here")                                                     \
    X(FILE_OPEN, "F201", "a file cannot be opened")                                                                    \
    X(FILE_KIND, "F202", "a file of another kind")                                                                     \
    X(FILE_INCOMPLETE, "F203", "a file not written to its end, or damaged")                                            \
    X(FILE_FIELD, "F204", "a field is missing or has the wrong shape or type")                                         \
    X(FILE_VERSION, "F205", "a file of an unknown version")                                                            \
    X(FILE_WRITE, "F206", "a file cannot be written")                                                                  \
    X(FILE_EXISTS, "F207", "the output exists already")                                                                \
    X(NOT_FINITE, "R301", "guard: a value is not finite")                                                              \
    X(ESCAPED, "R302", "guard: a particle escaped through a wall")                                                     \
    X(STEP_COLLAPSE, "R303", "guard: the time step collapsed")                                                         \
    X(STEP_TOO_LARGE, "R304", "guard: a particle moves farther than its support radius in one fixed step")             \
    X(NOT_CONVERGED, "R305", "guard: the pressure solver did not come to an end for many steps")                       \
    X(DENSITY, "R306", "guard: the density of a particle is none that a liquid has")                                   \
    X(ENERGY, "R307", "guard: energy came from nothing")                                                               \
    X(SUPERSONIC, "R308", "guard: a particle is faster than the liquid's sound")                                       \
    X(MOMENTUM, "R309", "guard: momentum came from nothing")                                                           \
    X(GL_MISSING, "P401", "no OpenGL context of the wanted kind")                                                      \
    X(GL_SHADER, "P402", "a shader does not compile or link")                                                          \
    X(GL_FAILED, "P403", "OpenGL refused a framebuffer or a draw")                                                     \
    X(DEVICE, "D501", "a device, its driver or its compiler failed")

/** The code of a diagnostic. */
typedef enum sph2d_code {
#define SPH2D__CODE_ENUM(name, code, text) SPH2D_CODE_##name,
    SPH2D_CODE_MAP(SPH2D__CODE_ENUM)
#undef SPH2D__CODE_ENUM
        SPH2D_CODE_COUNT
} sph2d_code;

/** Whether a diagnostic made the call fail. */
typedef enum sph2d_severity { SPH2D_ERROR = 0, SPH2D_WARNING = 1 } sph2d_severity;

/** One diagnostic. All strings are NUL-terminated and may be empty; they are cut at their capacity. */
typedef struct sph2d_diagnostic {
    /** Error or warning. */
    sph2d_severity severity;

    /** Kind of fault; sph2d_code_text() prints it. */
    sph2d_code code;

    /** Key path in the scene, `blocks[0].box.max`. Empty if it is not about a key. */
    char path[96];

    /** File, where one is involved; else empty. */
    char file[256];

    /** Position in `file`, counted from 1; 0 if unknown. */
    int line, column;

    /** That line of the file, for a caret under `column`. */
    char excerpt[160];

    /** What is wrong: one sentence without a full stop. */
    char message[320];

    /** What to do about it. */
    char hint[480];
} sph2d_diagnostic;

/** The largest number of diagnostics in a report. */
#define SPH2D_REPORT_CAPACITY 20

/** A caller-owned list of diagnostics. Start it with `{0}`. */
typedef struct sph2d_report {
    /** Number of diagnostics in `items`, at most SPH2D_REPORT_CAPACITY. */
    size_t count;

    /** Number of those that did not fit. */
    size_t dropped;

    /** Number of errors among all, kept or dropped; the rest are warnings. */
    size_t errors;

    /** The diagnostics, in the order in which they were found. */
    sph2d_diagnostic items[SPH2D_REPORT_CAPACITY];
} sph2d_report;

/** The enumerator's name without prefix, "SCENE"; "UNKNOWN" for an invalid value. Static storage. */
SPH2D_API const char *sph2d_status_name(sph2d_status status);

/** One sentence for a status. Static storage. */
SPH2D_API const char *sph2d_status_text(sph2d_status status);

/** The printed code of a diagnostic, "S104"; "G000" for an invalid value. Static storage. */
SPH2D_API const char *sph2d_code_text(sph2d_code code);

/** Empties a report. NULL is fine. */
SPH2D_API void sph2d_report_clear(sph2d_report *report);

/** Adds a diagnostic and returns it for the caller to complete (file, line, hint ...); NULL when `report` is NULL or
 *  full. `path` may be NULL. `format` is printf's. */
SPH2D_API sph2d_diagnostic *sph2d_report_add(sph2d_report *report, sph2d_severity severity, sph2d_code code,
                                             const char *path, const char *format, ...) SPH2D_PRINTF(5, 6);

/** Sets the hint of a diagnostic; NULL is fine, so that calls can be chained on sph2d_report_add. */
SPH2D_API void sph2d_diagnostic_hint(sph2d_diagnostic *diagnostic, const char *format, ...) SPH2D_PRINTF(2, 3);

/** Writes one diagnostic as text: `scene.yaml:12:9: error[S104]: message`, then the source line with a caret and the
 *  hint, each on its own line, without a final newline. Works like snprintf: returns the length it needs. */
SPH2D_API size_t sph2d_diagnostic_format(const sph2d_diagnostic *diagnostic, char *buffer, size_t size);

#ifdef __cplusplus
}
#endif
#endif
