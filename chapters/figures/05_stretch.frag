// The largest stretch of a linear map: drag the tips of the two black arrows, the images of the unit vectors along x
// and y. The map takes the unit circle to the ellipse. The vector that is stretched most is mapped to the longest
// radius of the ellipse, half of the green line. The number at the end of this line is the length of the radius, the
// largest singular value.
#include "figure.glsl"
#include "transform.glsl"

uniform vec2 imageX; // (0.45, 0.0) handle: the image of the unit vector along x
uniform vec2 imageY; // (0.45, 0.45) handle: the image of the unit vector along y

const float UNIT = 0.45; // length of the unit vectors, units of the sheet

float sceneDistance(vec3 p)
{
    return p.z;
}

// The distance to f = 0, accurate enough for a line: f divided by the length of its gradient.
float lineOf(float f)
{
    return f * sheetPixel() / max(length(vec2(dFdx(f), dFdy(f))), 1e-5);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    mat2 m = mat2(imageX, imageY) / UNIT;
    float area = abs(determinant(m)) > 1e-3 ? determinant(m) : 1e-3;
    mat2 back = mat2(m[1].y, -m[0].y, -m[1].x, m[0].x) / area / UNIT;
    vec2 q = back * p; // the map takes UNIT q to p
    float sigma = largestStretch(mat3(vec3(m[0], 0.0), vec3(m[1], 0.0), vec3(0.0)));
    // The longest image of a unit vector: m times the eigenvector of transpose(m) m with the larger eigenvalue.
    mat2 s = transpose(m) * m;
    float angle = 0.5 * atan(2.0 * s[1][0], s[0][0] - s[1][1] + 1e-6);
    vec2 longest = m * vec2(cos(angle), sin(angle));
    vec2 cell = abs(q - floor(q + 0.5)) / vec2(length(vec2(back[0].x, back[1].x)), length(vec2(back[0].y, back[1].y)));
    if (abs(area) > 0.03)
        stroke(min(cell.x, cell.y), 0.8, PALE);
    fill(lineOf(length(q) - 1.0), SKY, 0.8);
    stroke(length(p) - UNIT, 1.5, INK);
    stroke(lineOf(length(q) - 1.0), 2.0, BLUE);
    line2(p, -UNIT * longest, UNIT * longest, 2.5, TEAL);
    arrow(p, vec2(0.0), imageX, 2.0, INK);
    arrow(p, vec2(0.0), imageY, 2.0, INK);
    number(p, UNIT * longest + 0.13 * normalize(longest + 1e-6), sigma, 3, TEAL); // # | largest stretch #
    return sheetColour;
}
