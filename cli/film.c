/* SPDX-License-Identifier: MIT */
/** @file film.c
 *  Films by ffmpeg. It has a process group of its own, so that Ctrl-C reaches this command alone, which then decides
 *  what becomes of the film. */
#include "film.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

/* ---- kinds of films ---------------------------------------------------------------------------------------------- */

/* What ffmpeg is told for one. */
typedef struct film_kind {
    const char *suffix;
    bool image;
    double rate_max;
    const char *filters; /* after those of the rate */
    const char *options[16];
} film_kind;

/* One palette for all frames, so that nothing flickers, and no dithering, which would triple the size: smooth water has
 * fewer shades than the palette. 128 colours take 0.52 MB for 50 frames of 640 x 360 of a dam break, 256 take 0.62. */
#define PALETTE "split[a][b];[a]palettegen=max_colors=128[p];[b][p]paletteuse=dither=none:diff_mode=rectangle"

/* An animated PNG has the same palette, and filters of its rows only make it larger: 0.41 MB instead of 0.48; with all
 * colours 1.3 MB. */
#define APNG(suffix)                                                                                                   \
    {                                                                                                                  \
        suffix, true, 25, PALETTE,                                                                                     \
        {                                                                                                              \
            "-c:v", "apng", "-pred", "none", "-plays", "0", "-f", "apng", NULL                                         \
        }                                                                                                              \
    }

/* Players expect even sides with halved colours (yuv420p), the first of them on the left and the colours of HD; of odd
 * sides the last row or column of pixels is left out, which is margin. Browsers slow images of more than 50 frames a
 * second down, and a delay is counted in 1/100 s. */
static const film_kind kinds[] = {
    {".mp4",
     false,
     60,
     "crop=trunc(iw/2)*2:trunc(ih/2)*2:0:0,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
     {"-c:v", "libx264", "-crf", "18", "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709",
      "-movflags", "+faststart", "-f", "mp4", NULL}},
    {".gif", true, 25, PALETTE, {"-loop", "0", "-f", "gif", NULL}},
    APNG(".apng"),
    APNG(".png"),
};

static const film_kind *kind_of(const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; ++i)
        if (dot && dot != name && strcasecmp(dot, kinds[i].suffix) == 0)
            return &kinds[i];
    return NULL;
}

bool film_can_be(const char *path)
{
    return kind_of(path);
}

bool film_is_image(const char *path)
{
    return kind_of(path) && kind_of(path)->image;
}

double film_rate_max(const char *path)
{
    return kind_of(path) ? kind_of(path)->rate_max : 0;
}

/* ---- errors ------------------------------------------------------------------------------------------------------ */

static sph2d_status cannot(sph2d_report *report, const char *what, const char *path, int error)
{
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_WRITE, NULL, "cannot %s '%s': %s", what, path,
                     strerror(error));
    return error == ENOMEM ? SPH2D_NOMEM : SPH2D_CANTCREAT;
}

/* The last line of what ffmpeg said, but for the one that only says that it failed. */
static char *last_words(const film *f, char *out, size_t size)
{
    char line[256];
    out[0] = '\0';
    rewind(f->said);
    while (fgets(line, sizeof line, f->said)) {
        line[strcspn(line, "\r\n")] = '\0';
        if (line[0] != '\0' && strcmp(line, "Conversion failed!") != 0)
            snprintf(out, size, "%s", line);
    }
    return out;
}

static sph2d_status missing(sph2d_report *report)
{
    sph2d_diagnostic_hint(sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL,
                                           "films are made by ffmpeg, which is not installed"),
                          "install it (Debian: apt install ffmpeg), or write the frames to a folder with -o DIR");
    return SPH2D_RENDER;
}

/* ---- the process ------------------------------------------------------------------------------------------------- */

/* Closes the pipe and waits. Returns the status of the process. */
static int wait_for_end(film *f)
{
    int status = 0;
    if (f->pixels >= 0)
        close(f->pixels);
    f->pixels = -1;
    while (f->pid > 0 && waitpid(f->pid, &status, 0) < 0 && errno == EINTR)
        ;
    f->pid = 0;
    return status;
}

void film_abort(film *f)
{
    if (!f->path)
        return;
    if (f->pid > 0)
        kill(f->pid, SIGKILL);
    wait_for_end(f);
    if (f->unfinished)
        unlink(f->unfinished);
    free(f->unfinished);
    if (f->said)
        fclose(f->said);
    *f = (film){.pixels = -1};
}

/* The signals that this command ignores or handles are as usual for ffmpeg, but for a limit on the size of files, which
 * would end it without a word. */
static int spawn(film *f, const char *const *arguments, int input)
{
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    sigset_t usual;
    sigfillset(&usual);
    sigdelset(&usual, SIGKILL);
    sigdelset(&usual, SIGSTOP);
    sigdelset(&usual, SIGXFSZ);
    int error = posix_spawn_file_actions_init(&actions);
    if (error != 0)
        return error;
    error = posix_spawnattr_init(&attributes);
    if (error == 0) {
        posix_spawnattr_setsigdefault(&attributes, &usual);
        posix_spawnattr_setpgroup(&attributes, 0);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
        posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, fileno(f->said), STDERR_FILENO);
        error =
            posix_spawnp(&f->pid, arguments[0], &actions, &attributes, (char *const *)(uintptr_t)arguments, environ);
        posix_spawnattr_destroy(&attributes);
    }
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
        f->pid = 0;
    return error;
}

/* With the pipe, whose end for writing no other process gets: its closing is the end of the film. */
static sph2d_status start(film *f, const char *const *arguments, sph2d_report *report)
{
    int ends[2];
    if (pipe(ends) != 0)
        return cannot(report, "start ffmpeg for", f->path, errno);
    f->pixels = ends[1];
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    const int error = spawn(f, arguments, ends[0]);
    close(ends[0]);
    if (error == ENOENT)
        return missing(report);
    return error == 0 ? SPH2D_OK : cannot(report, "start ffmpeg for", f->path, error);
}

/* ---- opening ----------------------------------------------------------------------------------------------------- */

/* Makes the temporary file `DIR/.NAME.tmp.NUMBER`, by which it is known that a film can be there. */
static sph2d_status make_file(film *f, sph2d_report *report)
{
    const char *slash = strrchr(f->path, '/');
    const int folder = slash ? (int)(slash - f->path) + 1 : 0;
    const size_t size = strlen(f->path) + 48;
    struct timespec now = {0};
    clock_gettime(CLOCK_REALTIME, &now);
    char *name = malloc(size);
    if (!name)
        return SPH2D_NOMEM;
    snprintf(name, size, "%.*s.%s.tmp.%ld%09ld", folder, f->path, f->path + folder, (long)getpid(), now.tv_nsec);
    const int made = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (made < 0) {
        free(name);
        return cannot(report, "create", f->path, errno);
    }
    close(made);
    f->unfinished = name;
    f->said = tmpfile();
    return f->said ? SPH2D_OK : cannot(report, "create a temporary file for", f->path, errno);
}

/* `file:` keeps ffmpeg from taking the beginning of a name for a protocol or an option. */
static sph2d_status start_for(film *f, const film_kind *kind, const film_form *form, sph2d_report *report)
{
    enum { MOST = 48 };
    char size[32], rate[32], threads[16], filters[320], *file = malloc(strlen(f->unfinished) + 6);
    if (!file)
        return SPH2D_NOMEM;
    snprintf(size, sizeof size, "%ux%u", form->width, form->height);
    snprintf(rate, sizeof rate, "%.9g", form->rate);
    snprintf(threads, sizeof threads, "%d", form->threads);
    const bool too_many = form->rate > kind->rate_max;
    if (too_many)
        snprintf(filters, sizeof filters, "fps=%g,%s", kind->rate_max, kind->filters);
    else
        snprintf(filters, sizeof filters, "%s", kind->filters);
    sprintf(file, "file:%s", f->unfinished);
    const char *arguments[MOST] = {
        "ffmpeg",        "-hide_banner", "-nostdin",    "-loglevel", "error",      "-f", "rawvideo",
        "-pixel_format", "rgb0",         "-video_size", size,        "-framerate", rate, "-i",
        "pipe:0",        "-vf",          filters,       "-threads",  threads};
    size_t count = 19;
    for (size_t i = 0; kind->options[i]; ++i)
        arguments[count++] = kind->options[i];
    arguments[count++] = "-y";
    arguments[count++] = file;
    const sph2d_status status = start(f, arguments, report);
    free(file);
    return status;
}

sph2d_status film_open(film *f, const char *path, const film_form *form, sph2d_report *report)
{
    *f = (film){.path = path, .pixels = -1, .frame_bytes = (size_t)form->width * form->height * 4};
    sph2d_status status = make_file(f, report);
    if (status == SPH2D_OK)
        status = start_for(f, kind_of(path), form, report);
    if (status != SPH2D_OK)
        film_abort(f);
    return status;
}

/* ---- frames ------------------------------------------------------------------------------------------------------ */

static sph2d_status failed(film *f, int status, sph2d_report *report)
{
    char words[256];
    if (WIFSIGNALED(status))
        snprintf(words, sizeof words, "signal %d ended it", WTERMSIG(status));
    else
        last_words(f, words, sizeof words);
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_WRITE, NULL, "ffmpeg cannot make '%s': %s", f->path,
                     words[0] != '\0' ? words : "it does not say why");
    film_abort(f);
    return SPH2D_IO;
}

/* An error means that ffmpeg is gone, and why is known when it has ended. */
sph2d_status film_add(film *f, const unsigned char *pixels, sph2d_report *report)
{
    for (size_t done = 0; done < f->frame_bytes;) {
        const ssize_t written = write(f->pixels, pixels + done, f->frame_bytes - done);
        if (written >= 0)
            done += (size_t)written;
        else if (errno != EINTR)
            return failed(f, wait_for_end(f), report);
    }
    return SPH2D_OK;
}

/* Without the sync of the file a crash could leave the name on an empty one; without that of its folder, the old one. */
static bool sync_path(const char *path, int flags)
{
    const int fd = open(path, flags | O_CLOEXEC);
    const bool synced = fd >= 0 && (fsync(fd) == 0 || errno == EINVAL || errno == ENOTSUP);
    const int error = errno;
    if (fd >= 0)
        close(fd);
    errno = error;
    return synced;
}

/* Errors are all that ffmpeg is to say. It also ends with 0 where the last bytes of a file found no room. */
sph2d_status film_close(film *f, sph2d_report *report)
{
    char words[256];
    const int status = wait_for_end(f);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || last_words(f, words, sizeof words)[0] != '\0')
        return failed(f, status, report);
    const bool kept = sync_path(f->unfinished, O_WRONLY) && rename(f->unfinished, f->path) == 0;
    const int error = errno;
    if (kept) {
        char *slash = strrchr(f->unfinished, '/'); /* what is before it is the folder */
        if (slash)
            slash[1] = '\0';
        sync_path(slash ? f->unfinished : ".", O_RDONLY); /* not every folder can be opened */
        free(f->unfinished);
        f->unfinished = NULL;
    } else {
        cannot(report, "write", f->path, error);
    }
    film_abort(f);
    return kept ? SPH2D_OK : SPH2D_IO;
}
