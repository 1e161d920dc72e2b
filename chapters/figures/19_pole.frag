// The sky at a latitude: drag the observer (black) along the Earth, and the star (orange), which is so far away that it
// is seen in the same direction from the Earth's centre and from the observer. On the right is the whole sky above the
// observer, with the zenith in the centre, north at the top, and the trails of the stars in an hour and a half. The
// pole (green) is as high as the latitude. The numbers are the latitude, and the star's height when it is due south or
// north of the zenith, in degrees.
#include "figure.glsl"
#include "night.glsl"
#include "repetition.glsl"

uniform vec2  observer; // (-0.62, 0.32) handle: position of the observer
uniform vec2  star;     // (-0.12, 0.12) handle: direction of the star
uniform float hour;     // 22 in [12, 36] step 0.1, hours: solar time; from 24 on it is the next day

const vec2  EARTH = vec2(-1.02, -0.06), SKY_AT = vec2(0.88, 0.0);
const float RADIUS = 0.5, RIM = 0.82;

float sceneDistance(vec3 p)
{
    return sdCircle(p.xy - EARTH, RADIUS);
}

// The position of a direction in the round sky, and the inverse: equal angles become equal lengths. West is on the
// right.
vec2 inSky(vec3 d)
{
    return SKY_AT + RIM * atan(length(d.xz), d.y) / 1.5707963 * normalize(vec2(-d.z, d.x) + 1e-6);
}

vec3 skyDirection(vec2 p)
{
    float angle = 1.5707963 / RIM * length(p);
    vec2 level = sin(angle) * normalize(p + 1e-6);
    return vec3(level.y, cos(angle), -level.x);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), out_ = observer - EARTH, to = star - EARTH;
    float latitude = degrees(atan(out_.y, max(out_.x, 1e-4))), declination = degrees(atan(to.y, max(to.x, 1e-4)));
    vec2 up = vec2(cos(radians(latitude)), sin(radians(latitude))), north = vec2(-up.y, up.x);
    vec2 toStar = vec2(cos(radians(declination)), sin(radians(declination))), at = EARTH + RADIUS * up;

    // The sky of the observer: trails, one in each cell of declination and hour angle, and the circle of the star.
    mat3 turn = skyTurn(hour, latitude);
    vec2 point = p - SKY_AT;
    vec3 d = turn * skyDirection(point);
    vec2 fixed_ = degrees(vec2(atan(d.z, length(d.xy)), atan(d.y, d.x)));
    float band = floor(fixed_.x / 4.0), around = fixed_.y / 45.0 + 4.0 + cellRandom(ivec3(int(band), 20, 20));
    float lot = cellRandom(ivec3(int(band), int(around), 19));
    float across = abs(fixed_.x - 4.0 * (band + 0.2 + 0.6 * lot)), along = 45.0 * fract(around) - 22.0 * fract(7.0 * lot);
    float width = degrees(1.5707963 / RIM) * penWidth(1.0), rim = length(point) - RIM;
    fill(rim, NIGHT, 1.0);
    if (along > 0.0 && along < 22.5)
        fill(max(rim, (across - 0.5 * width) / width * penWidth(1.0)), mix(BLUE, CHALK, fract(31.0 * lot)), 1.0);
    fill(max(rim, (abs(fixed_.x - declination) - 0.8 * width) / width * penWidth(1.0)), ORANGE, 1.0);
    vec3 fixedStar = vec3(toStar.x * vec2(cos(2.0), sin(2.0)), toStar.y), seen = transpose(turn) * fixedStar;
    vec3 pole = vec3(up.x, up.y, 0.0);
    if (seen.y > 0.0)
        dot2(p, inSky(seen), 11.0, ORANGE);
    dot2(p, inSky(latitude < 0.0 ? -pole : pole), 11.0, TEAL);
    stroke(rim, 2.0, INK);

    // The Earth from the side: its axis, the horizon of the observer, the directions of pole and star.
    float earth = sceneDistance(vec3(p, 0.0));
    fill(earth, SKY, 1.0);
    stroke(earth, 2.0, BLUE);
    dashes(p, EARTH - vec2(0.0, 0.72), EARTH + vec2(0.0, 0.72), 1.0, INK);
    dashes(p, EARTH, EARTH + RADIUS * up, 1.0, INK);
    line2(p, at - 0.45 * north, at + 0.45 * north, 2.0, BLUE);
    dashes(p, EARTH, EARTH + length(to) * toStar, 1.0, ORANGE);
    dot2(p, EARTH + length(to) * toStar, 14.0, ORANGE);
    float height = degrees(arcSine(dot(up, toStar))), southern = latitude < 0.0 ? -1.0 : 1.0;
    if (height > 0.0)
        arrow(p, at, at + 0.42 * toStar, 2.0, ORANGE);
    arrow(p, at, at + vec2(0.0, 0.42 * southern), 2.0, TEAL);
    dot2(p, at, 10.0, INK);
    number(p, at + vec2(0.0, 0.5 * southern), abs(latitude), 0, TEAL); // #° | latitude # degrees
    number(p, vec2(0.0, -0.9), height, 0, ORANGE); // height #°
    return sheetColour;
}
