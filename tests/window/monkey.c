// monkey [SEED [SECONDS [PROGRAM]]] - tests the window with random input. Each sequence of events
// is carried out by a process of its own, which then checks what must hold after any input. A
// sequence that fails is shortened to the fewest events that fail, and printed as a test.
//
// After each sequence, with the window and the files as they were: nothing has crashed, and no
// sanitizer has complained; no frame has taken more than half a second of the test's clock; a
// shader with an error leaves the picture as it is; a shader without one is drawn; as many files
// are open as at the start, and not many more objects of OpenGL; Backspace ends the program, which
// then has freed everything; nothing was reported unless a file was changed.
//
// Without arguments, one sequence for each program in which most can go wrong, always the same;
// with the sanitizers more if the environment variable CI is set, and for all programs if ALL is
// set. With SECONDS, as many as begin within this time, for the programs whose names begin with
// PROGRAM.
#include <glob.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "linked.h"
#include "lib/events.h"
#include "lib/gpu.h"
#include "lib/scratch.h"
#include "lib/session.h"
#include "lib/system.h"
#include "window/state.h"

enum { LONGEST = 300, PROGRAMS = 200, FOUND = 7, HANGS_SECONDS = 300 };

// How much more there may be at the end than at the start: the programs of views that were not
// shown before, and targets that keep the largest size that the window has had.
enum { OBJECTS = 150, MEGABYTES = 160 };

#define LONGEST_FRAME 0.5 // seconds

struct program {
    char name[64];
    char stem[64];     // the chapter
    char options[256]; // of the command line; %s is the path of a file in the scratch folder
    const char *list; // the scenes of a lecture, with the same %s, or the path of a list, or "" for
                      // the course; NULL for a chapter
};

static struct program programs[PROGRAMS];
static int program_count;

#define OWN "--size 320x200 --shader %s"

static const char scenes[] = "01 --shader %s\n  One.\n"
                             "01 --shader %s --view slice --step 0\n  Two.\n"
                             "== Part\n01 --shader %s --compare %s\n"
                             "23 --set tool=0.1\n01 --shader %s --set focalLength=2\n"
                             "03 --time 1 --set lampSpeed=50\n";

static void add_program(const char *name, const char *stem, const char *options, const char *list)
{
    struct program *program = &programs[program_count++];
    assert_true(program_count <= PROGRAMS);
    snprintf(program->name, sizeof program->name, "%s", name);
    snprintf(program->stem, sizeof program->stem, "%s", stem);
    snprintf(program->options, sizeof program->options, "%s", options);
    program->list = list;
}

// Return the stem of the chapter with a number, "23".
static const char *stem_of(const char *number)
{
    for (const struct linked_chapter *each = linked_chapters; each->stem != NULL; each++)
        if (strncmp(each->stem, number, 2) == 0)
            return each->stem;
    fail_msg("chapter %s: not found", number);
    return NULL;
}

// The first RISKY programs are those in which most can go wrong.
enum { RISKY = 6 };
static void list_programs(void)
{
    char pattern[4200];
    glob_t found;
    add_program("sculpting", stem_of("23"), OWN " --set tool=0.1 --set turnSpeed=0", NULL);
    add_program("comparison", stem_of("03"), OWN " --compare %s", NULL);
    add_program("lecture", stem_of("01"), "", scenes);
    add_program("probe", stem_of("01"), OWN " --view slice --step 0 --overlay", NULL);
    add_program("figure 04_blend", stem_of("04"),
                "--size 320x200 --shader chapters/figures/04_blend.frag", NULL);
    add_program("sculpting, compared", stem_of("23"), OWN " --set tool=-0.1 --compare %s", NULL);
    for (const struct linked_chapter *each = linked_chapters; each->stem != NULL; each++)
        add_program(each->stem, each->stem, OWN, NULL);
    snprintf(pattern, sizeof pattern, "%s/chapters/figures/*.frag", gpu_project_root());
    assert_int_equal(glob(pattern, 0, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        const char *file = strrchr(found.gl_pathv[i], '/') + 1;
        char name[64], options[256];
        snprintf(name, sizeof name, "figure %.*s", (int)strcspn(file, "."), file);
        snprintf(options, sizeof options, "--size 320x200 --shader chapters/figures/%s", file);
        add_program(name, stem_of(file), options, NULL);
    }
    globfree(&found);
    add_program("the course", stem_of("00"), "", "");
    add_program("the course's lecture", stem_of("00"), "", "docs/lecture.txt");
}

// ---- One sequence, in a process of its own ----

static const struct program *the; // the program of this process
static int report_to;             // where to say what is wrong

static void find(const char *format, ...) __attribute__((noreturn, format(printf, 1, 2)));
static void find(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    vdprintf(report_to, format, values);
    va_end(values);
    dprintf(report_to, "\n");
    _exit(FOUND);
}

static void turn(void)
{
    double before = user.now;
    session_turn();
    if (user.now - before > LONGEST_FRAME + 1.0 / 60.0)
        find("an iteration takes %.3f s", user.now - before);
}

static void turns(int count)
{
    while (count-- > 0)
        turn();
}

static void open_program(void)
{
    static char line[4096], list[8192];
    const char *path[EVENTS_FILES];
    for (int i = 0; i < EVENTS_FILES; i++) {
        events_save(the->stem, i, 0);
        path[i] = scratch_path(events_file[i]);
    }
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    if (the->list == NULL) {
        snprintf(line, sizeof line, the->options, path[0], path[1]);
        session_open(the->stem, "%s", line);
    } else if (the->list[0] == '\0') {
        session_open_lecture(NULL);
    } else if (strchr(the->list, '\n') == NULL) {
        session_open_lecture(the->list);
    } else {
        snprintf(line, sizeof line, the->list, path[0], path[0], path[0], path[1], path[0]);
        snprintf(list, sizeof list, "%s", scratch_write("list.txt", line));
        session_open_lecture(list);
    }
#pragma GCC diagnostic pop
}

// Let go of everything, and undo what the events did to the window and the files.
static void calm(void)
{
    for (int button = 0; button < 3; button++)
        user_button(button, GLFW_RELEASE);
    for (int file = 0; file < EVENTS_FILES; file++)
        events_save(the->stem, file, 0);
    user.hidden = false;
    user.density = 1;
    user_focus(false);
    user_focus(true);
    user_resize(320, 200);
    if (user.captured)
        user_key(GLFW_KEY_M, 0);
    if (session_window()->input.typing)
        user_key(GLFW_KEY_ESCAPE, 0);
    user_drop(events_dropped(0)); // a file that was dropped may be missing
    if (session_window()->contents.open)
        user_key(GLFW_KEY_HOME, 0);
    turns(120);
    session_window()->paused = true;
    turns(30);
}

// Draw the picture of some inputs again, without the overlay.
static void draw(const struct renderer_inputs *inputs, struct image *image)
{
    struct renderer *renderer = session_window()->renderer;
    const struct overlay *overlay = renderer->overlay;
    const double cost = user.pixel_seconds;
    renderer->overlay = NULL;
    user.pixel_seconds = 0.0; // this picture is not part of what the window draws
    if (!renderer_picture(renderer, inputs, image))
        find("the picture cannot be drawn: %s", session_said(2));
    renderer->gl->Finish();
    user.pixel_seconds = cost;
    renderer->overlay = overlay;
    session_window()->stale = true; // the window's own picture has been overwritten
}

// A shader with an error must leave the picture as it is.
static void check_broken(void)
{
    const struct renderer_inputs inputs = session_window()->inputs;
    struct image before, after;
    draw(&inputs, &before);
    for (int file = 0; file < EVENTS_FILES; file++)
        events_save(the->stem, file, 1);
    turns(60);
    draw(&inputs, &after);
    if (memcmp(before.pixel, after.pixel, 3 * (size_t)before.width * (size_t)before.height) != 0)
        find("a shader with an error changes the picture");
    image_free(&before);
    image_free(&after);
    for (int file = 0; file < EVENTS_FILES; file++)
        events_save(the->stem, file, 0);
    turns(60);
    if (session_window()->broken)
        find("a shader without an error is not drawn: %s", session_said(2));
}

// Functions of the sanitizers' runtime; NULL in the other build.
__attribute__((weak)) void __sanitizer_set_report_fd(void *file);
__attribute__((weak)) size_t __sanitizer_get_current_allocated_bytes(void);

static double megabytes(void)
{
    return __sanitizer_get_current_allocated_bytes != NULL
               ? 1e-6 * (double)__sanitizer_get_current_allocated_bytes()
               : 0.0;
}

// While no file changes, the only reason for a report is a view that a shader does not have.
static void check_reports(const char *said)
{
    for (const char *line = said; *line != '\0'; line = strchr(line, '\n') + 1) {
        const char *reason = strstr(line, "cannot show the view");
        if (reason == NULL || reason > strchr(line, '\n'))
            find("reported without a reason: %s", line);
    }
}

// Continue in the scratch folder, which receives the screenshots, and from which relative paths
// still lead to the project's files.
static void move_to_scratch(void)
{
    static char root[4096];
    static const char *const folders[] = {"chapters", "docs"};
    if (realpath(gpu_project_root(), root) == NULL || chdir(scratch_path("")) != 0 ||
        setenv("PROJECT_ROOT", root, 1) != 0 || setenv("VISUAL", "true", 1) != 0)
        find("no folder for screenshots");
    for (int i = 0; i < 2; i++) {
        char target[4200];
        snprintf(target, sizeof target, "%s/%s", root, folders[i]);
        system_make_link(target, folders[i]);
    }
}

// Carry out a sequence, and check what must hold afterwards. Does not return.
static void run_sequence(const struct event *events, int count)
{
    bool saved = false;
    session_setup(NULL);
    session_smooths = true;
    move_to_scratch();
    const bool costs = count > 0 && events[0].kind == EVENTS_COST;
    user.pixel_seconds = costs ? events[0].x : 0.0;
    open_program();
    turns(10);
    const int files = system_open_files(), objects = user.objects;
    const double memory = megabytes();
    for (int n = costs; n < count && !user.ended; n++) {
        events_do(&events[n], turn, the->stem);
        saved |= events[n].kind == EVENTS_SAVE || events[n].kind == EVENTS_DROP;
    }
    user.ended = false; // Backspace was among the keys
    if (!saved)
        check_reports(session_said(2));
    calm();
    check_broken();
    if (system_open_files() != files)
        find("%d files were open at the start, and %d are at the end", files, system_open_files());
    if (user.objects > objects + OBJECTS)
        find("%d objects of OpenGL at the start, %d at the end", objects, user.objects);
    if (megabytes() > memory + MEGABYTES)
        find("%.1f MB at the start, %.1f MB at the end", memory, megabytes());
    user_key(GLFW_KEY_BACKSPACE, 0);
    turns(1);
    if (!user.ended)
        find("Backspace does not end the program");
    session_said(2);
    session_close();
    if (user.objects != 0)
        find("%d objects of OpenGL are left", user.objects);
    session_teardown(NULL);
    exit(0);
}

// ---- Many sequences ----

static char report_path[4096];

// Run a sequence in a new process. Returns true if all was well; otherwise, the reasons are in the
// file report_path.
static bool passes(const struct program *program, const struct event *events, int count)
{
    int status = 0;
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        FILE *file = fopen(report_path, "w");
        const struct rlimit limit = {HANGS_SECONDS, HANGS_SECONDS + 5};
        if (file == NULL || setrlimit(RLIMIT_CPU, &limit) != 0)
            _exit(FOUND);
        the = program;
        report_to = fileno(file);
        dup2(report_to, 1);
        dup2(report_to, 2);
        if (__sanitizer_set_report_fd != NULL)
            __sanitizer_set_report_fd((void *)(intptr_t)report_to); // NOLINT: the runtime's type
        run_sequence(events, count);
    }
    if (child < 0 || waitpid(child, &status, 0) != child)
        fail_msg("no process for a sequence");
    FILE *file = fopen(report_path, "a");
    if (file != NULL && WIFSIGNALED(status))
        fprintf(file, "ended by the signal %s\n", strsignal(WTERMSIG(status)));
    else if (file != NULL && WEXITSTATUS(status) != FOUND)
        fprintf(file, "ended with status %d\n", WEXITSTATUS(status));
    if (file != NULL)
        fclose(file);
    return status == 0;
}

// Remove from a sequence that fails all events without which it still fails: first halves, then
// quarters, and so on to single events.
static int shorten(const struct program *program, struct event *events, int count)
{
    struct event fewer[LONGEST];
    for (int part = (count + 1) / 2; part >= 1; part = part > 1 ? (part + 1) / 2 : 0)
        for (int from = 0; from < count;) {
            int end = from + part < count ? from + part : count;
            memcpy(fewer, events, sizeof *events * (size_t)from);
            memcpy(fewer + from, events + end, sizeof *events * (size_t)(count - end));
            if (passes(program, fewer, count - (end - from))) {
                from = end;
                continue;
            }
            count -= end - from;
            memcpy(events, fewer, sizeof *events * (size_t)count);
        }
    return count;
}

static void print_report(void)
{
    char line[512];
    FILE *file = fopen(report_path, "r");
    while (file != NULL && fgets(line, sizeof line, file) != NULL)
        printf("#   %.*s\n", (int)strcspn(line, "\n"), line);
    if (file != NULL)
        fclose(file);
}

// Try one sequence. If it fails, shorten and print it. Returns true if it passes.
static bool try_seed(const struct program *program, uint64_t seed)
{
    struct event events[LONGEST];
    uint64_t state = seed;
    int count = 1 + events_random(&state, LONGEST);
    events_make(&state, events, count);
    if (passes(program, events, count))
        return true;
    printf("# %s, seed %llu: fails with %d events; shortening\n", program->name,
           (unsigned long long)seed, count);
    print_report();
    count = shorten(program, events, count);
    if (passes(program, events, count))
        printf("# the shortened sequence does not always fail\n");
    printf("# %d events are left:\n", count);
    print_report();
    printf("# SESSION_TEST(monkey_%llu)\n# {\n", (unsigned long long)seed);
    const bool costs = count > 0 && events[0].kind == EVENTS_COST;
    if (costs)
        printf("#     user.pixel_seconds = %g;\n", events[0].x);
    if (program->list == NULL)
        printf("#     session_open(\"%s\", \"%s\", ...);\n", program->stem, program->options);
    else
        printf("#     session_open_lecture(...);\n");
    for (int n = costs; n < count; n++) {
        printf("# ");
        events_print(&events[n], program->stem, stdout);
    }
    printf("#     session_close();\n# }\n");
    return false;
}

static int tests, failures;

// Try sequences of one program, and print the result as a line of TAP.
//   until  the time after which no sequence begins, if count is 0
static void try_program(const struct program *program, uint64_t seed, int count, time_t until)
{
    bool good = true;
    int tried = 0;
    for (; good && (count > 0 ? tried < count : time(NULL) < until || tried == 0); tried++)
        good = try_seed(program, seed + (uint64_t)tried);
    failures += !good;
    printf("%sok %d - %s: %d random sequences from seed %llu\n", good ? "" : "not ", ++tests,
           program->name, tried, (unsigned long long)seed);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    const bool sanitized = __sanitizer_set_report_fd != NULL;
    const bool all = sanitized && getenv("ALL") != NULL, ci = sanitized && getenv("CI") != NULL;
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 1;
    const double seconds = argc > 2 ? strtod(argv[2], NULL) : 0.0;
    const char *const chosen = argc > 3 ? argv[3] : "";
    snprintf(report_path, sizeof report_path, "%s/report", scratch_make());
    list_programs();
    const int end = argc > 1 || all ? program_count : RISKY;
    int fits = 0, done = 0;
    for (int i = 0; i < end; i++)
        fits += strncmp(programs[i].name, chosen, strlen(chosen)) == 0;
    const time_t begin = time(NULL);
    for (int i = 0; i < end; i++)
        if (strncmp(programs[i].name, chosen, strlen(chosen)) == 0)
            try_program(&programs[i], seed,
                        argc > 2 ? 0
                        : all    ? 8
                        : ci     ? 10
                                 : 1,
                        begin + (time_t)(seconds * ++done / fits));
    if (fits == 0) {
        fprintf(stderr, "make monkey: PROGRAM='%s': no such program; the programs are:\n", chosen);
        for (int i = 0; i < program_count; i++)
            fprintf(stderr, "  %s\n", programs[i].name);
    }
    scratch_remove();
    printf("1..%d\n", tests);
    return fits == 0 ? 2 : failures > 0;
}
