// The report's figure 11, redrawn: slender towers on lawns between two roads, a lamp in front of them, the sky of the
// hour, and reflections of all this in the windows.
//
// The hour, the sky and the exposure are those of chapter 09, two of whose functions are renamed. As in
// 16_report_boxes.frag, the ray from the eye and the reflected ray share one loop.
#include "main.glsl"
#define sceneDistance chapterSceneDistance
#define rayColour chapterRayColour
#include "09_sky_and_sunset.frag"
#undef sceneDistance
#undef rayColour
#include "coarse.glsl"  // coarseStart
#include "hue.glsl"     // hsvToRGB
#include "fresnel.glsl" // schlickShare

uniform int  rays;    // 2 in [1, 2]: only the ray from the eye, or also the reflected ray
uniform bool clipped; // true: march only between the ground and the highest roof
uniform bool parks;   // true: the distance takes into account where there are no towers

// Lengths as measured in the figure; a scene unit is about a metre. As in chapter 09, x is north
// and z east.
const float PLOT = 5.0;                            // distance between the centres of neighbouring towers
const float BLOCK = 25.0;                          // distance from road to road: four plots and the road
const float ROAD = 2.5;                            // half the width of a road
const float FLOOR = 1.7;                           // height of a floor; a tower is 2 wide
const float HIGHEST = 20.0 * FLOOR;                // no roof is higher
const vec2  PANE = vec2(0.84, 0.69);               // half the size of a window's pane, along the wall and up
const float RECESS = 0.12;                         // how far the pane lies behind the wall
const vec3  POST = vec3(-2.7, 0.0, 6.3);           // foot of the lamp
const vec3  GLOBE = vec3(0.0, 2.95, 0.0);          // centre of the lamp's globe, relative to the foot
const float GLOBE_RADIUS = 0.42;
const float TAPER = 0.48;                          // slope of the post's foot
const float CITY_FAR = 110.0;                      // a ray that has travelled this far meets the sky
const float SHADOW = 40.0;                         // length of a shadow ray
const float NEAR = 0.001;                          // the distance that counts as a hit, for the ray from the eye
const int   STEPS = 400;                           // steps after which a ray is abandoned

// A point in the coordinates of its plot.
struct Plot {
    vec2  local;  // from the centre of the plot: x and z
    vec2  aside;  // the absolute values of local: perpendicular to the nearest wall, and along the wall
    float floors; // number of floors of the tower; 0 on a road or in a park
};

// The plot of a point. Every second row of blocks is a park.
Plot plotAt(vec3 p)
{
    vec2 cell = vec2(cellOf(p.x, PLOT), cellOf(p.z, PLOT)), local = p.xz - PLOT * cell, aside = abs(local);
    float floors = floor(9.0 + 12.0 * cellRandom(ivec3(cell, 3)));
    bool built = min(mod(cell.x, 5.0), mod(cell.y, 5.0)) > 0.0 && mod(cell.y, 10.0) > 5.0;
    return Plot(local, aside.x > aside.y ? aside : aside.yx, built ? floors : 0.0);
}

// The distances to the walls of a tower and to the plane of its roof. A tower is a box without a bottom.
//   max of the two  a lower bound
vec2 outsideTower(Plot plot, float y)
{
    return vec2(plot.aside.x - 1.0, y - FLOOR * plot.floors);
}

// A lower bound of the distance to the lamp, a globe on a post with a wider foot.
float postDistance(vec3 q)
{
    float post = 0.9 * (length(q.xz) - 0.13 - TAPER * max(0.4 - q.y, 0.0)); // 0.9 sqrt(1 + TAPER^2) < 1
    return min(max(post, q.y - GLOBE.y), sdSphere(q - GLOBE, GLOBE_RADIUS));
}

// The smallest of the distance to the tower of this plot, the distance to the lamp, and a lower bound for all other
// towers. The result is a lower bound and 1-Lipschitz.
float sceneDistance(vec3 p)
{
    Plot plot = plotAt(p);
    float others = PLOT - 1.0 - plot.aside.x, row = abs(opRepeat(p.z + 0.5 * BLOCK, 2.0 * BLOCK)) - 8.5;
    vec2 outside = outsideTower(plot, p.y);
    float tower = plot.floors > 0.0 ? max(outside.x, outside.y) : CITY_FAR;
    return min(min(tower, parks ? max(others, row) : others), postDistance(p - POST));
}

// ---- Where a ray ends: the march finds towers and the lamp, the ground ends the interval ----

// The normal of a tower: upwards on its roof, otherwise that of the nearest wall.
vec3 towerNormal(Plot plot, vec2 outside)
{
    vec2 wall = abs(plot.local.x) < abs(plot.local.y) ? vec2(0.0, sign(plot.local.y)) : vec2(sign(plot.local.x), 0.0);
    return outside.y > outside.x ? vec3(0.0, 1.0, 0.0) : vec3(wall.x, 0.0, wall.y);
}

vec3 postNormal(vec3 q)
{
    vec3 post = vec3(q.x, q.y < 0.4 ? TAPER * length(q.xz) : 0.0, q.z);
    return normalize(length(q - GLOBE) < GLOBE_RADIUS + 0.05 ? q - GLOBE : post);
}

// Where a ray ends, and how that point appears in the pixel.
struct Spot {
    vec3  p, normal;
    float t, width;           // distance to p along the ray; width of the pixel at p, scene units
    float facing;             // cosine of the angle between normal and ray, at least 0.03
    bool  met, ground, post;  // on a tower if met and neither ground nor post
};

// The t at which a march ends at the latest: there are objects only between the ground and the highest roof.
float cityEnd(Ray ray, float far)
{
    vec2 crossing = (vec2(0.0, HIGHEST) - ray.origin.y) / ray.direction.y;
    return clipped || ray.direction.y < 0.0 ? min(max(crossing.x, crossing.y), far) : far;
}

// The threshold of the ray from the eye does not grow, so that outlines are the same wherever a
// march began.
float coarseMargin(float t)
{
    return NEAR;
}

// March along a ray, and describe the point where it ends.
//   start  length of the path to the ray's origin
//   clear  t up to which the ray is known to be free
Spot spotAlong(Ray ray, float start, float clear)
{
    float spread = footprint * pixelSpread(), end = cityEnd(ray, CITY_FAR);
    Hit hit = marchCone(ray, clear, end, NEAR + spread * start, start > 0.0 ? spread : 0.0, STEPS);
    float t = hit.found ? hit.t : end;
    vec3 p = ray.origin + t * ray.direction, q = p - POST;
    bool ground = !hit.found && p.y < 0.01, met = hit.found || ground, post = length(q.xz) < 0.7 && !ground;
    Plot plot = plotAt(p);
    vec2 outside = outsideTower(plot, p.y);
    vec3 normal = ground ? vec3(0.0, 1.0, 0.0) : post ? postNormal(q) : towerNormal(plot, outside);
    float facing = max(-dot(normal, ray.direction), 0.03);
    float rest = ground || post ? 0.0 : max(outside.x, outside.y) / facing; // remaining distance to the wall
    if (met) { // report the ground to the views and the probe too
        traceNormal(normal);
        traceMarch(trace.steps, t, END_HIT);
    }
    t += rest;
    return Spot(p + rest * ray.direction, normal, t, 2.0 * spread * (start + t), facing, met, ground, post);
}

// ---- Light ----

// The share of a pixel that lies within the windows of a wall.
//   at  position on the wall: along the wall from its centre, and upwards
float openingAt(vec2 at, Spot spot)
{
    vec2 inside = PANE - abs(vec2(at.x, mod(at.y, FLOOR) - 0.5 * FLOOR));
    return coverage(inside.x, spot.width / spot.facing) * coverage(inside.y, spot.width);
}

// A window is a shallow box. Returns the share of the pixel that looks into it, and the share of this part that sees
// the pane at its back and not a side.
vec2 windowAt(Spot spot, vec3 direction)
{
    vec3 along = abs(spot.normal.zyx), local = plotAt(spot.p).local.xxy;
    vec2 at = vec2(dot(local, along), spot.p.y);
    vec2 behind = at + RECESS / spot.facing * vec2(dot(direction, along), direction.y);
    bool wall = spot.met && !spot.ground && !spot.post && spot.normal.y == 0.0;
    return wall ? vec2(openingAt(at, spot), openingAt(behind, spot)) : vec2(0.0);
}

// Lawns mown in stripes, and roads.
vec3 groundColour(Spot spot)
{
    float width = spot.width / spot.facing;
    vec2 road = abs(vec2(opRepeat(spot.p.x, BLOCK), opRepeat(spot.p.z, BLOCK))) - ROAD;
    float mown = mix(stripes(0.5 * spot.p.x, 0.5, 0.5 * width), 0.5, blurred(0.5 * width));
    vec3 lawn = mix(vec3(0.030, 0.085, 0.018), vec3(0.042, 0.115, 0.025), mown);
    return mix(vec3(0.030, 0.030, 0.045), lawn, coverage(min(road.x, road.y), width));
}

// The light from a spot to the eye, except for the light that its glass reflects. The globe emits
// light itself, with a hue that depends on the hour, as in the figure.
//   toLight, beam, sky  direction and light of the sun or the moon; and the light of the whole sky
vec3 spotLight(Spot spot, vec2 window, vec3 toLight, vec3 beam, vec3 sky)
{
    Ray ray = shadowRay(spot.p, spot.normal, toLight, 0.03 + spot.width);
    float far = spot.met ? shadowReach(spot.normal, toLight, cityEnd(ray, SHADOW)) : 0.0;
    float seen = lightReaching(ray, far, 0.01 + 0.5 * spot.width, 64);
    vec3 tower = mix(vec3(0.36, 0.35, 0.33), mix(vec3(0.11), vec3(0.01, 0.02, 0.03), window.y), window.x);
    vec3 colour = spot.ground ? groundColour(spot) : spot.post ? vec3(0.1) : tower;
    bool globe = spot.post && length(spot.p - POST - GLOBE) < GLOBE_RADIUS + 0.05;
    vec3 light = colour * ((0.6 + 0.4 * spot.normal.y) * sky + seen * lambert(spot.normal, toLight) * beam);
    return globe ? (0.6 + 0.4 * spot.facing) * hsvToRGB(20.0 * (hour() - 7.2), 0.6, 0.85) : light;
}

vec3 rayColour(Ray ray)
{
    vec3 sun = sunDirection(hour(), LATITUDE, DECLINATION), light = vec3(0.0), share = vec3(1.0);
    vec3 beam = sunOrMoonLight(sun, airDepth()), around = skyAmbient(sun, airDepth()) + 0.1 * beam;
    float start = 0.0, clear = coarseStart(ray);
    for (int turn = 0; turn < rays && share.y > 0.0; turn++) {
        vec3 sky = skyLight(vec3(ray.direction.x, max(ray.direction.y, 0.0), ray.direction.z), sun);
        Spot spot = spotAlong(ray, start, clear);
        vec2 window = windowAt(spot, ray.direction);
        vec3 air = vec3(exp(-0.00004 * spot.t * spot.t));
        light += share * (spot.met ? mix(sky, spotLight(spot, window, lightDirection(sun), beam, around), air) : sky);
        share *= air * window.x * window.y * schlickShare(spot.facing, 0.3) * vec3(0.75, 0.9, 1.0);
        start += spot.t;
        clear = 0.0;
        ray = Ray(spot.p + (0.02 + spot.width) * spot.normal, reflect(ray.direction, spot.normal));
    }
    return exposed(light, sun);
}
