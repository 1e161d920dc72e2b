// A prism in a dark room: drag the lamp, the point it is aimed at, and the corner of the prism. Turn the prism: the
// colours behind it move, stop and come back. At the top left are the angle by which green light is turned and, pale,
// the smallest such angle.
#include "figure.glsl"
#include "lighting.glsl"
#include "prism.glsl"

uniform vec2 lamp;   // (-1.5, -0.33) handle: where the light comes from
uniform vec2 aim;    // (-0.5, 0.27) handle: where the light points
uniform vec2 corner; // (-0.15, 0.86) handle: corner of the prism
uniform float dispersion; // 0.013 in [0, 0.04] step 0.001, square micrometres: variation of the index; 0.013 for flint

const vec2 MIDDLE = vec2(-0.15, 0.3);
const float GREEN = 1.7337; // index of green light
const vec4 FOLLOWED = vec4(0.40, 0.46, 0.55, 0.70); // wavelengths whose rays are followed; the others lie between

float sceneDistance(vec3 p)
{
    return p.z;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), up = normalize(corner - MIDDLE + 1e-6), right = vec2(up.y, -up.x);
    float size = 0.5 * clamp(length(corner - MIDDLE), 0.2, 0.9), width = penWidth(3.0); // size: from middle to side
    mat3x2 normal = mat3x2(-up, 0.5 * up + 0.8660254 * right, 0.5 * up - 0.8660254 * right); // normals of the sides
    vec3 above = (p - MIDDLE) * normal - size;
    // amount: the total width of the bands of wavelengths that reach p, in micrometres.
    float prism = max(above.x, max(above.y, above.z)), turned = 0.0, amount = 0.0;

    // White light, up to the prism. Of the sides that it faces, it enters through the one that it crosses last.
    vec2 start = normalize(aim - lamp + 1e-6);
    vec3 facing = start * normal, way = (size - (lamp - MIDDLE) * normal) / (facing + 1e-7);
    vec3 first = mix(way, vec3(-1e6), vec3(greaterThan(facing, vec3(0.0))));
    float enter = max(first.x, max(first.y, first.z));
    vec2 meet = lamp + enter * start, side = enter == way.x ? normal[0] : (enter == way.y ? normal[1] : normal[2]);
    vec3 over = (meet - MIDDLE) * normal - size;
    bool hit = enter > 0.0 && max(over.x, max(over.y, over.z)) < 1e-4;
    vec3 light = vec3(coverage(0.5 * width - sdSegment(p, lamp, hit ? meet : lamp + 4.0 * start), sheetPixel()));

    vec2 waves = vec2(9.0, 0.0); // the smallest and the largest of the wavelengths that arrive at p
    vec3 before = vec3(9.0);     // how far p is from the pieces of the previous ray
    for (int k = 0; k < (hit ? 4 : 0); k++) {
        float last = FOLLOWED[max(k - 1, 0)], wave = FOLLOWED[k];
        float index = GREEN + dispersion * (1.0 / (wave * wave) - 1.0 / 0.3025);
        vec2 from = meet, direction = refract(start, side, 1.0 / index);
        bool within = true;
        // The ray passes through the prism, once more after total reflection, and leaves the prism.
        for (int piece = 0; piece < 3; piece++) {
            facing = direction * normal;
            way = (size - (from - MIDDLE) * normal) / (facing + 1e-7);
            way = mix(vec3(9.0), way, vec3(greaterThan(facing, vec3(1e-4))));
            float t = within ? min(way.x, min(way.y, way.z)) : 9.0, along = dot(p - from, direction);
            float off = along < 0.0 || along > t ? 9.0 : determinant(mat2(direction, p - from));
            float middle = 0.5 * (off + before[piece]), half2 = 0.5 * max(abs(off - before[piece]), sheetPixel());
            vec2 part = clamp(0.5 + 0.5 * (vec2(-0.5, 0.5) * width - middle) / half2, 0.0, 1.0);
            part = off < before[piece] ? 1.0 - part.yx : part;
            if (k > 0 && max(off, before[piece]) < 5.0 && part.y > part.x) {
                waves = vec2(min(waves.x, mix(last, wave, part.x)), max(waves.y, mix(last, wave, part.y)));
                amount += (part.y - part.x) * (wave - last);
            }
            before[piece] = off;
            from += t * direction;
            vec2 out2 = t == way.x ? normal[0] : (t == way.y ? normal[1] : normal[2]);
            vec2 bent = refract(direction, -out2, index);
            bool back = dot(bent, bent) < 0.5;
            direction = within ? (back ? reflect(direction, out2) : bent) : direction;
            within = within && back;
        }
        turned = k == 2 ? degrees(angleBetween(start, direction)) : turned;
    }
    light += meanColour(waves.x, waves.y) * amount / max(waves.y - waves.x, 1e-4);
    sheetColour = 0.7 * NIGHT;
    fill(prism, BLUE, 0.3);
    stroke(prism, 1.5, BLUE);
    sheetColour = encodeSRGB(pow(sheetColour, vec3(2.2)) + 2.0 * light);
    dot2(p, lamp, 12.0, CHALK);
    number(p, vec2(-1.56, 0.86), turned, 1, CHALK); // turned by #°
    number(p, vec2(-1.56, 0.74), degrees(leastDeviation(radians(60.0), GREEN)), 1, PALE); // least #°
    return sheetColour;
}
