/* Lets the n-th open, write, flush, link, rename or removal under one folder fail; loaded with LD_PRELOAD.
 *
 * Python, GDAL and SQLite all call these functions of the C library, so one counter sees them all.
 * Streams buffer: what a program writes through them fails in fwrite or in fclose.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

#define FILES 4096
#define DIE -1 /* in place of an error number: the process is killed at that call */

static char under[PATH_MAX];
static int wanted, seen, code;
static char watched[FILES];
static char last[64];

void faults_arm(const char *folder, int n, int error)
{
    snprintf(under, sizeof under, "%s", folder);
    wanted = n;
    seen = 0;
    code = error;
    last[0] = 0;
}

int faults_seen(void) { return seen; }
const char *faults_last(void) { return last; }

static int fails(const char *name)
{
    if (!wanted || ++seen != wanted)
        return 0;
    snprintf(last, sizeof last, "%s", name);
    if (code == DIE)
        raise(SIGKILL);
    errno = code;
    return 1;
}

static int inside(const char *path)
{
    return wanted && path && under[0] && strncmp(path, under, strlen(under)) == 0;
}

static int watching(int fd) { return fd >= 0 && fd < FILES && watched[fd]; }

static int note(int fd)
{
    if (fd >= 0 && fd < FILES)
        watched[fd] = 1;
    return fd;
}

#define NEXT(type, name, ...) \
    static type (*next)(__VA_ARGS__); \
    if (!next) \
        next = (type (*)(__VA_ARGS__))dlsym(RTLD_NEXT, #name)

#define OPEN(name) \
    int name(const char *path, int flags, ...) \
    { \
        NEXT(int, name, const char *, int, ...); \
        va_list rest; \
        va_start(rest, flags); \
        mode_t mode = va_arg(rest, mode_t); \
        va_end(rest); \
        int ours = inside(path); \
        if (ours && fails("open")) \
            return -1; \
        int fd = next(path, flags, mode); \
        return ours ? note(fd) : fd; \
    }

OPEN(open)
OPEN(open64)

#define FOPEN(name) \
    FILE *name(const char *path, const char *mode) \
    { \
        NEXT(FILE *, name, const char *, const char *); \
        int ours = inside(path); \
        if (ours && fails("fopen")) \
            return NULL; \
        FILE *stream = next(path, mode); \
        if (ours && stream) \
            note(fileno(stream)); \
        return stream; \
    }

FOPEN(fopen)
FOPEN(fopen64)

size_t fwrite(const void *data, size_t size, size_t count, FILE *stream)
{
    NEXT(size_t, fwrite, const void *, size_t, size_t, FILE *);
    if (wanted && watching(fileno(stream)) && fails("fwrite"))
        return 0;
    return next(data, size, count, stream);
}

int fclose(FILE *stream)
{
    NEXT(int, fclose, FILE *);
    int fd = fileno(stream);
    int broken = wanted && watching(fd) && fails("fclose");
    if (fd >= 0 && fd < FILES)
        watched[fd] = 0;
    int result = next(stream);
    if (broken) {
        errno = code;
        return EOF;
    }
    return result;
}

int close(int fd)
{
    NEXT(int, close, int);
    if (fd >= 0 && fd < FILES)
        watched[fd] = 0;
    return next(fd);
}

ssize_t write(int fd, const void *data, size_t size)
{
    NEXT(ssize_t, write, int, const void *, size_t);
    if (wanted && watching(fd) && fails("write"))
        return -1;
    return next(fd, data, size);
}

#define PWRITE(name, offset_type) \
    ssize_t name(int fd, const void *data, size_t size, offset_type offset) \
    { \
        NEXT(ssize_t, name, int, const void *, size_t, offset_type); \
        if (wanted && watching(fd) && fails("pwrite")) \
            return -1; \
        return next(fd, data, size, offset); \
    }

PWRITE(pwrite, off_t)
PWRITE(pwrite64, off64_t)

#define ON_FILE(name, more, pass) \
    int name more \
    { \
        NEXT(int, name, ON_FILE_TYPES_##name); \
        if (wanted && watching(fd) && fails(#name)) \
            return -1; \
        return next pass; \
    }
#define ON_FILE_TYPES_fsync int
#define ON_FILE_TYPES_fdatasync int
#define ON_FILE_TYPES_ftruncate int, off_t
#define ON_FILE_TYPES_ftruncate64 int, off64_t

ON_FILE(fsync, (int fd), (fd))
ON_FILE(fdatasync, (int fd), (fd))
ON_FILE(ftruncate, (int fd, off_t size), (fd, size))
ON_FILE(ftruncate64, (int fd, off64_t size), (fd, size))

int rename(const char *from, const char *to)
{
    NEXT(int, rename, const char *, const char *);
    if (inside(to) && fails("rename"))
        return -1;
    return next(from, to);
}

int link(const char *from, const char *to)
{
    NEXT(int, link, const char *, const char *);
    if (inside(to) && fails("link"))
        return -1;
    return next(from, to);
}

int linkat(int from_folder, const char *from, int to_folder, const char *to, int flags)
{
    NEXT(int, linkat, int, const char *, int, const char *, int);
    if (inside(to) && fails("link"))
        return -1;
    return next(from_folder, from, to_folder, to, flags);
}

int unlink(const char *path)
{
    NEXT(int, unlink, const char *);
    if (inside(path) && fails("unlink"))
        return -1;
    return next(path);
}
