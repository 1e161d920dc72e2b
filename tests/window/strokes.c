// strokes.c - tests the sculpting of chapter 23: a drag with the tool changes the clay, and the
// option that is printed draws the same picture.
#include "lib/session.h"

#define CHAPTER "23_stored_distances"
#define OPTIONS "--size 320x180 --set turnSpeed=0 --set tool="

// Open the chapter, and drag over the elephant's flank.
static void sculpt(const char *tool)
{
    session_open_bare(CHAPTER, OPTIONS "%s", tool);
    session_keep(0);
    session_said(1);
    user_drag(118, 80, 8, 8);
    session_turn();
}

// End the drag. Returns the option that was printed.
static const char *let_go(void)
{
    static char option[512];
    user_button(GLFW_MOUSE_BUTTON_LEFT, GLFW_RELEASE);
    session_turn();
    session_turn();
    snprintf(option, sizeof option, "%s", session_said(1));
    option[strcspn(option, "\n")] = '\0';
    return option;
}

static void assert_drawn_again(const char *tool)
{
    sculpt(tool);
    const char *option = let_go();
    assert_int_equal(strncmp(option, "--stroke ", 9), 0);
    assert_true(session_off(0, NULL) > 0.002);
    session_wait(1.0); // until the picture is sharp
    session_assert_shown(CHAPTER, OPTIONS "%s %s", tool, option);
    session_close();
}

SESSION_TEST(a_stroke_is_printed_as_the_option_that_draws_it)
{
    assert_drawn_again("0.06");
    assert_drawn_again("-0.06");
}

// Between two slow frames, the pointer may go far. The stroke follows its path over the clay.
SESSION_TEST(a_stroke_follows_a_quick_drag)
{
    session_open_bare(CHAPTER, OPTIONS "0.06");
    session_said(1);
    user_point(118, 80);
    user_button(GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS);
    for (int i = 1; i <= 30; i++)
        user_point(118.0 + 1.5 * i, 80.0 + 12.0 * sin(0.1 * i));
    session_turn();
    const char *option = let_go();
    int commas = 0;
    for (const char *c = option; *c != '\0'; c++)
        commas += *c == ',';
    assert_true(commas >= 3 * 5); // an amount, and the three numbers of each point
    session_close();
}

SESSION_TEST(strokes_are_taken_back)
{
    sculpt("0.06");
    let_go();
    user_drag(140, 55, 6, 15);
    session_turn();
    let_go();
    session_keep(1);
    session_key(GLFW_KEY_U);
    session_wait(1.0);
    assert_true(session_off(1, NULL) > 0.001);
    assert_true(session_off(0, NULL) > 0.001);
    session_key(GLFW_KEY_U);
    session_wait(1.0);
    session_assert_shown(CHAPTER, OPTIONS "0");
    session_key(GLFW_KEY_U); // there is no stroke left
    session_close();
}

SESSION_TEST(a_stroke_that_is_being_made_is_not_taken_back)
{
    session_open_bare(CHAPTER, OPTIONS "0.06");
    session_said(1);
    user_point(118, 80);
    user_button(GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS);
    session_turn();
    session_shift_key(GLFW_KEY_U);
    user_point(126, 88);
    session_turn();
    assert_int_equal(strncmp(let_go(), "--stroke ", 9), 0);
    session_close();
}

SESSION_TEST(shift_u_also_takes_back_strokes_of_the_command_line)
{
    session_open_bare(CHAPTER, OPTIONS "0.06 --stroke 0.09,-0.36,0.06,-0.38,-0.37,-0.14,-0.25");
    session_shift_key(GLFW_KEY_U);
    session_wait(1.0);
    session_assert_shown(CHAPTER, OPTIONS "0");
    session_close();
}

// The part of a drag that is outside the window changes nothing, in one picture or in two.
SESSION_TEST(a_drag_may_leave_the_window)
{
    static const double far[][2] = {{320, 80}, {1e4, 90},   {-1, 80},   {-1e4, 80},
                                    {160, -1}, {160, -1e4}, {160, 180}, {160, 1e4}};
    static const char *const others[] = {"", " --compare --set turnSpeed=0 --divider 1",
                                         " --compare --set turnSpeed=0 --divider 0"};
    for (int i = 0; i < 3; i++) {
        session_open_bare(CHAPTER, OPTIONS "0.06%s", others[i]);
        for (size_t k = 0; k < sizeof far / sizeof *far; k++) {
            session_said(1);
            user_point(118, 80);
            user_button(GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS);
            session_turn();
            user_point(far[k][0], far[k][1]);
            session_turn();
            const char *option = let_go(), *first = strchr(option, ',');
            assert_int_equal(strncmp(option, "--stroke ", 9), 0);
            for (int commas = 1; commas < 4; commas++) // amount and one point
                first = strchr(first + 1, ',') != NULL ? strchr(first + 1, ',') : first;
            assert_null(strchr(first + 1, ','));
        }
        session_close();
    }
}

// A drag turns the camera if the drag starts beside the clay or if the tool is set to 0.
SESSION_TEST(a_drag_beside_the_clay_looks_around)
{
    sculpt("0");
    assert_string_equal(let_go(), "");
    assert_true(session_off(0, NULL) > 0.05);
    session_close();
    session_open_bare(CHAPTER, OPTIONS "0.06");
    session_said(1);
    session_keep(0);
    user_drag(20, 20, 12, 6);
    session_turn();
    assert_string_equal(let_go(), "");
    assert_true(session_off(0, NULL) > 0.05);
    session_close();
}

TESTS(NULL, NULL)
