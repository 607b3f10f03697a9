/* SPDX-License-Identifier: MIT */
/** @file state.c
 *  What all parts of a study need: messages, and texts that become files. */
#include "state.h"

#include <stdlib.h>
#include <string.h>

#include "../exit.h"
#include "../message.h"
#include "../text.h"

int study_report(cli_study *s, sph2d_status status)
{
    message_report(status, &s->report, NULL);
    return exit_of_status(status);
}

int study_write(cli_study *s, const char *name, void (*put)(const void *what, FILE *out), const void *what)
{
    sph2d_status status = SPH2D_NOMEM;
    size_t length = 0;
    char *text = compose(put, what, &length);
    const char *path = folder_file(&s->folder, "%s", name);
    if (text && path)
        status = sph2d_text_write(path, text, length, &s->report);
    free(text);
    return study_report(s, status);
}

void study_fill(FILE *out, const char *template, const study_slot *slots, const void *what)
{
    for (const char *at; (at = strstr(template, "{{")); template = strstr(at, "}}") + 2) {
        const study_slot *slot = slots;
        fwrite(template, 1, (size_t)(at - template), out);
        while (strncmp(slot->name, at + 2, strlen(slot->name)) != 0 || at[2 + strlen(slot->name)] != '}')
            ++slot;
        slot->put(what, out);
    }
    fputs(template, out);
}

void study_clean(char *text, const char *others, char by)
{
    text_whole(text);
    for (char *c = strpbrk(text, others); c; c = strpbrk(c + 1, others))
        *c = by;
}
