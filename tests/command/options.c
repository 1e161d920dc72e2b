// options.c - tests of the command line: what each option sets, and that each mistake is reported
// in one clear line.
#include "lib/test.h"
#include "command/options.h"
#include "lib/scratch.h"
#include "lib/system.h"

// Parse a command line. The words are valid until the next call.
static bool parse(struct options *options, const char *line)
{
    static char text[4096];
    static char *words[OPTIONS_WORDS + 1];
    snprintf(text, sizeof text, "program %s", line);
    int count = options_split(text, words);
    assert_true(count > 0);
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

// Assert that the command line is accepted, and that its options, o, satisfy the condition.
#define ACCEPTED(line, condition)                                                                  \
    do {                                                                                           \
        struct options o = parsed(line);                                                           \
        if (!(condition))                                                                          \
            fail_msg("%s: not %s", line, #condition);                                              \
        options_free(&o);                                                                          \
    } while (false)

static bool same(const char *a, const char *b)
{
    return a != NULL && strcmp(a, b) == 0;
}

// ---- What the options set ----

TEST(nothing_given_means_the_defaults)
{
    struct options given = parsed("");
    assert_int_equal(given.action, OPTIONS_RUN);
    assert_true(given.window && given.output == NULL && given.shader == NULL && given.root == NULL);
    assert_true(given.width == 960 && given.height == 540 && given.time == 0.0 &&
                given.samples == 1);
    assert_true(given.setting_count == 0 && given.probe_count == 0 && given.frames == 0 &&
                given.step == -1);
    assert_true(!given.has_camera && !given.has_from && !given.has_overlay && !given.compares &&
                !given.shadertoy);
    assert_int_equal(given.view, VIEW_PICTURE);
    assert_int_equal(given.backend, CONTEXT_ANY);
    options_free(&given);
    options_free(&given);
    ACCEPTED("-o a.png", !o.window && o.width == 640 && o.height == 360);
    ACCEPTED("--probe 639,359", !o.window && o.width == 640 && o.height == 360);
    ACCEPTED("--benchmark 2", !o.window);
}

TEST(options_have_long_and_short_spellings)
{
    static const char *const lines[] = {
        "-o a.png -s 320x200 -t 1.5 -p a=1 -p b=2,3 -c 1,-2.5,3e0,270,-89 -a 4 -v steps "
        "--probe 319,199 -b osmesa -f my.frag",
        "--output a.png --size 320x200 --time 1.5 --set a=1 --set b=2,3 --camera "
        "1,-2.5,3e0,270,-89 --samples 4 --view steps --probe 319,199 --backend osmesa --shader "
        "my.frag",
        "--output=a.png --size=320x200 --time=1.5 --set=a=1 --set=b=2,3 "
        "--camera=1,-2.5,3e0,270,-89 --samples=4 --view=steps --probe=319,199 --backend=osmesa "
        "--shader=my.frag --root=/x",
        "-oa.png -s320x200 -t1.5 -pa=1 -pb=2,3 -c1,-2.5,3e0,270,-89 -a4 -vsteps --probe 319,199 "
        "-bosmesa -fmy.frag",
    };
    for (int i = 0; i < 4; i++) {
        struct options o = parsed(lines[i]);
        assert_string_equal(o.output, "a.png");
        assert_true(o.width == 320 && o.height == 200 && o.time == 1.5 && o.samples == 4);
        assert_int_equal(o.setting_count, 2);
        assert_string_equal(o.settings[0], "a=1");
        assert_string_equal(o.settings[1], "b=2,3");
        const struct camera *c = &o.camera;
        assert_true(o.has_camera && c->position[0] == 1.0f && c->position[1] == -2.5f &&
                    c->position[2] == 3.0f && c->pan == 270.0f && c->tilt == -89.0f);
        assert_int_equal(o.view, VIEW_STEPS);
        assert_true(o.probe_count == 1 && o.probe[0][0] == 319 && o.probe[0][1] == 199);
        assert_int_equal(o.backend, CONTEXT_OSMESA);
        assert_string_equal(o.shader, "my.frag");
        assert_true(i != 2 || same(o.root, "/x"));
        options_free(&o);
    }
    ACCEPTED("-o a.png -o b.png -s 1x1 -s 16384x16384 -t 1 -t -2 -a 1 -a 8", // the last one counts
             same(o.output, "b.png") && o.width == 16384 && o.time == -2.0 && o.samples == 8);
    ACCEPTED("--include a --include ../b", same(o.include, "../b"));
    ACCEPTED("-f --size", same(o.shader, "--size"));
    ACCEPTED("-o A.PNG", same(o.output, "A.PNG"));
}

TEST(help_has_priority_and_otherwise_the_last_action_counts)
{
    static const struct {
        const char *line;
        enum options_action action;
    } actions[] = {{"--print-shader", OPTIONS_PRINT_SHADER},
                   {"--print-shader=shadertoy", OPTIONS_PRINT_SHADER},
                   {"--print-shader=page", OPTIONS_PRINT_SHADER},
                   {"--print-shader=page --print-shader=shadertoy", OPTIONS_PRINT_SHADER},
                   {"--list", OPTIONS_LIST},
                   {"-h", OPTIONS_HELP},
                   {"--help", OPTIONS_HELP},
                   {"-V", OPTIONS_VERSION},
                   {"--version", OPTIONS_VERSION},
                   {"--help --list", OPTIONS_HELP},
                   {"--list --help", OPTIONS_HELP},
                   {"--list -V", OPTIONS_VERSION}};
    for (size_t i = 0; i < sizeof actions / sizeof *actions; i++) {
        const bool toy = strstr(actions[i].line, "shadertoy") != NULL;
        const bool page = !toy && strstr(actions[i].line, "page") != NULL;
        ACCEPTED(actions[i].line,
                 o.action == actions[i].action && o.shadertoy == toy && o.page == page);
    }
}

TEST(the_scale_of_the_overlay_is_optional)
{
    ACCEPTED("--overlay", o.has_overlay && o.overlay == 0.0);
    ACCEPTED("--overlay=0.5", o.has_overlay && o.overlay == 0.5);
    ACCEPTED("--overlay=8", o.has_overlay && o.overlay == 8.0);
}

TEST(a_film_has_frames_and_a_rate)
{
    ACCEPTED("--frames 100000 --fps 0.5 -o a%05d.png",
             o.frames == 100000 && o.fps == 0.5 && o.width == 640);
    ACCEPTED("--frames 1 -o %d.png", o.fps == 0.0); // the shader decides
    ACCEPTED("--frames 100-199 -o %d.png", o.first_frame == 100 && o.frames == 200);
    ACCEPTED("--frames 7-7 --frames 3 -o %d.png", o.first_frame == 0 && o.frames == 3);
    ACCEPTED("--frame 99999 --fps 2 -o a.png", o.has_frame && o.frame == 99999 && o.fps == 2.0);
    ACCEPTED("--frame 0", o.window && o.has_frame && o.frame == 0);
    ACCEPTED("-o %d.png", o.frames == 0); // without --frames, %d is an ordinary part of a name
    ACCEPTED("--frames 2 --probe 1,1 -v slice -o %d.png", o.frames == 2);
}

// The march of one ray can be shown up to a step, step by step in a film, or from another camera.
TEST(a_march_can_be_shown_step_by_step)
{
    ACCEPTED("-v slice --step 3 -o a.png", o.step == 3 && !o.walk);
    ACCEPTED("-v slice --step 1", o.step == 1 && o.window);
    ACCEPTED("-v plot --step walk --frames 5 -o %d.png", o.step == -1 && o.walk);
    ACCEPTED("--probe 1,1 --overlay --step walk --frames 5 -o %d.png", o.walk);
    ACCEPTED("--probe 1,1 --overlay --step 0 --from 1,2,3,40,-50 -c 0,0,0,0,0 -o a.png",
             o.has_from && o.from.position[2] == 3.0f && o.from.tilt == -50.0f &&
                 o.camera.tilt == 0.0f);
    ACCEPTED("-v slice --probe 3,4 -o a.png", o.view == VIEW_SLICE && o.probe_count == 1 &&
                                                  o.probe[0][0] == 3 && o.probe[0][1] == 4);
    ACCEPTED("--probe 3,4 -s 16x9 --probe=15,8",
             o.probe_count == 2 && o.probe[0][0] == 3 && o.probe[1][0] == 15 && o.probe[1][1] == 8);
}

// A --set before --compare applies to both pictures; a later one applies only to the second. The
// file of --compare is the next word, unless that word begins with '-'.
TEST(a_comparison_has_a_file_or_values)
{
    ACCEPTED("-p a=1 --compare my.frag -p b=2 -p c=3 -o a.png",
             o.compares && o.divider == 0.5 && same(o.compare, "my.frag") &&
                 o.shared_settings == 1 && o.setting_count == 3);
    ACCEPTED("--compare=my.frag --divider 0.25",
             same(o.compare, "my.frag") && o.divider == 0.25 && o.window && !o.shared_settings);
    ACCEPTED("--labels wrong,right --compare my.frag", same(o.labels, "wrong,right"));
    ACCEPTED("--divider=0 -f x.frag --compare -p b=2",
             o.compares && o.compare == NULL && o.divider == 0.0 && !o.shared_settings);
    ACCEPTED("-p a=1 -p b=1", !o.compares && o.shared_settings == 2);
}

TEST(a_stroke_is_an_amount_and_points)
{
    struct options o = parsed("--stroke 0.09,-0.5,0,1e-1 --stroke=-.1,1,2,3,4,5,6.00004");
    const struct stroke *one = &o.strokes.item[0], *two = &o.strokes.item[1];
    assert_true(o.strokes.count == 2 && one->points == 1 && two->points == 2);
    assert_true(one->amount == 0.09 && one->point[0][0] == -0.5 && one->point[0][2] == 0.1);
    assert_true(two->amount == -0.1 && two->point[0][1] == 2.0 && two->point[1][2] == 6.0);
    char *text = stroke_text(two);
    assert_string_equal(text, "-0.1,1,2,3,4,5,6");
    free(text);
    options_free(&o);
    assert_null(o.strokes.item);
}

TEST(textures_and_channels_have_files)
{
    struct options o = parsed("--texture a=b.png --texture a=c=d --channel 2=x.png --channel 2=y");
    assert_true(o.texture_count == 2 && same(o.textures[0], "a=b.png"));
    assert_string_equal(o.textures[1], "a=c=d");
    assert_true(same(o.channels[2], "y") && !o.channels[0] && !o.channels[1] && !o.channels[3]);
    options_free(&o);
    assert_null(o.textures);
}

// ---- What is refused ----

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

// A command line that consists of the given beginning and any one of the words is refused.
TEST(values_out_of_range_are_refused)
{
    static const struct {
        const char *begin, *words, *why;
    } refused[] = {
        {"--overlay=", "0.49 8.01 0 big nan -1", "the scale must be a number between 0.5 and 8"},
        {"-s ", "0x10 10x0 -5x10 10x-5 16385x1 99999x99999 1x99999999999999999999",
         "between 1 and 16384 pixels"},
        {"--size ", "12x x12 axb 12 12x12x12 '' 1.5x2 12X12 0x10x 1e2x10 12x12a 1-2x3",
         "WIDTHxHEIGHT"},
        {"-t ", "abc 1s nan inf -inf 1e999 '' 0x10 1,5", "number of seconds"},
        {"-a ", "0 9 -1 2.5 two '' 2x 99999999999999999999", "between 1 and 8"},
        {"-c ",
         "1,2,3,4 1,2,3,4,5,6 a,2,3,4,5 1,2,3,4, '' 1,2,3,4,5x 1,2,3,4,nan 1;2;3;4;5 "
         "1,2,inf,4,5",
         "X,Y,Z,PAN,TILT"},
        {"-c ", "0,0,0,0,89.5 0,0,0,0,-90", "between -89 and 89 degrees"},
        {"-c ", "1e999,0,0,0,0 0,0,0,1e300,0", "1e9"},
        {"--probe ", "0,360 -1,0 0,-1", "outside"},
        {"--probe ", "1 1,2,3 1.5,2 a,b", "X,Y"},
        {"-v ", "probe slices ''", "unknown view"},
        {"-p ", "a =1", "NAME=VALUE"},
        {"-o ", "'' a.txt a.frag a .png - a.png.jpg", "must name a file that ends in .png"},
        {"--benchmark ", "0 -1 1.5 x '' 10001 yaml", "whole number of frames"},
        {"--stroke ", "a 1 1,2,3 1,2,3,4,5 1,2,3,x 1,2,3,4, 1,2,3,1e10 nan,1,2,3",
         "must be AMOUNT,X,Y,Z"},
        {"--texture ", "a =b a= ''", "must be NAME=FILE.png"},
        {"--channel ", "4=a 0 0= '' =a -1=a 10=a", "must be N=FILE.png"},
    };
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        char words[256], line[128], *rest = words;
        snprintf(words, sizeof words, "%s", refused[i].words);
        for (char *word = strtok_r(rest, " ", &rest); word; word = strtok_r(NULL, " ", &rest)) {
            snprintf(line, sizeof line, "%s%s", refused[i].begin, word);
            assert_refused(line, refused[i].why);
        }
    }
}

static const char *const mistakes[][2] = {
    {"--overlay=", "the scale must be a number between 0.5 and 8"},
    {"--overlay 2", "unexpected argument '2'"},
    {"-t 1e10", "1e9"},
    // Numbers with a decimal comma.
    {"-t 0,5", "must be a number of seconds, as in 1.5: write 0.5"},
    {"--frames 2 -o %d.png --fps 12,5", ": write 12.5"},
    {"--overlay=1,5", ": write 1.5"},
    {"--compare a.frag --divider 0,3", "write 0.3"},
    // Pixels outside the picture.
    {"--probe 640,0",
     "outside the picture of 640x360: X must be between 0 and 639, Y between 0 and 359"},
    {"--probe 10,10 -s 10x20", "outside the picture of 10x20"},
    {"-s 10x10 --probe 99999999999999,0", "outside"},
    {"-v slice -s 16x9 -o a.png --probe 16,0", "outside the picture"},
    {"-s 16x9 --probe 16,0 --probe 1,1", "--probe '16,0': outside the picture"},
    {"-s 16x9 --probe 1,1 --probe 1,9", "--probe '1,9': outside the picture"},
    // Unknown or empty names.
    {"-v colours", "the views are picture, normals, depth, steps, slice"},
    {"-b vulkan", "use glfw, egl or osmesa"},
    {"-f ''", "--shader"},
    {"--root ''", "--root"},
    {"--include ''", "--include"},
    // Films and steps.
    {"--frames 0 -o %d.png", "--frames '0': must be a whole number of pictures"},
    {"--frames 100001 -o %d.png", "between 1 and 100000"},
    {"--frames 5-3 -o %d.png", "the first and the last picture of a part"},
    {"--frames 3- -o %d.png", "the first and the last picture of a part"},
    {"--frames 0-100000 -o %d.png", "counted from 0 to 99999"},
    {"--frames 1-2 --step walk -v plot -o %d.png", "requires --frames N"},
    {"--probe 99999999999999999999,0", "--probe '99999999999999999999,0'"},
    {"--frames 2 --fps 0 -o %d.png", "--fps '0'"},
    {"--frames 2 --fps 1000.1 -o %d.png", "between 0.001 and 1000"},
    {"--frames 2", "requires --output"},
    {"--fps 2 -o %d.png", "requires --frames"},
    {"--frames 2 -o a.png", "must contain one %d"},
    {"--frame -1 -o a.png", "--frame '-1': must be a whole number between 0 and 99999"},
    {"--frame 100000 -o a.png", "between 0 and 99999"},
    {"--frame 1 --frames 2 -o %d.png", "--frame: cannot be combined with --frames"},
    {"--frame 99999 --fps 0.001 -t 1e9 -o a.png", "--frame: the last time"},
    {"--frames 2 --probe 1,1 -o %d.png", "cannot be combined with --frames"},
    {"-v slice --step -1 -o a.png", "--step '-1': must be a whole number between 0"},
    {"-v slice --step 2048 -o a.png", "between 0 and 2047, or walk"},
    {"-v slice --step runs -o a.png", "or walk with --frames"},
    {"-v slice --step 1 --benchmark 2", "requires --output"},
    {"-v slice --step walk", "requires --output"},
    {"--step 1 -o a.png", "requires --view slice or plot, or --probe"},
    {"--probe 1,1 --step 1 -o a.png", "--overlay"},
    {"-v slice --step walk -o a.png", "requires --frames"},
    {"-v slice --step 1 --frames 2 -o %d.png", "use --step walk"},
    {"--from 0,0,0,0,90 -o a.png", "--from '0,0,0,0,90': the tilt"},
    {"--from 0,0,0,0,0", "requires --output"},
    {"--from 0,0,0,0,0 -o a.png", "requires --probe and --overlay"},
    {"-v slice --probe 1,1 --overlay --from 0,0,0,0,0 -o a.png", "cannot be combined with --view"},
    // Two options that exclude each other.
    {"--benchmark 3 -o a.png", "cannot be combined with --output"},
    {"--benchmark 3 --probe 1,1", "cannot be combined with --probe"},
    {"--print-shader=shadertoy -v steps", "only the picture view runs on Shadertoy"},
    {"--print-shader=page -v steps", "only the picture view runs in a page"},
    {"--compare a.frag --benchmark 3", "cannot be combined with --benchmark"},
    {"--compare a.frag --print-shader", "cannot be combined with --print-shader"},
    // Comparisons that are incomplete or malformed.
    {"--compare", "--set NAME=VALUE after it"},
    {"-p a=1 --compare", "--set NAME=VALUE after it"},
    {"--compare ''", "must name a file"},
    {"--compare a.frag --compare b.frag", "can be given only once"},
    {"--compare a.frag b.frag", "unexpected argument 'b.frag'"},
    {"--divider 0.3", "requires --compare"},
    {"--labels a,b", "--labels: requires --compare"},
    {"--compare a.frag --labels right", "two names with a comma"},
    {"--compare a.frag --divider 1.01", "between 0 and 1"},
    {"--compare a.frag --divider x", "fraction of the width"},
    // Unknown options; a prefix of a name is not a name.
    {"--nonsense", "unknown option '--nonsense'"},
    {"--nonsense=3", "unknown option '--nonsense'"},
    {"-x", "unknown option '-x'"},
    {"-hx", "unknown option '-x'"},
    {"-1", "unknown option '-1'"},
    {"--bench 3", "unknown option '--bench'"},
    {"--out=a.png", "unknown option '--out'"},
    {"--out", "unknown option '--out'"},
    {"--lis", "unknown option '--lis'"},
    {"--lis=3", "unknown option '--lis'"},
    {"--=3", "unknown option '--'"},
    // A value that is missing, or that is not expected.
    {"-o", "--output: a value is missing"},
    {"--size", "--size: a value is missing"},
    {"--probe", "--probe: a value is missing"},
    {"-c", "--camera: a value is missing"},
    {"--list=3", "--list: takes no value"},
    {"--help=3", "--help: takes no value"},
    {"--print-shader=x", "--print-shader 'x': must be shadertoy or page"},
    {"--print-shader=", "must be shadertoy or page"},
    {"--print-shader shadertoy", "unexpected argument 'shadertoy'"},
    {"--list foo -V", "unexpected argument 'foo'"},
    {"-- -o", "unexpected argument '-o'"},
};

TEST(each_mistake_is_reported_in_one_line)
{
    for (size_t i = 0; i < sizeof mistakes / sizeof *mistakes; i++)
        assert_refused(mistakes[i][0], mistakes[i][1]);
}

// A comma is not taken for a decimal comma where an integer or a list is expected, or where the
// rest is not a number.
TEST(a_decimal_comma_is_not_guessed)
{
    static const char *const lines[] = {"-a 1,5", "-c 0,5", "-t 1,5,2", "-t 1,x"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        struct options o;
        capture_begin();
        assert_false(parse(&o, lines[i]));
        assert_null(strstr(capture_end(), "write"));
    }
}

TEST(the_help_names_the_options)
{
    static const char *const words[] = {"Usage: ./prog ",      "A title",
                                        "What it shows.",      "--output FILE.png",
                                        "--size WxH",          "--time SECONDS",
                                        "--texture NAME=FILE", "--channel N=FILE",
                                        "--set NAME=VALUE",    "--camera X,Y,Z,PAN,TILT",
                                        "--samples N",         "--view NAME",
                                        "--probe X,Y",         "--backend NAME",
                                        "--shader FILE",       "--root DIR",
                                        "--print-shader",      "--list",
                                        "-h, --help",          "-V, --version",
                                        "Exit status: 0",      "W A S D",
                                        "--compare [FILE]",    "--divider FRACTION",
                                        "--include DIR"};
    char help[8192];
    FILE *file = system_open_scratch();
    options_print_help(file, "./prog", "A title", "What it shows.");
    rewind(file);
    help[fread(help, 1, sizeof help - 1, file)] = '\0';
    fclose(file);
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strstr(help, words[i]) == NULL)
            fail_msg("'%s' is missing", words[i]);
    for (const char *c = help; *c != '\0'; c += strcspn(c, "\n") + 1)
        assert_true(strcspn(c, "\n") <= 100);
}

TEST(a_line_is_split_as_a_shell_does)
{
    char line[] = " 03  --set\t'a b'\n-o \"it's\"x'' ''", *word[OPTIONS_WORDS + 1];
    static const char *const words[] = {"03", "--set", "a b", "-o", "it'sx", ""};
    assert_int_equal(options_split(line, word), 6);
    for (int i = 0; i < 6; i++)
        assert_string_equal(word[i], words[i]);
    assert_null(word[6]);
    char blank[] = " \t", open[] = "a 'b", many[2 * OPTIONS_WORDS + 3];
    assert_int_equal(options_split(blank, word), 0);
    for (int i = 0; i <= OPTIONS_WORDS; i++)
        snprintf(many + 2 * i, sizeof many - 2 * (size_t)i, "a ");
    many[2 * OPTIONS_WORDS] = '\0';
    assert_int_equal(options_split(many, word), OPTIONS_WORDS);
    for (int i = 0; i <= OPTIONS_WORDS; i++)
        snprintf(many + 2 * i, sizeof many - 2 * (size_t)i, "a ");
    capture_begin();
    assert_int_equal(options_split(open, word), -1);
    assert_int_equal(options_split(many, word), -1);
    assert_string_equal(capture_end(), "a quote, ', is not closed\na line has at most 64 words\n");
}

TESTS(NULL, NULL)
