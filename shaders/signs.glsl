// signs.glsl - numbers and words in a picture, on a grid of square cells: a digit is 5 cells high.

// Compiled only with the files that write text.
#if VIEW_OF_TRACE || VIEW == VIEW_SLICE || VIEW == VIEW_PLOT || defined(FIGURE)

const int SIGN_POINT = 10, SIGN_MINUS = 11;
const int SIGN_T = 1, SIGN_DISTANCE = 2, SIGN_THRESHOLD = 3, SIGN_HIT = 4, SIGN_MISS = 5, SIGN_GIVEN_UP = 6;

#ifdef SHADERTOY

// Shadertoy has no texture with these signs, so each sign of row 0 has 3 by 5 full cells: bit 3 r + c is the cell in
// row r from below and column c.
const int SIGN_CELLS[12] = int[](0x7b6f, 0x2697, 0x79cf, 0x79e7, 0x5be4, 0x73e7, 0x73ef, 0x7912, 0x7bef, 0x7be7, 0x0001,
                                 0x01c0);

// The side of a cell, pixels.
int signCell()
{
    return max(int(iResolution.y / 180.0 + 0.5), 2);
}

// The share of a pixel that the signs of row 0 cover, 0 or 1. The parameters are those of the other signCover.
float signCover(int row, ivec2 at)
{
    int cell = signCell(), wide = 4 * cell, sign = at.x / wide;
    ivec2 inside = ivec2(at.x - sign * wide - cell / 2, at.y);
    if (row != 0 || sign > SIGN_MINUS || min(inside.x, inside.y) < 0 || inside.x >= 3 * cell || inside.y >= 5 * cell)
        return 0.0;
    return float(SIGN_CELLS[sign] >> (3 * (inside.y / cell) + inside.x / cell) & 1);
}

#else

// The coverage of each sign's pixels, from a font (common/picture/axis_labels.c). A row is 8 cells high, and the
// baseline of its signs is 2 cells above its lower end. Row 0 contains the digits, the point and the minus, each in the
// middle of 4 cells, except the point, which is in the middle of 2; each further row contains a word.
uniform sampler2D iSigns;

// The side of a cell, pixels.
int signCell()
{
    return textureSize(iSigns, 0).x / 48;
}

// The share of a pixel that the signs of a row cover, in [0, 1].
//   at  pixels from the row's left end and its baseline
float signCover(int row, ivec2 at)
{
    int cell = signCell();
    if (at.x < 0 || at.x >= 48 * cell || at.y < -2 * cell || at.y >= 6 * cell)
        return 0.0;
    return texelFetch(iSigns, at + ivec2(0, (8 * row + 2) * cell), 0).r;
}

#endif

// The share of a pixel that a word covers, in [0, 1].
//   word    SIGN_T, ...
//   offset  in pixels, from the word's bottom left corner
float wordCover(int word, vec2 offset)
{
    return signCover(word, ivec2(floor(offset)));
}

// 10^n, for n in [0, 9], as a product of powers whose exponents are powers of 2. The compiler would copy a loop over
// the digits into each number of a picture, and llvmpipe would need minutes to compile four numbers.
int powerOfTen(int n)
{
    return ((n & 1) != 0 ? 10 : 1) * ((n & 2) != 0 ? 100 : 1) * ((n & 4) != 0 ? 10000 : 1) * (n > 7 ? 100000000 : 1);
}

// How many digits a number has, at least one before the point.
//   number    >= 0
//   decimals  how many of the digits follow the point
int digitsOf(int number, int decimals)
{
    int digits = 1;
    digits += int(number > 9) + int(number > 99) + int(number > 999) + int(number > 9999) + int(number > 99999);
    digits += int(number > 999999) + int(number > 9999999) + int(number > 99999999) + int(number > 999999999);
    return max(digits, decimals + 1);
}

// The width in cells of number / 10^decimals: 4 for each digit and for the minus, 2 for the point, less the last
// gap.
int numberWidth(int number, int decimals)
{
    int width = 4 * digitsOf(abs(number), decimals) - 1;
    return width + (decimals > 0 ? 2 : 0) + (number < 0 ? 4 : 0);
}

// The share of a pixel that number / 10^decimals covers, in [0, 1].
//   offset  in pixels, from the number's bottom left corner
float numberCover(int number, int decimals, vec2 offset)
{
    int cell = signCell(), wide = 4 * cell;
    ivec2 at = ivec2(floor(offset)) + ivec2(cell / 2, 0); // half a gap is to the left of the first sign
    if (at.x < 0 || at.x >= (numberWidth(number, decimals) + 1) * cell)
        return 0.0;
    if (number < 0 && at.x < wide)
        return signCover(0, at + ivec2(SIGN_MINUS * wide, 0));
    at.x -= number < 0 ? wide : 0;
    int rest = abs(number), digits = digitsOf(rest, decimals);
    int point = (digits - decimals) * wide;
    if (decimals > 0 && at.x >= point) {
        if (at.x < point + 2 * cell)
            return signCover(0, at + ivec2(SIGN_POINT * wide - point, 0));
        at.x -= 2 * cell;
    }
    int digit = rest / powerOfTen(max(digits - 1 - at.x / wide, 0)) % 10;
    return signCover(0, ivec2(digit * wide + at.x % wide, at.y));
}

#endif
