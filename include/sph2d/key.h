/* SPDX-License-Identifier: MIT */
/** @file key.h
 *  The table of the scene's keys: name, kind, place in the struct, unit, range, default and meaning of each. The scene
 *  reader, the checker's ranges, `sph2d init` and the documentation are all driven by it, so a new key is one new row.
 */
#ifndef SPH2D_KEY_H
#define SPH2D_KEY_H

#include "sph2d/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What a key holds, and the C type at its offset. */
typedef enum sph2d_key_kind {
    SPH2D_KEY_NUMBER,  /**< double */
    SPH2D_KEY_COUNT,   /**< uint64_t: a whole number */
    SPH2D_KEY_COUNTS2, /**< uint64_t[2] */
    SPH2D_KEY_TEXT,    /**< const char * */
    SPH2D_KEY_WORD,    /**< an enum: int, one of `words` */
    SPH2D_KEY_POINT,   /**< sph2d_vec2: [x, y] */
    SPH2D_KEY_POINTS,  /**< const sph2d_vec2 *, with a size_t at count_offset: [[x, y], ...] */
    SPH2D_KEY_PATH,    /**< const sph2d_path_point *, with a size_t at count_offset: [[t, x, y], ...] */
    SPH2D_KEY_NUMBERS, /**< const double *, with a size_t at count_offset */
    SPH2D_KEY_GROUP,   /**< a struct described by `keys` */
    SPH2D_KEY_LIST     /**< const struct *, described by `keys`, with a size_t at count_offset */
} sph2d_key_kind;

struct sph2d_keys;

/** One key. */
typedef struct sph2d_key {
    const char *name;
    sph2d_key_kind kind;
    bool required;                 /**< a file must give it */
    size_t offset;                 /**< in the struct that owns the key */
    size_t count_offset;           /**< of the number of items, for the list kinds */
    double min, max;               /**< range of numbers and of point coordinates, both ends included ... */
    bool min_excluded;             /**< ... but the lower end where this is set */
    bool zero_is_unset;            /**< 0 stands for a value that is not given, whatever the range */
    size_t choice_offset;          /**< of an int that tells which key of a choice is given ... */
    int choice;                    /**< ... and its value for this key; 0: the key is no part of a choice */
    const char *const *words;      /**< names of a WORD's values 0, 1, ..., ended by NULL */
    const struct sph2d_keys *keys; /**< of a GROUP or LIST */
    bool as_mapping;               /**< a file writes this LIST of two texts as a mapping, {first: second}, the second
                                        being any value */
    const char *unit;              /**< "m", "Pa s"; "" for none */
    const char *default_text;      /**< the default, in words; NULL for none */
    const char *text;              /**< one sentence */
    bool stands_alone;             /**< of a WORD: in a file it may stand for the whole group, `method: wcsph` */
    int feature;                   /**< sph2d_feature (method.h) that the key asks for; 0: all methods have it */
    void (*preset)(void *owner);   /**< of a WORD that stands for values of other keys: sets them in the struct, once it
                                        has its own; those that are given replace them */
} sph2d_key;

/** The keys of one struct. */
typedef struct sph2d_keys {
    const sph2d_key *items;
    size_t count;
    size_t size;                    /**< sizeof the struct */
    void (*set_default)(void *out); /**< fills it with defaults; NULL for groups, which get theirs from their owner */
} sph2d_keys;

/** Whether a number may be the value of a NUMBER, a COUNT, or a coordinate of a POINT; otherwise `why` gets a sentence of
 *  at most `size` bytes: "-1 is out of range: must be above 0". */
SPH2D_API bool sph2d_key_accepts(const sph2d_key *key, double value, char *why, size_t size);

/** The keys of a scene. Static storage. */
SPH2D_API const sph2d_keys *sph2d_scene_keys(void);

#ifdef __cplusplus
}
#endif
#endif
