// stretch.glsl - how fast a distance can change along one ray: a Lipschitz constant for each ray.
//
// A stretch of transform.glsl is valid for all directions, so it is that of the steepest direction. A ray has only one
// direction, which may be less steep. Divided by the stretch along a ray, a distance is safe for marching that ray,
// forwards and backwards, but not for any other ray, nor for a normal.

// The stretch along a ray over y - h(x, z), a ground or a sea of height h.
//   slope      the largest |grad h| in the region, >= 0
//   direction  of the ray, length 1
//   formula    |v_y| + slope |(v_x, v_z)|
//   returns    at most heightStretch(slope), which the steepest direction reaches; for a level ray, slope, which
//              may be small
float heightStretchAlong(float slope, vec3 direction)
{
    return abs(direction.y) + slope * length(direction.xz);
}

// The stretch along a ray through a volume turned by opTwist, in the cylinder x^2 + z^2 <= radius^2.
//   rate       of the twist, radians per scene unit of height
//   direction  of the ray, length 1; y is the direction of the twist's axis
//   formula    sqrt((|(v_x, v_z)| + |rate| radius |v_y|)^2 + v_y^2)
//   returns    from 1, for a level ray, to twistStretch(rate, radius)
float twistStretchAlong(float rate, float radius, vec3 direction)
{
    float across = length(direction.xz) + abs(rate) * radius * abs(direction.y);
    return length(vec2(across, direction.y));
}
