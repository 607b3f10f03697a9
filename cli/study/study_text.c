/* SPDX-License-Identifier: MIT */
/** @file study_text.c
 *  A text that is printed into, and becomes a file. */
#include "study_text.h"

#include <stdlib.h>

#include <sph2d/io.h>

bool study_text_begin(study_text *t)
{
    *t = (study_text){NULL, NULL, 0};
    t->out = open_memstream(&t->text, &t->size);
    return t->out != NULL;
}

char *study_text_take(study_text *t)
{
    bool failed = ferror(t->out) != 0;
    if (fclose(t->out) == 0 && !failed)
        return t->text;
    free(t->text);
    return NULL;
}

sph2d_status study_text_write(study_text *t, const char *path, sph2d_report *report)
{
    char *text = study_text_take(t);
    sph2d_status status = SPH2D_NOMEM;
    if (text != NULL && path != NULL)
        status = sph2d_text_write(path, text, t->size, report);
    free(text);
    return status;
}
