// air_path.h - the air of a round Earth, and what its tables share: how much air, dust and ozone a
// path passes through, how much sunlight of each wavelength remains at its end, and the position of
// a sine in a table. Distances and heights are in kilometres.
#ifndef AIR_PATH_H
#define AIR_PATH_H

// The properties of one wavelength. The wavelengths are 400 to 700 nm, in steps of 20 nm.
enum { AIR_WAVES = 16 };
struct air_wave {
    double sun;    // sunlight above the air, W m^-2 nm^-1
    double ozone;  // cross section of a molecule, 1e-25 m^2
    double eye[3]; // the eye's colour matching functions x, y, z
};
extern const struct air_wave air_waves[AIR_WAVES];

// The Earth's radius, and the height at which the air ends.
#define AIR_EARTH 6371.0
#define AIR_TOP   120.0

// Dust scatters the share AIR_DUST_KEPT of the light that it removes, at angles whose mean cosine
// is AIR_FORWARD.
#define AIR_DUST_KEPT 0.92
#define AIR_FORWARD   0.76

#define AIR_PI 3.14159265358979324

// Amounts along a path, as shares of the amounts overhead at sea level.
struct air_amount {
    double air, dust, ozone;
};

// The optical depth of the air overhead, and of the dust overhead, at a wavelength, which is given
// as an index into air_waves.
double air_depth(int wave);
double air_dust_depth(int wave);

// The amounts in one kilometre of path at a height, in [0, AIR_TOP].
struct air_amount air_density(double height);

// For a ray that begins at a distance of radius from the Earth's centre, in a direction whose
// height has the given sine: the height above the sea at a distance along the ray, and the length
// of the ray up to the top of the air.
double air_height_at(double radius, double sine, double distance);
double air_way_out(double radius, double sine);

// The amounts along a ray that does not descend (sine >= 0), up to the top of the air.
struct air_amount air_amount_up(double radius, double sine);

// The share of the light of a wavelength that passes through these amounts: e^-depth, with a
// relative error of at most 3e-10.
//   ozone  amount of ozone; 1 is 300 Dobson units
double air_share_through(int wave, struct air_amount amount, double ozone);

// Add the share of the light above the air that travels from the sun to a point and from there to
// an eye. The sun is a disc, and near the edge of the Earth's shadow only a part of it is visible.
//   radius  distance of the point from the Earth's centre
//   sine    sine of the height of the sun's centre
//   way     the amounts between the point and the eye
void air_add_sunlight(double radius, double sine, struct air_amount way, double ozone,
                      double share[AIR_WAVES]);

// ---- Tables over a height of the sun or of a direction ----

// The position of a sine in a table: x from -1 to 1, stretched around 0 by 1 / k.
//   formula  the x with x (k + (1 - k) |x|) = sine
double air_drawn_out(double sine, double k);

// The inverse of air_drawn_out: the sine at position x.
double air_drawn_back(double x, double k);

#endif
