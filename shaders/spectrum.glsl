// spectrum.glsl - light of one wavelength: how glass refracts it, and its colour on a screen.
//
// Wavelengths are those of light in a vacuum, in micrometres (thousandths of a millimetre), from SHORTEST_WAVE, violet,
// to LONGEST_WAVE, red. White light contains equal parts of all these wavelengths.

const float SHORTEST_WAVE = 0.40;
const float LONGEST_WAVE = 0.70;

// The index of refraction of a glass.
//   glass       the two numbers of the glass for Cauchy's formula: (a, b), b in square micrometres; crown glass BK7
//               (1.5046, 0.00420), dense flint SF10 (1.6894, 0.01341), water (1.3240, 0.00310)
//   wavelength  > 0
//   formula     a + b / wavelength^2
// The result differs from that of Sellmeier's formula with the maker's six numbers by at most 0.00011 for BK7; for SF10
// by 0.0004 from 0.486 to 0.656, and in the violet it is too small by up to 0.005.
// Sources: A.-L. Cauchy, 'Mémoire sur la dispersion de la lumière' (1836); the two numbers of SF10 are fitted to the
// indices of the maker's catalogue (Schott, 'Optical Glass').
float cauchyIndex(vec2 glass, float wavelength)
{
    return glass.x + glass.y / (wavelength * wavelength);
}

// The inverse of cauchyIndex: the wavelength that has a given index.
//   index    > glass.x
//   formula  sqrt(b / (index - a))
float cauchyWave(vec2 glass, float index)
{
    return sqrt(glass.y / max(index - glass.x, 1e-9));
}

// A bell curve with two different halves: 1 at middle, 1 / e at middle - below and at middle + above.
float bell(float x, float middle, float below, float above)
{
    float part = (x - middle) / (x < middle ? below : above);
    return exp(-part * part);
}

// The colour of one wavelength, as a weight: the mean over all wavelengths from SHORTEST_WAVE to LONGEST_WAVE is
// white, (1, 1, 1).
//   returns  linear red, green, blue, >= 0, up to 5.5
//   formula  a bell per channel, and a second bell for the red in violet: fitted to the eye's curves of 1931 in the
//            screen's primaries. In these primaries a pure colour has a negative channel, which no screen can display:
//            it is replaced with 0, and each channel is divided by its mean. The fit is off by at most 0.4
// Sources: CIE 1931 colour matching functions, as fitted by C. Wyman, P.-P. Sloan, P. Shirley, 'Simple analytic
// approximations to the CIE XYZ color matching functions', Journal of Computer Graphics Techniques 2 (2013);
// IEC 61966-2-1 for the primaries.
vec3 waveColour(float wavelength)
{
    float violet = 0.42 * bell(wavelength, 0.4435, 0.0265, 0.0105);
    return vec3(4.2674 * bell(wavelength, 0.6025, 0.0325, 0.0433) + violet,
                3.9732 * bell(wavelength, 0.5410, 0.0426, 0.0426),
                5.4559 * bell(wavelength, 0.4450, 0.0248, 0.0375));
}

// Wavelength k of the count wavelengths of a sample, one in each of count equal parts of the spectrum.
//   k, count  0 <= k < count
//   shift     position within the part, in [0, 1]; 1/2 is the middle, which for count 1 is 0.55, green
float sampleWave(int k, int count, float shift)
{
    return mix(SHORTEST_WAVE, LONGEST_WAVE, (float(k) + shift) / float(count));
}

// The colour of light that contains only the wavelengths between two limits, relative to white light, which contains
// all of them.
//   a, b     wavelengths, in either order; any part outside the visible range is left out
//   returns  white, (1, 1, 1), for the whole range. The result is computed from ten wavelengths, and is off by at most
//            0.02 for the whole range and by at most 0.03 for a part
vec3 meanColour(float a, float b)
{
    a = clamp(a, SHORTEST_WAVE, LONGEST_WAVE);
    b = clamp(b, SHORTEST_WAVE, LONGEST_WAVE);
    float share = abs(b - a) / (LONGEST_WAVE - SHORTEST_WAVE);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < (share > 0.0 ? 10 : 0); i++)
        sum += waveColour(mix(a, b, (float(i) + 0.5) / 10.0));
    return share / 10.0 * sum;
}
