// Highlights in double precision; see gloss.h.
#include "lib/gloss.h"

static struct d3 halfway(struct d3 to_light, struct d3 to_eye)
{
    return d3_unit(d3_add(to_light, to_eye));
}

// GGX in its published form: D G / (4 (N.L) (N.V)), with G from Smith's function Lambda.
static double density(double cosine, double alpha)
{
    double c2 = cosine * cosine, tangent2 = (1.0 - c2) / c2, a2 = alpha * alpha;
    return 1.0 / (MIRROR_PI * a2 * c2 * c2 * pow(1.0 + tangent2 / a2, 2.0));
}

static double lambda(double cosine, double alpha)
{
    double tangent2 = 1.0 / (cosine * cosine) - 1.0;
    return 0.5 * (sqrt(1.0 + alpha * alpha * tangent2) - 1.0);
}

double gloss_ggx(struct d3 to_light, struct d3 to_eye, double roughness)
{
    double alpha = roughness * roughness;
    if (to_light.z <= 0.0 || to_eye.z <= 0.0)
        return 0.0;
    double seen = 1.0 / (1.0 + lambda(to_light.z, alpha) + lambda(to_eye.z, alpha));
    return density(halfway(to_light, to_eye).z, alpha) * seen / (4.0 * to_light.z * to_eye.z);
}

double gloss_bare(struct d3 to_light, struct d3 to_eye, double exponent)
{
    double cosine = halfway(to_light, to_eye).z;
    return to_light.z <= 0.0 || cosine <= 0.0 ? 0.0 : pow(cosine, exponent);
}

double gloss_blinn_phong(struct d3 to_light, struct d3 to_eye, double exponent)
{
    double factor = (exponent + 2.0) * (exponent + 4.0) /
                    (8.0 * MIRROR_PI * (exponent + pow(2.0, -0.5 * exponent)));
    return factor * gloss_bare(to_light, to_eye, exponent);
}

double gloss_usual(struct d3 to_light, struct d3 to_eye, double exponent)
{
    return (exponent + 8.0) / (8.0 * MIRROR_PI) * gloss_bare(to_light, to_eye, exponent);
}

double gloss_exponent(double roughness)
{
    return 2.0 / pow(roughness, 4.0) - 2.0;
}

struct d3 gloss_eye(double cosine)
{
    return d3(sqrt(1.0 - cosine * cosine), 0.0, cosine);
}

// For any model, the half vectors are distributed like the density of a GGX highlight times the
// cosine. Each half vector represents the solid angle 4 (eye . half) / (density cosine) of light.
// Grazing light comes from the long tail of the density, which would contain few half vectors. Half
// vectors are therefore made denser there: s is uniformly distributed, with u = 1 - (1 - s)^3.
double gloss_albedo(gloss_model *model, double parameter, double roughness, double cosine)
{
    enum { SIDE = 384 };
    double alpha = roughness * roughness, sum = 0.0;
    struct d3 eye = gloss_eye(cosine);
    for (int i = 0; i < SIDE; i++) {
        double rest = 1.0 - (i + 0.5) / SIDE, u = 1.0 - rest * rest * rest;
        double tangent = alpha * sqrt(u / (1.0 - u)), part = 3.0 * rest * rest;
        double c = 1.0 / sqrt(1.0 + tangent * tangent);
        for (int k = 0; k < SIDE; k++) {
            // The angles from 0 to pi are enough, because the others mirror them.
            double turn = MIRROR_PI * (k + 0.5) / SIDE;
            struct d3 half = d3(c * tangent * cos(turn), c * tangent * sin(turn), c);
            double facing = d3_dot(eye, half);
            struct d3 light = d3_sub(d3_times(2.0 * facing, half), eye);
            if (facing > 0.0 && light.z > 0.0)
                sum += part * model(light, eye, parameter) * light.z * 4.0 * facing /
                       (density(c, alpha) * c);
        }
    }
    return sum / (SIDE * (double)SIDE);
}

double gloss_mean_albedo(gloss_model *model, double parameter, double roughness)
{
    enum { ANGLES = 24 };
    double sum = 0.0;
    for (int i = 0; i < ANGLES; i++)
        sum += gloss_albedo(model, parameter, roughness, sqrt((i + 0.5) / ANGLES));
    return sum / ANGLES;
}
