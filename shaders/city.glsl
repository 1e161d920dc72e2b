// city.glsl - an endless city: towers that differ from block to block, with lamps and trees along the streets.
//
// Blocks are the cells of repetition.glsl along x and z, in scene units of about 8 metres. The ground is y = 0
// and is not part of the distance. docs/09_sky_and_sunset.md proves the bounds.
#include "primitives.glsl"
#include "repetition.glsl"

const float PERIOD = 6.0;     // distance between the centres of neighbouring blocks
const float GAP = 1.35;       // half a street: no tower comes closer to the border of its block
const float TALLEST = 9.3;    // no tower is taller
const vec3  BAY = vec3(0.36, 0.4, 0.36); // size of a window with the wall around it, one floor high
const vec3  LAMP = vec3(0.26, 1.08, 0.0); // position of a lamp's bulb, relative to the foot of its post

// A point in its block, and the block's random number.
struct Block {
    vec3  local;  // relative to the centre of the block, on the ground
    float random; // in [0, 1)
};

// The block that contains p.
Block blockAt(vec3 p)
{
    vec2 cell = vec2(cellOf(p.x, PERIOD), cellOf(p.z, PERIOD));
    return Block(p - PERIOD * vec3(cell.x, 0.0, cell.y), cellRandom(ivec3(cell, 9)));
}

// A tower is a shaft on a base: two boxes without bottoms, whose widths and heights are whole numbers of windows.
// Each of the next two functions returns how far a point is outside the faces of a box, per axis; negative inside.
//   the largest component  the exact distance in front of a face, a lower bound in front of an edge, the exact depth
//                          inside
vec3 outsideShaft(Block block)
{
    vec3 r = fract(block.random * vec3(1.0, 256.0, 65536.0));
    vec3 corner = vec3(2.5, 4.0, 2.5) + floor(vec3(2.0 * r.y, 19.0 * r.x * r.x, 2.0 * r.z));
    return vec3(abs(block.local.x), block.local.y - 0.08, abs(block.local.z)) - corner * BAY;
}

vec3 outsideBase(Block block)
{
    float floors = floor(1.0 + 4.0 * fract(block.random * 65536.0));
    return vec3(abs(block.local.x), block.local.y - 0.08, abs(block.local.z)) - vec3(4.5, floors, 4.5) * BAY;
}

// The position relative to the foot of the lamp on the pavement. The pavements on the two sides of the block, which
// run along z, are folded into one.
//   local  from a Block
vec3 pavement(vec3 local)
{
    return vec3(abs(local.x) - 2.1, local.yz);
}

// The distance to a lamp, which consists of a post, an arm over the street and a bulb. It is exact outside.
//   q  from pavement
float lampDistance(vec3 q)
{
    float post = length(vec3(q.x, max(q.y - 1.1, 0.0), q.z)) - 0.018;
    float arm = length(vec3(q.x - clamp(q.x, 0.0, LAMP.x), q.y - 1.1, q.z)) - 0.012;
    return min(min(post, arm), sdSphere(q - LAMP, 0.045));
}

// The position relative to the nearest point on a crown's axis. The trees on either side of a lamp are folded into one.
//   q  from pavement
vec3 treeAxis(vec3 q)
{
    return vec3(q.x, q.y - clamp(q.y, 0.5, 1.0), abs(q.z) - 1.5);
}

// A lower bound of the distance to a tree, which consists of a trunk and a crown that tapers upwards.
//   q  from pavement
float treeDistance(vec3 q)
{
    vec3 c = treeAxis(q);
    float crown = 0.98 * (length(c) - 0.3 + 0.2 * (q.y - c.y)); // 0.2 is the slope of the taper
    return min(crown, max(length(c.xz) - 0.03, q.y - 0.6));
}

// A lower bound of the distance to the city, 1-Lipschitz. Only the tower of the point's own block is evaluated, and no
// step is longer than the distance to the border of the block plus half a street.
//   formula  min(tower of the block, distance to the border + GAP, lamps, trees)
float cityDistance(vec3 p)
{
    Block block = blockAt(p);
    vec3 q = pavement(block.local);
    vec3 shaft = outsideShaft(block), base = outsideBase(block);
    float tower = min(max(shaft.x, max(shaft.y, shaft.z)), max(base.x, max(base.y, base.z)));
    float wall = 0.5 * PERIOD - max(abs(block.local.x), abs(block.local.z));
    return min(min(tower, wall + GAP), min(lampDistance(q), treeDistance(q)));
}

// The normal of the city, length 1, computed from the city's shapes: on a box, the normal of the face; on a crown or a
// post, the direction away from the axis.
//   block        of a point on the surface
//   tower, lamp  whether the surface belongs to a tower or a lamp; otherwise it belongs to a tree
// On a post, the component along z is never negative: the half that faces -z has the mirror images of the normals of
// the other half.
vec3 cityNormal(Block block, bool tower, bool lamp)
{
    vec3 base = outsideBase(block), shaft = outsideShaft(block), q = pavement(block.local);
    float toBase = max(base.x, max(base.y, base.z)), toShaft = max(shaft.x, max(shaft.y, shaft.z));
    vec3 face = toBase < toShaft ? step(toBase, base) : step(toShaft, shaft);
    vec3 axis = lamp ? vec3(q.x, 0.0, q.z) : treeAxis(q);
    return normalize((tower ? face : axis) * sign(block.local));
}
