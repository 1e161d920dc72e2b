// material.glsl - the material of a surface: how it reflects light.
//
// A march needs only distances. The material is computed once per ray, for the point that the march found, so the
// record may be as long as it needs to be.

// How a surface reflects light.
struct Material {
    vec3  colour;    // share of the light that enters and returns in all directions, linear RGB, in [0, 1]
    vec3  straight;  // share that the surface reflects at normal incidence, in [0, 1]: 0.03 to 0.06 for cloth,
                     // skin, wax and glaze; for a metal, its colour
    float roughness; // in [0, 1]: 0 a mirror, 1 fully matt; as in gloss.glsl
};

// A mixture of two materials.
//   share    of b, in [0, 1]: 0 gives a, 1 gives b; for a smooth union, use smoothUnionShare
//   formula  (1 - share) a + share b, member by member: a weighted mean of shares of light, so each member
//            stays in [0, 1]
Material mixMaterials(Material a, Material b, float share)
{
    return Material(mix(a.colour, b.colour, share), mix(a.straight, b.straight, share),
                    mix(a.roughness, b.roughness, share));
}
