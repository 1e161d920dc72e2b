// pace.c - tests a window whose picture takes a long time to draw: the picture is coarser while
// something moves, and sharpens at rest. The clock advances by the time that the test sets for each
// pixel.
#include "lib/compare.h"
#include "lib/scratch.h"
#include "lib/session.h"

#define CHAPTER "01_normal_colouring"
#define LARGE   "--size 480x300 --camera 1.65,1.6,3.4,-26,-23.5"

enum { WIDTH = 480, HEIGHT = 300 };
static const int above[4] = {0, 0, WIDTH, HEIGHT / 4}, below[4] = {0, 225, WIDTH, HEIGHT / 4};

// Make the whole picture take a second to draw.
static void make_heavy(void)
{
    user.pixel_seconds = 1.0 / WIDTH / HEIGHT;
}

// Open the chapter, and store its sharp picture under the number 0.
static void open_sharp(const char *options)
{
    session_open_bare(CHAPTER, LARGE "%s", options);
    session_assert_shown(CHAPTER, LARGE "%s", options);
    session_keep(0);
    make_heavy();
}

static void disturb(void)
{
    session_key(GLFW_KEY_RIGHT);
    session_key(GLFW_KEY_LEFT);
}

static bool sharp(const int part[4])
{
    return session_off(0, part) <= 0.0;
}

// Run the main loop until the upper part of the picture is sharp and the lower part is not.
static void turn_to_half(void)
{
    for (int i = 0; i < 200 && !sharp(above); i++)
        session_turn();
    assert_true(sharp(above) && !sharp(below));
}

SESSION_TEST(a_slow_picture_is_coarse_and_sharpens_from_the_top)
{
    open_sharp("");
    for (int i = 0; i < 3; i++)
        disturb();
    assert_true(!sharp(above) && !sharp(below));
    double begun = user.now;
    disturb();
    assert_true(user.now - begun < 0.25); // two pictures of 0.08 s, and two iterations
    for (int i = 0; i < 10; i++) {        // the picture must rest for 0.3 s before it sharpens
        session_turn();
        assert_false(sharp(above));
    }
    turn_to_half();
    disturb(); // sharpening starts again
    assert_true(!sharp(above));
    turn_to_half();
    begun = user.now;
    session_key(GLFW_KEY_H); // takes effect at once, and does not interrupt the sharpening
    assert_true(user.now - begun < 0.25);
    assert_true(session_off(0, (const int[]){8, 8, 130, 20}) > 0.1);
    session_key(GLFW_KEY_H);
    assert_true(sharp(above));
    session_wait(2.0);
    assert_true(sharp(NULL));
    int frames = user.frames;
    session_wait(1.0);
    assert_int_equal(user.frames, frames);
    session_close();
}

// The shade of grey that the window shows.
static int grey(void)
{
    struct image image;
    user_look(&image);
    int value = image.pixel[0];
    image_free(&image);
    return value;
}

// The picture is black on the left and white on the right. A coarse pixel must not become a block.
SESSION_TEST(a_coarse_picture_is_interpolated)
{
    scratch_write("edge.frag",
                  "void mainImage(out vec4 c, vec2 p)\n"
                  "{ c = vec4(step(0.5, p.x / iResolution.x), fract(iTime), 0.0, 1.0); }");
    session_open_bare(CHAPTER, "--size 480x300 --shader %s", scratch_path("edge.frag"));
    make_heavy();
    session_wait(4.0); // the first pictures take a second each
    struct image image;
    user_look(&image);
    const unsigned char *row = image.pixel + 3 * (100 * WIDTH);
    int between = 0;
    for (int x = 1; x < WIDTH; x++) {
        assert_true(row[3 * x] >= row[3 * x - 3]);
        between += row[3 * x] > 0 && row[3 * x] < 255;
        assert_true(abs(x - WIDTH / 2) < 8 || row[3 * x] == (x < WIDTH / 2 ? 0 : 255));
    }
    assert_in_range(between, 2, 8);
    image_free(&image);
    session_close();
}

// The selected pixel must be scaled with the picture, because otherwise another ray would be
// marched. The shade of grey is a tenth of the distance from the second step of the marched ray to
// a plane on the right.
SESSION_TEST(a_coarse_picture_marches_the_selected_ray)
{
    scratch_write("marched.frag",
                  "#include \"main.glsl\"\n#include \"camera.glsl\"\n#include \"march.glsl\"\n"
                  "#include \"marched.glsl\"\n"
                  "uniform float unused; // 1 in [0, 2]: a change redraws the picture\n"
                  "Ray pixelRay(vec2 screen) { return perspectiveRay(screen); }\n"
                  "float sceneDistance(vec3 p) { return 4.0 - p.x; }\n"
                  "vec3 rayColour(Ray ray)\n{\n"
                  "    march(ray, 0.0, 100.0, 0.01, 64);\n"
                  "    return vec3(0.1 * marchedStep(1).y + 1e-6 * unused);\n}\n");
    session_open_bare(CHAPTER, "--size 480x300 --camera 0,0,0,0,0 --shader %s",
                      scratch_path("marched.frag"));
    int middle = grey();
    session_click(330, 60); // the picture is drawn again, because it depends on the ray
    int selected = grey();
    make_heavy();
    for (int i = 0; i < 3; i++)
        disturb();
    assert_true(middle - selected > 10);
    assert_in_range(grey(), selected - 2, selected + 2);
    session_close();
}

SESSION_TEST(a_screenshot_waits_for_the_sharp_picture)
{
    open_sharp("");
    disturb();
    session_assert_screenshot(CHAPTER, LARGE);
    session_close();
}

// All rows show the same time, although drawing them takes many iterations of the main loop. The
// time advances only when all rows are drawn.
SESSION_TEST(a_screenshot_shows_a_single_time)
{
    scratch_write("moving.frag",
                  "void mainImage(out vec4 c, vec2 p) { c = vec4(fract(iTime), 1.0, 0.0, 1.0); }");
    session_open_bare(CHAPTER, "--size 480x300 --shader %s", scratch_path("moving.frag"));
    make_heavy();
    session_wait(0.5);
    struct image image;
    session_shoot(&image);
    for (int i = 0; i < 3 * image.width * image.height; i++)
        assert_int_equal(image.pixel[i], image.pixel[i % 3]);
    image_free(&image);
    session_keep(0);
    session_wait(0.5);
    assert_true(session_off(0, NULL) > 0.5);
    session_close();
}

SESSION_TEST(a_coarse_pair_has_its_divider_in_place)
{
    scratch_write("left.frag",
                  "void mainImage(out vec4 c, vec2 p) { c = vec4(1.0, 0.0, 0.0, 1.0); }");
    scratch_write("right.frag",
                  "void mainImage(out vec4 c, vec2 p) { c = vec4(0.0, fract(iTime), 1.0, 1.0); }");
    session_open_bare(CHAPTER, "--size 480x300 --shader %s --compare %s --divider 0.4",
                      scratch_path("left.frag"), scratch_path("right.frag"));
    make_heavy();
    session_wait(0.5);
    session_keep(0);
    struct image image;
    user_look(&image);
    for (int x = 4; x < WIDTH; x++) {
        const unsigned char *pixel = image.pixel + 3 * (100 * WIDTH + x);
        if (abs(x - 192) > 12)
            assert_true((pixel[0] == 255) == (x < 192) && (pixel[2] == 255) == (x >= 192));
    }
    image_free(&image);
    session_wait(0.5);
    assert_true(session_off(0, (const int[]){204, 40, 270, 200}) > 0.3);
    session_close();
}

// Run an iteration of the main loop that takes at most half a second.
static void assert_quick_turn(void)
{
    double begun = user.now;
    session_turn();
    assert_true(user.now - begun < 0.5);
}

// Save a shader whose pixels all differ.
static const char *save_noise(const char *comment)
{
    char text[256];
    snprintf(text, sizeof text,
             "void mainImage(out vec4 c, vec2 p) { c = vec4(fract(sin(dot(p, vec2(12.9, 78.2))) "
             "* 43758.5)); }\n%s\n",
             comment);
    return scratch_write("noise.frag", text);
}

// Every pixel of the saved shader takes 5 ms, and the whole picture 12 minutes.
SESSION_TEST(a_very_slow_shader_never_blocks_the_window)
{
    char line[4096];
    for (int i = 0; i < 2; i++) {
        const char *path = save_noise("");
        snprintf(line, sizeof line, "%s%s%s", path, i > 0 ? " --divider 0.3 --compare " : "",
                 i > 0 ? path : "");
        session_open_bare(CHAPTER, "--size 480x300 --shader %s", line);
        session_wait(0.5);
        session_said(1);
        save_noise("// slow");
        user.pixel_seconds = 0.005;
        for (int k = 0; k < 30; k++)
            assert_quick_turn();
        assert_non_null(strstr(session_said(1), "noise.frag: reloaded"));
        session_keep(0);
        for (int k = 0; k < 200; k++)
            assert_quick_turn();
        assert_true(session_off(0, above) > 0.01); // some rows are sharp
        assert_true(session_off(0, below) <= 0.0);
        user_press(GLFW_KEY_W, 0);
        for (int k = 0; k < 10; k++)
            assert_quick_turn();
        user_release(GLFW_KEY_W);
        user_key(GLFW_KEY_BACKSPACE, 0);
        assert_quick_turn();
        assert_true(user.ended);
        session_close();
        user_reset();
    }
}

// A window of one pixel shows nothing about the cost of a pixel, whether the program in it is new
// or not.
SESSION_TEST(a_window_that_was_tiny_is_not_blocked_when_it_grows)
{
    for (int i = 0; i < 2; i++) {
        session_open_bare(CHAPTER, LARGE);
        session_wait(0.5);
        user.pixel_seconds = 0.001;
        user_resize(1, 1);
        if (i > 0)
            session_key(GLFW_KEY_2);
        for (int k = 0; k < 10; k++)
            assert_quick_turn();
        double begun = user.now;
        user_resize(WIDTH, HEIGHT); // draws at once
        assert_true(user.now - begun < 0.5);
        for (int k = 0; k < 30; k++)
            assert_quick_turn();
        session_close();
        user_reset();
    }
}

// Each column of the table of a march's steps takes as long as the march itself. This one has 80.
SESSION_TEST(the_table_of_a_march_has_no_column_without_a_step)
{
    const char *path = scratch_write(
        "fine.frag", "#include \"main.glsl\"\n#include \"camera.glsl\"\n"
                     "#include \"march.glsl\"\n"
                     "Ray pixelRay(vec2 screen) { return perspectiveRay(screen); }\n"
                     "float sceneDistance(vec3 p) { return p.y; }\n"
                     "vec3 rayColour(Ray ray)\n"
                     "{ march(ray, 0.0, 10000.0, 0.00001, 80); return vec3(0.5); }\n");
    user.pixel_seconds = 1e-4;
    session_open_bare(CHAPTER, "--size 480x300 --camera 0,1,0,0,-1 --view slice --shader %s", path);
    session_click(240, 150);
    for (int k = 0; k < 30; k++)
        assert_quick_turn();
    session_close();
}

static void assert_smooth(int samples)
{
    session_assert_shown(CHAPTER, LARGE " --samples %d", samples);
}

// A second after the last movement, and after a screenshot, which has one sample.
SESSION_TEST(edges_are_smooth_at_rest)
{
    for (int heavy = 0; heavy < 2; heavy++) {
        session_smooths = true;
        session_open_bare(CHAPTER, LARGE);
        assert_smooth(2);
        if (heavy)
            make_heavy();
        for (int i = 0; i < 2; i++) {
            disturb();
            session_wait(0.9);
            if (!heavy)
                assert_smooth(2);
            session_wait(20.0);
            assert_smooth(3);
            session_assert_screenshot(CHAPTER, LARGE);
            session_wait(20.0);
            assert_smooth(3);
        }
        session_close();
        user_reset();
        session_smooths = false;
    }
}

// If four times the pixels take less than 0.03 s; the stub's clock counts each pass over a pixel.
SESSION_TEST(edges_are_smooth_in_motion_if_there_is_time)
{
    for (int slow = 0; slow < 2; slow++) {
        session_smooths = true;
        user.pixel_seconds = (slow ? 0.035 : 0.025) / 4 / WIDTH / HEIGHT;
        session_open_bare(CHAPTER, LARGE);
        for (int i = 0; i < 4; i++) {
            disturb();
            assert_smooth(slow ? 1 : 2);
        }
        session_assert_screenshot(CHAPTER, LARGE);
        session_close();
        user_reset();
        session_smooths = false;
    }
}

TESTS(NULL, NULL)
