#version 330 core
// For precision.c: the values of this driver's built-in functions. Time selects the function; the pixel's coordinates
// determine its argument.

in float Time;
out vec4 FragColor;

void main()
{
    int function = int(Time);
    // u runs from 0 to 1, and v from -1 to 1.
    float u = (gl_FragCoord.x + 1024.0 * (gl_FragCoord.y - 0.5)) / 4096.0, v = 2.0 * u - 1.0;
    vec2 pair = vec2(u, 0.0);
    if (function == 0)
        pair = vec2(3.14159265 * v, sin(3.14159265 * v));
    else if (function == 1)
        pair = vec2(3.14159265 * v, cos(3.14159265 * v));
    else if (function == 2)
        pair = vec2(1.5 * v, tan(1.5 * v));
    else if (function == 3)
        pair = vec2(v, asin(v));
    else if (function == 4)
        pair = vec2(v, acos(v));
    else if (function == 5)
        pair = vec2(20.0 * v, atan(20.0 * v));
    else if (function == 6)
        pair = vec2(20.0 * v, exp(20.0 * v));
    else if (function == 7)
        pair = vec2(20.0 * u, log(20.0 * u));
    else if (function == 8)
        pair = vec2(u, pow(u, 2.4));
    else if (function == 9)
        pair = vec2(20.0 * u, sqrt(20.0 * u));
    else
        pair = vec2(20.0 * u, inversesqrt(20.0 * u));
    FragColor = vec4(pair, 0.0, 0.0);
}
