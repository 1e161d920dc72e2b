// panel_mouse.c - tests the panel with the mouse: rows, typed numbers, the colour picker and the
// panel's position. The title bar shows the changes. tests/window/input.c tests what a field
// accepts and when a picker closes.
#include "lib/scratch.h"
#include "lib/session.h"
#include "window/panel_input.h"
#include "window/state.h"

#define CHAPTER "01_normal_colouring"

// At scale 1, the rows begin 46 pixels from the top and are 12 pixels high. Below the row of the
// selected parameter are its range and unit and, for a vector, its components.
static const char rows[] =
    "uniform float size; // 5 in [0, 10], units: how large the object is\n"
    "uniform float fine; // 0.01 in [0.0001, 1] step *10, units: spans decades\n"
    "uniform bool lit; // true: whether there is light\n"
    "uniform vec3 tint; // 0.5 in [0, 1], linear RGB: the colour of everything\n"
    "#include \"main.glsl\"\n#include \"camera.glsl\"\n#include \"lighting.glsl\"\n"
    "#include \"march.glsl\"\n"
    "Ray pixelRay(vec2 screen) { return perspectiveRay(screen); }\n"
    "float sceneDistance(vec3 p) { return 1.0 + fine * size; }\n"
    "vec3 rayColour(Ray ray)\n"
    "{\n"
    "    march(ray, 0.0, 9.0, 0.001, 8);\n"
    "    return lit ? encodeSRGB(tint) : vec3(DARK);\n"
    "}\n";

//   timed  the shader reads the time, although its picture stays the same
static void open_rows(int scale, bool timed)
{
    char text[sizeof rows + 64];
    snprintf(text, sizeof text, "#define DARK %s\n%s", timed ? "min(iTime, 0.0)" : "0.0", rows);
    scratch_write("rows.frag", text);
    session_open(CHAPTER, "--size %dx%d --overlay=%d --shader %s", scale * 480, scale * 270, scale,
                 scratch_path("rows.frag"));
}

// The value that the title bar shows.
static double value(void)
{
    const char *at = strstr(user.title, " = ");
    assert_non_null(at);
    return atof(at + 3);
}

static void point(double x, double y)
{
    user_point(x, y);
    session_turn();
}

static void drag(double x, double y, double right, double down)
{
    user_drag(x, y, right, down);
    session_turn();
}

static void wheel(double notches)
{
    user_wheel(notches);
    session_turn();
}

static void double_click(double x, double y)
{
    for (int i = 0; i < 2; i++)
        user_click(x, y, GLFW_MOUSE_BUTTON_LEFT);
    session_turn();
    session_turn();
    user.now += 1.0;
}

static void type(const char *text, int key)
{
    user_type(text);
    session_key(key);
    session_turn();
}

// Move the pointer off the panel, so that only the selected parameter shows its range or
// components.
static void leave_panel(void)
{
    point(400, 200);
}

SESSION_TEST(a_row_changes_its_value)
{
    open_rows(1, false);
    session_assert_title("size = 5");
    user_point(60, 50);
    session_wait(0.7);
    char tip[512];
    struct panel panel = {0};
    window_panel_fill(session_window(), &panel, tip);
    assert_non_null(strstr(tip, "drag it, or click and type"));
    drag(60, 50, 60, 0);
    assert_true(value() > 5.5);
    double dragged = value();
    drag(120, 50, -60, 0);
    assert_true(value() > 4.99 && value() < 5.01 && dragged < 10.0);
    drag(60, 50, 10, 0);
    user_click(60, 50, GLFW_MOUSE_BUTTON_RIGHT);
    session_turn();
    session_assert_title("size = 5");
    wheel(1.0);
    session_assert_title("size = 5.1");
    wheel(-1.0);
    session_assert_title("size = 5");
    session_click(60, 74);
    session_assert_title("fine = 0.01");
    drag(60, 74, 40, 0); // on a logarithmic scale
    assert_true(value() > 0.015 && value() < 0.1);
    leave_panel();
    session_click(60, 86);
    session_assert_title("lit = false");
    leave_panel();
    session_click(60, 74);
    session_assert_title("lit = true");
    leave_panel();
    session_click(60, 98);
    session_assert_title("tint = 0.5,0.5,0.5");
    drag(60, 122, 40, 0); // green, because the range of lit is still open above tint
    assert_true(strstr(user.title, "tint = 0.5,0.") != NULL && !session_titled("0.5,0.5,0.5"));
    session_close();
}

// When a click selects another parameter, the rows below the previous parameter stay open while the
// pointer is on the panel, so that a second click at the same position hits the same row.
SESSION_TEST(rows_do_not_move_under_the_pointer)
{
    open_rows(1, false);
    session_click(60, 98);
    session_assert_title("tint = ");
    session_click(60, 86); // lit, the row above tint
    session_assert_title("lit = false");
    session_wait(1.0);
    session_click(60, 86);
    session_assert_title("lit = true");
    session_click(60, 74); // fine, because the range of size is still open above it
    session_assert_title("fine = ");
    session_wait(1.0);
    session_click(60, 74);
    session_assert_title("fine = ");
    leave_panel();
    session_click(60, 62); // fine is one row higher, because the range of size is hidden
    session_assert_title("fine = ");
    session_close();
}

// If there is no room for all rows, a row that is pressed stays under the pointer, and the line
// below the rows turns to the others.
SESSION_TEST(a_list_that_is_cut_can_be_turned)
{
    session_open("21_a_landscape", "--size 480x270 --overlay=1 --time 0");
    struct panel_rows *panel = &session_window()->panel.rows;
    const struct panel_row *more = NULL;
    session_key(GLFW_KEY_ESCAPE);
    for (int i = 0; i < panel->count; i++)
        more = panel->row[i].kind == PANEL_ROW_MORE ? &panel->row[i] : more;
    assert_non_null(more);
    int last = more != NULL ? more->part : 0;
    double x = more != NULL ? (double)more->left + 4.0 : 0.0;
    double y = more != NULL ? (double)more->top + 3.0 : 0.0;
    session_click(x, y);
    session_turn();
    int from = panel->from, pressed = -1;
    assert_true(from > 0 && from <= last);
    for (int i = 0; i < panel->count; i++)
        pressed = pressed < 0 && panel->row[i].kind == PANEL_ROW_PARAMETER ? i + 1 : pressed;
    float top = panel->row[pressed].top;
    int parameter = panel->row[pressed].parameter;
    session_click(x, (double)top + 3.0);
    session_turn();
    assert_int_equal(panel->from, from);
    assert_int_equal(panel_rows_at(panel, (float)x, top + 3.0f)->parameter, parameter);
    point(x, y);
    wheel(1.0); // back to the rows before
    session_turn();
    assert_true(panel->from < from);
    session_close();
}

// A picture that is paused, and then sharpened, has no wider panel.
SESSION_TEST(a_pause_changes_no_row)
{
    user.pixel_seconds = 1e-4;
    session_open("21_a_landscape", "--size 480x270 --overlay=1 --time 12");
    const struct panel_rows *panel = &session_window()->panel.rows;
    session_wait(0.5);
    float width = panel->width;
    int count = panel->count;
    session_key(GLFW_KEY_ESCAPE);
    for (int i = 0; i < 12; i++) {
        session_turn();
        assert_true(panel->width <= width);
        assert_int_equal(panel->count, count);
        session_wait(0.1);
    }
    assert_true(session_window()->sharpening.rows > 0);
    user.pixel_seconds = 0.0;
    session_close();
}

// The row of a single component accepts one number. Ctrl+V pastes into its field.
SESSION_TEST(a_component_is_typed_or_pasted)
{
    open_rows(1, false);
    session_click(60, 98);
    leave_panel();
    double_click(60, 110); // the row of the green component, below the red one
    type("0.5.5", GLFW_KEY_ENTER);
    session_assert_title("tint = 0.5,0.5,0.5");
    assert_string_equal(session_said(2), ""); // no message says that tint takes three numbers
    user.clipboard = " 0.25\r\n";
    for (int i = 0; i < 5; i++)
        session_key(GLFW_KEY_BACKSPACE);
    user_key(GLFW_KEY_V, GLFW_MOD_CONTROL);
    session_turn();
    session_assert_title("tint = 0.5,0.5,0.5"); // the pasted line break does not act as Enter
    session_key(GLFW_KEY_ENTER);
    session_turn();
    session_assert_title("tint = 0.5,0.25,0.5");
    session_close();
}

// Whoever clicks on a number and types expects the number to change, and no view or program to end.
SESSION_TEST(a_clicked_number_is_typed_at_once)
{
    open_rows(1, false);
    session_click(60, 50);
    user_key(GLFW_KEY_7, 0);
    type("7", GLFW_KEY_ENTER);
    session_assert_title("size = 7");
    session_assert_title(" - picture - ");
    session_click(60, 50);
    user_key(GLFW_KEY_BACKSPACE, 0);
    session_turn();
    assert_false(user.ended);
    type("6", GLFW_KEY_ENTER);
    session_assert_title("size = 6");
    session_click(60, 50); // any other key acts as usual, and so does every key from then on
    session_key(GLFW_KEY_RIGHT);
    session_assert_title("size = 6.1");
    session_key(GLFW_KEY_4);
    session_assert_title(" - steps - ");
    session_key(GLFW_KEY_1);
    session_click(60, 50);
    leave_panel();
    session_key(GLFW_KEY_4);
    session_assert_title(" - steps - ");
    assert_false(session_window()->input.typing);
    session_close();
}

SESSION_TEST(words_act_as_buttons)
{
    open_rows(1, false);
    session_keep(0);
    session_click(60, 30); // opens the list of views
    session_click(60, 30 + 12 * 3);
    session_assert_title(" - depth - ");
    session_click(60, 30 + 12);
    session_assert_title(" - picture - ");
    leave_panel(); // closes the list of views
    session_turn();
    assert_true(session_off(0, NULL) <= 0.0);
    // There is no button that pauses a still picture. The one for the next step selects the ray of
    // the middle pixel.
    session_click(87, 128);
    assert_non_null(strstr(session_said(1), "ray of pixel 240,135"));
    session_key(GLFW_KEY_X);
    session_click(126, 128); // the button that hides the panel
    leave_panel();
    session_assert_shown(CHAPTER, "--size 480x270 --shader %s", scratch_path("rows.frag"));
    point(60, 18);
    session_keep(1);
    leave_panel();
    assert_true(session_off(1, NULL) > 0.005); // under the pointer, the panel's title was visible
    point(60, 18);
    session_click(68, 18); // the mark in the title unfolds the panel
    leave_panel();
    assert_true(session_off(0, NULL) <= 0.0);
    session_close();
}

SESSION_TEST(a_button_pauses)
{
    open_rows(1, true);
    session_click(28, 128);
    session_assert_title("(paused)");
    session_click(28, 128);
    assert_false(session_titled("(paused)"));
    session_close();
}

SESSION_TEST(numbers_are_typed)
{
    open_rows(1, true);
    session_click(60, 50);
    session_keep(0);
    const int row[4] = {150, 49, 8, 6}; // a field is dark to the end of its row
    double_click(60, 50);
    assert_true(session_off(0, row) > 0.9);
    type("7.25", GLFW_KEY_ENTER);
    session_assert_title("size = 7.25");
    double_click(60, 50);
    type("3", GLFW_KEY_ESCAPE);
    session_assert_title("size = 7.25");
    assert_false(session_titled("paused"));
    double_click(60, 50);
    type("99", GLFW_KEY_ENTER);
    session_assert_title("size = 7.25");
    assert_non_null(strstr(session_said(2), "out of range"));
    session_key(GLFW_KEY_ESCAPE);
    double_click(60, 50);
    user_type("4");
    session_click(400, 200); // a press in the picture closes the field and discards its text
    session_assert_title("size = 7.25");
    assert_non_null(strstr(session_said(1), "ray of pixel 400,69"));
    session_close();
}

// The picture shows only the colour of the parameter tint, whose row is the first.
static const char colour[] =
    "uniform vec3 tint; // 0.5 in [0, 1], linear RGB: the colour of everything\n"
    "#include \"main.glsl\"\n#include \"camera.glsl\"\n#include \"lighting.glsl\"\n"
    "Ray pixelRay(vec2 screen) { return perspectiveRay(screen); }\n"
    "float sceneDistance(vec3 p) { return 1.0; }\n"
    "vec3 rayColour(Ray ray) { return encodeSRGB(tint); }\n";

SESSION_TEST(a_colour_is_picked)
{
    scratch_write("colour.frag", colour);
    for (int scale = 1; scale <= 2; scale++) {
        const int s = scale, beside[4] = {s * 197, s * 44, s * 283, s * 226};
        int box[4];
        session_open(CHAPTER, "--size %dx%d --overlay=%d --shader %s", s * 480, s * 270, s,
                     scratch_path("colour.frag"));
        session_keep(0);
        session_click(s * 97, s * 50); // the swatch in the row of the colour
        point(s * 400, s * 250);
        session_bounds(0, beside, box);
        assert_int_equal(box[2], s * 104);
        assert_int_equal(box[3], s * 86);
        const int left = box[0], top = box[1];
        session_click(left + 7 * s, top + 7 * s);
        session_assert_title("tint = 1,1,1");
        drag(left + 40 * s, top + 40 * s, s * 160, s * -80); // beyond the picker's square
        session_assert_title("tint = 1,0");
        session_click(left + 91 * s, top + 31 * s); // on the picker's bar
        session_assert_title("tint = 0");
        assert_non_null(strstr(user.title, ",1"));
        session_key(GLFW_KEY_ESCAPE);
        session_keep(0);
        session_click(s * 97, s * 50);
        session_click(s * 400, s * 250);
        assert_true(session_off(0, beside) <= 0.0);
        session_close();
    }
}

// Check that the panel is, or is not, at a position. The panel is darker than the white picture
// behind it.
static void assert_panel(int x, int y, bool there)
{
    struct image image;
    user_look(&image);
    double sum = 0.0;
    for (int i = 0; i < 50; i++)
        sum += image.pixel[3 * (y * image.width + x + i)];
    image_free(&image);
    assert_true((sum / 50.0 < 128.0) == there);
}

SESSION_TEST(the_panel_moves_collapses_and_helps)
{
    open_rows(1, false);
    session_keep(0);
    point(60, 50);
    session_wait(2.0);
    assert_true(session_off(0, NULL) > 0.001); // the row's help is shown
    user_enter(false);                         // the pointer leaves the window
    session_wait(0.5);
    assert_true(session_off(0, (const int[]){0, 44, 480, 226}) <= 0.0);
    user_click(60, 98, GLFW_MOUSE_BUTTON_LEFT);
    for (int i = 0; i < 3; i++) {
        user_drag(60, 110 + 12 * i, 200, 0); // makes the picture white
        session_turn();
    }
    point(400, 200);
    assert_panel(20, 100, true);
    session_key(GLFW_KEY_O);
    assert_panel(20, 100, false);
    assert_panel(400, 100, true);
    session_click(360, 62); // the panel responds at its new position
    session_assert_title("fine = ");
    session_key(GLFW_KEY_T);
    point(100, 200);
    assert_panel(400, 100, false);
    assert_panel(400, 16, true);
    session_key(GLFW_KEY_T);
    session_key(GLFW_KEY_O);
    assert_panel(20, 100, true);
    drag(60, 16, 230, 0); // drag the panel by its title, past the middle of the window
    point(240, 200);
    assert_panel(400, 100, true);
    drag(400, 16, -170, 0);
    point(400, 200);
    assert_panel(20, 100, true);
    int x = 250; // the mark that collapses the panel is at the right end of the title
    do {
        session_click(x -= 10, 20);
        point(400, 200);
        session_keep(1);
    } while (x > 150 && session_off(0, (const int[]){20, 100, 50, 1}) <= 0.5);
    assert_true(x > 150);
}

// ---- Shadertoy's mouse ----

// Check the value of iMouse: a shader that shows iMouse must look the same as one with this value.
static void assert_mouse(const char *mouse)
{
    char text[512];
    const char *const names[] = {"mouse.frag", "wanted.frag"};
    for (int i = 0; i < 2; i++) {
        snprintf(text, sizeof text,
                 "void mainImage(out vec4 c, vec2 p) {\n vec4 m = %s;\n"
                 " c = p.x < 60.0 ? vec4(m.x / 320.0, m.y / 200.0, sign(m.z) * 0.5 + 0.5, 1.0)\n"
                 " : vec4(abs(m.zw) / 320.0, sign(m.w) * 0.5 + 0.5, 1.0); }\n",
                 i == 0 ? "iMouse" : mouse);
        scratch_write(names[i], text);
    }
    if (!user.open)
        session_open_bare(CHAPTER, "--size 320x200 --shader %s", scratch_path("mouse.frag"));
    session_assert_shown(CHAPTER, "--size 320x200 --shader %s", scratch_path("wanted.frag"));
}

// Every handle of some figures can be grabbed as soon as the window is open. The panel of the first
// one moves for this; O moves it back, and it stays there.
SESSION_TEST(the_panel_makes_room_for_handles)
{
    static const char *const figures[] = {"00_pixels", "00_march", "06_trace", "00_distance"};
    for (size_t i = 0; i < sizeof figures / sizeof *figures; i++) {
        session_open("00_first_scene", "--size 960x540 --shader chapters/figures/%s.frag",
                     figures[i]);
        session_wait(0.2);
        const struct window *window = session_window();
        const float scale = window->panel.overlay.scale;
        assert_true(window->handles.count > 0 && window->panel.right); // their numbers are left
        for (int k = 0; k < window->handles.count; k++) {
            const float *pixel = window->handles.item[k].pixel;
            assert_false(panel_rows_hold(&window->panel.rows, pixel[0] / scale,
                                         (540.0f - pixel[1]) / scale));
        }
        const bool right = window->panel.right;
        session_key(GLFW_KEY_O);
        session_wait(0.2);
        assert_true(window->panel.right == !right);
        session_close();
    }
}

SESSION_TEST(shadertoy_s_mouse_is_set)
{
    assert_mouse("vec4(0.0)");
    user_point(100, 80);
    user_button(GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS);
    session_turn();
    assert_mouse("vec4(100.0, 120.0, 100.0, 120.0)");
    // While the button is held, the last two numbers are the position of the press. From the second
    // frame on, the last number is negative.
    point(160, 150);
    assert_mouse("vec4(160.0, 50.0, 100.0, -120.0)");
    user_button(GLFW_MOUSE_BUTTON_LEFT, GLFW_RELEASE);
    point(30, 90);
    assert_mouse("vec4(160.0, 50.0, -100.0, -120.0)");
    session_close();
}

TESTS(NULL, NULL)
