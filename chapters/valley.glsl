// valley.glsl - the scene of chapter 21: a lake between mountains, and the objects on its shore.
//
// One scene unit is 100 metres. x points north, y up, z east; the water is y = 0. The valley faces
// south-south-west. Most of this file uses the axes of the valley: x right, y up, z ahead, and in
// the plane x right, y ahead.
#include "inputs.glsl"     // iTime
#include "land.glsl"
#include "water.glsl"      // fourWaves; the lookups of texture.glsl
#include "bounds.glsl"     // boxInterval, intervalUnion
#include "repetition.glsl" // cellRandom

const vec2  AHEAD = vec2(-0.9063, -0.4226); // the direction ahead (north, east): 205 degrees
const float CELLS = 0.08;                   // cells of the noise of the largest ridges per scene unit
const vec2  SEED = vec2(31.2, 9.9);         // offset of the noise; another offset gives other mountains
const float GAIN = 0.42;                    // weight of an octave of ridges relative to the one before
const float LACUNARITY = 2.1;               // how much finer an octave is than the one before
const mat2  TURN = mat2(0.8, 0.6, -0.6, 0.8); // rotation from octave to octave, so that no lattice is visible
const vec2  SHIFT = vec2(17.17, 29.73);     // offset from octave to octave
const float FOOT = 0.4;                     // height of the hills at which ridges begin, scene units
const float RIDGES = 3.6;                   // ridges add at most this factor times the height above FOOT
const float HILL_SLOPE = 0.45;              // no hill is steeper than this
const float SHORE_SLOPE = 0.204;            // the shore is no steeper than this
const float HIGHEST = 18.8;                 // no land is higher: 4.4 + RIDGES (4.4 - FOOT), with hills up to 4.4
const vec2  MIDDLE = vec2(20.0, 95.0);      // centre of a circle that contains the valley: right, ahead
const vec3  SWELL_X = vec3(0.0023, -0.0087, -0.0053); // periods of the three waves of the land around, per unit to the right
const vec3  SWELL_Z = vec3(0.0084, 0.0044, -0.0042); // the same, per unit ahead
const vec3  SWELL = vec3(18.0, 16.0, 20.0); // 16 times the heights of these waves, scene units
const float SWELL_SUNK = 0.975;             // depth of their mean below the water: no crest is higher than 2.4
const vec3  SWELL_START = vec3(0.83, 0.39, 0.15);   // where they begin, periods
const vec3  SWELL_STEP = vec3(0.731, 0.818, 0.692); // how far they move from one seed to the next, periods
const float SEA_FOOT = -1.6;                // their FOOT: ridges that begin below the water give the coast its bays

uniform sampler2D turf;    // "turf.png" sRGB repeat: a meadow
uniform sampler2D granite; // "granite.png" sRGB repeat: rock

uniform int seed;    // 0 in [0, 99]: number of the land around the valley
uniform int octaves; // 4 in [1, 8]: octaves of the ridges in the march

// A gap above the land is divided by way.x + way.y s where the slope is s, and a gap above the shore
// by way.z. For a ray that climbs or descends by c per unit, way is oneWay(c). For all directions it
// is (0.65, 1, 1.03): these divisors are at least sqrt(1 + s^2) for s >= HILL_SLOPE and for the shore.
const vec3 ALL_WAYS = vec3(0.65, 1.0, 1.03);
vec3 way = ALL_WAYS;

vec3 oneWay(float climb)
{
    return vec3(climb, 1.0, climb + SHORE_SLOPE);
}

// The vertical gap between the land and the point for which landDistance was last called, scene units.
float overLand = 0.0;

// Convert north and east to right and ahead in the valley, and back.
vec2 inValley(vec2 xz)
{
    return vec2(dot(xz, vec2(-AHEAD.y, AHEAD.x)), dot(xz, AHEAD));
}

vec2 fromValley(vec2 q)
{
    return q.x * vec2(-AHEAD.y, AHEAD.x) + q.y * AHEAD;
}

// The shore on which the eye is, a rounded cone: height (x), gradient (yz).
vec3 shore(vec2 q)
{
    vec2 r = q - vec2(-1.45, 0.5);
    r.y *= 1.2;
    float d = sqrt(dot(r, r) + 0.04);
    return vec3(0.26 - 0.17 * d, -0.17 * r * vec2(1.0, 1.2) / d);
}

// The land around the valley, without ridges: the sum of three waves, except in a circle that contains the valley.
//   returns  height (x), gradient (yz), and the height at which its ridges begin (w): FOOT in the circle, SEA_FOOT
//            outside, and numbers in between only where the land is not higher than the bottom of the lake
vec4 landSwell(vec2 q)
{
    vec2 away = q - MIDDLE;
    vec3 s = SWELL_X * q.x + SWELL_Z * q.y + SWELL_START + SWELL_STEP * float(seed);
    s -= floor(s + 0.5);
    vec3 slope = SWELL * (0.5 - 2.0 * abs(s));
    float wave = dot(SWELL, s * (0.5 - abs(s))) - SWELL_SUNK, circle = 0.001 * dot(away, away) - 16.0;
    vec3 h = circle < wave ? vec3(circle, 0.002 * away) : vec3(wave, dot(slope, SWELL_X), dot(slope, SWELL_Z));
    return vec4(h, clamp(FOOT - 2.0 * (circle + 4.0), SEA_FOOT, FOOT));
}

// The hills without ridges and without the shore: height (x), gradient (yz), height at which their ridges begin (w).
vec4 hills(vec2 q)
{
    vec3 h = hill(q - vec2(4.0, 46.0), vec2(43.0, 25.5), 7.4);
    h = higherGround(h, hill(q - vec2(-25.0, 24.0), vec2(24.0, 24.5), 7.0));
    h = higherGround(h, hill(q - vec2(64.0, 90.0), vec2(58.0, 42.0), 6.4));
    h = higherGround(h, hill(q - vec2(19.0, 22.0), vec2(13.0, 12.5), 3.6));
    h.x -= 3.0;
    vec4 other = landSwell(q);
    return vec4(higherGround(h, other.xyz), other.w);
}

// The largest height of the ridges above the hills (x), and its growth with the hills' height (y).
//   foot  the height of the hills at which ridges begin
vec2 roughness(float height, float foot)
{
    return height > foot ? vec2(RIDGES * (height - foot), RIDGES) : vec2(0.0);
}

// The height that the hills must have before the land can reach y: the inverse of
// height + roughness(height, foot).x.
float hillsUnder(float y, float foot)
{
    return min(y, foot + (y - foot) / (1.0 + RIDGES));
}

// A lower bound of the distance to the land: the largest of several bounds. The first uses only the
// hills: the land cannot reach p.y before the hills reach hillsUnder. Each octave of ridges
// gives another bound, because the octaves that follow add at most the rest of the weights. Octaves
// are evaluated while they can still enlarge the result. The shore has no ridges; the result is the
// smaller of the bound for the shore and the bound for the hills.
//   count    number of octaves of the ridges
//   returns  with ALL_WAYS a distance, 1-Lipschitz; otherwise the free length along a ray
float landDistance(vec3 p, int count)
{
    vec2 q = inValley(p.xz), x = CELLS * q + SEED;
    vec4 ground = hills(q);
    float base = ground.x, over = p.y - base, high = roughness(base, ground.w).x;
    float hilly = way.x + way.y * HILL_SLOPE, growth = way.y * RIDGES * HILL_SLOPE;
    float weight = 1.0 - GAIN, rest = 1.0, sum = 0.0, first = 1.0;
    float steep = way.y * 2.0 * VALUE_STRETCH * CELLS, slope = (1.0 + weight) * steep;
    float d = (hillsUnder(p.y, ground.w) - base) / hilly, coast = p.y - shore(q).x, least = 0.0;
    bool counts = true;
    for (int i = 0; i < count && counts; i++) {
        float ridge = ridged(groundNoise(x)).x;
        first = i == 0 ? ridge : first;
        sum += weight * ridge;
        rest = i + 1 < count ? rest - weight : 0.0;
        float most = first * (sum + rest);
        least = first * sum;
        d = max(d, wayToClose(over - high * most, hilly + growth * most + high * slope, 2.0 * growth * slope));
        weight *= GAIN;
        steep *= LACUNARITY;
        slope += weight * steep;
        counts = over - high * least > d * (hilly + growth * least + slope * (high + growth * d));
        x = LACUNARITY * TURN * x + SHIFT;
    }
    overLand = min(over - high * least, coast);
    return min(d, coast / way.z);
}

// The land at a point: height (x), gradient (yz), and, for its colours, a value in [0, 1] that
// varies from point to point (w).
//   count  octaves, any value >= 1; the last one is weighted by the fractional part
vec4 landAt(vec2 q, float count)
{
    vec4 ground = hills(q);
    vec3 base = higherGround(ground.xyz, shore(q)), sum = vec3(0.0), first = vec3(1.0, 0.0, 0.0);
    vec2 high = roughness(base.x, ground.w), x = CELLS * q + SEED;
    float weight = 1.0 - GAIN, fine = 0.5, scale = CELLS;
    vec2 grain = vec2(0.0);
    mat2 turn = mat2(CELLS);
    for (int i = 0; i < int(count) + 1; i++) {
        vec3 noise = groundNoise(x);
        noise.yz = noise.yz * turn;
        vec3 ridge = ridged(noise);
        first = i == 0 ? ridge : first;
        float share = clamp(count - float(i), 0.0, 1.0);
        sum += share * weight * ridge;
        fine = mix(fine, noise.x, 0.45 * share);
        grain += i > 3 ? share * noise.yz / scale : vec2(0.0);
        scale *= LACUNARITY;
        weight *= GAIN;
        x = LACUNARITY * TURN * x + SHIFT;
        turn = LACUNARITY * TURN * turn;
    }
    vec3 rough = vec3(first.x * sum.x, first.yz * sum.x + first.x * sum.yz);
    return vec4(base.x + high.x * rough.x, base.yz * (1.0 + high.y * rough.x) + high.x * rough.yz + 0.16 * grain, fine);
}

// The colour of the land: grass, rock or snow, depending on slope and height.
//   chance  the value w of landAt; without it all borders would be contour lines
//   width   of the pixel at p
vec3 landColour(vec3 p, vec3 direction, vec3 normal, float chance, float width)
{
    Footprint f = footprintOn(direction, normal, 0.577 * width);
    vec3 weights = twoPlaneWeights(planeWeights(normal, 4.0)), snow = vec3(0.85, 0.87, 0.90);
    vec3 stone = textureOnPlanes(granite, 0.35 * p, footprintSeen(f, mat3(1.0), 0.35), weights).rgb;
    vec3 grass = textureFromAbove(turf, 9.0 * p, footprintSeen(f, mat3(1.0), 5.0)).rgb * mix(0.5, 1.6, chance);
    vec3 wood = mix(vec3(0.010, 0.022, 0.010), vec3(0.045, 0.055, 0.02), chance);
    vec3 rock = stone * mix(vec3(0.30, 0.28, 0.27), vec3(0.80, 0.74, 0.68), chance);
    float uneven = chance - 0.5, level = normal.y + 0.3 * uneven, height = p.y + 2.0 * uneven;
    vec3 green = mix(grass, wood, smoothstep(0.25, 0.5, p.y + 0.3 * uneven));
    vec3 colour = mix(rock, green, smoothstep(0.55, 0.70, level) * (1.0 - smoothstep(2.3, 3.9, height)));
    colour = mix(colour, snow, smoothstep(0.48, 0.64, level) * smoothstep(3.6, 5.0, height));
    return mix(stone * mix(0.3, 0.6, chance), colour, smoothstep(0.002, 0.014, p.y + 0.01 * uneven));
}

// ---- The lake ----

const float BEAT = 0.2617994; // 2 pi / 24 s: waves whose frequencies are multiples of it repeat after 24 s

// Eight waves in all directions, steeper in gusts.
//   wind  in [0, 1]
Water wavesAt(vec2 p, Footprint f, float wind)
{
    float gust = wind * (0.3 + 0.7 * smoothstep(0.35, 0.75, groundNoise(0.5 * p).x)), beat = BEAT * iTime;
    Water swell = fourWaves(p, f, vec4(55.0, -80.0, 120.0, 170.0), vec4(30.0, 70.0, -40.0, 90.0),
                            gust * vec4(0.03, 0.03, 0.025, 0.025), beat * vec4(9.0, 12.0, 13.0, 17.0));
    Water ripples = fourWaves(p, f, vec4(-250.0, 310.0, 480.0, -700.0), vec4(120.0, -300.0, 350.0, 250.0),
                              gust * vec4(0.03, 0.025, 0.02, 0.02), beat * vec4(20.0, 25.0, 29.0, 33.0));
    return Water(swell.slope + ripples.slope, swell.variance + ripples.variance + 3e-5);
}

// ---- The objects on the shore ----

const vec3 CABIN = vec3(-0.50, 0.094, 0.74); // position: right, up, ahead
const float CABIN_SIZE = 1.35;
const vec3 BOAT = vec3(0.62, 0.0, 1.75);
const float CELL = 0.175;                   // side of a cell of the wood, scene units
const vec3 BOAT_REACH = vec3(0.04, 0.1, 0.02);
const vec3 GROVE_LOW = vec3(-1.7, 0.0, 0.6), GROVE_HIGH = vec3(-0.2, 0.38, 1.75);

vec3 atCabin(vec3 p)
{
    p -= CABIN;
    return vec3(0.94 * p.x + 0.34 * p.z, p.y, 0.94 * p.z - 0.34 * p.x) / CABIN_SIZE;
}

// A lower bound of the distance to a box, exact in front of its faces.
float block(vec3 p, vec3 halfSize)
{
    vec3 q = abs(p) - halfSize;
    return max(q.x, max(q.y, q.z));
}

float cabinDistance(vec3 p)
{
    vec3 q = atCabin(p);
    float slope = dot(vec2(abs(q.z), q.y - 0.066), vec2(0.64, 0.768)), low = -0.02 - q.y;
    float walls = max(block(vec3(q.x, 0.0, q.z), vec3(0.042, 1.0, 0.03)), max(slope, low));
    float roof = max(abs(slope) - 0.003, block(vec3(q.x, 0.0, q.z), vec3(0.05, 1.0, 0.042)));
    float chimney = block(q - vec3(0.02, 0.062, 0.012), vec3(0.006, 0.018, 0.006));
    return CABIN_SIZE * min(min(walls, roof), chimney);
}

// A pine: a stem, and a crown whose width grows and shrinks in tiers.
float pineDistance(vec3 p, float height)
{
    float s = height - p.y, tier = abs(fract(0.9 + 42.0 * s) - 0.5), across = length(p.xz);
    float radius = 0.24 * max(s, 0.0) * (0.62 + 0.76 * tier);
    float crown = max(0.6 * (across - radius), max(0.16 * height - p.y, -s));
    return min(crown, max(across - 0.025 * height, abs(p.y - 0.1 * height) - 0.12 * height));
}

// The pine of a cell: its position (x right, y ahead), the height of the ground at its foot (z) and
// the height of the pine (w), which is 0 if the cell has no pine.
vec4 pineOf(vec2 cell)
{
    float lot = cellRandom(ivec3(cell, 5)), other = fract(64.0 * lot);
    vec2 at = CELL * (cell + 0.5) + 0.02 * (2.0 * vec2(other, fract(64.0 * other)) - 1.0);
    bool grows = lot < 0.62 && at.y > 0.86 + 0.9 * max(at.x + 0.75, 0.0) && at.x < -0.2;
    return vec4(at, shore(at).x - 0.005, grows ? 0.13 + 0.13 * other : 0.0);
}

// A wood: at most one pine in each cell of a lattice, far enough from the walls of the cell that no
// pine in another cell is nearer than the returned distance.
float pinesDistance(vec3 p)
{
    vec2 cell = floor(p.xz * (1.0 / CELL)), wall = 0.5 * CELL - abs(p.xz - CELL * (cell + 0.5));
    vec4 pine = pineOf(cell);
    float free = 0.008 + min(wall.x, wall.y);
    return min(free, pine.w > 0.0 ? pineDistance(p - pine.xzy, pine.w) : 1.0);
}

// A hull, a mast and two sails.
float boatDistance(vec3 p)
{
    vec3 q = p - BOAT;
    float hull = max(length(vec3(0.35 * q.x, q.y - 0.006, q.z)) - 0.010, q.y - 0.008);
    float mast = block(q - vec3(0.0, 0.045, 0.0), vec3(0.0009, 0.045, 0.0009));
    float sail = max(max(q.x + 0.001, 0.013 - q.y), 0.924 * -q.x + 0.383 * (q.y - 0.013) - 0.0275);
    float jib = max(max(0.002 - q.x, 0.015 - q.y), 0.943 * q.x + 0.333 * (q.y - 0.013) - 0.0215);
    return min(min(hull, mast), max(min(sail, jib), abs(q.z) - 0.0007));
}

vec3 localOf(vec3 p)
{
    return vec3(inValley(p.xz), p.y).xzy;
}

vec2 thingsInterval(Ray ray)
{
    Ray local = Ray(localOf(ray.origin), localOf(ray.direction));
    return intervalUnion(boxInterval(local, GROVE_LOW, GROVE_HIGH), boxInterval(local, BOAT - BOAT_REACH, BOAT + BOAT_REACH));
}

float thingsDistance(vec3 p)
{
    vec3 local = localOf(p);
    return min(min(cabinDistance(local), pinesDistance(local)), boatDistance(local));
}

// The normal of an object at a point near its surface, length 1: for the cabin, the normal of the
// roof or a wall; for a pine, the normal of a cone; for the boat, the normal of the sails.
vec3 thingNormal(vec3 p)
{
    vec3 local = localOf(p), q = atCabin(local);
    vec3 wall = abs(q.x) > 0.0415 ? vec3(sign(q.x), 0.0, 0.0) : vec3(0.0, 0.0, sign(q.z));
    vec3 house = 0.64 * abs(q.z) + 0.768 * (q.y - 0.066) > -0.006 ? vec3(0.0, 0.768, 0.64 * sign(q.z)) : wall;
    vec2 aside = local.xz - pineOf(floor(local.xz * (1.0 / CELL))).xy;
    vec3 n = local.x > 0.0 ? vec3(0.5, 0.2, -0.84) : vec3(aside.x, 0.4 * length(aside), aside.y);
    n = normalize(length(q) < 0.1 ? vec3(0.94 * house.x - 0.34 * house.z, house.y, 0.34 * house.x + 0.94 * house.z) : n);
    return vec3(fromValley(n.xz), n.y).xzy;
}

// The colour of an object (xyz), and 1 in a lit window, otherwise 0 (w).
vec4 thingColour(vec3 p, vec3 normal)
{
    vec3 local = localOf(p), q = atCabin(local);
    bool cabin = length(q) < 0.1, boat = local.x > 0.0;
    vec2 pane = abs(vec2(abs(q.x) - 0.02, q.y - 0.012)) - vec2(0.008, 0.008);
    vec2 bar = abs(vec2(abs(q.x) - 0.02, q.y - 0.0125));
    bool window = cabin && q.z < -0.029 && max(pane.x, pane.y) < 0.0 && min(bar.x, bar.y) > 0.0007;
    vec3 wood = vec3(0.17, 0.09, 0.05) * (0.8 + 0.2 * step(0.5, fract(160.0 * q.y)));
    vec3 roof = vec3(0.10, 0.055, 0.045), leaf = vec3(0.016, 0.034, 0.012);
    vec3 ofCabin = q.y > 0.03 && abs(normal.y) > 0.3 ? roof : (window ? vec3(0.02) : wood);
    return vec4(cabin ? ofCabin : (boat ? vec3(0.8, 0.78, 0.72) : leaf), window);
}

// ---- The mirrored world ----

// The point where the water mirrors a ray, and the direction of the mirrored ray. The mirrored world
// lies below the water: a ray that goes straight on into it meets the image of whatever the mirrored
// ray meets.
struct Bend {
    bool  waves;     // false for level water, which is the same for every ray
    vec3  point;     // on the water
    vec3  direction; // length 1, upwards
};
Bend bend = Bend(false, vec3(0.0), vec3(0.0));

// The point of the world whose image is at p: above the water, p itself.
vec3 unmirrored(vec3 p)
{
    vec3 bent = bend.point + length(p - bend.point) * bend.direction;
    return p.y >= 0.0 ? p : (bend.waves ? bent : vec3(p.x, -p.y, p.z));
}

// March only to the objects, in their bounding boxes. Returns the t of the hit, or -1 for a miss.
//   water  where the ray meets the water
float thingsAlong(Ray ray, float water, float tMax, float threshold, float spread)
{
    vec2 interval = thingsInterval(ray), mirrored = water + thingsInterval(Ray(bend.point, bend.direction));
    interval.y = min(interval.y, water);
    interval = water < tMax ? intervalUnion(interval, mirrored) : interval;
    float t = interval.x, last = min(interval.y, tMax);
    bool found = false, searching = t < last;
    int steps = 0;
    while (searching) {
        float distance = thingsDistance(unmirrored(ray.origin + t * ray.direction));
        found = distance < threshold + spread * t;
        t += found ? 0.0 : distance;
        steps++;
        searching = !found && t < last && steps < 64;
    }
    return found ? t : -1.0;
}
