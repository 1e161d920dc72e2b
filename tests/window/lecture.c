// lecture.c - tests the scenes of a list in one window: the keys of a presenter's remote control,
// the time at which scenes are compiled, and the messages about a bad list.
#include "command/lecture.h"

#include "lib/compare.h"
#include "lib/gpu.h"
#include "lib/mirror.h"
#include "lib/scratch.h"
#include "lib/session.h"
#include "report.h"
#include "window/state.h"

#define STILL "--samples 1 --camera 1.65,1.6,3.4,-26,-23.5"
#define SIZE  "--size 320x180 "

static const char *const stems[] = {
    "00_first_scene",           "01_normal_colouring", "03_shadows",
    "06_sierpinski_symmetry",   "07_repetition",       "09_sky_and_sunset",
    "10_distance_in_the_plane", "24_bounces"};
// The course of these tests leaves out the last one, which only the lecture shows.
enum { CHAPTERS = sizeof stems / sizeof *stems, IN_COURSE = CHAPTERS - 1 };

static struct lecture_chapter chapters[CHAPTERS];
static struct lecture *lecture;

static int read_list(const char *path)
{
    for (int i = 0; i < CHAPTERS; i++) {
        chapters[i].stem = chapters[i].title = stems[i];
        assert_true(mirror_camera(gpu_project_root(), stems[i], &chapters[i].camera));
    }
    return lecture_read(&lecture, path, chapters, CHAPTERS);
}

static void turn(void)
{
    user.now += 1.0 / 60.0;
    assert_true(window_turn(lecture_window(lecture)));
    lecture_follow(lecture);
}

static void turns(int count)
{
    while (count-- > 0)
        turn();
}

static void key(int code, int modifiers)
{
    user_key(code, modifiers);
    turns(2); // the new scene is drawn in the second iteration
}

static void on(void)
{
    key(GLFW_KEY_PAGE_DOWN, 0);
}

static void back(void)
{
    key(GLFW_KEY_PAGE_UP, 0);
}

static void open_with(const char *path, bool notes)
{
    assert_int_equal(read_list(path), RUN_DONE);
    assert_int_equal(lecture_open(lecture, notes), RUN_DONE);
    assert_true(user.full);
    user_resize(320, 180); // fewer pixels, to save time
    turns(2);
}

static void open_list(const char *path)
{
    open_with(path, false);
}

static void open_text(const char *text)
{
    static char path[4096];
    snprintf(path, sizeof path, "%s", scratch_write("list.txt", text));
    open_list(path);
}

static void close_list(void)
{
    lecture_close(lecture);
    assert_false(user.open);
}

// Fails the test unless the window, without its overlay, shows the picture that a chapter writes.
static void assert_scene(const char *stem, const char *options)
{
    key(GLFW_KEY_H, 0); // the first press shows the panel with the caption, the second hides both
    key(GLFW_KEY_H, 0);
    session_assert_shown(stem, SIZE "%s", options);
}

SESSION_TEST(page_keys_change_the_scene)
{
    open_text("# mine\n01 " STILL "\n  The picture.\n\n"
              "01 " STILL
              " --view normals\n  Its\n  normals.\n3 --samples 1 --time 1 --set lampSpeed=50\n");
    session_keep(0);
    assert_scene(stems[1], STILL);
    assert_true(session_off(0, (const int[]){9, 152, 50, 18}) > 0.2);  // the caption is gone
    assert_true(session_off(0, (const int[]){0, 0, 320, 140}) <= 0.0); // nothing else has changed
    back(); // there is no scene before the first
    assert_scene(stems[1], STILL);
    on();
    session_keep(0);
    assert_scene(stems[1], STILL " --view normals");
    assert_true(session_off(0, (const int[]){9, 152, 50, 18}) > 0.2);
    user_repeat(GLFW_KEY_PAGE_DOWN, 0); // a held key has no effect
    turns(2);
    session_assert_shown(stems[1], SIZE STILL " --view normals");
    on();
    turns(60); // the scene's time is paused
    assert_scene(stems[2], "--time 1 --set lampSpeed=50");
    session_assert_title("lampSpeed = 50"); // the first parameter of --set is selected
    on();                                   // there is no scene after the last
    key(GLFW_KEY_RIGHT, 0);
    session_assert_title("lampSpeed = 55");
    back();
    assert_scene(stems[1], STILL " --view normals");
    on(); // the scene has its own values again
    assert_scene(stems[2], "--time 1 --set lampSpeed=50");
    key(GLFW_KEY_ESCAPE, 0);
    session_keep(0);
    turns(60);
    assert_true(session_off(0, NULL) > 0.01);
    close_list();
}

// The value of the brightest pixel.
static int brightest(void)
{
    struct image image;
    int most = 0;
    user_look(&image);
    for (int i = 0; i < 3 * image.width * image.height; i++)
        most = image.pixel[i] > most ? image.pixel[i] : most;
    image_free(&image);
    return most;
}

SESSION_TEST(b_makes_the_screen_black)
{
    open_text("01 " STILL "\n  The picture.\n01 " STILL " --view normals\n");
    session_keep(0);
    key(GLFW_KEY_B, 0);
    assert_int_equal(brightest(), 0);
    user_click(100.0, 100.0, GLFW_MOUSE_BUTTON_LEFT); // nothing is selected unseen
    turns(2);
    assert_true(session_off(0, NULL) <= 0.0);
    key(GLFW_KEY_B, 0);
    key(GLFW_KEY_5, 0);
    assert_true(session_off(0, NULL) <= 0.0);
    key(GLFW_KEY_B, 0);
    key(GLFW_KEY_PERIOD, 0); // as a presenter's remote control sends
    assert_true(session_off(0, NULL) <= 0.0);
    key(GLFW_KEY_B, 0);
    on(); // the next scene is seen
    assert_scene(stems[1], STILL " --view normals");
    close_list();
}

// tests/window/window.sh tests that they are printed.
SESSION_TEST(notes_are_not_in_the_window)
{
    open_with(scratch_write("list.txt", "01 " STILL "\n  The picture.\n== Part\n01 " STILL
                                        " --view normals\n  Its normals.\n"),
              true);
    session_assert_shown(stems[1], SIZE STILL);
    key(GLFW_KEY_1, GLFW_MOD_SHIFT);
    session_assert_shown(stems[1], SIZE STILL " --view normals");
    close_list();
}

SESSION_TEST(a_ray_comes_before_the_next_scene)
{
    open_text("01 " STILL " --view slice --step 2\n01 " STILL "\n");
    assert_scene(stems[1], STILL " --view slice --step 2");
    key(GLFW_KEY_Q, 0); // goes to step 1, from which Page Down also steps along the ray
    on();
    on();
    session_assert_shown(stems[1], SIZE STILL " --view slice --step 3");
    user_repeat(GLFW_KEY_PAGE_DOWN, 0);
    turns(2);
    session_assert_shown(stems[1], SIZE STILL " --view slice --step 4");
    on(); // the march has five steps
    assert_scene(stems[1], STILL);
    back(); // to the last step of the previous scene
    assert_scene(stems[1], STILL " --view slice --step 4");
    back();
    back();
    back(); // the scene begins at step 2
    assert_scene(stems[1], STILL " --view slice --step 2");
    close_list();
}

SESSION_TEST(n_skips_the_steps_of_a_ray)
{
    open_text("01 " STILL " --view slice --step 2\n01 " STILL "\n01 " STILL " --view normals\n");
    key(GLFW_KEY_N, 0);
    assert_scene(stems[1], STILL);
    key(GLFW_KEY_N, 0);
    user_repeat(GLFW_KEY_N, 0); // there is no scene after the last
    turns(2);
    assert_scene(stems[1], STILL " --view normals");
    key(GLFW_KEY_N, GLFW_MOD_SHIFT);
    key(GLFW_KEY_N, GLFW_MOD_SHIFT);
    assert_scene(stems[1], STILL " --view slice --step 4"); // the last step, as with Page Up
    close_list();
}

SESSION_TEST(presses_that_pile_up_count_once)
{
    open_text("01 " STILL "\n01 " STILL " --view normals\n01 " STILL " --view depth\n");
    for (int i = 0; i < 5; i++)
        user_key(GLFW_KEY_PAGE_DOWN, 0);
    turns(2);
    assert_scene(stems[1], STILL " --view normals");
    close_list();
}

SESSION_TEST(digits_with_shift_show_the_parts)
{
    open_text("01 --view depth\n== One\n01 " STILL "\n01 " STILL " --view depth\n"
              "== Two\n01 " STILL " --view normals\n");
    key(GLFW_KEY_2, GLFW_MOD_SHIFT);
    assert_scene(stems[1], STILL " --view normals");
    key(GLFW_KEY_9, GLFW_MOD_SHIFT); // there is no part 9
    assert_scene(stems[1], STILL " --view normals");
    key(GLFW_KEY_1, GLFW_MOD_SHIFT);
    assert_scene(stems[1], STILL);
    key(GLFW_KEY_2, 0); // without Shift, the key selects a view
    session_assert_shown(stems[1], SIZE STILL " --view normals");
    on();
    assert_scene(stems[1], STILL " --view depth");
    close_list();
}

// The programs of the next scene are linked before the user asks for the scene. Scenes that differ
// only in values need no new programs.
SESSION_TEST(the_next_scene_is_compiled_ahead)
{
    open_text("01 " STILL "\n01 " STILL " --set focalLength=1.5\n03 --samples 1 --time 0\n00\n");
    int ahead = user.links;
    on();
    on();
    assert_int_equal(user.links, ahead);
    assert_scene(stems[2], "--time 0");
    assert_true(user.links > ahead); // the fourth scene is compiled ahead
    ahead = user.links;
    back();
    assert_scene(stems[1], STILL " --set focalLength=1.5");
    assert_int_equal(user.links, ahead);
    close_list();
}

// Save a shader that draws a single shade of grey.
static void save(const char *grey)
{
    char text[256];
    snprintf(text, sizeof text, "void mainImage(out vec4 c, in vec2 p) { c = vec4(%s); }", grey);
    scratch_write("mine.frag", text);
}

static int grey(void)
{
    struct image image;
    user_look(&image);
    int value = image.pixel[3 * (image.width * 20 + 160)];
    image_free(&image);
    return value;
}

SESSION_TEST(a_shader_that_is_saved_during_the_lecture_is_shown)
{
    char list[8192];
    save("0.2");
    snprintf(list, sizeof list, "01 " STILL "\n01 --shader %s\n01 " STILL " --view normals\n",
             scratch_path("mine.frag"));
    open_text(list);
    turns(5);
    save("0.4"); // after the scene was compiled ahead
    on();
    assert_int_equal(grey(), 102);
    save("0.6");
    turns(60);
    assert_int_equal(grey(), 153);
    back();
    save("undeclared");
    capture_begin();
    on(); // the previous scene stays, with the error
    assert_non_null(strstr(capture_end(), "undeclared"));
    session_keep(0);
    on(); // the lecture continues
    assert_scene(stems[1], STILL " --view normals");
    capture_begin();
    back();
    assert_non_null(strstr(capture_end(), "undeclared"));
    save("0.8");
    turns(60); // the mended scene appears
    assert_int_equal(grey(), 204);
    back();
    assert_scene(stems[1], STILL);
    close_list();
}

// Save a shader in the course's dialect, whose parameter shade is the colour of the picture.
static const char *save_shade(const char *colour)
{
    char text[1024];
    snprintf(text, sizeof text,
             "#include \"main.glsl\"\n#include \"camera.glsl\"\n"
             "uniform float shade; // 0 in [0, 1] step 0.2: of the picture\n"
             "Ray pixelRay(vec2 screen) { return perspectiveRay(screen); }\n"
             "float sceneDistance(vec3 p) { return length(p); }\n"
             "vec3 rayColour(Ray ray) { return vec3(%s); }\n",
             colour);
    return scratch_write("shade.frag", text);
}

// Scenes with the same shaders share their renderers, which the scene that stays must get back.
SESSION_TEST(a_scene_stays_when_the_next_one_does_not_compile)
{
    char list[16384];
    const char *path = save_shade("shade");
    snprintf(list, sizeof list,
             "01 --shader %s --set shade=0.2\n01 --shader %s --set shade=0.8 --view normals\n"
             "01 --shader %s --set shade=0.2 --divider 0.9 --compare %s\n"
             "01 --shader %s --set shade=0.8 --divider 0.9 --compare %s\n",
             path, path, path,
             scratch_write("other.frag", "void mainImage(out vec4 c, vec2 p)"
                                         "{ c = vec4(1.0); }"),
             path, scratch_path("other.frag"));
    open_text(list);
    assert_int_equal(grey(), 51);
    key(GLFW_KEY_RIGHT, 0);
    assert_int_equal(grey(), 102); // the value that the speaker has chosen
    capture_begin();
    save_shade("undeclared");
    on();
    turns(60);
    assert_non_null(strstr(capture_end(), "undeclared"));
    assert_int_equal(grey(), 102);
    key(GLFW_KEY_RIGHT, 0);
    assert_int_equal(grey(), 153);
    capture_begin();
    save_shade("shade + 0.0");
    turns(60); // a save still reloads the scene that is shown
    back();
    on();
    save_shade("shade - 0.0");
    on();
    assert_int_equal(grey(), 51);
    key(GLFW_KEY_RIGHT, 0);
    assert_int_equal(grey(), 102);
    turns(60);
    capture_end();
    capture_begin();
    scratch_write("other.frag", "undeclared");
    on(); // the first picture compiles, and the second does not
    assert_non_null(strstr(capture_end(), "other.frag"));
    assert_int_equal(grey(), 102);
    close_list();
}

// A scene has the values of its line, even if its shader was saved since its renderer was made.
SESSION_TEST(a_scene_of_a_saved_shader_has_its_own_values)
{
    char list[8192];
    const char *path = save_shade("shade");
    snprintf(list, sizeof list, "01 --shader %s --set shade=0.2\n01 --shader %s --set shade=0.8\n",
             path, path);
    open_text(list);
    assert_int_equal(grey(), 51);
    save_shade("shade + 0.0");
    on();
    assert_int_equal(grey(), 204);
    close_list();
}

SESSION_TEST(a_bad_list_is_refused_with_its_line)
{
    static const struct {
        const char *text, *why;
        int status;
    } bad[] = {
        {"# nothing\n\n", "list.txt: contains no scene", RUN_WRONG_COMMAND_LINE},
        {"== One\n", "list.txt: contains no scene", RUN_WRONG_COMMAND_LINE},
        {"\n  A sentence.\n", "list.txt:2: a sentence without a scene", RUN_WRONG_COMMAND_LINE},
        {"01\n\n33 --view steps\n", "list.txt:3: '33': no such chapter", RUN_WRONG_COMMAND_LINE},
        {"01\nWhy?\n", "list.txt:2: 'Why?': no such chapter", RUN_WRONG_COMMAND_LINE},
        {"01 --shadow 3\n", "list.txt:1: unknown option '--shadow'", RUN_WRONG_COMMAND_LINE},
        {"01 --set\n", "list.txt:1: --set: a value is missing", RUN_WRONG_COMMAND_LINE},
        {"# one\n01 --set period=3\n", "list.txt:2: --set period=3: unknown parameter",
         RUN_WRONG_COMMAND_LINE},
        {"01 --output a.png\n", "list.txt:1: a scene is shown in a window", RUN_WRONG_COMMAND_LINE},
        {"01 --help\n", "list.txt:1: a scene is shown in a window", RUN_WRONG_COMMAND_LINE},
        {"01 --shader 'my file.frag\n", "list.txt:1: a quote, ', is not closed",
         RUN_WRONG_COMMAND_LINE},
        {"01 --shader 'no file.frag'\n", "list.txt:1: no file.frag: cannot be read", RUN_NOT_DONE},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        static char path[4096];
        snprintf(path, sizeof path, "%s", scratch_write("list.txt", bad[i].text));
        capture_begin();
        int status = read_list(path);
        const char *said = capture_end();
        lecture_close(lecture);
        if (status != bad[i].status || strstr(said, bad[i].why) == NULL || line_count(said) != 1)
            fail_msg("%s: status %d: %s", bad[i].text, status, said);
    }
    capture_begin();
    assert_int_equal(read_list("no/such.txt"), RUN_WRONG_COMMAND_LINE);
    assert_non_null(strstr(capture_end(), "no/such.txt: cannot be read"));
    lecture_close(lecture);
    report("%s", "after a list, messages have no prefix");
    assert_string_equal(report_last(), "after a list, messages have no prefix\n");
}

// Go to the end of the course's own list and a few scenes back, with two keys.
SESSION_TEST(two_keys_are_enough_for_the_lecture)
{
    open_list("docs/lecture.txt");
    capture_begin();
    int presses = 0;
    while (strstr(user.title, "period = 3.5") == NULL && presses++ < 100)
        on();
    assert_in_range(presses, 30, 60);
    key(GLFW_KEY_ESCAPE, 0);
    key(GLFW_KEY_R, 0);
    assert_scene("07_repetition", "--samples 2 --set period=3.5 --time 0");
    while (strstr(user.title, "timeOfDay = 17") == NULL && presses-- > -5)
        back();
    assert_in_range(presses, 0, 5); // a scene with a ray takes more than one press
    key(GLFW_KEY_ESCAPE, 0);
    key(GLFW_KEY_R, 0);
    assert_scene("09_sky_and_sunset", "--samples 2 --set timeOfDay=17 --time 0");
    assert_string_equal(capture_end(), "");
    close_list();
}

// ---- The course ----

static void open_course(const char *first)
{
    for (int i = 0; i < IN_COURSE; i++) {
        chapters[i].stem = chapters[i].title = chapters[i].shows = stems[i];
        assert_true(mirror_camera(gpu_project_root(), stems[i], &chapters[i].camera));
    }
    assert_int_equal(lecture_course(&lecture, first, chapters, IN_COURSE), RUN_DONE);
    assert_int_equal(lecture_open(lecture, false), RUN_DONE);
    assert_false(user.full);
    user_resize(320, 180);
    turns(2);
}

static void assert_chapter(const char *stem)
{
    session_assert_title(stem);
}

SESSION_TEST(the_course_goes_from_chapter_to_chapter)
{
    open_course("01");
    assert_chapter("01_normal_colouring");
    on();
    turns(30);
    assert_chapter("03_shadows");
    back();
    back();
    turns(30);
    assert_chapter("00_first_scene");
    back(); // there is none before it
    assert_string_equal(lecture_window(lecture)->panel.note_heading, "This is the first chapter");
    turns(30);
    assert_chapter("00_first_scene");
    close_list();
}

// Nobody lectures in the course's window, so its black screen says how it ends.
SESSION_TEST(a_reader_finds_back_from_black)
{
    open_course(NULL);
    key(GLFW_KEY_PERIOD, 0);
    assert_true(brightest() > 100);
    session_keep(0);
    key(GLFW_KEY_PERIOD, 0);
    assert_true(session_off(0, (const int[]){0, 0, 320, 150}) > 0.9);
    close_list();
}

static int openings; // frames that said which chapter was being opened

static void count_openings(void)
{
    const struct window *window = lecture_window(lecture);
    const char *heading = window->panel.note_heading;
    openings += window->panel.note[0] != '\0' && heading != NULL && strcmp(heading, "Opening") == 0;
}

// A chapter that takes long to compile is announced, but not one that has been compiled before.
SESSION_TEST(a_chapter_is_announced_before_it_is_compiled)
{
    open_course(NULL);
    user.look = count_openings;
    openings = 0;
    key(GLFW_KEY_HOME, 0);
    for (int i = 0; i < 3; i++)
        key(GLFW_KEY_RIGHT, 0);
    key(GLFW_KEY_ENTER, 0);
    turns(200);
    assert_int_equal(openings, 1);
    assert_string_equal(lecture_window(lecture)->panel.note, "");
    key(GLFW_KEY_PAGE_DOWN, 0); // the next one has been compiled meanwhile
    turns(10);
    assert_int_equal(openings, 1);
    user.look = NULL;
    close_list();
}

// The tooltip belongs to what is under the pointer, which has moved over the sheet of contents.
SESSION_TEST(the_sheet_follows_the_pointer)
{
    open_course("01");
    const struct window *window = lecture_window(lecture);
    const struct panel_row *row = window->panel.rows.row;
    while (row->kind != PANEL_ROW_PARAMETER)
        row++;
    double scale = (double)window->panel.overlay.scale;
    user_point(scale * (double)(row->left + 20.0f), scale * (double)(row->top + 4.0f));
    turns(60);
    assert_true(window->grab.tip);
    key(GLFW_KEY_HOME, 0);
    user_click(40.0, 130.0, GLFW_MOUSE_BUTTON_LEFT); // the first picture of the second row
    turns(60);
    assert_chapter("07_repetition");
    assert_false(window->grab.tip);
    close_list();
}

// The sheet of 7 pictures in a window of 320 x 180 has four columns.
SESSION_TEST(the_sheet_of_contents_opens_a_chapter)
{
    open_course(NULL);
    session_keep(0);
    key(GLFW_KEY_HOME, 0);
    assert_true(session_off(0, NULL) > 0.05);
    key(GLFW_KEY_HOME, 0);
    key(GLFW_KEY_HOME, 0);
    for (int i = 0; i < 9; i++) // the frame stops at the last one
        key(GLFW_KEY_RIGHT, 0);
    key(GLFW_KEY_LEFT, 0);
    key(GLFW_KEY_UP, 0);
    key(GLFW_KEY_DOWN, 0);
    key(GLFW_KEY_DOWN, 0); // there is no third row
    key(GLFW_KEY_ENTER, 0);
    turns(30);
    assert_chapter("09_sky_and_sunset");
    key(GLFW_KEY_Q, 0);    // the last step of a ray
    key(GLFW_KEY_HOME, 0); // its first step
    assert_false(lecture_window(lecture)->contents.open);
    assert_string_equal(lecture_window(lecture)->panel.note, "Home again: all chapters");
    key(GLFW_KEY_HOME, 0);
    assert_true(lecture_window(lecture)->contents.open);
    user_click(40.0, 40.0, GLFW_MOUSE_BUTTON_LEFT); // the first picture of the first row
    turns(30);
    assert_chapter("00_first_scene");
    close_list();
}

TESTS(NULL, NULL)
