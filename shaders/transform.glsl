// transform.glsl - a volume moved, turned, scaled and deformed: the inverse map is applied to the point.
//
// A volume A, changed by a map T, is { T(a) : a in A }. So p belongs to the changed volume if the inverse of T
// takes p into A, and a scene evaluates A at that point:
//
//   translation by v          sd(p - v)                          exact where sd is
//   rotation by a matrix R    sd(transpose(R) p), or sd(p * R)   exact where sd is
//   uniform scaling by k > 0  k sd(p / k)                        exact where sd is
//   a linear map M^-1         sd(M p) / largestStretch(M)        a lower bound
//   twist, bend               sd(opTwist(p, k)) / twistStretch(k, rho)    a lower bound near the axis
//   displacement by g         (sd(p) + g(p)) / displacementStretch(|grad g|)   a lower bound
//
// A function named ...Stretch is a Lipschitz constant: the largest factor by which the inverse map can stretch
// distances. Divided by this constant, a distance is safe to march with: the step factor is 1 / constant.

// ---- Isometries: a moved volume keeps its size, and distances stay exact ----

// The rotation about an axis by an angle, counter-clockwise as seen from the tip of the axis.
//   angle    radians
//   returns  an orthonormal matrix of determinant 1; its inverse is its transpose, and the rotation by
//            -angle. GLSL writes matrices column by column
//   formula  for rotationX: (x, y cos a - z sin a, y sin a + z cos a)
// Source: report, section 2.2.2, whose three factors are the same but named after other axes.
mat3 rotationX(float angle)
{
    float c = cos(angle), s = sin(angle);
    return mat3(1.0, 0.0, 0.0, 0.0, c, s, 0.0, -s, c);
}

mat3 rotationY(float angle)
{
    float c = cos(angle), s = sin(angle);
    return mat3(c, 0.0, -s, 0.0, 1.0, 0.0, s, 0.0, c);
}

mat3 rotationZ(float angle)
{
    float c = cos(angle), s = sin(angle);
    return mat3(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0);
}

// The pose of an object: turned first, then moved.
struct Pose {
    vec3 position; // position of the object's origin, scene units
    mat3 turn;     // a rotation
};

// A point in the coordinates of an object with a pose: moved back, then turned back. In GLSL, row times matrix is
// the transposed matrix times the column, and the transposed matrix is the inverse rotation.
//   p        point, scene units
//   formula  transpose(turn) (p - position)
//   sd(seenFrom(pose, p))  exact where sd is
vec3 seenFrom(Pose pose, vec3 p)
{
    return (p - pose.position) * pose.turn;
}

// ---- Linear maps ----

// The largest factor by which a matrix stretches a vector: its largest singular value.
//   m        any matrix: the matrix that is applied to the point, p -> m p
//   formula  square root of the largest eigenvalue of S = transpose(m) m, which is symmetric: with
//            mean = tr S / 3, D = S - mean I, spread^2 = tr(D D) / 6 and
//            angle = acos(det(D) / (2 spread^3)) / 3 the eigenvalue is mean + 2 spread cos(angle); the arc
//            cosine is computed with atan, because a driver's acos may be inexact
//   returns  >= 0; 1 for a rotation, |k| for k times a rotation
// Source: O. K. Smith, 'Eigenvalues of a symmetric 3 x 3 matrix', CACM 4 (1961).
float largestStretch(mat3 m)
{
    mat3 s = transpose(m) * m;
    float mean = (s[0][0] + s[1][1] + s[2][2]) / 3.0;
    mat3 d = s - mat3(mean);
    float spread = sqrt((dot(d[0], d[0]) + dot(d[1], d[1]) + dot(d[2], d[2])) / 6.0);
    float cosine = spread > 0.0 ? clamp(determinant(d) / (2.0 * spread * spread * spread), -1.0, 1.0) : 1.0;
    return sqrt(mean + 2.0 * spread * cos(atan(sqrt(1.0 - cosine * cosine), cosine) / 3.0));
}

// ---- Deformations: not isometries ----

// The inverse of a twist about the y axis: each height turns by a different angle.
//   p        point, scene units
//   rate     radians per scene unit of height, any sign
//   formula  rotationY(rate y) p; the volume itself is turned by -rate y
// The result is not a distance: divide by twistStretch, in the region that twistStretch names.
vec3 opTwist(vec3 p, float rate)
{
    float c = cos(rate * p.y), s = sin(rate * p.y);
    return vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
}

// The Lipschitz constant of opTwist in the cylinder x^2 + z^2 <= radius^2, a convex region. The constant is tight:
// it is reached on the cylinder's wall. Without a bound on the radius there is no Lipschitz constant.
//   formula  (u + sqrt(u^2 + 4)) / 2, u = |rate| radius
float twistStretch(float rate, float radius)
{
    float u = abs(rate) * radius;
    return 0.5 * (u + sqrt(u * u + 4.0));
}

// The inverse of a bend in the x, y plane: each x turns by a different angle about the z axis. A bar
// along x becomes an arch for rate > 0, with its ends down, and a bowl for rate < 0.
//   p        point, scene units
//   rate     radians per scene unit along x, any sign
//   formula  rotationZ(rate x) p
// The result is not a distance: divide by bendStretch, in the region that bendStretch names.
vec3 opBend(vec3 p, float rate)
{
    float c = cos(rate * p.x), s = sin(rate * p.x);
    return vec3(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
}

// The Lipschitz constant of opBend in the cylinder x^2 + y^2 <= radius^2. The constant is tight: it is reached on
// the wall at x = 0, on the side where rate y < 0.
//   formula  1 + |rate| radius
float bendStretch(float rate, float radius)
{
    return 1.0 + abs(rate) * radius;
}

// The Lipschitz constant of sd(p) + g(p), a surface that is moved inwards by g, if sd is 1-Lipschitz.
//   slope    the largest |grad g| in the region, >= 0
//   formula  1 + slope; reached where grad g points along grad sd
float displacementStretch(float slope)
{
    return 1.0 + slope;
}

// The Lipschitz constant of y - h(x, z), a ground or a sea of height h: here the two gradients are
// always perpendicular, so the constant is smaller than for a displacement in general. It is tight.
//   slope    the largest |grad h| in the region, >= 0
//   formula  sqrt(1 + slope^2)
float heightStretch(float slope)
{
    return sqrt(1.0 + slope * slope);
}

// ---- The volume that chapter 5 turns and twists ----

// A torus around the y axis. Exact everywhere.
//   p        point, scene units
//   radius   from the centre to the middle of the tube, > 0, scene units
//   tube     radius of the tube, in (0, radius], scene units
//   formula  |(|(x, z)| - radius, y)| - tube
float sdTorus(vec3 p, float radius, float tube)
{
    return length(vec2(length(p.xz) - radius, p.y)) - tube;
}
