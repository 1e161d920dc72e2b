#include "camera.h"

#include <math.h>

// The basis is computed in double, because cos(tilt) loses digits in float near the tilt's limit.
struct camera_basis camera_basis_of(const struct camera *camera)
{
    double pan = (double)camera->pan * GLM_PI / 180.0;
    double tilt = (double)camera->tilt * GLM_PI / 180.0;
    return (struct camera_basis){
        .right = {(float)cos(pan), 0.0f, (float)sin(pan)},
        .up = {(float)(-sin(pan) * sin(tilt)), (float)cos(tilt), (float)(cos(pan) * sin(tilt))},
        .forward = {(float)(sin(pan) * cos(tilt)), (float)sin(tilt),
                    (float)(-cos(pan) * cos(tilt))},
    };
}

void camera_turn(struct camera *camera, float pan, float tilt)
{
    double turned = fmod((double)camera->pan + (double)pan + 180.0, 360.0);
    float wrapped = (float)(turned < 0.0 ? turned + 180.0 : turned - 180.0);
    // A double just below 180 may be rounded to the float 180.
    camera->pan = wrapped >= 180.0f ? -180.0f : wrapped;
    camera->tilt = glm_clamp(camera->tilt + tilt, -CAMERA_TILT_LIMIT, CAMERA_TILT_LIMIT);
}

void camera_move(struct camera *camera, const float direction[3], float distance)
{
    struct camera_basis basis = camera_basis_of(camera);
    vec3 path = {0.0f, direction[1], 0.0f};
    glm_vec3_muladds(basis.right, direction[0], path);
    glm_vec3_muladds(basis.forward, direction[2], path);
    // If the camera is tilted, forward and the world's up are not perpendicular, so the length of
    // path may differ from that of direction.
    float length = glm_vec3_norm(path);
    if (length > 1e-6f)
        glm_vec3_muladds(path, distance / length, camera->position);
}
