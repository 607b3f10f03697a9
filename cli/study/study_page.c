/* SPDX-License-Identifier: MIT */
/** @file study_page.c
 *  The study as one page for a browser: no script, nothing from elsewhere, wide tables scroll by themselves. */
#include "study_page.h"
#include "study_verdict.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../build.h"
#include "../exit.h"
#include "study_cells.h"
#include "study_scene.h"
#include "study_table.h"
#include "study_text.h"

static const char style[] =
    "body { font: 16px/1.5 system-ui, sans-serif; color: #222; max-width: 62rem; margin: 0 auto; padding: 1rem; }\n"
    "code { font: 0.9em ui-monospace, monospace; background: #f3f3f3; padding: 0.1em 0.3em; overflow-wrap: anywhere; "
    "}\n"
    ".wide { overflow-x: auto; margin: 1rem 0; }\n"
    "table { border-collapse: collapse; font-size: 0.85rem; white-space: nowrap; }\n"
    "th, td { padding: 0.25rem 0.6rem; text-align: right; border-bottom: 1px solid #ddd; }\n"
    "th { border-bottom: 2px solid #888; vertical-align: bottom; }\n"
    "th.word, td.word { text-align: left; }\n"
    "td:first-child, th:first-child { position: sticky; left: 0; background: #fff; }\n"
    "tr.front td { font-weight: 600; }\n"
    "figure { display: inline-block; margin: 0.5rem 0.5rem 0.5rem 0; max-width: 100%; vertical-align: top; }\n"
    "figure img { width: 30rem; max-width: 100%; height: auto; }\n"
    "figcaption, .conditions { color: #555; font-size: 0.85rem; }\n"
    ".verdict { font-weight: 600; }\n"
    "@media (max-width: 40rem) { td:first-child, th:first-child { white-space: normal; min-width: 5rem; "
    "max-width: 9rem; } }\n";

/* ---- text -------------------------------------------------------------------------------------------------------- */

static void put(FILE *out, const char *text)
{
    for (; *text != '\0'; ++text) {
        if (*text == '<')
            fputs("&lt;", out);
        else if (*text == '>')
            fputs("&gt;", out);
        else if (*text == '&')
            fputs("&amp;", out);
        else if (*text == '"')
            fputs("&quot;", out);
        else
            putc(*text, out);
    }
}

static void put_paragraph(FILE *out, const char *class, const char *text)
{
    if (text[0] == '\0')
        return;
    fprintf(out, "<p class=\"%s\">", class);
    put(out, text);
    fputs("</p>\n", out);
}

/* A word of a command line, quoted where a shell would take it apart. */
static void put_word(FILE *out, const char *word)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:%@";
    putc(' ', out);
    if (word[0] != '\0' && word[strspn(word, plain)] == '\0') {
        put(out, word);
        return;
    }
    putc('\'', out);
    for (const char *rest = word; *rest != '\0';) {
        char part[64];
        size_t length = strcspn(rest, "'");
        length = length < sizeof part ? length : sizeof part - 1;
        snprintf(part, sizeof part, "%.*s", (int)length, rest);
        put(out, part);
        rest += length;
        if (*rest == '\'')
            fputs("'\\''", out);
        rest += *rest == '\'';
    }
    putc('\'', out);
}

static void put_override(FILE *out, const sph2d_override *override)
{
    size_t size = strlen(override->path) + strlen(override->value) + 2;
    char *word = malloc(size);
    if (word == NULL)
        return;
    snprintf(word, size, "%s=%s", override->path, override->value);
    fputs(" --set", out);
    put_word(out, word);
    free(word);
}

static void put_command(const cli_study *s, FILE *out)
{
    char text[64];
    fputs("<p><code>sph2d study", out);
    put_word(out, s->path);
    for (size_t i = 0; i < s->options->override_count; ++i)
        put_override(out, &s->options->overrides[i]);
    if (s->options->all)
        fputs(" --all", out);
    if (s->jobs > 1)
        fprintf(out, " --jobs %zu", s->jobs);
    snprintf(text, sizeof text, " --threads %d", s->threads.count);
    put(out, text);
    if (s->options->isa != SPH2D_ISA_AUTO)
        fprintf(out, " --isa %s", sph2d_isa_name(s->options->isa));
    if (s->options->repeat > 0)
        fprintf(out, " --repeat %d", s->options->repeat);
    if (s->options->target > 0)
        fprintf(out, s->options->percent ? " --target %g%%" : " --target %g",
                s->options->percent ? 100 * s->options->target : s->options->target);
    fputs(" -o DIR</code></p>\n", out);
}

/* ---- the scene --------------------------------------------------------------------------------------------------- */

/* The comment that a scene file starts with, in one line. */
static void put_first_comment(FILE *out, const char *text)
{
    fputs("<p>", out);
    while (*text == '#') {
        size_t length = strcspn(text, "\n");
        char *line = strndup(text, length);
        if (line != NULL)
            put(out, line + strspn(line, "# "));
        free(line);
        text += length + (text[length] == '\n');
        if (*text == '#')
            putc(' ', out);
    }
    fputs("</p>\n", out);
}

/* What the study's own first comment says of its rows. */
static void put_study_comment(const cli_study *s, FILE *out)
{
    char line[512];
    const char *before = "<p>";
    FILE *in = s->made == NULL ? fopen(s->path, "r") : NULL;
    while (in != NULL && fgets(line, sizeof line, in) != NULL && line[0] == '#') {
        line[strcspn(line, "\r\n")] = '\0';
        fputs(before, out);
        put(out, line + strspn(line, "# "));
        before = " ";
    }
    if (before[0] == ' ')
        fputs("</p>\n", out);
    if (in != NULL)
        fclose(in);
}

static void put_scene(cli_study *s, FILE *out)
{
    sph2d_scene_file *file;
    if (study_scene_open(s, &s->rows[0].run, &file) != CLI_EXIT_SUCCESS)
        return;
    const char *name = sph2d_scene_file_scene(file)->name, *text = sph2d_scene_file_text(file);
    fputs("<h2>", out);
    put(out, name);
    fputs("</h2>\n", out);
    if (text[0] == '#')
        put_first_comment(out, text);
    put_study_comment(s, out);
    sph2d_scene_file_destroy(file);
}

/* ---- the table --------------------------------------------------------------------------------------------------- */

static void put_cell(FILE *out, const char *tag, const study_column *c, const char *text)
{
    fprintf(out, "<%s%s>", tag, study_cells_left(c) ? " class=\"word\"" : "");
    put(out, text);
    fprintf(out, "</%s>", tag);
}

static void put_table(const cli_study *s, FILE *out)
{
    char cell[STUDY_CELL_SIZE];
    study_column *columns = malloc(study_cells_most(s) * sizeof *columns);
    size_t count = columns != NULL ? study_cells_list(s, columns) : 0;
    fputs("<div class=\"wide\"><table>\n<tr>", out);
    for (size_t k = 0; k < count; ++k) {
        study_cells_heading(s, &columns[k], cell);
        put_cell(out, "th", &columns[k], cell);
    }
    fputs("</tr>\n", out);
    for (size_t r = 0; r < s->row_count; ++r) {
        if (!s->rows[r].there)
            continue;
        fprintf(out, "<tr%s>", s->rows[r].on_front ? " class=\"front\"" : "");
        for (size_t k = 0; k < count; ++k) {
            study_cells_text(&s->rows[r], &columns[k], cell);
            put_cell(out, "td", &columns[k], cell);
        }
        fputs("</tr>\n", out);
    }
    fputs("</table></div>\n", out);
    free(columns);
}

/* ---- the page ---------------------------------------------------------------------------------------------------- */

static void put_plot(cli_study *s, FILE *out, const char *name, const char *caption)
{
    char file[64];
    snprintf(file, sizeof file, "%s.svg", name);
    if (!folder_holds(s->folder.path, file))
        return;
    fprintf(out, "<figure><a href=\"%s.png\"><img src=\"%s\" alt=\"%s\"></a><figcaption>%s</figcaption></figure>\n",
            name, file, caption, caption);
}

static void put_conditions(const cli_study *s, FILE *out)
{
    char line[1024];
    put_paragraph(out, "conditions", study_conditions(s, line, sizeof line));
    put_paragraph(out, "conditions", build_describe(line, sizeof line));
}

static void put_page(cli_study *s, FILE *out)
{
    char verdict[512];
    fputs("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Study of ",
          out);
    put(out, s->study->scene);
    fprintf(out, "</title>\n<style>\n%s</style>\n</head>\n<body>\n<section>\n", style);
    put_scene(s, out);
    put_command(s, out);
    put_paragraph(out, "verdict", study_verdict(s, verdict, sizeof verdict));
    put_table(s, out);
    put_plot(s, out, "error_time",
             "Error against CPU time. Black: the front, rows that no other beats in both. Grey: other settings.");
    put_plot(s, out, "error_along",
             "Error against what the rows of a line differ in; the order is the slope of its best fit.");
    fputs("</section>\n", out);
    put_conditions(s, out);
    fputs("</body>\n</html>\n", out);
}

int study_page_write(cli_study *s)
{
    study_text page;
    if (s->options->output == NULL)
        return CLI_EXIT_SUCCESS;
    if (!study_text_begin(&page))
        return study_report(s, SPH2D_NOMEM, NULL, NULL);
    put_page(s, page.out);
    const char *path = folder_file(&s->folder, "study.html");
    return study_report(s, study_text_write(&page, path, &s->report), NULL, NULL);
}
