// test_options.c - the command line: what each option sets, and one clear line for each mistake.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
// cmocka needs the four above.
#include <cmocka.h>

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "../common/command/options.h"
#include "support_scratch.h"
#include "support_system.h"

#define WORDS 32

// Parse a command line written with blanks between its words; a word of two quotes is empty.
// The words live until the next call.
static bool parse(struct options *options, const char *line)
{
    static char text[4096];
    static char *words[WORDS + 1];
    int count = 0;
    snprintf(text, sizeof text, "program %s", line);
    for (char *word = strtok(text, " "); word != NULL; word = strtok(NULL, " ")) {
        assert_true(count < WORDS);
        if (strcmp(word, "''") == 0)
            word[0] = '\0';
        words[count++] = word;
    }
    words[count] = NULL;
    return options_parse(options, count, words);
}

static struct options parsed(const char *line)
{
    struct options options;
    capture_begin();
    bool done = parse(&options, line);
    const char *said = capture_end();
    if (!done || said[0] != '\0')
        fail_msg("%s: %s", line, said);
    return options;
}

static bool parsed_window(const char *line)
{
    struct options options = parsed(line);
    bool window = options.window;
    options_free(&options);
    return window;
}

static void assert_refused(const char *line, const char *why)
{
    struct options options;
    capture_begin();
    bool done = parse(&options, line);
    const char *said = capture_end();
    if (done)
        fail_msg("not refused: %s", line);
    if (line_count(said) != 1 || strstr(said, why) == NULL)
        fail_msg("%s: not one line with '%s': %s", line, why, said);
    assert_null(options.settings);
}

static void test_overlay(void **state)
{
    (void)state;
    static const struct {
        const char *line;
        double scale;
    } good[] = {
        {"--overlay", 0.0}, {"--overlay=0.5", 0.5}, {"--overlay=8", 8.0}, {"--overlay=1.5", 1.5}};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        struct options o = parsed(good[i].line);
        assert_true(o.has_overlay);
        assert_true(o.overlay == good[i].scale);
        options_free(&o);
    }
    static const char *const bad[] = {"--overlay=0.49", "--overlay=8.01", "--overlay=0",
                                      "--overlay=",     "--overlay=big",  "--overlay=nan",
                                      "--overlay=-1"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_refused(bad[i], "the scale must be a number from 0.5 to 8");
    assert_refused("--overlay 2", "unexpected argument '2'");
}

static void test_defaults(void **state)
{
    (void)state;
    struct options o = parsed("");
    assert_int_equal(o.action, OPTIONS_RUN);
    assert_null(o.output);
    assert_int_equal(o.width, 960);
    assert_int_equal(o.height, 540);
    assert_true(o.time == 0.0);
    assert_int_equal(o.setting_count, 0);
    assert_false(o.has_camera);
    assert_int_equal(o.samples, 1);
    assert_int_equal(o.view, SHADER_PICTURE);
    assert_int_equal(o.probe_count, 0);
    assert_false(o.has_overlay);
    assert_int_equal(o.backend, CONTEXT_ANY);
    assert_null(o.shader);
    assert_null(o.root);
    options_free(&o);
    options_free(&o);
    static const char *const still[] = {"-o a.png", "--probe 639,359"};
    assert_true(parsed_window(""));
    assert_false(parsed_window("--benchmark 2"));
    for (int i = 0; i < 2; i++) {
        o = parsed(still[i]);
        assert_false(o.window);
        assert_int_equal(o.width, 640);
        assert_int_equal(o.height, 360);
        options_free(&o);
    }
}

static void test_every_option(void **state)
{
    (void)state;
    static const char *const lines[] = {
        "-o a.png -s 320x200 -t 1.5 -p a=1 -p b=2,3 -c 1,-2.5,3e0,270,-89 -a 4 -v steps "
        "--probe 319,199 -b osmesa -f my.frag",
        "--output a.png --size 320x200 --time 1.5 --set a=1 --set b=2,3 --camera "
        "1,-2.5,3e0,270,-89 --samples 4",
        "--output=a.png --size=320x200 --time=1.5 --set=a=1 --set=b=2,3 "
        "--camera=1,-2.5,3e0,270,-89 --samples=4 --view=steps --probe=319,199 --backend=osmesa "
        "--shader=my.frag --root=/x",
        "-oa.png -s320x200 -t1.5 -pa=1 -pb=2,3 -c1,-2.5,3e0,270,-89 -a4 -vsteps",
    };
    for (int i = 0; i < 4; i++) {
        struct options o = parsed(lines[i]);
        assert_string_equal(o.output, "a.png");
        assert_int_equal(o.width, 320);
        assert_int_equal(o.height, 200);
        assert_true(o.time == 1.5);
        assert_int_equal(o.setting_count, 2);
        assert_string_equal(o.settings[0], "a=1");
        assert_string_equal(o.settings[1], "b=2,3");
        assert_true(o.has_camera);
        assert_true(o.camera.position[0] == 1.0f && o.camera.position[1] == -2.5f &&
                    o.camera.position[2] == 3.0f);
        assert_true(o.camera.pan == 270.0f && o.camera.tilt == -89.0f);
        assert_int_equal(o.samples, 4);
        assert_int_equal(o.view, i == 1 ? SHADER_PICTURE : SHADER_STEPS);
        if (i == 0 || i == 2) {
            assert_true(o.probe_count == 1 && o.probe[0][0] == 319 && o.probe[0][1] == 199);
            assert_int_equal(o.backend, CONTEXT_OSMESA);
            assert_string_equal(o.shader, "my.frag");
        }
        if (i == 2)
            assert_string_equal(o.root, "/x");
        options_free(&o);
    }
}

static void test_actions(void **state)
{
    (void)state;
    static const struct {
        const char *line;
        enum options_action action;
    } actions[] = {{"--print-shader", OPTIONS_PRINT_SHADER},
                   {"--list", OPTIONS_LIST},
                   {"-h", OPTIONS_HELP},
                   {"--help", OPTIONS_HELP},
                   {"-V", OPTIONS_VERSION},
                   {"--version", OPTIONS_VERSION},
                   {"--help --list", OPTIONS_HELP},
                   {"--list --help", OPTIONS_HELP},
                   {"--list -V", OPTIONS_VERSION}};
    for (size_t i = 0; i < sizeof actions / sizeof *actions; i++) {
        struct options o = parsed(actions[i].line);
        assert_int_equal(o.action, actions[i].action);
        options_free(&o);
    }
}

static void test_last_one_wins(void **state)
{
    (void)state;
    struct options o = parsed("-o a.png -o b.png -s 1x1 -s 16384x16384 -t 1 -t -2 -a 1 -a 8");
    assert_string_equal(o.output, "b.png");
    assert_int_equal(o.width, 16384);
    assert_true(o.time == -2.0);
    assert_int_equal(o.samples, 8);
    options_free(&o);
}

static void test_sizes(void **state)
{
    (void)state;
    static const char *const sizes[] = {
        "0x10", "10x0", "-5x10", "10x-5", "16385x1", "99999x99999", "1x99999999999999999999"};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        char line[64];
        snprintf(line, sizeof line, "-s %s", sizes[i]);
        assert_refused(line, "1 to 16384 pixels");
    }
    static const char *const forms[] = {"12x",   "x12",   "axb",   "12",     "12x12x12", "''",
                                        "1.5x2", "12X12", "0x10x", "1e2x10", "12x12a",   "1-2x3"};
    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
        char line[64];
        snprintf(line, sizeof line, "--size %s", forms[i]);
        assert_refused(line, "WIDTHxHEIGHT");
    }
}

static void test_numbers(void **state)
{
    (void)state;
    static const char *const times[] = {"abc",   "1s", "nan",  "inf", "-inf",
                                        "1e999", "''", "0x10", "1,5"};
    for (size_t i = 0; i < sizeof times / sizeof *times; i++) {
        char line[64];
        snprintf(line, sizeof line, "-t %s", times[i]);
        assert_refused(line, "number of seconds");
    }
    assert_refused("-t 1e10", "1e9");
    assert_refused("-t 0,5", "must be a number of seconds, as in 1.5: write 0.5");
    assert_refused("--frames 2 -o %d.png --fps 12,5", ": write 12.5");
    assert_refused("--overlay=1,5", ": write 1.5");
    static const char *const others[] = {"-a 1,5", "-c 0,5", "-t 1,5,2", "-t 1,x"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        struct options o;
        capture_begin();
        assert_false(parse(&o, others[i]));
        assert_null(strstr(capture_end(), "write"));
    }
    static const char *const samples[] = {"0",   "9",  "-1", "2.5",
                                          "two", "''", "2x", "99999999999999999999"};
    for (size_t i = 0; i < sizeof samples / sizeof *samples; i++) {
        char line[64];
        snprintf(line, sizeof line, "-a %s", samples[i]);
        assert_refused(line, "1 to 8");
    }
}

static void test_cameras(void **state)
{
    (void)state;
    static const char *const forms[] = {"1,2,3,4", "1,2,3,4,5,6", "a,2,3,4,5",   "1,2,3,4,",
                                        "''",      "1,2,3,4,5x",  "1,2,3,4,nan", "1;2;3;4;5"};
    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
        char line[64];
        snprintf(line, sizeof line, "-c %s", forms[i]);
        assert_refused(line, "X,Y,Z,PAN,TILT");
    }
    assert_refused("-c 0,0,0,0,89.5", "from -89 to 89 degrees");
    assert_refused("-c 0,0,0,0,-90", "from -89 to 89 degrees");
    assert_refused("-c 1e999,0,0,0,0", "1e9");
    assert_refused("-c 0,0,0,1e300,0", "1e9");
}

static void test_probes(void **state)
{
    (void)state;
    struct options o = parsed("--probe 0,0 -s 1x1");
    options_free(&o);
    assert_refused("--probe 640,0",
                   "outside the picture of 640x360: X is from 0 to 639, Y from 0 to 359");
    assert_refused("--probe 0,360", "outside");
    assert_refused("--probe -1,0", "outside");
    assert_refused("--probe 10,10 -s 10x20", "outside the picture of 10x20");
    assert_refused("-s 10x10 --probe 99999999999999,0", "outside");
    assert_refused("--probe 1", "X,Y");
    assert_refused("--probe 1,2,3", "X,Y");
    assert_refused("--probe 1.5,2", "X,Y");
    assert_refused("--probe a,b", "X,Y");
}

static void test_names(void **state)
{
    (void)state;
    assert_refused("-v colours", "there are picture, normals, depth, steps, slice");
    assert_refused("-v probe", "no such view");
    assert_refused("-v ''", "no such view");
    assert_refused("-b vulkan", "there are glfw, egl, osmesa");
    assert_refused("-p a", "NAME=VALUE");
    assert_refused("-p =1", "NAME=VALUE");
    static const char *const outputs[] = {"''", "a.txt", "a.frag", "a", ".png", "-", "a.png.jpg"};
    for (size_t i = 0; i < sizeof outputs / sizeof *outputs; i++) {
        char line[64];
        snprintf(line, sizeof line, "-o %s", outputs[i]);
        assert_refused(line, "must name a file that ends in .png");
    }
    struct options o = parsed("-o A.PNG");
    assert_string_equal(o.output, "A.PNG");
    options_free(&o);
    assert_refused("-f ''", "--shader");
    assert_refused("--root ''", "--root");
}

static void test_frames(void **state)
{
    (void)state;
    struct options o = parsed("--frames 100000 --fps 0.5 -o a%05d.png");
    assert_int_equal(o.frames, 100000);
    assert_true(o.fps == 0.5);
    assert_int_equal(o.width, 640);
    options_free(&o);
    o = parsed("--frames 1 -o %d.png");
    assert_true(o.fps == 25.0);
    options_free(&o);
    o = parsed("-o %d.png"); // a name like any other
    assert_int_equal(o.frames, 0);
    options_free(&o);
    assert_refused("--frames 0 -o %d.png", "--frames '0': must be a whole number of pictures");
    assert_refused("--frames 100001 -o %d.png", "from 1 to 100000");
    assert_refused("--frames 2 --fps 0 -o %d.png", "--fps '0'");
    assert_refused("--frames 2 --fps 1000.1 -o %d.png", "from 0.001 to 1000");
    assert_refused("--frames 2", "goes with --output");
    assert_refused("--fps 2 -o %d.png", "goes with --frames");
    assert_refused("--frames 2 -o a.png", "must hold one %d");
    assert_refused("--frames 2 --probe 1,1 -o %d.png", "leave --frames out");
    o = parsed("--frames 2 --probe 1,1 -v slice -o %d.png");
    options_free(&o);
}

// One ray's march, up to a step, or step by step in a film; and from another camera.
static void test_steps(void **state)
{
    (void)state;
    struct options o = parsed("-v slice --step 3 -o a.png");
    assert_int_equal(o.step, 3);
    assert_false(o.walk);
    options_free(&o);
    o = parsed("-o a.png");
    assert_int_equal(o.step, -1);
    assert_false(o.has_from);
    options_free(&o);
    o = parsed("-v plot --step walk --frames 5 -o %d.png");
    assert_true(o.walk);
    assert_int_equal(o.step, -1);
    options_free(&o);
    o = parsed("--probe 1,1 --overlay --step walk --frames 5 -o %d.png");
    options_free(&o);
    o = parsed("--probe 1,1 --overlay --step 0 --from 1,2,3,40,-50 -c 0,0,0,0,0 -o a.png");
    assert_true(o.has_from && o.from.position[2] == 3.0f && o.from.tilt == -50.0f);
    assert_true(o.camera.tilt == 0.0f);
    options_free(&o);
    assert_refused("-v slice --step -1 -o a.png", "--step '-1': must be a whole number from 0");
    assert_refused("-v slice --step 2048 -o a.png", "from 0 to 2047, or walk");
    assert_refused("-v slice --step runs -o a.png", "or walk with --frames");
    assert_refused("-v slice --step 1", "goes with --output");
    assert_refused("--step 1 -o a.png", "goes with --view slice or plot, or with --probe");
    assert_refused("--probe 1,1 --step 1 -o a.png", "--overlay");
    assert_refused("-v slice --step walk -o a.png", "goes with --frames");
    assert_refused("-v slice --step 1 --frames 2 -o %d.png", "--frames wants --step walk");
    assert_refused("--from 0,0,0,0,90 -o a.png", "--from '0,0,0,0,90': the tilt");
    assert_refused("--from 0,0,0,0,0", "goes with --output");
    assert_refused("--from 0,0,0,0,0 -o a.png", "goes with --probe and --overlay");
    assert_refused("-v slice --probe 1,1 --overlay --from 0,0,0,0,0 -o a.png", "no --view of one");
}

static void test_print_shader(void **state)
{
    (void)state;
    struct options o = parsed("--print-shader");
    assert_int_equal(o.action, OPTIONS_PRINT_SHADER);
    assert_false(o.shadertoy);
    options_free(&o);
    o = parsed("--print-shader=shadertoy");
    assert_int_equal(o.action, OPTIONS_PRINT_SHADER);
    assert_true(o.shadertoy);
    options_free(&o);
}

static void test_unknown_options(void **state)
{
    (void)state;
    assert_refused("--nonsense", "unknown option '--nonsense'");
    assert_refused("--nonsense=3", "unknown option '--nonsense'");
    assert_refused("-x", "unknown option '-x'");
    assert_refused("-hx", "unknown option '-x'");
    assert_refused("-1", "unknown option '-1'");
    assert_refused("--bench 3", "unknown option '--bench'");
    assert_refused("--fp 3", "unknown option '--fp'");
    assert_refused("--out a.png", "unknown option '--out'");
    assert_refused("--out=a.png", "unknown option '--out'");
    assert_refused("--out", "unknown option '--out'");
    assert_refused("--s 1x1", "unknown option '--s'");
    assert_refused("--lis", "unknown option '--lis'");
    assert_refused("--lis=3", "unknown option '--lis'");
    assert_refused("--he", "unknown option '--he'");
    assert_refused("--print", "unknown option '--print'");
    assert_refused("--=3", "unknown option '--'");
}

static void test_values_missing_or_too_many(void **state)
{
    (void)state;
    static const char *const names[][2] = {{"-o", "--output"},   {"--size", "--size"},
                                           {"-t", "--time"},     {"--probe", "--probe"},
                                           {"--root", "--root"}, {"-c", "--camera"}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char why[64];
        snprintf(why, sizeof why, "%s: a value is missing", names[i][1]);
        assert_refused(names[i][0], why);
    }
    assert_refused("--list=3", "--list: takes no value");
    assert_refused("--help=3", "--help: takes no value");
    assert_refused("--print-shader=x", "--print-shader 'x': must be shadertoy");
    assert_refused("--print-shader=", "must be shadertoy");
    assert_refused("--print-shader=shadertoy -v steps", "only the picture runs there");
    assert_refused("foo", "unexpected argument 'foo'");
    assert_refused("--list foo -V", "unexpected argument 'foo'");
    assert_refused("-- -o", "unexpected argument '-o'");
    assert_refused("--print-shader shadertoy", "unexpected argument 'shadertoy'");
    struct options o = parsed("-f --size");
    assert_string_equal(o.shader, "--size");
    options_free(&o);
}

// --set before --compare is for both pictures, behind it for the second alone. The file is the next
// word, unless that begins with '-'.
static void test_compare(void **state)
{
    (void)state;
    struct options o = parsed("-p a=1 --compare my.frag -p b=2 -p c=3 -o a.png");
    assert_true(o.compares && o.divider == 0.5);
    assert_string_equal(o.compare, "my.frag");
    assert_int_equal(o.shared_settings, 1);
    assert_int_equal(o.setting_count, 3);
    options_free(&o);
    o = parsed("--compare=my.frag --divider 0.25");
    assert_string_equal(o.compare, "my.frag");
    assert_true(o.divider == 0.25 && o.window && o.shared_settings == 0);
    options_free(&o);
    o = parsed("--divider=0 -f x.frag --compare -p b=2");
    assert_true(o.compares && o.compare == NULL && o.divider == 0.0 && o.shared_settings == 0);
    options_free(&o);
    o = parsed("-p a=1 -p b=1");
    assert_true(!o.compares && o.shared_settings == 2);
    options_free(&o);
    assert_refused("--compare", "--set NAME=VALUE behind it");
    assert_refused("-p a=1 --compare", "--set NAME=VALUE behind it");
    assert_refused("--compare ''", "must name a file");
    assert_refused("--compare a.frag --compare b.frag", "give it once");
    assert_refused("--divider 0.3", "goes with --compare");
    assert_refused("--compare a.frag --divider 1.01", "from 0 to 1");
    assert_refused("--compare a.frag --divider 0,3", "write 0.3");
    assert_refused("--compare a.frag --divider x", "share of the width");
    assert_refused("--compare a.frag --benchmark 3", "leave --benchmark out");
    assert_refused("--compare a.frag --print-shader", "leave --print-shader out");
    assert_refused("--compare a.frag b.frag", "unexpected argument 'b.frag'");
}

// A probe of the slice view chooses its ray: it must lie in the picture that is written.
static void test_slice_takes_a_probe(void **state)
{
    (void)state;
    struct options o = parsed("-v slice --probe 3,4 -o a.png");
    assert_int_equal(o.view, SHADER_SLICE);
    assert_true(o.probe_count == 1 && o.probe[0][0] == 3 && o.probe[0][1] == 4);
    assert_string_equal(o.output, "a.png");
    options_free(&o);
    o = parsed("--view=slice");
    assert_int_equal(o.view, SHADER_SLICE);
    assert_int_equal(o.probe_count, 0);
    options_free(&o);
    assert_refused("-v slice -s 16x9 -o a.png --probe 16,0", "outside the picture");
    assert_refused("-v slices", "slice");
}

static void test_several_probes(void **state)
{
    (void)state;
    struct options o = parsed("--probe 3,4 -s 16x9 --probe=15,8");
    assert_int_equal(o.probe_count, 2);
    assert_true(o.probe[0][0] == 3 && o.probe[0][1] == 4);
    assert_true(o.probe[1][0] == 15 && o.probe[1][1] == 8);
    options_free(&o);
    assert_refused("-s 16x9 --probe 16,0 --probe 1,1", "--probe '16,0': outside the picture");
    assert_refused("-s 16x9 --probe 1,1 --probe 1,9", "--probe '1,9': outside the picture");
}

static void test_pictures(void **state)
{
    (void)state;
    struct options o = parsed("--texture a=b.png --texture a=c=d --channel 2=x.png --channel 2=y");
    assert_int_equal(o.texture_count, 2);
    assert_string_equal(o.textures[0], "a=b.png");
    assert_string_equal(o.textures[1], "a=c=d");
    assert_string_equal(o.channels[2], "y");
    assert_true(o.channels[0] == NULL && o.channels[1] == NULL && o.channels[3] == NULL);
    options_free(&o);
    assert_null(o.textures);
    static const char *const wrong[] = {"--texture a", "--texture =b",
                                        "--texture a=", "--texture ''"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_refused(wrong[i], "must be NAME=FILE.png");
    static const char *const none[] = {
        "--channel 4=a", "--channel 0",    "--channel 0=",  "--channel ''",
        "--channel =a",  "--channel -1=a", "--channel 10=a"};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        assert_refused(none[i], "must be N=FILE.png");
}

static void test_help_names_every_option(void **state)
{
    (void)state;
    static const char *const words[] = {"Usage: ./prog ",       "A title",
                                        "What it shows.",       "-o, --output FILE.png",
                                        "-s, --size WxH",       "-t, --time SECONDS",
                                        "--texture NAME=FILE",  "--channel N=FILE",
                                        "-p, --set NAME=VALUE", "-c, --camera X,Y,Z,PAN,TILT",
                                        "-a, --samples N",      "-v, --view NAME",
                                        "--probe X,Y",          "-b, --backend NAME",
                                        "-f, --shader FILE",    "--root DIR",
                                        "--print-shader",       "--list",
                                        "-h, --help",           "-V, --version",
                                        "Exit status: 0",       "W A S D",
                                        "--compare [FILE]",     "--divider SHARE"};
    char help[8192];
    FILE *file = system_open_scratch();
    options_print_help(file, "./prog", "A title", "What it shows.");
    rewind(file);
    size_t size = fread(help, 1, sizeof help - 1, file);
    help[size] = '\0';
    fclose(file);
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strstr(help, words[i]) == NULL)
            fail_msg("'%s' is missing", words[i]);
    for (const char *c = help; *c != '\0'; c += strcspn(c, "\n") + 1)
        assert_true(strcspn(c, "\n") <= 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_defaults),
        cmocka_unit_test(test_overlay),
        cmocka_unit_test(test_compare),
        cmocka_unit_test(test_every_option),
        cmocka_unit_test(test_actions),
        cmocka_unit_test(test_last_one_wins),
        cmocka_unit_test(test_sizes),
        cmocka_unit_test(test_numbers),
        cmocka_unit_test(test_cameras),
        cmocka_unit_test(test_probes),
        cmocka_unit_test(test_names),
        cmocka_unit_test(test_frames),
        cmocka_unit_test(test_print_shader),
        cmocka_unit_test(test_unknown_options),
        cmocka_unit_test(test_values_missing_or_too_many),
        cmocka_unit_test(test_pictures),
        cmocka_unit_test(test_help_names_every_option),
        cmocka_unit_test(test_slice_takes_a_probe),
        cmocka_unit_test(test_steps),
        cmocka_unit_test(test_several_probes),
    };
    return cmocka_run_group_tests_name("options", tests, NULL, NULL);
}
