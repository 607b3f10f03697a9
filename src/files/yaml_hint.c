/* SPDX-License-Identifier: MIT */
/** @file yaml_hint.c
 *  Usual mistakes by what stands in the line: tabs, signs without a blank, brackets, quotes, dashes, indentation. */
#include "files/yaml_hint.h"

#include <stdio.h>
#include <string.h>

#include "files/tree.h"

/* ---- lines ------------------------------------------------------------------------------------------------------- */

/** A line of a text. */
typedef struct line {
    const char *text;
    size_t length;
    size_t indent; /**< blanks at its start */
} line;

static line line_of(const sph2d__source *source, size_t offset)
{
    size_t start = offset < source->length ? offset : source->length;
    while (start > 0 && !strchr("\r\n", source->text[start - 1]))
        --start;
    line l = {source->text + start, strcspn(source->text + start, "\r\n"), 0};
    l.indent = strspn(l.text, " ");
    return l;
}

/** Whether a line says something. */
static bool says(line l)
{
    return l.indent < l.length && l.text[l.indent] != '#';
}

/** The next line that says something, after or before one; that itself if there is none. */
static line next_line(const sph2d__source *source, line from)
{
    for (line l = from; l.text[l.length];) {
        l = line_of(source, (size_t)(l.text - source->text) + l.length + 1);
        if (says(l))
            return l;
    }
    return from;
}

static line line_before(const sph2d__source *source, line from)
{
    for (line l = from; l.text > source->text;) {
        l = line_of(source, (size_t)(l.text - source->text) - 1);
        if (says(l))
            return l;
    }
    return from;
}

/** " of line 3"; "" for a text without lines. */
static const char *of_line(const sph2d__source *source, line l, char out[32])
{
    const int number = sph2d__place_line((sph2d__place){source, (size_t)(l.text - source->text)});
    out[0] = '\0';
    if (number > 0)
        snprintf(out, 32, " of line %d", number);
    return out;
}

static bool has_tab(line l)
{
    const size_t before = strspn(l.text, " \t");
    return before < l.length && memchr(l.text, '\t', before);
}

/* ---- signs ------------------------------------------------------------------------------------------------------- */

static size_t letters(const char *text)
{
    return strspn(text, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789");
}

bool sph2d__yaml_hint_word(sph2d_diagnostic *diagnostic, const char *word)
{
    const size_t dash = *word == '-', length = letters(word + dash), end = dash + length;
    const char *sign = word + end + strspn(word + end, " ");
    const bool no_break = strncmp(word, "\xc2\xa0", 2) == 0;
    if (no_break)
        sph2d_diagnostic_hint(diagnostic, "it begins with a no-break space: type a usual blank");
    if (length == 0)
        return no_break;
    if (*sign == '=')
        sph2d_diagnostic_hint(diagnostic, "write a colon and a blank in place of the sign =: %.*s: ...", (int)length,
                              word + dash);
    else if (word[end] == ':' && word[end + 1] != '\0' && !strchr(" \t\r\n", word[end + 1]))
        sph2d_diagnostic_hint(diagnostic, "write a blank after the colon: %.*s: ...", (int)length, word + dash);
    else if (dash)
        sph2d_diagnostic_hint(diagnostic, "write a blank after the dash: - %.*s", (int)length, word + dash);
    else
        return false;
    return true;
}

/** About a key at the start of a line, which may be the first of an item. */
static bool hint_line(sph2d_diagnostic *d, line l)
{
    const char *word = l.text + l.indent;
    while (strncmp(word, "- ", 2) == 0)
        word += 1 + strspn(word + 1, " ");
    return *word != '-' && sph2d__yaml_hint_word(d, word);
}

/* ---- brackets ---------------------------------------------------------------------------------------------------- */

/** The end of the text in quotes that begins at `c`, or of the comment. */
static const char *skip_text(const char *c, const char *end)
{
    const char quote = *c == '#' ? '\n' : *c;
    for (++c; c < end && *c != quote; ++c)
        c += quote == '"' && *c == '\\' && c + 1 < end;
    return c;
}

/** The innermost bracket that is open at `offset`; NULL if there is none. */
static const char *open_bracket(const sph2d__source *source, size_t offset)
{
    const char *open[SPH2D__TREE_DEPTH];
    const char *end = source->text + (offset < source->length ? offset : source->length);
    size_t depth = 0;
    for (const char *c = source->text; c < end; ++c) {
        const bool starts = c == source->text || strchr(" \t\r\n[{,:", c[-1]);
        if (*c == '\'' || *c == '"' || *c == '#')
            c = starts ? skip_text(c, end) : c;
        else if ((*c == '[' || *c == '{') && (starts || depth > 0) && depth < SPH2D__TREE_DEPTH)
            open[depth++] = c;
        else if ((*c == ']' || *c == '}') && depth > 0)
            --depth;
    }
    return depth > 0 ? open[depth - 1] : NULL;
}

/** Whether a comment behind an open bracket, in its line, has the sign that closes it: "color: #ff0000}". */
static bool is_hidden(const char *open, line first, char close)
{
    const char *end = first.text + first.length;
    for (const char *c = open + 1; c < end; ++c)
        if (*c == '\'' || *c == '"')
            c = skip_text(c, end);
        else if (*c == '#' && strchr(" \t", c[-1]))
            return memchr(c, close, (size_t)(end - c));
    return false;
}

/** Says that a comment hides what closes the bracket `open`, where one does. */
static bool hint_hidden(sph2d_diagnostic *d, const sph2d__source *source, const char *open)
{
    const line first = line_of(source, (size_t)(open - source->text));
    const char close = *open == '[' ? ']' : '}';
    char where[32];
    const bool hidden = is_hidden(open, first, close);
    if (hidden)
        sph2d_diagnostic_hint(d,
                              "a # begins a comment, which hides the %c%s: write what begins with # in quotation marks",
                              close, of_line(source, first, where));
    return hidden;
}

void sph2d__yaml_hint_open(sph2d_diagnostic *d, const sph2d__source *source, size_t bracket)
{
    if (d && !hint_hidden(d, source, source->text + bracket))
        sph2d_diagnostic_hint(d, "close it by %c", source->text[bracket] == '[' ? ']' : '}');
}

static bool hint_bracket(sph2d_diagnostic *d, const sph2d__source *source, size_t offset, line here)
{
    const char *open = open_bracket(source, offset), c = source->text[offset];
    const bool closes = c == ']' || c == '}';
    if (!open) {
        if (closes)
            sph2d_diagnostic_hint(d, "no bracket is open here: leave this one out");
        return closes;
    }
    const line first = line_of(source, (size_t)(open - source->text));
    const char close = *open == '[' ? ']' : '}';
    char where[32];
    of_line(source, first, where);
    if (closes && c != close)
        sph2d_diagnostic_hint(d, "the bracket to close here is the %c%s: write %c", *open, where, close);
    else if (hint_hidden(d, source, open))
        return true;
    else if (here.text != first.text && here.indent <= first.indent)
        sph2d_diagnostic_hint(d, "close the bracket %c%s by %c, or indent this line", *open, where, close);
    else
        return false;
    return true;
}

/* ---- by the parser's words --------------------------------------------------------------------------------------- */

/** Hints that the parser's message decides. */
static bool hint_message(sph2d_diagnostic *d, const char *message, line here, line before)
{
    static const char *const hints[][2] = {
        {"missing comma", "write a comma before it"},
        {"same line", "put a text with a colon and a blank in it into quotes"},
        {"invalid escape", "write \\\\ for a backslash, or take single quotes"},
        {"trailing content after single", "write '' for a ' in the text, or take double quotes"},
        {"trailing content", "write \\\" for a \" in the text, or take single quotes"},
        {"closing quote", "close the text by the quote that it begins with"},
        {"quoted scalar", "close the text by the quote that it begins with"},
        {"cannot start", "put a text that begins with this sign into quotes"},
        {"invalid alias", "put a text that begins with this sign into quotes"},
    };
    for (size_t i = 0; i < sizeof hints / sizeof *hints; ++i)
        if (strstr(message, hints[i][0])) {
            sph2d_diagnostic_hint(d, "%s", hints[i][1]);
            return true;
        }
    if (here.text[here.indent] == '-' && here.text != before.text) {
        sph2d_diagnostic_hint(d, "an item of a list stands among keys: it belongs below the key of its list");
        return true;
    }
    return false;
}

/** The blanks before the keys of the item of a list that a line belongs to; 0 if it belongs to none. */
static size_t item_indent(const sph2d__source *source, line l)
{
    for (line above = line_before(source, l); above.text != l.text; l = above, above = line_before(source, l))
        if (strncmp(above.text + above.indent, "- ", 2) == 0)
            return above.indent + 1 + strspn(above.text + above.indent + 1, " ");
        else if (above.indent == 0)
            return 0;
    return 0;
}

static bool hint_indent(sph2d_diagnostic *d, const sph2d__source *source, line here)
{
    const line before = line_before(source, here), after = next_line(source, here);
    const size_t item = item_indent(source, here);
    const line other = after.text != here.text && after.indent > here.indent ? after : before;
    char where[32];
    if (item > 0 && here.indent != item && after.indent <= here.indent)
        sph2d_diagnostic_hint(
            d, "begin a new item by a dash and a blank, or indent this line by %zu blanks, as that item", item);
    else if (other.text != here.text && other.indent != here.indent)
        sph2d_diagnostic_hint(d, "keys of a group begin in one column: the key%s begins in column %zu, this one in %zu",
                              of_line(source, other, where), other.indent + 1, here.indent + 1);
    else
        return false;
    return true;
}

void sph2d__yaml_hint(sph2d_diagnostic *diagnostic, const sph2d__source *source, size_t offset, const char *message)
{
    const line here = line_of(source, offset), before = line_before(source, here), after = next_line(source, here);
    if (!diagnostic)
        return;
    if (has_tab(here) || (here.indent > 0 && has_tab(after)))
        sph2d_diagnostic_hint(diagnostic, "indent by blanks: a tab has no width of its own");
    else if (strncmp(here.text + here.indent, "//", 2) == 0 || strncmp(here.text + here.indent, "/*", 2) == 0)
        sph2d_diagnostic_hint(diagnostic, "a comment begins with #");
    else if (hint_line(diagnostic, here) || hint_bracket(diagnostic, source, offset, here) ||
             hint_message(diagnostic, message, here, before) || hint_indent(diagnostic, source, here))
        return;
    else if (!memchr(here.text, ':', here.length))
        sph2d_diagnostic_hint(diagnostic, "a line of a scene is `key: value`, or an item of a list, `- value`");
}
