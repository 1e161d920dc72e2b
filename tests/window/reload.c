// reload.c - tests files that are saved while their window is open: shaders, their includes,
// textures, and both shaders of a comparison.
#include "lib/gpu.h"
#include "lib/scratch.h"
#include "lib/session.h"

#define CHAPTER "01_normal_colouring"
#define MAIN    "#include \"main.glsl\"\n#include \"camera.glsl\"\n#include \"mine.glsl\"\n"
#define SCENE                                                                                      \
    "Ray pixelRay(vec2 screen) { return perspectiveRay(screen); }\n"                               \
    "float sceneDistance(vec3 p) { return length(p) - 1.0; }\n"

static char said[2][65536];

// Wait two and a half seconds, long enough for a saved file to be noticed and either loaded or
// refused with an error. Stores what was printed and reported, and returns how many times a file of
// this name was reloaded.
static int reloads(const char *name)
{
    char line[64];
    int count = 0;
    snprintf(line, sizeof line, "%s: reloaded", name);
    session_wait(2.5);
    for (int i = 0; i < 2; i++)
        snprintf(said[i], sizeof said[i], "%s", session_said(i + 1));
    for (const char *at = strstr(said[0], line); at != NULL; at = strstr(at + 1, line))
        count++;
    return count;
}

// Save a shader that shows one colour.
static void save(const char *name, const char *parameters, const char *colour)
{
    char text[2048];
    snprintf(text, sizeof text, "%s\n" MAIN SCENE "vec3 rayColour(Ray ray) { return %s; }\n",
             parameters, colour);
    scratch_write(name, text);
}

static void assert_colour(int red, int green)
{
    struct image image;
    user_look(&image);
    const unsigned char *pixel = image.pixel + 3 * (image.width * image.height - 1);
    assert_int_equal(pixel[0], red);
    assert_int_equal(pixel[1], green);
    image_free(&image);
}

// Check that a saved file is refused: nothing is loaded, a message says why just once, the picture
// keeps its colour, and the title bar and the overlay show the error.
static void assert_refused(const char *why, int red, int green)
{
    session_keep(0);
    assert_int_equal(reloads(""), 0);
    assert_non_null(strstr(said[1], why));
    session_assert_title(" - error - ");
    assert_colour(red, green);
    assert_true(session_off(0, NULL) > 0.02);
    assert_int_equal(reloads(""), 0);
    assert_string_equal(said[1], "");
}

SESSION_TEST(a_saved_shader_is_loaded)
{
    scratch_write("mine.glsl", "// nothing");
    save("mine.frag", "", "vec3(1.0, 0.0, 0.0)");
    session_open_bare(CHAPTER, "--size 320x200 --shader %s", scratch_path("mine.frag"));
    assert_colour(255, 0);
    session_said(1);
    save("mine.frag", "", "vec3(0.0, 1.0, 0.0)");
    assert_int_equal(reloads("mine.frag"), 1);
    assert_colour(0, 255);
    save("mine.frag", "", "undeclared");
    assert_refused("mine.frag:7", 0, 255);
    save("mine.frag", "", "vec3(1.0, 1.0, 0.0)");
    assert_int_equal(reloads("mine.frag"), 1);
    assert_false(session_titled("error"));
    assert_colour(255, 255);
    char bomb[4096] = "#define A0 1.0\n"; // expanding A28 would use all the driver's memory
    for (int i = 1; i <= 28; i++)
        snprintf(bomb + strlen(bomb), sizeof bomb - strlen(bomb), "#define A%d A%d + A%d\n", i,
                 i - 1, i - 1);
    save("mine.frag", bomb, "vec3(A28)");
    assert_refused("A28: this macro expands to more than 4 million", 255, 255);
    remove(scratch_path("mine.frag"));
    assert_refused("mine.frag", 255, 255);
    save("mine.frag", "", "vec3(0.0, 0.0, mine)");
    scratch_write("mine.glsl", "const float mine = 0.5;");
    assert_int_equal(reloads("mine.frag"), 1);
    scratch_write("mine.glsl", "const float mine = 0.25;");
    assert_int_equal(reloads("mine.frag"), 1);
    session_close();
}

SESSION_TEST(parameters_follow_the_file)
{
    scratch_write("mine.glsl", "// nothing");
    save("mine.frag", "uniform float fresh; // 3 in [0, 4] step 0.5, units: one", "vec3(fresh)");
    session_open_bare(CHAPTER, "--size 320x200 --shader %s", scratch_path("mine.frag"));
    session_assert_title("fresh = 3");
    session_key(GLFW_KEY_RIGHT);
    session_assert_title("fresh = 3.5");
    save("mine.frag", "uniform float fresh; // 3 in [0, 3.2], units: one", "vec3(fresh)");
    assert_int_equal(reloads("mine.frag"), 1);
    session_assert_title("fresh = 3.2");
    save("mine.frag", "uniform float fresh; // 2 in [0, 3.2], units: one", "vec3(fresh)");
    assert_int_equal(reloads("mine.frag"), 1);
    session_assert_title("fresh = 2");
    save("mine.frag", "uniform float orthographic; // 0 in [0, 1]: other", "vec3(orthographic)");
    assert_int_equal(reloads("mine.frag"), 1);
    session_assert_title("orthographic = 0");
    session_key(GLFW_KEY_TAB);
    session_wait(1.0);
    session_assert_title("orthographic = 1");
    session_close();
}

// Save a picture in a single shade of grey.
static void save_texture(const char *name, int grey)
{
    struct image image;
    assert_true(image_create(&image, 4, 4));
    memset(image.pixel, grey, 3 * 4 * 4);
    assert_true(image_write_png(&image, scratch_path(name)));
    image_free(&image);
}

SESSION_TEST(a_saved_texture_is_loaded)
{
    scratch_write("mine.glsl",
                  "uniform sampler2D stone; // \"stone.png\" linear repeat: saved\n"
                  "uniform sampler2D other; // \"first.png\" linear repeat: replaced\n");
    save("mine.frag", "",
         "vec3(textureLod(stone, vec2(0.5), 0.0).r, textureLod(other, vec2(0.5), 0.0).r, 0.0)");
    save_texture("stone.png", 64);
    save_texture("first.png", 64);
    save_texture("second.png", 191);
    session_open_bare(CHAPTER, "--size 320x200 --shader %s --texture other=%s",
                      scratch_path("mine.frag"), scratch_path("second.png"));
    assert_colour(64, 191);
    save_texture("stone.png", 191);
    assert_int_equal(reloads("mine.frag"), 1);
    assert_colour(191, 191);
    scratch_write("stone.png", "\x89PNG\r\n\x1a\n and no more");
    assert_refused("mine.glsl:1: sampler stone: ", 191, 191);
    save_texture("stone.png", 64);
    assert_int_equal(reloads("mine.frag"), 1);
    assert_colour(64, 191);
    assert_false(session_titled("error"));
    remove(scratch_path("stone.png"));
    assert_refused("stone.png", 64, 191);
    save_texture("stone.png", 191);
    assert_int_equal(reloads("mine.frag"), 1);
    save_texture("second.png", 64); // the texture given with --texture
    assert_int_equal(reloads("mine.frag"), 1);
    assert_colour(191, 64);
    session_close();
}

SESSION_TEST(each_of_two_files_is_loaded)
{
    scratch_write("mine.glsl", "// nothing");
    save("first.frag", "", "vec3(1.0, 0.0, 0.0)");
    save("second.frag", "", "vec3(0.0, 1.0, 0.0)");
    session_open_bare(CHAPTER, "--size 320x200 --shader %s --compare %s --divider 0",
                      scratch_path("first.frag"), scratch_path("second.frag"));
    assert_colour(0, 255);
    save("second.frag", "", "vec3(0.0, 0.4, 0.0)");
    assert_int_equal(reloads("second.frag"), 1);
    assert_colour(0, 102);
    save("second.frag", "", "undeclared");
    assert_int_equal(reloads("second.frag"), 0);
    session_assert_title(" - error - ");
    assert_colour(0, 102);
    assert_non_null(strstr(said[1], "second.frag:7"));
    save("first.frag", "", "vec3(0.6, 0.0, 0.0)");
    save("second.frag", "", "vec3(0.0, 0.8, 0.0)");
    assert_int_equal(reloads("first.frag"), 1);
    assert_false(session_titled("error"));
    assert_colour(0, 204);
    session_close();
}

// A shader of another tool has no slice, so the view becomes the picture, on both sides.
SESSION_TEST(a_shader_without_the_view_shows_its_picture)
{
    static const char toy[] =
        "void mainImage(out vec4 c, in vec2 p) { c = vec4(0.0, 1.0, 0.0, 1.0); }";
    scratch_write("mine.glsl", "// nothing\n");
    for (int i = 0; i < 2; i++)
        save(i == 0 ? "a.frag" : "b.frag", "#include \"march.glsl\"",
             "march(ray, 0.0, 1.0, 0.1, 9).found ? vec3(0.5) : vec3(1.0, 0.0, 0.0)");
    session_open_bare(CHAPTER, "--size 64x36 --shader %s --compare %s", scratch_path("a.frag"),
                      scratch_path("b.frag"));
    session_key(GLFW_KEY_5);
    session_assert_title(" - slice");
    scratch_write("b.frag", "void mainImage(out vec4 c, in vec2 p) { c = x; }");
    assert_int_equal(reloads("b.frag"), 0);
    session_assert_title(" - slice");
    scratch_write("b.frag", toy);
    assert_int_equal(reloads("b.frag"), 1);
    assert_string_equal(said[1], "");
    session_assert_title(" - picture");
    assert_colour(0, 255);
    session_close();
}

// Wait until the window's file has been read.
static void drop(const char *path)
{
    user_drop(path);
    session_wait(1.0);
}

SESSION_TEST(a_shader_that_is_dropped_is_shown_and_reloaded)
{
    const char *red = "void mainImage(out vec4 c, vec2 p) { c = vec4(1.0, 0.0, 0.0, 1.0); }";
    session_open_bare("01_normal_colouring", SESSION_STILL);
    scratch_write("red.frag", red);
    drop(scratch_path("red.frag"));
    session_assert_title("red.frag");
    session_assert_shown("01_normal_colouring", SESSION_STILL " --shader %s",
                         scratch_path("red.frag"));
    scratch_write("red.frag",
                  "void mainImage(out vec4 c, vec2 p) { c = vec4(0.0, 0.0, 1.0, 1.0); }");
    session_wait(1.0);
    session_assert_shown("01_normal_colouring", SESSION_STILL " --shader %s",
                         scratch_path("red.frag"));
    scratch_write("broken.frag", "void mainImage(");
    session_said(2);
    drop(scratch_path("broken.frag")); // the last good picture stays, until the file is mended
    assert_non_null(strstr(session_said(2), "broken.frag"));
    scratch_write("broken.frag", red);
    session_wait(1.0);
    session_assert_shown("01_normal_colouring", SESSION_STILL " --shader %s",
                         scratch_path("broken.frag"));
    session_close();
}

SESSION_TEST(pictures_that_are_dropped_fill_the_channels)
{
    char picture[2][4096], channels[8400];
    for (int i = 0; i < 2; i++)
        snprintf(picture[i], sizeof picture[i], "%s/tests/references/%s", gpu_project_root(),
                 i == 0 ? "00_first_scene.png" : "03_shadows.png");
    scratch_write("two.frag",
                  "void mainImage(out vec4 c, vec2 p) { vec2 at = p / iResolution.xy;"
                  "c = at.x < 0.5 ? texture(iChannel0, at) : texture(iChannel1, at); }");
    session_open_bare("01_normal_colouring", "--size 320x200 --shader %s",
                      scratch_path("two.frag"));
    session_said(2); // the channels are black
    drop(picture[0]);
    drop(picture[1]);
    session_said(2);
    snprintf(channels, sizeof channels, "--channel 0=%s --channel 1=%s", picture[0], picture[1]);
    session_assert_shown("01_normal_colouring", "--size 320x200 --shader %s %s",
                         scratch_path("two.frag"), channels);
    session_close();
    session_open_bare("01_normal_colouring", SESSION_STILL); // it reads no picture
    drop(picture[0]);
    assert_non_null(strstr(session_said(2), "reads no picture"));
    drop("mesh.obj");
    assert_non_null(strstr(session_said(2), "make bake"));
    session_wait(0.5);
    assert_false(session_titled("error")); // the picture is as good as before
    session_close();
}

TESTS(NULL, NULL)
