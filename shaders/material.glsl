// material.glsl - what a surface is made of: a record, found once where a ray has ended.
//
// A march asks for distances alone. What lies at its end is asked once a ray, of the point that was
// found; so the record may be as long as it likes.

// What light meets at a surface.
struct Material {
    vec3  colour;    // share of the light that goes in and comes back in all directions, linear RGB, in [0, 1]
    vec3  straight;  // share that the surface mirrors when one looks straight at it, in [0, 1]: 0.04
                     // for glaze, wax and skin, the colour of a metal
    float roughness; // in [0, 1]: 0 a mirror, 1 all matt; of gloss.glsl
};

// What lies between two materials.
//   share    of b, in [0, 1]: 0 is a, 1 is b; smoothUnionShare gives that of a blend
//   formula  (1 - share) a + share b, member by member: shares of light mixed in shares, so that each
//            stays in [0, 1]
Material mixMaterials(Material a, Material b, float share)
{
    return Material(mix(a.colour, b.colour, share), mix(a.straight, b.straight, share),
                    mix(a.roughness, b.roughness, share));
}
