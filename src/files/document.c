/* SPDX-License-Identifier: MIT */
/** @file document.c
 *  What scene files and study files share. */
#include "files/document.h"

#include <string.h>

#include "base/c_locale.h"
#include "files/yaml.h"

enum { MOST_BYTES = 64 << 20 };

/** Whether the text holds a mapping; a fault otherwise. */
static bool has_keys(const sph2d__document *document, const sph2d__document_kind *kind, sph2d__faults *faults)
{
    const sph2d__node *root = document->root;
    if (root && root->kind == SPH2D__NODE_MAPPING)
        return true;
    if (faults->errors > 0) /* anchors and the like say enough */
        return false;
    sph2d_diagnostic *d;
    if (!root || sph2d__node_is_null(root)) {
        sph2d__place whole = {&document->source, SPH2D__NOWHERE};
        d = sph2d__fault(faults, SPH2D_CODE_SYNTAX, whole, NULL, "there is no %s in this file: it is empty",
                         kind->name);
    } else {
        char got[80];
        d = sph2d__fault(faults, SPH2D_CODE_SYNTAX, root->place, NULL, "expected the keys of a %s, got %s", kind->name,
                         sph2d__node_describe(root, got, sizeof got));
    }
    sph2d_diagnostic_hint(d, "%s", kind->hint);
    return false;
}

sph2d_status sph2d__document_parse(sph2d__document *document, const sph2d__document_kind *kind, const char *text,
                                   size_t length, const char *name, void *owner, sph2d_report *report)
{
    document->source = (sph2d__source){.name = sph2d__pool_text(&document->pool, name, strlen(name)),
                                       .text = sph2d__pool_text(&document->pool, text, length),
                                       .length = length,
                                       .has_lines = true};
    sph2d__c_locale locale;
    if (!document->source.name || !document->source.text || !sph2d__c_locale_begin(&locale))
        return SPH2D_NOMEM;
    sph2d__faults faults = {.report = report, .pool = &document->pool};
    size_t first = report ? report->count : 0;
    sph2d_status status = sph2d__yaml_parse(&document->source, &faults, &document->root);
    if (status == SPH2D_OK)
        status = has_keys(document, kind, &faults) ? kind->read(owner, &faults) : SPH2D_SCENE;
    sph2d__faults_sort(report, first);
    sph2d__c_locale_end(&locale);
    return status;
}

sph2d_status sph2d__document_text(const char *path, char **text, size_t *length, sph2d_report *report)
{
    return sph2d__text_read(path, MOST_BYTES, text, length, report);
}

sph2d_status sph2d__document_text_open(int descriptor, const char *name, char **text, size_t *length,
                                       sph2d_report *report)
{
    return sph2d__text_read_open(descriptor, name, MOST_BYTES, text, length, report);
}

void sph2d__document_pass(const sph2d__document *document, const sph2d_report *found, sph2d__faults *faults,
                          bool (*is_consequence)(const sph2d_diagnostic *diagnostic, const sph2d__faults *faults))
{
    bool sound = faults->errors + found->errors == 0; /* warnings about what has faults may be wrong */
    size_t without_room = found->errors;
    for (size_t i = 0; i < found->count; ++i) {
        const sph2d_diagnostic *d = &found->items[i];
        bool is_error = d->severity == SPH2D_ERROR;
        without_room -= is_error;
        if (is_error ? is_consequence && is_consequence(d, faults) : !sound)
            continue;
        faults->errors += is_error;
        sph2d_diagnostic *copy = sph2d_report_add(faults->report, d->severity, d->code, NULL, "%s", d->message);
        if (copy) {
            *copy = *d;
            sph2d__node_locate(document->root, copy);
        }
    }
    faults->errors += without_room;
    if (faults->report) {
        faults->report->dropped += found->dropped;
        faults->report->errors += without_room;
    }
}
