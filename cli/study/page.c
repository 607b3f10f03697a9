/* SPDX-License-Identifier: MIT */
/** @file page.c
 *  The study as one page for a browser, from page.html: no script, nothing from elsewhere, wide tables scroll by
 *  themselves. */
#include <stdlib.h>
#include <string.h>

#include "../build.h"
#include "columns.h"
#include "parts.h"

static void put(FILE *out, const char *text)
{
    for (; *text != '\0'; ++text) {
        const char *name = *text == '<' ? "&lt;" : *text == '>' ? "&gt;" : *text == '&' ? "&amp;" : "&quot;";
        if (strchr("<>&\"", *text))
            fputs(name, out);
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

/* ---- the scene and the command ----------------------------------------------------------------------------------- */

/* The comment that a text starts with, in one line; nothing where it starts with none. */
static void put_first_comment(FILE *out, const char *text)
{
    const char *before = "<p>";
    for (; *text == '#'; before = " ") {
        size_t length = strcspn(text, "\r\n");
        char *line = strndup(text, length);
        fputs(before, out);
        if (line)
            put(out, line + strspn(line, "# "));
        free(line);
        text += length + strcspn(text + length, "\n");
        text += *text == '\n';
    }
    fputs(before[0] == ' ' ? "</p>\n" : "", out);
}

/* What the study's own first comment says of its rows. */
static void put_study_comment(const cli_study *s, FILE *out)
{
    char text[32768] = "";
    FILE *in = !s->made ? fopen(s->path, "r") : NULL;
    if (!in)
        return;
    size_t length = fread(text, 1, sizeof text - 1, in);
    text[length] = '\0';
    fclose(in);
    put_first_comment(out, text);
}

static void put_about(const void *study, FILE *out)
{
    const cli_study *s = study;
    sph2d_scene_file *file;
    if (sph2d_study_run_scene(s->results, &s->results->rows[0].run, &file, NULL) != SPH2D_OK)
        return;
    fputs("<h2>", out);
    put(out, sph2d_scene_file_scene(file)->name);
    fputs("</h2>\n", out);
    put_first_comment(out, sph2d_scene_file_text(file));
    put_study_comment(s, out);
    sph2d_scene_file_destroy(file);
}

/* A word of a command line, quoted where a shell would take it apart. */
static void put_word(FILE *out, const char *word)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:%@";
    const char *quote = word[0] == '\0' || word[strspn(word, plain)] != '\0' ? "'" : "";
    fprintf(out, " %s", quote);
    for (; *word != '\0'; ++word)
        put(out, *word == '\'' ? "'\\''" : (const char[2]){*word, '\0'});
    fputs(quote, out);
}

static void put_command(const void *study, FILE *out)
{
    const cli_study *s = study;
    const cli_options *options = s->options;
    fputs("sph2d study", out);
    put_word(out, s->path);
    for (size_t i = 0; i < options->override_count; ++i) {
        const sph2d_override *override = &options->overrides[i];
        size_t size = strlen(override->path) + strlen(override->value) + 2;
        char *word = malloc(size);
        fputs(" --set", out);
        if (word) {
            snprintf(word, size, "%s=%s", override->path, override->value);
            put_word(out, word);
        }
        free(word);
    }
    fputs(options->all ? " --all" : "", out);
    if (s->jobs > 1 && options->shards == 0)
        fprintf(out, " --jobs %zu", s->jobs);
    if (s->threads.wanted > 0)
        fprintf(out, " --threads %d", s->threads.wanted);
    if (options->isa != SPH2D_ISA_AUTO)
        fprintf(out, " --isa %s", sph2d_isa_name(options->isa));
    if (s->device.number > 0)
        fprintf(out, " --device %d%s", s->device.number, s->device.same_bits ? " --same-bits" : "");
    if (options->repeat > 0)
        fprintf(out, " --repeat %d", options->repeat);
    if (options->target > 0)
        fprintf(out, options->percent ? " --target %g%%" : " --target %g",
                options->percent ? 100 * options->target : options->target);
}

/* ---- what came out ----------------------------------------------------------------------------------------------- */

static void put_scene(const void *study, FILE *out)
{
    put(out, ((const cli_study *)study)->study->scene);
}

static void put_verdict(const void *study, FILE *out)
{
    char verdict[512];
    put_paragraph(out, "verdict", study_verdict(study, verdict, sizeof verdict));
}

static void put_cell(FILE *out, const char *tag, const study_column *c, const char *text)
{
    fprintf(out, "<%s%s>", tag, study_aligns_left(c) ? " class=\"word\"" : "");
    put(out, text);
    fprintf(out, "</%s>", tag);
}

static void put_table(const void *study, FILE *out)
{
    const cli_study *s = study;
    char cell[STUDY_CELL_SIZE];
    study_column *columns;
    size_t count = study_columns_shown(s, &columns);
    fputs("<tr>", out);
    for (size_t k = 0; k < count; ++k) {
        study_heading(s, &columns[k], cell);
        put_cell(out, "th", &columns[k], cell);
    }
    fputs("</tr>\n", out);
    STUDY_FOR_ROWS (s, row) {
        fprintf(out, "<tr%s>", row->on_front ? " class=\"front\"" : "");
        for (size_t k = 0; k < count; ++k) {
            study_cell(row, &columns[k], cell);
            put_cell(out, "td", &columns[k], cell);
        }
        fputs("</tr>\n", out);
    }
    free(columns);
}

static void put_plots(const void *study, FILE *out)
{
    static const char *const plots[][2] = {
        {"error_time",
         "Error against CPU time. Black: the front, rows that no other beats in both. Grey: other settings."},
        {"error_along", "Error against what the rows of a line differ in; the order is the slope of its best fit."}};
    for (size_t i = 0; i < sizeof plots / sizeof *plots; ++i) {
        const char *name = plots[i][0], *caption = plots[i][1];
        char file[64];
        snprintf(file, sizeof file, "%s.svg", name);
        if (folder_holds(((const cli_study *)study)->folder.path, file))
            fprintf(out,
                    "<figure><a href=\"%s.png\"><img src=\"%s\" alt=\"%s\"></a><figcaption>%s</figcaption></figure>\n",
                    name, file, caption, caption);
    }
}

static void put_conditions(const void *study, FILE *out)
{
    char line[1024];
    put_paragraph(out, "conditions", study_conditions(study, line, sizeof line));
    put_paragraph(out, "conditions", build_describe(line, sizeof line));
}

static void put_page(const void *study, FILE *out)
{
    static const study_slot slots[] = {{"scene", put_scene},          {"about", put_about}, {"command", put_command},
                                       {"verdict", put_verdict},      {"table", put_table}, {"plots", put_plots},
                                       {"conditions", put_conditions}};
    study_fill(out, study_page_html, slots, study);
}

int study_page_write(cli_study *s)
{
    return study_write(s, "study.html", put_page, s);
}
