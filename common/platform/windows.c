// platform.h for Windows: files, the program, its environment. This file calls the system directly,
// because the C library of Windows supports neither UTF-8 nor a rename that replaces a file, and
// prevents other programs from replacing an open file. Paths have '/' between their parts.
#include "platform.h"

#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <stdlib.h>
#include <string.h>

#define WIN32_LEAN_AND_MEAN
#include <windows.h>

enum {
    TRIES = 20,       // retries while another program, such as an editor, has a file open
    TRY_AGAIN = 50,   // ms
    PLAIN_PATH = 240, // a path with fewer characters gets no prefix; see widen
    BESIDE = 40       // bytes for the name of a new file beside a target
};

#define SHARED       (FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE)
#define SINCE_1601   116444736000000000LL // the start of 1970, in steps of 100 ns since 1601
#define POSIX_RENAME 3                    // FILE_RENAME_REPLACE_IF_EXISTS | _POSIX_SEMANTICS

// ---- Text ----

// Convert a path to the absolute path, in UTF-16, that the functions of the system need. A long
// path gets the prefix \\?\, without which a path is limited to 260 characters. Returns false with
// errno set if the path is malformed, empty or too long.
static bool widen(const char *path, wchar_t wide[PLATFORM_PATH])
{
    wchar_t given[PLATFORM_PATH], whole[PLATFORM_PATH];
    if (MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, given, PLATFORM_PATH) == 0) {
        errno = GetLastError() == ERROR_INSUFFICIENT_BUFFER ? ENAMETOOLONG : EILSEQ;
        return false;
    }
    DWORD length = GetFullPathNameW(given, PLATFORM_PATH, whole, NULL);
    if (length == 0 || length > PLATFORM_PATH - 8) {
        errno = length == 0 ? ENOENT : ENAMETOOLONG;
        return false;
    }
    bool network = wcsncmp(whole, L"\\\\", 2) == 0, device = network && wcschr(L"?.", whole[2]);
    wcscpy(wide, length < PLAIN_PATH || device ? L"" : network ? L"\\\\?\\UNC" : L"\\\\?\\");
    wcscat(wide, wide[0] != L'\0' && network ? whole + 1 : whole);
    return true;
}

// Convert a path back to UTF-8, with '/' between its parts. Returns false with errno set if the
// path is too long.
static bool narrow(const wchar_t *wide, char path[PLATFORM_PATH])
{
    if (WideCharToMultiByte(CP_UTF8, 0, wide, -1, path, PLATFORM_PATH, NULL, NULL) == 0) {
        errno = ENAMETOOLONG;
        return false;
    }
    for (char *at = path; *at != '\0'; at++)
        if (*at == '\\')
            *at = '/';
    return true;
}

// Return the errno that corresponds to the system's last error, or EIO if no errno does.
static int last_errno(void)
{
    static const struct {
        DWORD said;
        int number;
    } known[] = {{ERROR_FILE_NOT_FOUND, ENOENT},
                 {ERROR_PATH_NOT_FOUND, ENOENT},
                 {ERROR_INVALID_NAME, ENOENT},
                 {ERROR_BAD_PATHNAME, ENOENT},
                 {ERROR_BAD_NETPATH, ENOENT},
                 {ERROR_BAD_NET_NAME, ENOENT},
                 {ERROR_INVALID_DRIVE, ENOENT},
                 {ERROR_NOT_READY, ENOENT},
                 {ERROR_DIRECTORY, ENOTDIR},
                 {ERROR_ACCESS_DENIED, EACCES},
                 {ERROR_SHARING_VIOLATION, ETXTBSY},
                 {ERROR_LOCK_VIOLATION, ETXTBSY},
                 {ERROR_USER_MAPPED_FILE, ETXTBSY},
                 {ERROR_WRITE_PROTECT, EROFS},
                 {ERROR_FILE_EXISTS, EEXIST},
                 {ERROR_ALREADY_EXISTS, EEXIST},
                 {ERROR_DISK_FULL, ENOSPC},
                 {ERROR_HANDLE_DISK_FULL, ENOSPC},
                 {ERROR_FILENAME_EXCED_RANGE, ENAMETOOLONG},
                 {ERROR_NOT_ENOUGH_MEMORY, ENOMEM},
                 {ERROR_CANT_RESOLVE_FILENAME, ENOENT}};
    DWORD said = GetLastError();
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (known[i].said == said)
            return known[i].number;
    return EIO;
}

const char *platform_why(int error)
{
    return error == ETXTBSY ? "another program has the file open: close it there" : strerror(error);
}

// ---- Files that are read ----

// Open a file or a folder. An editor that is saving a file may deny access for a moment, so the
// call is repeated for up to a second.
static HANDLE open_any(const char *path, DWORD access)
{
    wchar_t wide[PLATFORM_PATH];
    if (!widen(path, wide))
        return INVALID_HANDLE_VALUE;
    for (int i = 0;; i++) {
        HANDLE handle = CreateFileW(wide, access, SHARED, NULL, OPEN_EXISTING,
                                    FILE_FLAG_BACKUP_SEMANTICS, NULL);
        errno = handle != INVALID_HANDLE_VALUE ? 0 : last_errno();
        if (errno != ETXTBSY || i == TRIES)
            return handle;
        Sleep(TRY_AGAIN);
    }
}

bool platform_look(const char *path, struct platform_file *file)
{
    BY_HANDLE_FILE_INFORMATION is;
    *file = (struct platform_file){0};
    HANDLE handle = open_any(path, FILE_READ_ATTRIBUTES);
    if (handle == INVALID_HANDLE_VALUE)
        return false;
    bool on_disk = GetFileType(handle) == FILE_TYPE_DISK;
    bool known = !on_disk || GetFileInformationByHandle(handle, &is);
    if (!known)
        errno = last_errno();
    CloseHandle(handle);
    if (!known || !on_disk)
        return known;
    long long changed =
        (long long)is.ftLastWriteTime.dwHighDateTime << 32 | is.ftLastWriteTime.dwLowDateTime;
    *file = (struct platform_file){
        .regular = (is.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) == 0,
        .size = (long long)is.nFileSizeHigh << 32 | is.nFileSizeLow,
        .changed = 100 * (changed - SINCE_1601),
        .identity = {is.dwVolumeSerialNumber,
                     (unsigned long long)is.nFileIndexHigh << 32 | is.nFileIndexLow}};
    return true;
}

bool platform_is_same(const struct platform_file *one, const struct platform_file *other)
{
    return one->identity[0] == other->identity[0] && one->identity[1] == other->identity[1];
}

// Remove the prefix of a long path: "\\?\C:\folder" becomes C:/folder, and "\\?\UNC\server\share"
// becomes //server/share. The caller frees the path.
static char *plain(wchar_t *wide)
{
    char text[PLATFORM_PATH];
    if (wcsncmp(wide, L"\\\\?\\UNC\\", 8) == 0)
        (wide += 6)[0] = L'\\';
    else if (wcsncmp(wide, L"\\\\?\\", 4) == 0)
        wide += 4;
    return narrow(wide, text) ? _strdup(text) : NULL;
}

char *platform_resolve(const char *path)
{
    wchar_t whole[PLATFORM_PATH];
    HANDLE handle = open_any(path, 0);
    if (handle == INVALID_HANDLE_VALUE)
        return NULL;
    DWORD length = GetFinalPathNameByHandleW(handle, whole, PLATFORM_PATH, VOLUME_NAME_DOS);
    CloseHandle(handle);
    // GetFinalPathNameByHandleW may fail on a virtual drive, which a program provides. The given
    // path is then used instead.
    bool told = (length > 0 && length < PLATFORM_PATH) || widen(path, whole);
    return told ? plain(whole) : NULL;
}

// Other programs may replace the file while it is open here, which fopen would prevent.
// platform_look is not used, because it would also query the file's disk.
FILE *platform_open(const char *path)
{
    FILE_BASIC_INFO is;
    HANDLE handle = open_any(path, FILE_READ_ATTRIBUTES);
    if (handle == INVALID_HANDLE_VALUE)
        return NULL;
    bool regular = GetFileType(handle) == FILE_TYPE_DISK &&
                   GetFileInformationByHandleEx(handle, FileBasicInfo, &is, sizeof is) &&
                   (is.FileAttributes & FILE_ATTRIBUTE_DIRECTORY) == 0;
    CloseHandle(handle);
    handle = regular ? open_any(path, GENERIC_READ) : INVALID_HANDLE_VALUE;
    if (!regular)
        errno = 0;
    if (handle == INVALID_HANDLE_VALUE)
        return NULL;
    int number = _open_osfhandle((intptr_t)handle, _O_RDONLY);
    if (number < 0)
        CloseHandle(handle);
    return number < 0 ? NULL : _fdopen(number, "rb");
}

// ---- Files that are written ----

static bool refuse(char why[PLATFORM_WHY], const char *phrase)
{
    snprintf(why, PLATFORM_WHY, "%s", phrase);
    return false;
}

// Return the index at which the last component of a path begins.
static size_t name_at(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? (size_t)(slash - path) + 1 : path[0] != '\0' && path[1] == ':' ? 2 : 0;
}

// Create a file with a new name in the target's folder.
//   flags  FILE_FLAG_DELETE_ON_CLOSE to test whether a file can be created; otherwise 0
// Returns INVALID_HANDLE_VALUE with errno set if no file can be created.
static HANDLE create_beside(const char *target, wchar_t name[PLATFORM_PATH], DWORD flags)
{
    char path[PLATFORM_PATH + BESIDE];
    HANDLE handle = INVALID_HANDLE_VALUE;
    errno = EEXIST;
    for (int i = 0; i < 100 && handle == INVALID_HANDLE_VALUE && errno == EEXIST; i++) {
        snprintf(path, sizeof path, "%.*s.picture-%lu-%d.tmp", (int)name_at(target), target,
                 GetCurrentProcessId(), i);
        if (!widen(path, name))
            break;
        handle = CreateFileW(name, GENERIC_WRITE | DELETE, 0, NULL, CREATE_NEW,
                             FILE_ATTRIBUTE_NORMAL | flags, NULL);
        errno = handle == INVALID_HANDLE_VALUE ? last_errno() : 0;
    }
    return handle;
}

// True if the existing file may be replaced. A write-protected file must not be replaced.
static bool may_replace(const char *path, const struct platform_file *file, char why[PLATFORM_WHY])
{
    wchar_t wide[PLATFORM_PATH];
    DWORD attributes = widen(path, wide) ? GetFileAttributesW(wide) : INVALID_FILE_ATTRIBUTES;
    bool known = attributes != INVALID_FILE_ATTRIBUTES;
    if (!file->regular)
        return refuse(why, known && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0
                               ? "it is a folder: give the name of a file"
                               : "it is a device: give the name of a file");
    return !known || (attributes & FILE_ATTRIBUTE_READONLY) == 0 ||
           refuse(why, platform_why(EACCES));
}

// True if a new file may have this name.
static bool may_create(const char *path, char why[PLATFORM_WHY])
{
    wchar_t wide[PLATFORM_PATH];
    if (errno != ENOENT || path[0] == '\0')
        return refuse(why, platform_why(errno));
    if (path[strlen(path) - 1] == '/')
        return refuse(why, "a name that ends in / denotes a folder: give the name of a file");
    // A name with a colon would denote a stream of another file.
    if (strpbrk(path + name_at(path), "<>:\"|?*") != NULL)
        return refuse(why, "a name must not contain < > : \" | ? *: choose another name");
    if (widen(path, wide) && GetFileAttributesW(wide) != INVALID_FILE_ATTRIBUTES)
        return refuse(why, "it is a broken link: give the name of a file");
    return true;
}

static bool folder_writable(const char *target, char why[PLATFORM_WHY])
{
    wchar_t name[PLATFORM_PATH];
    HANDLE handle = create_beside(target, name, FILE_FLAG_DELETE_ON_CLOSE);
    if (handle != INVALID_HANDLE_VALUE)
        return CloseHandle(handle);
    int length = (int)name_at(target);
    snprintf(why, PLATFORM_WHY, "folder %.*s: %s: choose another", length > 1 ? length - 1 : 1,
             length > 0 ? target : ".", platform_why(errno));
    return false;
}

bool platform_target(const char *path, char target[PLATFORM_PATH], char why[PLATFORM_WHY])
{
    struct platform_file file;
    if (snprintf(target, PLATFORM_PATH, "%s", path) >= PLATFORM_PATH)
        return refuse(why, platform_why(ENAMETOOLONG));
    if (!platform_look(path, &file))
        return may_create(path, why) && folder_writable(target, why);
    if (!may_replace(path, &file, why))
        return false;
    char *resolved = platform_resolve(path); // a link is kept, and its target is replaced
    if (resolved != NULL)
        strcpy(target, resolved);
    free(resolved);
    return folder_writable(target, why);
}

// Rename a file to a target that other programs have open. They keep reading the old file.
static bool rename_as_posix(const wchar_t *name, const wchar_t *target)
{
    struct {
        DWORD flags;
        HANDLE root;
        DWORD length; // bytes
        wchar_t name[PLATFORM_PATH];
    } to = {.flags = POSIX_RENAME, .length = (DWORD)(wcslen(target) * sizeof *target)};
    wcscpy(to.name, target);
    HANDLE handle = CreateFileW(name, DELETE, SHARED, NULL, OPEN_EXISTING, 0, NULL);
    bool done = handle != INVALID_HANDLE_VALUE &&
                SetFileInformationByHandle(handle, (FILE_INFO_BY_HANDLE_CLASS)22, &to, sizeof to);
    if (handle != INVALID_HANDLE_VALUE)
        CloseHandle(handle);
    return done;
}

// Rename a file to its target. If access is denied, another program must have the target open,
// since platform_target has checked that the target is not write-protected; the rename is then
// tried again. Returns 0 or an errno.
static int put_in_place(const wchar_t *name, const wchar_t *target)
{
    for (int i = 0; !MoveFileExW(name, target, MOVEFILE_REPLACE_EXISTING); i++) {
        int error = last_errno();
        bool held = error == EACCES || error == ETXTBSY;
        if (held && rename_as_posix(name, target))
            return 0;
        if (!held || i == TRIES)
            return held ? ETXTBSY : error;
        Sleep(TRY_AGAIN);
    }
    return 0;
}

// Write a new file beside the target and rename it. Returns 0 or an errno. After an error, no new
// file is left.
static int replace(const char *target, const char *data, size_t size)
{
    wchar_t name[PLATFORM_PATH], wide[PLATFORM_PATH];
    HANDLE handle = widen(target, wide) ? create_beside(target, name, 0) : INVALID_HANDLE_VALUE;
    if (handle == INVALID_HANDLE_VALUE)
        return errno;
    int error = 0;
    while (size > 0 && error == 0) {
        DWORD part = size < 1u << 20 ? (DWORD)size : 1u << 20, written = 0;
        error = WriteFile(handle, data, part, &written, NULL) ? 0 : last_errno();
        data += written;
        size -= written;
    }
    if (!CloseHandle(handle) && error == 0)
        error = last_errno();
    error = error == 0 ? put_in_place(name, wide) : error;
    if (error != 0)
        DeleteFileW(name);
    return error;
}

static CRITICAL_SECTION writing;

// Ctrl+C is handled in a separate thread, which waits here until the file is complete.
static BOOL WINAPI on_interrupt(DWORD event)
{
    (void)event;
    EnterCriticalSection(&writing);
    LeaveCriticalSection(&writing);
    return FALSE; // the next handler then ends the program
}

int platform_replace(const char *target, const char *data, size_t size)
{
    static bool ready;
    if (!ready) {
        InitializeCriticalSection(&writing);
        SetConsoleCtrlHandler(on_interrupt, TRUE);
        ready = true;
    }
    EnterCriticalSection(&writing);
    int error = replace(target, data, size);
    LeaveCriticalSection(&writing);
    return error;
}

// ---- The program and its environment ----

bool platform_program(char path[PLATFORM_PATH])
{
    wchar_t wide[PLATFORM_PATH];
    char given[PLATFORM_PATH];
    DWORD length = GetModuleFileNameW(NULL, wide, PLATFORM_PATH);
    bool fits = length > 0 && length < PLATFORM_PATH && narrow(wide, given);
    char *resolved = fits ? platform_resolve(given) : NULL;
    bool told = resolved != NULL && snprintf(path, PLATFORM_PATH, "%s", resolved) < PLATFORM_PATH;
    free(resolved);
    return told;
}
