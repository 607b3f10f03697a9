/* SPDX-License-Identifier: MIT */
/** @file init.c
 *  `sph2d init NAME`: writes a scene with every key, those of the template with a value, all others commented out, each
 *  with its meaning, unit, range and default from the table of keys. */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command.h"
#include "exit.h"
#include "keys.h"
#include "message.h"
#include "sph2d/io.h"
#include "text.h"

enum { PATH_SIZE = 128, WIDTH = 100 };

typedef struct writer {
    FILE *out;
    const scene_template *template;
    const char *name; /* of the scene */
} writer;

/* ---- values of the template -------------------------------------------------------------------------------------- */

static const char *find_value(const writer *w, const char *path)
{
    if (strcmp(path, "name") == 0)
        return w->name;
    for (size_t i = 0; i < w->template->count; ++i)
        if (strcmp(w->template->values[i].path, path) == 0)
            return w->template->values[i].value;
    return NULL;
}

/* Whether the template has a value for a key inside a group or list. */
static bool has_inside(const writer *w, const char *path)
{
    size_t length = strlen(path);
    for (size_t i = 0; i < w->template->count; ++i) {
        const char *given = w->template->values[i].path;
        if (strncmp(given, path, length) == 0 && (given[length] == '.' || given[length] == '['))
            return true;
    }
    return false;
}

/* ---- lines ------------------------------------------------------------------------------------------------------- */

/* Writes a key's description, wrapped at spaces. */
static void write_comment(const writer *w, int indent, const sph2d_key *key)
{
    char text[400];
    keys_describe(key, text, sizeof text);
    size_t width = (size_t)(WIDTH - indent - 2);
    const char *rest = text;
    while (*rest != '\0') {
        size_t length = strlen(rest);
        if (length > width) {
            length = width;
            while (length > 0 && rest[length] != ' ')
                --length;
            if (length == 0)
                length = width;
        }
        fprintf(w->out, "%*s# %.*s\n", indent, "", (int)length, rest);
        rest += length;
        rest += strspn(rest, " ");
    }
}

/* The default as it can be written in a file; "" if it is a description. */
static const char *literal_default(const sph2d_key *key)
{
    double number;
    const char *text = key->default_text;
    if (!text)
        return "";
    bool word = false;
    for (size_t i = 0; key->kind == SPH2D_KEY_WORD && key->words[i]; ++i)
        word = word || strcmp(key->words[i], text) == 0;
    return word || text[0] == '[' || parse_number(text, &number) ? text : "";
}

/* Indentation of lines. In a list item `lead` precedes each key: "- " the first, then "  ". */
typedef struct margin {
    int indent;
    const char *lead;
} margin;

/* A key without a value of the template is commented out; without the # the line is valid. */
static void write_key(const writer *w, margin *p, bool given, const char *name, const char *value)
{
    const char *space = value[0] != '\0' ? " " : "";
    fprintf(w->out, "%*s%s%s%s:%s%s\n", p->indent, "", p->lead, given ? "" : "#", name, space, value);
    if (p->lead[0] != '\0')
        p->lead = "  ";
}

static void write_struct(const writer *w, const sph2d_keys *keys, const char *prefix, margin p);

static void write_items(const writer *w, const sph2d_key *key, const char *path, int indent)
{
    char item[PATH_SIZE];
    snprintf(item, sizeof item, "%.100s[0]", path);
    for (size_t i = 1; has_inside(w, item); ++i) {
        write_struct(w, key->keys, item, (margin){indent, "- "});
        snprintf(item, sizeof item, "%.100s[%zu]", path, i);
    }
}

static void write_one(const writer *w, const sph2d_key *key, const char *path, bool given, margin *p)
{
    int indent = p->indent + (int)strlen(p->lead);
    if (indent == 0)
        fputc('\n', w->out);
    write_comment(w, indent, key);
    if (key->kind == SPH2D_KEY_LIST) {
        write_key(w, p, given, key->name, given ? "" : "[] # see 'sph2d help scene'");
        write_items(w, key, path, indent + 2);
    } else if (key->kind == SPH2D_KEY_GROUP) {
        write_key(w, p, given, key->name, "");
        write_struct(w, key->keys, path, (margin){indent + 2, ""});
    } else {
        write_key(w, p, given, key->name, given ? find_value(w, path) : literal_default(key));
    }
}

static bool is_given(const writer *w, const sph2d_key *key, const char *prefix, char path[PATH_SIZE])
{
    snprintf(path, PATH_SIZE, "%.90s%s%.30s", prefix, prefix[0] != '\0' ? "." : "", key->name);
    return find_value(w, path) || has_inside(w, path);
}

/* Whether the template has another key of the same choice. */
static bool is_excluded(const writer *w, const sph2d_keys *keys, const sph2d_key *key, const char *prefix)
{
    char path[PATH_SIZE];
    for (size_t i = 0; key->choice != 0 && i < keys->count; ++i) {
        const sph2d_key *other = &keys->items[i];
        if (other != key && other->choice != 0 && other->choice_offset == key->choice_offset &&
            is_given(w, other, prefix, path))
            return true;
    }
    return false;
}

/* In a list item the keys with a value come first, since the dash must precede one of them. */
static void write_struct(const writer *w, const sph2d_keys *keys, const char *prefix, margin p)
{
    bool item = p.lead[0] != '\0';
    for (int pass = 0; pass < (item ? 2 : 1); ++pass) {
        for (size_t i = 0; i < keys->count; ++i) {
            char path[PATH_SIZE];
            bool given = is_given(w, &keys->items[i], prefix, path);
            if ((!item || given == (pass == 0)) && !is_excluded(w, keys, &keys->items[i], prefix))
                write_one(w, &keys->items[i], path, given, &p);
        }
    }
}

/* ---- the file ---------------------------------------------------------------------------------------------------- */

static bool ends_with(const char *text, const char *end)
{
    size_t length = strlen(text), tail = strlen(end);
    return length > tail && strcmp(text + length - tail, end) == 0;
}

/* The scene's name: that of the file or folder, if it needs no quotes in YAML. */
static void name_scene(const char *operand, char *name, size_t size)
{
    const char *slash = strrchr(operand, '/');
    snprintf(name, size, "%s", slash && slash[1] != '\0' ? slash + 1 : operand);
    char *dot = strrchr(name, '.');
    if (dot)
        *dot = '\0';
    const char *plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
    if (name[0] == '\0' || strspn(name, plain) != strlen(name))
        snprintf(name, size, "scene");
}

/* Makes a file that is not there yet, so that nobody's is overwritten. */
static int claim_file(const char *path)
{
    int made = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (made >= 0) {
        close(made);
        return CLI_EXIT_SUCCESS;
    }
    bool exists = errno == EEXIST;
    message_error(exists ? SPH2D_CODE_FILE_EXISTS : SPH2D_CODE_FILE_WRITE, exists ? "add --force to replace it" : NULL,
                  "cannot write '%s': %s", path, strerror(errno));
    return CLI_EXIT_CANTCREAT;
}

/* What a scene is written from. */
typedef struct scene_text {
    const char *path, *name;
    const scene_template *template;
} scene_text;

static void put_scene(const void *what, FILE *out)
{
    const scene_text *s = what;
    char file[TEXT_WORD_SIZE];
    text_word(file, s->path);
    fprintf(out,
            "# %s\n# Check it: sph2d check %s\n# Run it:   sph2d run %s -o out\n"
            "# Units are SI. A line #KEY: is a key that is not used; remove the # to use it.\n",
            s->template->text, file, file);
    writer w = {out, s->template, s->name};
    write_struct(&w, sph2d_scene_keys(), "", (margin){0, ""});
}

char *scene_template_text(const scene_template *from, const char *name, size_t *length)
{
    return compose(put_scene, &(scene_text){"scene.yaml", name, from}, length);
}

static int write_scene(const char *path, const scene_template *template, const char *name, bool force)
{
    int code = force ? CLI_EXIT_SUCCESS : claim_file(path);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    size_t length = 0;
    sph2d_report report = {0};
    char *text = compose(put_scene, &(scene_text){path, name, template}, &length);
    sph2d_status status = text ? sph2d_text_write(path, text, length, &report) : SPH2D_NOMEM;
    free(text);
    if (status != SPH2D_OK && !force)
        unlink(path);
    message_report(status, &report, NULL);
    if (status != SPH2D_OK)
        return exit_of_status(status);
    char file[TEXT_WORD_SIZE];
    message_note("wrote '%s'; next: sph2d check %s", path, text_word(file, path));
    return CLI_EXIT_SUCCESS;
}

static const scene_template *find_template(const char *name)
{
    if (!name)
        return &scene_templates[0];
    const char *names[8];
    for (size_t i = 0; i < scene_template_count; ++i) {
        names[i] = scene_templates[i].name;
        if (strcmp(names[i], name) == 0)
            return &scene_templates[i];
    }
    const char *nearest = text_nearest(name, names, scene_template_count);
    if (nearest)
        message_usage("init", "--template: no template '%s'; did you mean '%s'?", name, nearest);
    else
        message_usage("init", "--template: no template '%s'", name);
    return NULL;
}

int command_init(const cli_options *options)
{
    if (options->operand_count != 1 || options->operands[0][0] == '\0') {
        message_usage("init", "one name must be given: a folder for scene.yaml, or a file NAME.yaml");
        return CLI_EXIT_USAGE;
    }
    const scene_template *template = find_template(options->template_name);
    if (!template)
        return CLI_EXIT_USAGE;
    const char *operand = options->operands[0];
    bool file = ends_with(operand, ".yaml") || ends_with(operand, ".yml");
    if (!file && mkdir(operand, 0777) != 0 && errno != EEXIST) {
        message_error(SPH2D_CODE_FILE_WRITE, NULL, "cannot make the folder '%s': %s", operand, strerror(errno));
        return CLI_EXIT_CANTCREAT;
    }
    char name[64];
    name_scene(operand, name, sizeof name);
    size_t size = strlen(operand) + sizeof "/scene.yaml";
    char *path = malloc(size);
    if (!path) {
        message_error(SPH2D_CODE_GENERAL, NULL, "out of memory");
        return CLI_EXIT_SOFTWARE;
    }
    snprintf(path, size, "%s%s", operand, file ? "" : "/scene.yaml");
    int code = write_scene(path, template, name, options->force);
    free(path);
    return code;
}
