#include "picture/handles.h"

#include <math.h>
#include <string.h>

#define POINTS  3      // points per handle: the handle itself, and one along each axis
#define OFFSET  0.01f  // offset of the other two, as a fraction of the distance to the camera
#define GRID    1000.0 // values are rounded to 1 / GRID scene units
#define STEP    0.125  // longest step of Newton's method, as a fraction of the picture's height
#define ROUNDS  24     // maximum number of steps
#define ARRIVED 0.25   // distance from the pointer at which the method stops, pixels

// Find a handle's position in space.
static void point_of(const struct parameter *parameter, float point[3])
{
    bool flat = parameter->components == 2, ground = parameter->handle == HANDLE_XZ;
    point[0] = (float)parameter->value[0];
    point[1] = flat && ground ? 0.0f : (float)parameter->value[1];
    point[2] = flat ? (ground ? (float)parameter->value[1] : 0.0f) : (float)parameter->value[2];
}

static void axes_of(const struct parameter *parameter, const struct camera *camera,
                    float axis[2][3])
{
    struct camera_basis basis = camera_basis_of(camera);
    memset(axis, 0, 2 * sizeof *axis);
    axis[0][0] = 1.0f;
    axis[1][parameter->handle == HANDLE_XZ ? 2 : 1] = 1.0f;
    if (parameter->handle == HANDLE_SCREEN) {
        memcpy(axis[0], basis.right, sizeof axis[0]);
        memcpy(axis[1], basis.up, sizeof axis[1]);
    }
}

static float offset_of(const float point[3], const struct camera *camera)
{
    float away = 0.0f;
    for (int i = 0; i < 3; i++)
        away = hypotf(away, point[i] - camera->position[i]);
    return OFFSET * fmaxf(away, 0.1f);
}

// Find the positions of points in the picture. pixel receives 4 numbers per point: x and y in
// pixels; 1 if a ray passes through the point, otherwise 0; and 0.
static bool find_pixels(struct renderer *renderer, const struct renderer_inputs *inputs, int count,
                        const float *point, float *pixel)
{
    const struct gl *gl = renderer->gl;
    if (!renderer_link(renderer, VIEW_POSITIONS) ||
        !target_bind(&renderer->points, gl, POINTS * HANDLES_MOST, 1))
        return false;
    renderer_use(renderer, inputs, VIEW_POSITIONS);
    gl->Uniform1i(renderer->used[UNIFORM_iHandlePoints], count);
    gl->Uniform3fv(renderer->used[UNIFORM_iHandlePoint], count, point);
    renderer_clear(gl);
    renderer_fill(renderer, &renderer->points, 0, 0, count, 1);
    gl->Uniform1i(renderer->used[UNIFORM_iHandlePoints], 0);
    target_read(&renderer->points, gl, pixel);
    return true;
}

// The same for a shader without pixelRay: a handle of two components is a place on the screen, and
// one of three is not seen.
static void find_on_screen(const struct renderer_inputs *inputs, const struct handle *handle,
                           int count, float (*point)[3], float (*pixel)[4])
{
    float half[2] = {0.5f * (float)inputs->width, 0.5f * (float)inputs->height};
    for (int i = 0; i < count; i++) {
        const struct parameter *parameter = handle[i / POINTS].parameter;
        for (int k = 0; k < 2; k++)
            pixel[i][k] = half[k] + half[1] * point[i][k];
        pixel[i][2] = parameter->components == 2 && parameter->handle != HANDLE_XZ;
        pixel[i][3] = 0.0f;
    }
}

int handles_find(struct renderer *renderer, const struct renderer_inputs *inputs,
                 struct handle handle[HANDLES_MOST])
{
    float point[POINTS * HANDLES_MOST][3], pixel[POINTS * HANDLES_MOST][4], offset[HANDLES_MOST];
    int count = 0;
    for (int i = 0; i < renderer->parameters.count && count < HANDLES_MOST; i++) {
        struct parameter *parameter = &renderer->parameters.item[i];
        struct handle *at = &handle[count];
        float(*p)[3] = &point[POINTS * count];
        if (parameter->handle == HANDLE_NONE)
            continue;
        *at = (struct handle){.parameter = parameter};
        point_of(parameter, p[0]);
        axes_of(parameter, &inputs->camera, at->axis);
        offset[count] = offset_of(p[0], &inputs->camera);
        for (int k = 0; k < 2; k++)
            for (int c = 0; c < 3; c++)
                p[1 + k][c] = p[0][c] + offset[count] * at->axis[k][c];
        count++;
    }
    if (renderer->fragment.dialect != DIALECT_COURSE)
        find_on_screen(inputs, handle, POINTS * count, point, pixel);
    else if (count > 0 && !find_pixels(renderer, inputs, POINTS * count, point[0], pixel[0]))
        return -1;
    for (int i = 0; i < count; i++) {
        const float(*q)[4] = (const float(*)[4]) & pixel[POINTS * i];
        handle[i].seen = q[0][2] > 0.5f && q[1][2] > 0.5f && q[2][2] > 0.5f;
        memcpy(handle[i].pixel, q[0], sizeof handle[i].pixel);
        for (int k = 0; k < 2; k++)
            for (int c = 0; c < 2; c++)
                handle[i].move[k][c] = (q[1 + k][c] - q[0][c]) / offset[i];
    }
    return count;
}

// Take one step of Newton's method. Returns true if the value changed.
static bool move(const struct handle *handle, const double by[2])
{
    struct parameter *p = handle->parameter;
    const double a[2] = {(double)handle->move[0][0], (double)handle->move[0][1]};
    const double b[2] = {(double)handle->move[1][0], (double)handle->move[1][1]};
    double determinant = a[0] * b[1] - a[1] * b[0];
    bool changed = false;
    if (fabs(determinant) < 1e-9)
        return false;
    const double along[2] = {(by[0] * b[1] - by[1] * b[0]) / determinant,
                             (a[0] * by[1] - a[1] * by[0]) / determinant};
    for (int i = 0; i < p->components; i++) {
        int c = i == 1 && p->components == 2 && p->handle == HANDLE_XZ ? 2 : i; // scene coordinate
        double value = p->value[i] + along[0] * (double)handle->axis[0][c] +
                       along[1] * (double)handle->axis[1][c];
        value = fmin(fmax(round(GRID * value) / GRID, p->minimum), p->maximum);
        changed |= value != p->value[i];
        p->value[i] = value;
    }
    return changed;
}

bool handles_drag(struct renderer *renderer, const struct renderer_inputs *inputs,
                  struct handle handle[HANDLES_MOST], int moved, const double to[2])
{
    struct handle *at = &handle[moved];
    double longest = STEP * inputs->height;
    bool changed = false;
    for (int i = 0; i < ROUNDS && at->seen; i++) {
        double by[2] = {to[0] - (double)at->pixel[0], to[1] - (double)at->pixel[1]};
        double length = hypot(by[0], by[1]), share = fmin(longest / length, 1.0);
        const struct parameter before = *at->parameter;
        by[0] *= share;
        by[1] *= share;
        if (length < ARRIVED || !move(at, by))
            break;
        int count = handles_find(renderer, inputs, handle);
        if (count >= 0 && !at->seen) {
            *at->parameter = before;
            longest *= 0.25;
            count = handles_find(renderer, inputs, handle);
        } else
            changed = true;
        if (count < 0)
            break;
    }
    return changed;
}
