#include "options.h"

#include <string.h>

// Option, meaning, default; an empty default is not printed.
static const struct {
    const char *option, *meaning, *initial;
} lines[] = {
    {"-o, --output FILE.png", "render one picture without a window, write it, exit", ""},
    {"-s, --size WxH", "size of the picture in pixels, 1 to 16384 each",
     "960x540 in a window, 640x360 to a file"},
    {"-t, --time SECONDS", "time of the picture", "0"},
    {"-p, --set NAME=VALUE", "set a parameter of the shader; may be repeated", ""},
    {"-c, --camera X,Y,Z,PAN,TILT", "where the eye is, in scene units, and looks, in degrees",
     "the chapter's own"},
    {"-a, --samples N", "N x N samples a pixel, 1 to 8", "1"},
    {"-v, --view NAME", "picture, normals, depth, steps or slice", "picture"},
    {"    --probe X,Y", "print the march of a pixel's ray, the slice's; 0,0 is bottom left", ""},
    {"    --overlay[=SCALE]", "scale of the overlay, 0.5 to 8; draws it into a file too",
     "by the picture's height"},
    {"-b, --backend NAME", "glfw, egl or osmesa",
     "glfw for a window; egl, osmesa, glfw for a file"},
    {"-f, --shader FILE", "run this fragment shader instead of the chapter's", ""},
    {"    --root DIR", "the project's folder", "found from the program's place"},
    {"    --frames N", "N pictures from --time on, as in -o frame-%04d.png", ""},
    {"    --fps F", "pictures a second of --frames", "25"},
    {"    --print-shader[=shadertoy]", "print the shader as one file; one for Shadertoy", ""},
    {"    --benchmark N", "measure compilation, N frames and evaluations of the scene", ""},
    {"    --benchmark=json", "the same as JSON, of 20 frames unless N is given too", ""},
    {"    --list", "print the parameters: name, value, range, unit, meaning", ""},
    {"-h, --help", "print this text", ""},
    {"-V, --version", "print backend, OpenGL version and renderer", ""},
};

static const char controls[] =
    "In the window:\n"
    "  W A S D            move, by the keys' places on an American keyboard\n"
    "  Space, C           up, down (or Left Ctrl); Left Shift moves faster\n"
    "  drag               look; M captures and frees the mouse\n"
    "  click              choose a pixel's ray and show its march; again hides it\n"
    "  wheel              focal length; in the slice its zoom\n"
    "  Tab                perspective or orthographic, where the shader has both\n"
    "  1 2 3 4 5          views: picture, normals, depth, steps, slice\n"
    "  up, down           choose a parameter\n"
    "  left, right        change it, with Shift ten steps; Home resets it\n"
    "  Escape, R          pause and resume; restart the time, with Shift the camera too\n"
    "  H, K               hide and show the overlay; all keys and ranges in it\n"
    "  P, F11             write a screenshot; full screen\n"
    "  Backspace          end\n";

void options_print_help(FILE *file, const char *program, const char *title, const char *shows)
{
    int width = 0;
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        int length = (int)strlen(lines[i].option);
        width = length > width ? length : width;
    }
    fprintf(file, "Usage: %s [OPTION]...\n\n%s\n%s\n\n", program, title, shows);
    fprintf(file, "Without --output or --probe a window opens.\n\n");
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        fprintf(file, "  %-*s  %s\n", width, lines[i].option, lines[i].meaning);
        if (lines[i].initial[0] != '\0')
            fprintf(file, "  %-*s  default: %s\n", width, "", lines[i].initial);
    }
    fprintf(file, "\n%s", controls);
    fprintf(file, "\nExit status: 0 done; 1 it could not be done; 2 the command line is wrong.\n");
}
