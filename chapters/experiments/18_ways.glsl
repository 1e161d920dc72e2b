// 18_ways.glsl - for the experiments of chapter 18: other methods for a sky. Include the chapter's
// shader first.

uniform int  way;      // 0 in [0, 3]: method: 0 the chapter's, 1 the article's text by angle, 2 its shader by dot product, 3 chapter 09's formula
uniform bool encoded;  // false: mix the article's two colours as encoded numbers
uniform bool painted;  // false: make the article's second table a painter's, which differs from the first at the zenith too

// The light in a direction according to a table of complete colours, which stores only the light along the middle of
// the table's half of the sky.
//   level  1 for the half that contains the sun, -1 for the other
vec3 halfColour(sampler2D table, vec3 direction, vec3 sun, float level)
{
    vec2 uv = skyUV(sun.y, direction.y);
    float y = max(direction.y, 0.0), flat2 = (1.0 - y * y) * (1.0 - sun.y * sun.y);
    return tableLight(table, uv, y * sun.y + level * sqrt(max(flat2, 0.0)), skyScale(sun.y, uv.y));
}

// The share of the first table according to the article's text: from 1 to 0, linear in the horizontal
// angle to the sun. At the zenith there is no such angle; there the share is 1 here, and undefined in
// the article, because GLSL leaves atan(0, 0) undefined.
float shareByAngle(vec3 direction, vec3 sun)
{
    vec2 a = direction.xz, b = sun.xz;
    return 1.0 - abs(atan(a.x * b.y - a.y * b.x, dot(a, b) + float(a == vec2(0.0)))) / 3.14159265;
}

vec3 decoded(vec3 v)
{
    return mix(v / 12.92, pow((v + 0.055) / 1.055, vec3(2.4)), step(0.04045, v));
}

// An exposure for a picture of the whole sky, in stops.
//   sun      sine of the sun's height
//   formula  -2 - 0.85 log2 of the light of the whole sky, with 6e-8 for that of the night
float domeStops(float sun)
{
    return -2.0 - 0.85 * log2(exp2(skyBrightness(sun)) + 6e-8);
}

// The light of the sky by the selected method, in the chapter's unit.
//   numbers  true mixes the article's colours as encoded numbers
vec3 skyByWay(vec3 direction, vec3 sun, bool numbers)
{
    if (way == 3)
        return 0.8 * (sunlitSky(direction, sun, RAYLEIGH + 0.05) + nightSky(direction, sun));
    vec3 first = halfColour(sunward, direction, sun, 1.0), second = halfColour(away, direction, sun, -1.0);
    second *= painted ? vec3(0.4, 0.32, 0.3) : vec3(1.0);
    float share = way == 1 ? shareByAngle(direction, sun) : 0.5 + 0.5 * dot(direction, sun);
    float stops = domeStops(sun.y);
    vec3 mixed = numbers ? exposed(decoded(mix(encodeSRGB(exposed(second, stops)), encodeSRGB(exposed(first, stops)), share)), -stops)
                         : mix(second, first, share);
    return way == 0 ? tableSky(sunward, away, direction, sun) : mixed;
}
