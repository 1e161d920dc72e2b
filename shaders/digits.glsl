// digits.glsl - numbers in a picture, on a grid of square cells.

// Compiled only with the files that write numbers.
#if VIEW >= 1 && VIEW <= 5

// True on the strokes of a decimal digit drawn in a grid of 3 x 5 cells.
//   digit  0 to 9
//   cell   column from the left (0 to 2), row from the bottom (0 to 4)
bool digitCell(int digit, ivec2 cell)
{
    // Bit 3 row + column: five rows of three bits, the bottom row lowest.
    const int strokes[10] = int[10](31599, 9879, 31183, 31207, 23524, 29671, 29679, 30866, 31727, 31719);
    return ((strokes[digit] >> (3 * cell.y + cell.x)) & 1) == 1;
}

// How many digits a number has, at least one before the point.
//   number    >= 0
//   decimals  of the digits stand behind the point
int digitsOf(int number, int decimals)
{
    int digits = 1;
    for (int rest = number / 10; rest > 0 || digits <= decimals; rest /= 10)
        digits++;
    return digits;
}

// The width in cells of number / 10^decimals: 4 a digit, 2 the point, 4 the sign, without the last
// gap.
int numberWidth(int number, int decimals)
{
    int width = 4 * digitsOf(abs(number), decimals) - 1;
    return width + (decimals > 0 ? 2 : 0) + (number < 0 ? 4 : 0);
}

// True on the strokes of number / 10^decimals.
//   place  in cells, from the number's bottom left corner
bool numberCell(int number, int decimals, vec2 place)
{
    ivec2 cell = ivec2(floor(place));
    if (cell.x < 0 || cell.y < 0 || cell.y > 4 || cell.x >= numberWidth(number, decimals))
        return false;
    if (number < 0 && cell.x < 4)
        return cell.x < 3 && cell.y == 2;
    cell.x -= number < 0 ? 4 : 0;
    int rest = abs(number);
    int digits = digitsOf(rest, decimals);
    int point = 4 * (digits - decimals);
    if (decimals > 0 && cell.x >= point) {
        if (cell.x < point + 2)
            return cell.x == point && cell.y == 0;
        cell.x -= 2;
    }
    int column = cell.x / 4;
    if (cell.x % 4 == 3)
        return false;
    for (int i = digits - 1 - column; i > 0; i--)
        rest /= 10;
    return digitCell(rest % 10, ivec2(cell.x % 4, cell.y));
}

#endif
