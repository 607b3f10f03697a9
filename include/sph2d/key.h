/* SPDX-License-Identifier: MIT */
/** @file key.h
 *  The table of the scene's keys: name, kind, offset in the struct, unit, range, default and meaning of each. The
 *  reader of scene files, the checker's ranges, `sph2d init`, `sph2d help scene` and docs/scenes.md are derived from
 *  it, so that a new key is one new row.
 *
 *      const sph2d_keys *keys = sph2d_scene_keys();
 *      for (size_t i = 0; i < keys->count; ++i)
 *          printf("%s [%s]: %s\n", keys->items[i].name, keys->items[i].unit, keys->items[i].text); */
#ifndef SPH2D_KEY_H
#define SPH2D_KEY_H

#include "sph2d/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Largest magnitude of a scene's numbers, and the smallest of those that must be above 0. Scenes are tested within these
 *  limits (tests/test_extremes.c); beyond them products of a few numbers would leave the range of doubles. */
#define SPH2D_LARGEST 1e12
#define SPH2D_SMALLEST 1e-12

/** Kind of a key's value, and the C type at its offset. */
typedef enum sph2d_key_kind {
    /** double */
    SPH2D_KEY_NUMBER,

    /** uint64_t: a whole number */
    SPH2D_KEY_COUNT,

    /** uint64_t[2] */
    SPH2D_KEY_COUNTS2,

    /** const char * */
    SPH2D_KEY_TEXT,

    /** an enum: int, one of `words` */
    SPH2D_KEY_WORD,

    /** sph2d_vec2: [x, y] */
    SPH2D_KEY_POINT,

    /** const sph2d_vec2 *, with a size_t at count_offset: [[x, y], ...] */
    SPH2D_KEY_POINTS,

    /** const sph2d_path_point *, with a size_t at count_offset: [[t, x, y], ...] */
    SPH2D_KEY_PATH,

    /** const sph2d_pose_point *, with a size_t at count_offset: [[t, x, y, angle], ...]; a file may leave out angles */
    SPH2D_KEY_POSES,

    /** const double *, with a size_t at count_offset */
    SPH2D_KEY_NUMBERS,

    /** a struct described by `keys` */
    SPH2D_KEY_GROUP,

    /** const struct *, described by `keys`, with a size_t at count_offset */
    SPH2D_KEY_LIST
} sph2d_key_kind;

struct sph2d_keys;

/** One key. */
typedef struct sph2d_key {
    /** As in a file: "density". */
    const char *name;

    /** Kind of its value. */
    sph2d_key_kind kind;

    /** Whether a file must give it. */
    bool required;

    /** Offset of the value in the struct that owns the key [bytes]. */
    size_t offset;

    /** Offset of the number of items, for the list kinds [bytes]. */
    size_t count_offset;

    /** Range of numbers and of coordinates of points, both ends included ... */
    double min, max;

    /** ... except the lower end if this is set. */
    bool min_excluded;

    /** Whether 0 means that the value is not given, whatever the range ... */
    bool zero_is_unset;

    /** ... or NaN does. */
    bool nan_is_unset;

    /** Offset of an int that says which of several exclusive keys is given [bytes] ... */
    size_t choice_offset;

    /** ... and its value for this key; 0: the key is not exclusive. */
    int choice;

    /** Names of a WORD's values 0, 1, ..., terminated by NULL. */
    const char *const *words;

    /** Keys of a GROUP, or of an item of a LIST. */
    const struct sph2d_keys *keys;

    /** Whether a file writes this LIST of two texts as a mapping, {first: second}, the second being any value. */
    bool as_mapping;

    /** Unit, "m" or "Pa s"; "" for none. */
    const char *unit;

    /** The default, in words; NULL for none. */
    const char *default_text;

    /** Its meaning, in one sentence. */
    const char *text;

    /** Of a WORD: whether a file may give it in place of the group, `method: wcsph`. */
    bool stands_alone;

    /** Another word for it, which files may use as well; NULL for none. */
    const char *also;

    /** The sph2d_feature (method.h) that the key needs; 0: all methods have it. */
    int feature;

    /** Of a WORD that implies values of other keys: sets them in the struct, after its own; given values replace them.
     */
    void (*preset)(void *owner);
} sph2d_key;

/** The keys of one struct. */
typedef struct sph2d_keys {
    /** The keys, in the order of the pages that list them. */
    const sph2d_key *items;

    /** Number of keys. */
    size_t count;

    /** Size of the struct [bytes]. */
    size_t size;

    /** Fills the struct with defaults; NULL for groups, which get theirs from their owner. */
    void (*set_default)(void *out);
} sph2d_keys;

/** Whether a number may be the value of a NUMBER, a COUNT, or a coordinate of a POINT; otherwise `why` gets a message
 *  of at most `size` bytes: "-1 is out of range: must be above 0". */
SPH2D_API bool sph2d_key_accepts(const sph2d_key *key, double value, char *why, size_t size);

/** Reports every number out of range and every invalid word in a struct that the keys describe, and in nested ones,
 *  with key paths. Errors: SPH2D_SCENE when there is one, SPH2D_INVALID when a list has a count but no items. */
SPH2D_API sph2d_status sph2d_keys_check(const sph2d_keys *keys, const void *owner, sph2d_report *report);

/** The keys of a scene. Static storage. */
SPH2D_API const sph2d_keys *sph2d_scene_keys(void);

#ifdef __cplusplus
}
#endif
#endif
