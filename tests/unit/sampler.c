// sampler.c - tests annotated samplers: how their comments are read, where the program looks for
// their files, which error is reported for which line, and how the command line replaces pictures.
#include "lib/test.h"

#include "shader/compile.h"
#include "shader/parameter.h"
#include "lib/scratch.h"
#include "lib/system.h"

static struct shader_source source;
static struct parameters parameters;
static bool has_link; // the system supports symbolic links

// The PNG files are empty, because reading a sampler does not check that its file is a picture.
static int set_up(void **state)
{
    scratch_setup(state);
    scratch_write("root/shaders/lib.glsl",
                  "// lib\nuniform sampler2D l; // \"l.png\" sRGB clamp: x\n");
    scratch_write("root/shaders/l.png", "");
    scratch_write("root/shaders/textures/stone.png", "");
    scratch_write("root/shaders/textures/both.png", "");
    scratch_write("own/both.png", "");
    scratch_write("own/deep/far.png", "");
    scratch_write("outside.png", "");
    has_link = system_make_link(scratch_path("outside.png"), scratch_path("own/link.png"));
    return 0;
}

static void forget(void)
{
    shader_free(&source);
    parameters_free(&parameters);
}

// Read a text as own/my.frag. Returns what was reported.
//   done  receives whether the text and its parameters were read
static const char *read_asked(const char *text, const struct shader_request *request, bool *done)
{
    const char *path = scratch_write("own/my.frag", text);
    forget();
    capture_begin();
    *done = shader_read_asked(&source, path, scratch_path("root"), request) &&
            parameters_read(&parameters, &source);
    return capture_end();
}

static const struct samplers *samplers_of(const char *text, const struct shader_request *request)
{
    bool done;
    const char *said = read_asked(text, request, &done);
    if (!done || said[0] != '\0')
        fail_msg("%s: %s", text, said);
    return &parameters.samplers;
}

static void assert_refused(const char *text, const char *where, const char *why)
{
    bool done;
    const char *said = read_asked(text, NULL, &done);
    if (done || line_count(said) != 1 || strstr(said, where) == NULL || strstr(said, why) == NULL)
        fail_msg("%s: expected one line with '%s' and '%s', not: %s", text, where, why, said);
    assert_true(parameters.samplers.item == NULL && parameters.item == NULL);
}

TEST(test_all_parts_are_read)
{
    const struct samplers *read = samplers_of(
        "#include \"lib.glsl\"\n"
        "uniform sampler2D stone;   // \"stone.png\" sRGB repeat: grey: from above\n"
        "uniform float f; // 1 in [0, 2]: a parameter\n"
        "  uniform  highp sampler3D\tv ; //\"both.png\"  linear\tclamp  64 :\xC2\xA0 slices \n"
        "uniform mediump sampler2D w;//\"deep/far.png\"linear repeat:w\n"
        "uniform highp usampler2D table; // \"stone.png\": whole numbers\n",
        NULL);
    assert_int_equal(read->count, 5);
    assert_int_equal(parameters.count, 1);
    static const char *const names[] = {"l", "stone", "v", "w", "table"};
    static const char *const files[] = {"root/shaders/l.png", "root/shaders/textures/stone.png",
                                        "own/both.png", "own/deep/far.png",
                                        "root/shaders/textures/stone.png"};
    static const char *const meanings[] = {"x", "grey: from above", "slices", "w", "whole numbers"};
    static const int slices[] = {0, 0, 64, 0, 0};
    static const bool srgb[] = {true, true, false, false, false},
                      repeat[] = {false, true, false, true, false};
    for (int i = 0; i < 5; i++) {
        const struct sampler *s = &read->item[i];
        assert_string_equal(s->name, names[i]);
        assert_string_equal(source.paths[s->file], scratch_path(files[i]));
        assert_string_equal(s->meaning, meanings[i]);
        assert_int_equal(s->slices, slices[i]);
        assert_true(s->srgb == srgb[i] && s->repeat == repeat[i] && s->words == (i == 4));
    }
    // The pictures are files of the source, so a window watches them, and no output overwrites
    // them.
    assert_int_equal(source.file_count, 6);
    assert_string_equal(source.files[read->item[1].file], "shaders/textures/stone.png");
}

TEST(test_other_texts_declare_no_sampler)
{
    const struct samplers *read = samplers_of("#if 0\nuniform sampler2D a;\n#endif\n"
                                              "// uniform sampler2D b;\n"
                                              "/* uniform sampler2D c; */\n"
                                              "uniform sampler2D iMarch;\n"
                                              "uniform sampler2D iCoarse;\n"
                                              "uniform sampler2D iSigns;\n"
                                              "precision highp sampler3D;\n"
                                              "#if 0\n#define MORE uniform sampler2D d;\n#endif\n"
                                              "#define READ vec4 g(sampler2D x, sampler3D y)\n"
                                              "vec4 read(sampler2D e, const in sampler2D h) "
                                              "{ return vec4(0.0); }\n"
                                              "uniform float sampler;\n",
                                              NULL);
    assert_int_equal(read->count, 0);
}

// Mistakes in a declaration, and a part of the message for each mistake.
static const char *const wrong[][2] = {
    {"uniform sampler2D a;", "no picture is named"},
    {"uniform sampler2D a; // a stone", "no picture is named"},
    {"uniform sampler2D a; /* \"stone.png\" sRGB repeat: x */", "no picture is named"},
    {"uniform sampler2D a; // stone.png sRGB repeat: x", "no picture is named"},
    {"uniform sampler2D a; // \"stone.png sRGB repeat: x", "no closing quote"},
    {"uniform sampler2D a; // \"\" sRGB repeat: x", "file's name is missing"},
    {"uniform sampler2D a; // \" \" sRGB repeat: x", "file's name is missing"},
    {"uniform sampler2D a; // \"stone.png\"", "sRGB or linear is missing"},
    {"uniform sampler2D a; // \"stone.png\": x", "sRGB or linear is missing"},
    {"uniform sampler2D a; // \"stone.png\" repeat: x", "'repeat' is not understood"},
    {"uniform sampler2D a; // \"stone.png\" sRBG repeat: x", "'sRBG' is not understood"},
    {"uniform sampler2D a; // \"stone.png\" srgb repeat: x", "'srgb' is not understood"},
    {"uniform sampler2D a; // \"stone.png\" sRGBrepeat: x", "'sRGBrepeat' is not understood"},
    {"uniform sampler2D a; // \"stone.png\" sRGB: x", "repeat or clamp is missing"},
    {"uniform sampler2D a; // \"stone.png\" sRGB mirror: x", "'mirror' is not understood"},
    {"uniform sampler2D a; // \"stone.png\" sRGB repeat clamp: x", "'clamp: x' is not"},
    {"uniform sampler2D a; // \"stone.png\" sRGB repeat", "meaning is missing"},
    {"uniform sampler2D a; // \"stone.png\" sRGB repeat:  ", "meaning is missing"},
    {"uniform sampler2D a; // \"stone.png\" sRGB repeat 4: x", "has no slices"},
    {"uniform sampler2D a; // the last frame", "define vec4 frameKept(vec2 pixel)"},
    {"uniform sampler3D a; // the last frame", "is no volume: use a sampler2D"},
    {"uniform sampler2D a; // the last", "no picture is named"},
    {"vec4 frameKept(vec2 p) { return vec4(0.0); }\nuniform sampler2D a; // the last frame of it",
     "'of it' is not understood"},
    {"vec4 frameKept(vec2 p) { return vec4(0.0); }\nuniform sampler2D a; // the last frame:",
     "meaning is missing"},
    {"uniform sampler3D a; // \"stone.png\" sRGB repeat: x", "needs the number of its slices"},
    {"uniform sampler3D a; // \"stone.png\" sRGB repeat 0: x", "a whole number from 1 to 2048"},
    {"uniform sampler3D a; // \"stone.png\" sRGB repeat -4: x", "a whole number from 1"},
    {"uniform sampler3D a; // \"stone.png\" sRGB repeat 2.5: x", "a whole number from 1"},
    {"uniform sampler3D a; // \"stone.png\" sRGB repeat 1e99: x", "a whole number from 1"},
    {"uniform sampler3D a; // \"stone.png\" sRGB repeat 4x: x", "'x: x' is not understood"},
    {"uniform samplerCube a; // \"stone.png\" sRGB repeat: x", "type samplerCube cannot"},
    {"uniform isampler2D a; // \"stone.png\" linear repeat: x", "type isampler2D cannot"},
    {"uniform usampler3D a; // \"stone.png\": x", "or usampler2D for whole numbers"},
    {"uniform usampler2D a; // a table", "name one as in \"uniform usampler2D NAME;"},
    {"uniform usampler2D a; // \"stone.png\" linear clamp: x", "'linear clamp: x' is not"},
    {"uniform usampler2D a; // \"stone.png\"", "meaning is missing"},
    {"struct S { highp usampler2D a; }; uniform S s;", "\"table.png\": meaning"},
    {"uniform sampler2D a, b; // \"stone.png\" sRGB repeat: x", "alone on its line"},
    {"uniform sampler2D a[2]; // \"stone.png\" sRGB repeat: x", "alone on its line"},
    {"uniform sampler2D", "not a sampler's declaration"},
    {"struct S { float k; sampler2D a; }; uniform S s;", "a sampler2D must be a separate uniform"},
    {"struct S { highp sampler3D a; }; uniform S s;", "64: meaning"},
    {"unifrom sampler2D a; // \"stone.png\" sRGB repeat: x", "a separate uniform"},
    {"#define TEX sampler2D", "not in a structure or macro"},
    {"#define MORE uniform sampler2D d;", "not in a structure or macro"},
    {"uniform sampler2D a; // \"no\xC2\xA0\xE2\x80\xAF.png\" sRGB repeat: x",
     "a: no\xC2\xA0\xE2\x80\xAF.png: no such file"},
    {"uniform sampler2D a; // \"stone.png\" sRGB repeat: x\n"
     "uniform sampler2D a; // \"stone.png\" sRGB repeat: x",
     "declared twice"},
    {"uniform sampler2D a; // \"none.png\" sRGB repeat: x",
     "none.png: no such file beside my.frag or in shaders/textures/"},
    {"uniform sampler2D a; // \"../outside.png\" sRGB repeat: x", "lies outside"},
    {"uniform sampler2D a; // \"link.png\" sRGB repeat: x", "lies outside"},
    {"uniform sampler2D a; // \"/etc/hostname\" sRGB repeat: x", "an absolute path"},
    {"uniform sampler2D a; // \"both.png/x\" sRGB repeat: x", "no such file"}};

TEST(test_malformed_declarations_are_refused)
{
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        if (!has_link && strstr(wrong[i][0], "link.png") != NULL)
            continue;
        char text[1024];
        snprintf(text, sizeof text, "%s%s\n", strstr(wrong[i][0], "\n") == NULL ? "\n" : "",
                 wrong[i][0]);
        assert_refused(text, "own/my.frag:2: ", wrong[i][1]);
    }
    char text[1024];
    snprintf(text, sizeof text, "uniform sampler2D a; // \"%0300d.png\" sRGB repeat: x\n", 1);
    assert_refused(text, "my.frag:1: ", "too long");
    // The message names the file that declares the sampler.
    scratch_write("root/shaders/bad.glsl",
                  "// bad\n\nuniform sampler2D b; // \"b.png\" sRGB clamp: x\n");
    assert_refused("#include \"bad.glsl\"\n", "shaders/bad.glsl:3: sampler b: b.png: ",
                   "beside bad.glsl or in shaders/textures/");
}

static void note(void *to, const char *path)
{
    char *all = to;
    snprintf(all + strlen(all), 4096 - strlen(all), "%s\n", path);
}

// A window must watch each picture, and all possible locations of a missing picture.
TEST(test_every_file_is_visited)
{
    char visited[4096] = "";
    bool done;
    const struct shader_request request = {.visit = note, .to = visited};
    read_asked("uniform sampler2D a; // \"stone.png\" sRGB repeat: x\n"
               "uniform sampler2D b; // \"gone.png\" sRGB repeat: x\n",
               &request, &done);
    assert_false(done);
    static const char *const files[] = {"own/my.frag", "own/stone.png",
                                        "root/shaders/textures/stone.png", "own/gone.png",
                                        "root/shaders/textures/gone.png"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        if (strstr(visited, scratch_path(files[i])) == NULL)
            fail_msg("%s is missing in: %s", files[i], visited);
}

// ---- The command line ----

static void assert_misfit(const char *text, const struct shader_request *request, const char *why)
{
    const struct samplers *read = samplers_of(text, request);
    capture_begin();
    bool fits = samplers_fit(read, &source);
    const char *said = capture_end();
    if (fits || line_count(said) != 1 || strstr(said, why) == NULL)
        fail_msg("expected one line with '%s', not: %s", why, said);
}

static const char two[] = "uniform sampler2D a; // \"stone.png\" sRGB repeat: x\n"
                          "uniform sampler2D ab; // \"stone.png\" sRGB repeat: x\n";

TEST(test_the_command_line_replaces_a_picture)
{
    char first[4096 + 8], second[4096 + 8];
    snprintf(first, sizeof first, "ab=%s", scratch_path("own/both.png"));
    snprintf(second, sizeof second, "ab=%s", scratch_path("outside.png"));
    const char *const textures[] = {first, second};
    const struct shader_request request = {.textures = textures, .texture_count = 2};
    const struct samplers *read = samplers_of(two, &request);
    assert_true(samplers_fit(read, &source));
    assert_string_equal(source.paths[read->item[0].file],
                        scratch_path("root/shaders/textures/stone.png"));
    assert_string_equal(source.paths[read->item[1].file], scratch_path("outside.png"));
    const char *const unknown[] = {"b=x.png"};
    const struct shader_request other = {.textures = unknown, .texture_count = 1};
    assert_misfit(two, &other, "--texture b=x.png: unknown texture: this shader has a, ab");
    assert_misfit("float x;\n", &other, "--texture b=x.png: this shader has no textures");
    assert_misfit("void mainImage(out vec4 c, vec2 p) { c = vec4(1.0); }\n", &other,
                  "this shader has no textures");
    const char *const missing[] = {"a=gone.png"};
    const struct shader_request gone = {.textures = missing, .texture_count = 1};
    bool done;
    const char *said = read_asked(two, &gone, &done);
    assert_true(!done && line_count(said) == 1 &&
                strstr(said, "my.frag:1: sampler a: gone.png: cannot be read: No such file") !=
                    NULL);
}

// Samplers of any name take the channels in the order of the text, beside those that name one.
TEST(test_samplers_of_other_tools_have_channels)
{
    static const char text[] = "#version 330 core\n"
                               "uniform sampler2D wood, texture1, backbuffer, none, sky;\n"
                               "uniform sampler2D iChannel0, late; out vec4 c;\n"
                               "void main() { vec2 p = vec2(0.0); c = texture(wood, p) +\n"
                               "texture(texture1, p) + texture(sky, p) + texture(late, p); }\n";
    static const struct {
        const char *name;
        int channel;
    } right[] = {{"wood", 2}, {"texture1", 1},  {"none", 3},
                 {"sky", -1}, {"iChannel0", 0}, {"late", -1}};
    enum { COUNT = sizeof right / sizeof *right };
    char path[4096], named[4096 + 8];
    snprintf(path, sizeof path, "%s", scratch_path("outside.png"));
    snprintf(named, sizeof named, "sky=%s", path);
    const char *const channels[4] = {NULL, path, path, NULL}, *const textures[] = {named};
    const struct shader_request request = {
        .channels = channels, .textures = textures, .texture_count = 1};
    const struct samplers *read = samplers_of(text, &request);
    assert_int_equal(source.sampler_count, COUNT);
    for (int i = 0; i < COUNT; i++) {
        assert_string_equal(source.samplers[i].name, right[i].name);
        assert_int_equal(source.samplers[i].channel, right[i].channel);
    }
    assert_true(samplers_fit(read, &source));
    assert_int_equal(read->count, 3);
    assert_string_equal(read->item[0].name, "wood");
    assert_string_equal(read->item[1].name, "texture1");
    assert_string_equal(read->item[2].name, "sky");
    const char *const unknown[] = {"woods=x.png"};
    const struct shader_request other = {.textures = unknown, .texture_count = 1};
    assert_misfit(text, &other,
                  "--texture woods=x.png: unknown texture: this shader has wood, texture1, none, "
                  "sky, iChannel0, late");
}

TEST(test_channels_come_from_the_command_line)
{
    static const char toy[] = "void mainImage(out vec4 c, vec2 p) { c = texture(iChannel2, p); }\n";
    static const char whole[] = "#version 330 core\nuniform sampler2D iChannel2; out vec4 c;\n"
                                "void main() { c = texture(iChannel2, vec2(0.0)); }\n";
    char path[4096];
    snprintf(path, sizeof path, "%s", scratch_path("outside.png"));
    const char *const channels[4] = {NULL, NULL, path, NULL},
                      *const none[4] = {path, NULL, NULL, NULL},
                      *const missing[4] = {NULL, NULL, "gone.png", NULL};
    const struct shader_request request = {.channels = channels}, other = {.channels = none},
                                gone = {.channels = missing};
    for (int i = 0; i < 2; i++) {
        const struct samplers *read = samplers_of(i == 0 ? toy : whole, &request);
        assert_int_equal(read->count, 1);
        assert_string_equal(read->item[0].name, "iChannel2");
        assert_string_equal(source.paths[read->item[0].file], path);
        assert_true(!read->item[0].srgb && read->item[0].repeat && read->item[0].slices == 0);
        assert_true(samplers_fit(read, &source));
        char *prelude = shader_prelude(&source, VIEW_PICTURE);
        assert_true((strstr(prelude, "uniform sampler2D iChannel2;") != NULL) == (i == 0));
        assert_null(strstr(prelude, "iChannel1"));
        free(prelude);
        bool done;
        const char *said = read_asked(i == 0 ? toy : whole, &gone, &done);
        assert_true(!done && strstr(said, ": sampler iChannel2: gone.png: cannot be read") != NULL);
    }
    assert_misfit(toy, &other, "the shader does not read iChannel0");
    assert_misfit("float x;\n", &other, "use --texture NAME=FILE.png for its samplers");
    assert_refused("#version 330 core\nuniform samplerCube iChannel0; out vec4 c;\n"
                   "void main() { c = texture(iChannel0, vec3(0.0)); }\n",
                   "my.frag:2: ", "iChannel0: cube maps are not supported");
}

TEST(test_the_table_describes_a_texture)
{
    char text[1024];
    samplers_of("uniform sampler3D a; // \"stone.png\" linear clamp 12: what it is\n"
                "uniform usampler2D b; // \"stone.png\": a table\n",
                NULL);
    FILE *file = system_open_scratch();
    samplers_print(&parameters.samplers, &source, file);
    rewind(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    assert_string_equal(text,
                        "\ntexture  file                        colour  edge    slices  meaning\n"
                        "a        shaders/textures/stone.png  linear  clamp   12      what it is\n"
                        "b        shaders/textures/stone.png  words   -       -       a table\n");
}

TEST(test_a_sampler_reads_the_last_frame)
{
    static const char text[] = "vec4 frameKept(vec2 p) { return vec4(0.0); }\n"
                               "uniform sampler2D history; // the last frame\n"
                               "uniform sampler2D more; // the last frame: the same\n";
    char path[4096];
    snprintf(path, sizeof path, "history=%s", scratch_path("outside.png"));
    const char *const textures[1] = {path};
    const struct shader_request request = {.textures = textures, .texture_count = 1};
    const struct samplers *read = samplers_of(text, NULL);
    bool done;
    assert_int_equal(read->count, 2);
    assert_true(samplers_keep(read));
    assert_true(read->item[0].pass == 1 && read->item[0].file == -1);
    assert_string_equal(read->item[1].meaning, "the same");
    assert_true(strstr(read_asked(text, &request, &done), "not the picture of --texture") != NULL);
    assert_false(done);
    assert_false(samplers_keep(samplers_of("float x;\n", NULL)));
}

static int tear_down(void **state)
{
    forget();
    return scratch_teardown(state);
}

TESTS(set_up, tear_down)
