/* SPDX-License-Identifier: MIT */
/** @file h5_scope.c
 *  Silences HDF5's error printing and reads its error stack. */
#include "files/h5_scope.h"

#include <stdio.h>
#include <string.h>

#include "sph2d/io.h"

#define NUMBER(x) #x
#define DOTTED(a, b, c) NUMBER(a) "." NUMBER(b) "." NUMBER(c)

bool sph2d__h5_scope_begin(sph2d__h5_scope *scope)
{
    if (H5open() < 0)
        return false;
    scope->print = NULL;
    scope->data = NULL;
    H5Eget_auto2(H5E_DEFAULT, &scope->print, &scope->data);
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    return true;
}

void sph2d__h5_scope_end(const sph2d__h5_scope *scope)
{
    H5Eclear2(H5E_DEFAULT);
    H5Eset_auto2(H5E_DEFAULT, scope->print, scope->data);
}

typedef struct buffer {
    char *out;
    size_t size;
} buffer;

/** Copies the first error of the walk, without line ends. */
static herr_t take_first(unsigned n, const H5E_error2_t *error, void *data)
{
    const buffer *b = data;
    if (n == 0 && error->desc) {
        snprintf(b->out, b->size, "%s", error->desc);
        for (char *p = b->out; *p; ++p)
            if (*p == '\n' || *p == '\r')
                *p = ' ';
    }
    return 0;
}

void sph2d__h5_cause(char *out, size_t size)
{
    buffer b = {out, size};
    snprintf(out, size, "HDF5 gives no reason");
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, &b); /* upward starts at the innermost function, the cause */
}

const char *sph2d_io_hdf5_version(void)
{
    return DOTTED(H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE);
}
