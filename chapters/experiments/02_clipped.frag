// Experiment of chapter 02: the highlight warning of a camera. Where the light exceeds what a screen can
// show, in so many channels or more, the picture is painted over in one flat colour; compared with the
// picture as it was, it says how large a share is cut off.
//
// The chapter's call of encodeSRGB is turned into a call of warn; everything else is the chapter's.
#include "main.glsl"
#include "lighting.glsl"

uniform int channels; // 1 in [1, 3]: paint over where at least so many channels are cut off

const vec3 WARNING = vec3(0.85, 0.0, 0.75); // as the screen shows it

vec3 warn(vec3 light)
{
    vec3 over = vec3(greaterThan(light, vec3(1.0)));
    return over.r + over.g + over.b > float(channels) - 0.5 ? WARNING : encodeSRGB(light);
}

#define encodeSRGB warn
#include "02_lighting.frag"
