// room.glsl - the distance as a collision test: the camera stops at the ground and at the water.
#include "inputs.glsl"
#include "scene.glsl"

// The room around a camera at p, scene units: the distance to the scene, or a lower bound of that distance, minus the
// distance that the camera must keep. A camera that is moved in the window stops where the room would become negative.
// Only chapters that want this behaviour define the function; no picture depends on it.
float cameraRoom(vec3 p);

// Compiled only for the program that moves the camera.
#if VIEW == VIEW_ROOM

uniform vec3 iCameraTo; // where the camera is going, scene units

// Where a camera that moves straight from one point to another comes to rest.
//   from, to  scene units
//   returns   to, if there is room for a camera there; otherwise a point nearby that has room, so that the camera
//             slides along the ground; otherwise from, if no such point is found. The room never falls below
//             min(0, room at from): a camera that begins below the ground can leave it, but goes no deeper
//   formula   Newton's method for room = least, along the gradient g: p - (room - least) g / |g|^2, with steps 1 %
//             longer because of rounding. One step is enough on a plane
vec3 cameraStop(vec3 from, vec3 to)
{
    const float H = 0.004; // step of the differences, scene units
    float room[4], least = 0.0;
    vec3 p = from;
    for (int i = 0; i <= 8; i++) {
        for (int k = 0; k < 4; k++)
            room[k] = cameraRoom(p + H * vec3(k == 1, k == 2, k == 3)) - least;
        if (i > 0 && room[0] >= 0.0)
            return p;
        vec3 slope = (vec3(room[1], room[2], room[3]) - room[0]) / H;
        least = i == 0 ? min(room[0], 0.0) : least;
        p = i == 0 ? to : p - 1.01 * room[0] * slope / max(dot(slope, slope), 1e-6);
    }
    return from;
}

#endif
