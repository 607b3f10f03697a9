/* SPDX-License-Identifier: MIT */
/** @file shader.c
 *  Compiles and links GLSL, and converts the compiler's log to diagnostics with line numbers. */
#include "render/gl_loader.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/atomic_file.h"
#include "shaders.h"

enum { NAME_SIZE = 64, LOG_SIZE = 4096, SOURCE_MAX = 1 << 20 };

/* A shader's text, and its name in messages. */
typedef struct source {
    char *file;
    char *text;
} source;

static void free_source(source *from)
{
    free(from->file);
    free(from->text);
    *from = (source){0};
}

static char *copy_string(const char *text)
{
    const size_t size = strlen(text) + 1;
    char *copy = malloc(size);
    if (copy)
        memcpy(copy, text, size);
    return copy;
}

static sph2d_status no_memory(sph2d_report *report)
{
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory for the shaders");
    return SPH2D_NOMEM;
}

static sph2d_status read_built_in(const char *name, source *into, sph2d_report *report)
{
    for (size_t i = 0; i < sph2d__shader_source_count; ++i) {
        if (strcmp(sph2d__shader_sources[i].name, name) != 0)
            continue;
        into->file = copy_string(name);
        into->text = copy_string(sph2d__shader_sources[i].text);
        return into->file && into->text ? SPH2D_OK : no_memory(report);
    }
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GL_SHADER, NULL, "this build has no shader '%s'", name);
    return SPH2D_RENDER;
}

/* Reads an open file into into->text; on failure errno has the reason. */
static bool read_all(FILE *file, source *into)
{
    into->text = malloc(SOURCE_MAX + 1);
    if (!into->text)
        return false;
    errno = 0;
    const size_t length = fread(into->text, 1, SOURCE_MAX + 1, file);
    if (ferror(file))
        return false; /* for example a folder */
    if (length > SOURCE_MAX) {
        errno = EFBIG;
        return false;
    }
    into->text[length] = '\0';
    return true;
}

static sph2d_status read_file(const char *dir, const char *name, source *into, sph2d_report *report)
{
    const size_t size = strlen(dir) + strlen(name) + 2;
    into->file = malloc(size);
    if (!into->file)
        return no_memory(report);
    snprintf(into->file, size, "%s/%s", dir, name);

    FILE *file = fopen(into->file, "rb");
    const bool read = file && read_all(file, into);
    const int error = errno;
    if (file)
        fclose(file);
    if (!read) {
        sph2d__report_errno(report, SPH2D_CODE_FILE_OPEN, "read the shader", into->file, error);
        return error == ENOMEM ? SPH2D_NOMEM : SPH2D_NOINPUT;
    }
    return SPH2D_OK;
}

/* Mesa writes "0:12(5): error: text", others "0(12) : error ..." or "ERROR: 0:12: ...": the line is always the second
 * number, and only Mesa has a third directly after it, the column. */
static void locate(const char *message, int *line, int *column)
{
    char *at = NULL;
    strtol(message + strcspn(message, "0123456789"), &at, 10); /* index of the source string: there is one */
    if (*at != ':' && *at != '(')
        return;
    const bool mesa = *at == ':';
    *line = (int)strtol(at + 1, &at, 10);
    if (mesa && *at == '(')
        *column = (int)strtol(at + 1, &at, 10);
}

static void excerpt_line(const char *text, int line, char *excerpt, size_t size)
{
    for (int i = 1; i < line && text; ++i) {
        text = strchr(text, '\n');
        if (text)
            ++text;
    }
    if (text && line > 0)
        snprintf(excerpt, size, "%.*s", (int)strcspn(text, "\r\n"), text);
}

/* Adds a diagnostic for each line of the log except warnings, and at least one. */
static void report_log(sph2d_report *report, const source *from, const char *log)
{
    bool any = false;
    while (*log != '\0') {
        const size_t length = strcspn(log, "\n");
        char message[256] = "";
        snprintf(message, sizeof message, "%.*s", (int)length, log);
        log += length + (log[length] == '\n');
        if (length == 0 || strstr(message, "warning"))
            continue;
        any = true;
        sph2d_diagnostic *diagnostic = sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GL_SHADER, NULL,
                                                        "the shader does not compile: %s", message);
        if (!diagnostic)
            continue;
        snprintf(diagnostic->file, sizeof diagnostic->file, "%s", from->file);
        locate(message, &diagnostic->line, &diagnostic->column);
        excerpt_line(from->text, diagnostic->line, diagnostic->excerpt, sizeof diagnostic->excerpt);
    }
    if (!any)
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GL_SHADER, NULL,
                         "the shader '%s' does not compile, and OpenGL does not say why", from->file);
}

/* OpenGL ES compiles the same text with another first line. */
static const char DESKTOP_LINE[] = "#version 330 core\n",
                  ES_LINES[] =
                      "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";

/* Hands over the text with what is defined after its first line; lines keep their numbers in messages. */
static void set_source(const sph2d__gl *gl, GLuint shader, const char *text, const char *defined)
{
    char definition[NAME_SIZE + 32];
    snprintf(definition, sizeof definition, "%s%s\n#line 2\n", defined ? "#define " : "", defined ? defined : "");
    const size_t first = strncmp(text, "#version", 8) == 0 ? strcspn(text, "\n") + 1 : 0;
    const bool exchange = gl->es && strncmp(text, DESKTOP_LINE, sizeof DESKTOP_LINE - 1) == 0;
    const bool whole = first == 0 || first > strlen(text); /* no first line to put anything after */
    const GLchar *parts[3] = {exchange ? ES_LINES : text, definition, text + (whole ? 0 : first)};
    const GLint lengths[3] = {exchange ? -1 : (GLint)first, -1, -1};
    if (whole)
        gl->ShaderSource(shader, 1, &text, NULL);
    else
        gl->ShaderSource(shader, 3, parts, lengths);
}

static sph2d_status compile(const sph2d__gl *gl, const char *dir, const char *name, const char *defined, GLenum type,
                            GLuint *shader, sph2d_report *report)
{
    source from = {0};
    sph2d_status status = dir ? read_file(dir, name, &from, report) : read_built_in(name, &from, report);
    if (status == SPH2D_OK) {
        *shader = gl->CreateShader(type);
        set_source(gl, *shader, from.text, defined);
        gl->CompileShader(*shader);
        GLint compiled = GL_FALSE;
        gl->GetShaderiv(*shader, GL_COMPILE_STATUS, &compiled);
        if (compiled != GL_TRUE) {
            char log[LOG_SIZE] = "";
            gl->GetShaderInfoLog(*shader, sizeof log, NULL, log);
            report_log(report, &from, log);
            status = SPH2D_RENDER;
        }
    }
    free_source(&from);
    return status;
}

static sph2d_status link_program(const sph2d__gl *gl, const char *names[2], GLuint vertex, GLuint fragment,
                                 GLuint *program, sph2d_report *report)
{
    *program = gl->CreateProgram();
    gl->AttachShader(*program, vertex);
    gl->AttachShader(*program, fragment);
    gl->LinkProgram(*program);
    GLint linked = GL_FALSE;
    gl->GetProgramiv(*program, GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE)
        return SPH2D_OK;
    char log[LOG_SIZE] = "";
    gl->GetProgramInfoLog(*program, sizeof log, NULL, log);
    log[strcspn(log, "\n")] = '\0';
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GL_SHADER, NULL, "'%s.vert' and '%s.frag' do not link: %s",
                     names[0], names[1], log);
    gl->DeleteProgram(*program);
    *program = 0;
    return SPH2D_RENDER;
}

sph2d_status sph2d__program_build(const sph2d__gl *gl, const char *dir, const char *names[2], const char *defined,
                                  GLuint *program, sph2d_report *report)
{
    char vertex_name[NAME_SIZE], fragment_name[NAME_SIZE];
    snprintf(vertex_name, sizeof vertex_name, "%s.vert", names[0]);
    snprintf(fragment_name, sizeof fragment_name, "%s.frag", names[1]);
    GLuint vertex = 0, fragment = 0;
    *program = 0;
    sph2d_status status = compile(gl, dir, vertex_name, defined, GL_VERTEX_SHADER, &vertex, report);
    if (status == SPH2D_OK)
        status = compile(gl, dir, fragment_name, defined, GL_FRAGMENT_SHADER, &fragment, report);
    if (status == SPH2D_OK)
        status = link_program(gl, names, vertex, fragment, program, report);
    gl->DeleteShader(vertex); /* a linked program keeps them; 0 is ignored */
    gl->DeleteShader(fragment);
    return status;
}

void sph2d__program_set_int(const sph2d__gl *gl, GLuint program, const char *name, int value)
{
    gl->Uniform1i(gl->GetUniformLocation(program, name), value);
}

void sph2d__program_set_float(const sph2d__gl *gl, GLuint program, const char *name, double value)
{
    gl->Uniform1f(gl->GetUniformLocation(program, name), (GLfloat)value);
}

void sph2d__program_set_vec2(const sph2d__gl *gl, GLuint program, const char *name, double x, double y)
{
    gl->Uniform2f(gl->GetUniformLocation(program, name), (GLfloat)x, (GLfloat)y);
}
