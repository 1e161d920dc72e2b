// Chapter 23: stored distances. A clay elephant whose distance is stored in a grid, and a tool that
// adds or removes clay.
//
// The page is docs/23_stored_distances.md.
#include "../common/chapter.h"

#include <math.h>

#include "../shaders/textures/elephant.h"
#include "../shaders/textures/sculpt.h"

// Map a point of the scene to the elephant's coordinates.
//   angle  by which the turntable has turned, radians
static void turn_back(const double p[3], double angle, double q[3])
{
    double c = cos(angle), s = sin(angle);
    q[0] = c * p[0] - s * p[2];
    q[1] = p[1];
    q[2] = s * p[0] + c * p[2];
}

// Find the point of the clay under the pointer. Returns false if there is none.
static bool aim(const unsigned char *grid, const struct sculpture_aim *aim, double point[3])
{
    const struct parameter *turn = parameters_find(aim->parameters, "turn");
    const struct parameter *speed = parameters_find(aim->parameters, "turnSpeed");
    double degrees = turn != NULL ? turn->value[0] : 0.0, length = 0.0;
    degrees += speed != NULL ? speed->value[0] * aim->time : 0.0;
    double angle = degrees * 3.14159265358979 / 180.0, eye[3], way[3];
    turn_back(aim->eye, angle, eye);
    turn_back(aim->point, angle, way);
    for (int i = 0; i < 3; i++) {
        way[i] -= eye[i];
        length += way[i] * way[i];
    }
    for (int i = 0; i < 3; i++)
        way[i] /= sqrt(length);
    return length > 0.0 && sculpt_march(grid, eye, way, point);
}

int main(int argc, char **argv)
{
    static const struct sculpture_tool tool = {
        .texture = "grid",
        .size = {ELEPHANT_SIDE, ELEPHANT_SIDE, ELEPHANT_SIDE},
        .amount = "tool",
        .aim = aim,
        .work = sculpt_piece,
    };
    const struct chapter chapter = {
        .stem = "23_stored_distances",
        .title = "23 Stored distances",
        .shows = "A clay elephant, stored as distances in a grid, on a turntable.",
        .camera = {.position = {0.0f, 0.38f, 2.4f}, .pan = 0.0f, .tilt = -12.0f},
        .tool = &tool,
    };
    return chapter_run(&chapter, argc, argv);
}
