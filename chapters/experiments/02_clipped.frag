// Experiment of chapter 02: the highlight warning of a camera. Where at least a given number of
// channels exceed the range of a screen, the picture is painted over in one flat colour. A
// comparison with the original picture shows what fraction of the pixels is clipped.
//
// The macro turns the chapter's call to encodeSRGB into a call to warn; everything else is as in
// the chapter.
#include "main.glsl"
#include "lighting.glsl"

uniform int channels; // 1 in [1, 3]: paint over where at least this many channels are clipped

const vec3 WARNING = vec3(0.85, 0.0, 0.75); // an sRGB value

vec3 warn(vec3 light)
{
    vec3 over = vec3(greaterThan(light, vec3(1.0)));
    return over.r + over.g + over.b > float(channels) - 0.5 ? WARNING : encodeSRGB(light);
}

#define encodeSRGB warn
#include "02_lighting.frag"
