// Solution to exercise 21.2: snow down to an adjustable height, as there is late in the year, and
// grass that ends below it.
//
// The chapter's call to landColour becomes a call to winterColour.
#include "main.glsl"
#include "valley.glsl"

uniform float snowLine; // 4.3 in [-1, 12] step 0.25, scene units: middle of the range of heights in which rock turns white

vec3 winterColour(vec3 p, vec3 direction, vec3 normal, float chance, float width)
{
    return landColour(vec3(p.x, p.y + 4.3 - snowLine, p.z), direction, normal, chance, width);
}

#define landColour winterColour
#include "21_a_landscape.frag"
