// Solution of exercise 21.5: the mean of Schlick's share over the slopes that the pixel holds, by three of them.
//
// The chapter's call of schlickShare is turned into a call of meanShare, which is told the variance too.
#include "main.glsl"
#include "fresnel.glsl"

// With z = sqrt(3) times the standard deviation, the slopes -z, 0, z along the view have the weights 1/6, 2/3, 1/6.
float meanShare(float facing, float straight, float variance)
{
    float z = sqrt(3.0 * variance), side = sqrt(1.0 - facing * facing), sum = 0.0;
    for (int i = -1; i <= 1; i++) {
        float slope = float(i) * z, turned = (facing + slope * side) * inversesqrt(1.0 + slope * slope);
        sum += (i == 0 ? 4.0 : 1.0) / 6.0 * schlickShare(clamp(turned, 0.0, 1.0), straight);
    }
    return sum;
}

#define schlickShare(facing, straight) meanShare(facing, straight, waves.variance)
#include "21_a_landscape.frag"
