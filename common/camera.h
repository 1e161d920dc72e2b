// camera.h - the position of the eye and the direction in which it looks.
//
// The world is right-handed, and y is up. With pan 0 and tilt 0, the camera looks along -z. A
// positive pan turns it to the right (towards +x), and a positive tilt turns it upwards.
#ifndef CAMERA_H
#define CAMERA_H

#include <cglm/cglm.h>

// The limit of the tilt upwards and downwards. If the view direction were vertical, forward x
// (0, 1, 0) would be zero, and "right" would be undefined.
#define CAMERA_TILT_LIMIT 89.0f // degrees

struct camera {
    vec3 position; // scene units
    float pan;     // degrees, any value; camera_turn wraps it into [-180, 180)
    float tilt;    // degrees, in [-CAMERA_TILT_LIMIT, CAMERA_TILT_LIMIT]
};

// The orthonormal, right-handed frame of the eye: right x up = -forward.
struct camera_basis {
    vec3 right, up, forward;
};

// Return the frame of a camera:
//   forward = (sin pan cos tilt, sin tilt, -cos pan cos tilt)
//   right   = normalize(forward x (0, 1, 0)) = (cos pan, 0, sin pan)
//   up      = right x forward
//   camera  must have a tilt within the limit; its position is not used
struct camera_basis camera_basis_of(const struct camera *camera);

// Turn the camera by angles in degrees. The tilt stops at its limit, and the pan wraps into
// [-180, 180).
void camera_turn(struct camera *camera, float pan, float tilt);

// Move the camera.
//   direction  (right, up, forward), each usually -1, 0 or 1; right and forward are those of the
//              view, but up is the world's y. A zero direction does not move the camera; any other
//              is normalised, so that the camera is no faster along a diagonal.
//   distance   scene units: speed times seconds, so that the path does not depend on the frame rate
void camera_move(struct camera *camera, const float direction[3], float distance);

#endif
