#!/bin/bash
# test_others.sh - shaders that were written for other programs: the report's engine and Shadertoy.
#
# Most scenes are made here, as variations of a few texts: a scene that says the same in other words
# must give the same picture, to the bit. One that reads its inputs paints white where they hold
# what they must, black elsewhere.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh

open_scratch
unset DISPLAY WAYLAND_DISPLAY
program=$BUILD/01_normal_colouring
size=(-s 48x27)

# draw NAME OPTION...: render $scratch/NAME.frag into NAME.png. What it says is in $said.
draw() {
    local name=$1
    shift
    said=$("$program" -f "$scratch/$name.frag" "${size[@]}" -o "$scratch/$name.png" "$@" 2>&1)
}

# as REFERENCE NAME TITLE [OPTION...] <TEXT: the shader's picture is the reference's.
as() {
    local reference=$1 name=$2 title=$3
    shift 3
    cat >"$scratch/$name.frag"
    if ! draw "$name" "$@" || [ -n "$said" ]; then
        not_ok "$title" "$(echo "$said" | tr '\n' ' ')"
    elif cmp -s "$scratch/$reference.png" "$scratch/$name.png"; then
        ok "$title"
    else
        not_ok "$title" "$("$BUILD/tests/compare" "$scratch/$reference.png" "$scratch/$name.png" 2>&1)"
    fi
}

# refused NAME PATTERN TITLE [OPTION...] <TEXT: status 1, the pattern in what is said.
refused() {
    local name=$1 pattern=$2 title=$3 status
    shift 3
    cat >"$scratch/$name.frag"
    draw "$name" "$@"
    status=$?
    if [ "$status" = 1 ] && [[ $said =~ $pattern ]] && [ ! -e "$scratch/$name.png" ]; then
        ok "$title"
    else
        not_ok "$title" "status $status: $(echo "$said" | tr '\n' ' ')"
    fi
}

# ---- The report's engine ----

# A scene in the report's manner: march, normal, a sun. $1 its inputs, $2 what main does with them.
report_scene() { # DECLARATIONS BODY
    printf '#version 330 core\n%s\n' "$1"
    cat <<'GLSL'
float SDF_Scene(vec3 p) { return min(length(p) - 0.8, p.y + 0.8); }
vec3 grad(vec3 p) {
    vec2 e = vec2(0.001, 0.0);
    return normalize(vec3(SDF_Scene(p + e.xyy) - SDF_Scene(p - e.xyy),
                          SDF_Scene(p + e.yxy) - SDF_Scene(p - e.yxy),
                          SDF_Scene(p + e.yyx) - SDF_Scene(p - e.yyx)));
}
vec3 Get_Color(vec3 origin, vec3 direction) {
    float t = 0.0;
    for (int i = 0; i < 90; i++) t += SDF_Scene(origin + t * direction);
    return t > 20.0 ? vec3(.5, .7, 1.) : vec3(max(dot(grad(origin + t * direction), vec3(.6, .64, .48)), 0.));
}
GLSL
    printf 'void main() {\n%s\n}\n' "$2"
}
ray='vec3 d = normalize(FragCoord.x * vec3(1, 0, 0) + FragCoord.y * vec3(0, 1, 0) - vec3(0, 0, 1));'
still="$ray FragColor = vec4(Get_Color(vec3(0.0, 0.2, 3.0), d), 1.0);"
basic='in vec2 FragCoord; in float Time; out vec4 FragColor;'

report_scene "$basic" "$still" >"$scratch/scene.frag"
check "the report's form: a scene" draw scene

variation() { # TITLE DECLARATIONS BODY
    as scene variation "the report's form: $1" < <(report_scene "$2" "$3")
}
variation 'FragCoord alone' 'in vec2 FragCoord; out vec4 FragColor;' "$still"
variation 'another name of the colour' 'in vec2 FragCoord; out vec4 couleur;' "${still/FragColor =/couleur =}"
variation 'fragColour, the name of the course' 'in vec2 FragCoord; out vec4 fragColour;' "${still/FragColor =/fragColour =}"
variation 'a colour with a location' 'in vec2 FragCoord; layout(location = 0) out vec4 FragColor;' "$still"
variation 'three components' 'in vec2 FragCoord; out vec3 FragColor;' "${still/vec4(Get_Color(vec3(0.0, 0.2, 3.0), d), 1.0)/Get_Color(vec3(0.0, 0.2, 3.0), d)}"
variation 'no opacity' "$basic" "${still/FragColor = vec4(Get_Color(vec3(0.0, 0.2, 3.0), d), 1.0)/FragColor.rgb = Get_Color(vec3(0.0, 0.2, 3.0), d)}"
variation 'every input, unused' "$basic in vec3 Ex, Ey, Ez, CamPos; in float fovValue, FacteurLargeur, OrthoView, CustomToggle, CustomInt;" "$still"
variation 'smooth inputs' 'smooth in vec2 FragCoord; smooth in float Time; out vec4 FragColor;' "$still"
variation 'a flat input' "$basic flat in float CustomInt;" "${still/1.0);/CustomInt);}"
variation 'precisions' 'precision highp float; precision mediump int; in highp vec2 FragCoord; out mediump vec4 FragColor;' "$still"
variation 'an unknown input that nothing reads' "$basic in vec2 MousePos;" "$still"
variation 'names of our uniforms as its own' "$basic vec2 iPixelOffset = vec2(0.0); float focalLength = 2.0; const vec3 iResolution = vec3(1.0); struct Trace { int x; }; Trace trace;" "$still"
variation 'names of our library as its own' "$basic float march(vec3 p) { return p.x; } float sceneDistance(vec3 p) { return p.y; } vec3 rayColour(vec3 p) { return p; }" "$still"
variation 'macros' "$(printf '%s\n#define FC FragCoord\n#define SQ(x) ((x) * \\\n    (x))\n#define RES iResolution\n#ifdef GL_ES\nprecision mediump float;\n#endif' "$basic")" "${still//FragCoord/FC}"
variation 'constant arrays and whole loops' "$basic const float W[3] = float[](0.5, 0.25, 0.25); float sum() { float s = 0.0; for (int i = 0; i < 3; ++i) s += W[i]; return s; }" "${still/1.0);/sum());}"
variation 'an initialiser that is no constant' "$basic float now = Time; vec2 twice = 2.0 * FragCoord;" "$still"
variation 'a declaration over several lines' "$(printf 'in\n  vec2\n  FragCoord ;\nin float Time\n;\nout vec4\nFragColor;')" "$still"
variation 'functions with in and out' "$basic void move(in vec2 a, inout vec2 b, out vec2 c) { b += a; c = b; } void nothing(in vec2 foo) {}" "$still"
variation 'a uniform with a value' "$basic uniform float strength = 1.0;" "${still/1.0);/strength);}"
variation 'a uniform that nobody sets and nothing reads' "$basic uniform float strength; uniform sampler2D tex;" "$still"
variation 'whole inputs that are flat' "$basic flat in int CustomInt, CustomToggle;" "${still/1.0);/1 - CustomInt);}"
variation 'a location of an input' 'layout(location = 1) in vec2 FragCoord; layout (location = 4) out vec4 FragColor;' "$still"
variation 'what #ifdef leaves out' "$(printf '%s\n#ifdef OLD\nin vec2 uv;\nuniform float iTime;\n#endif\n#line 77' "$basic")" "$still"
variation 'a macro for the output' "$(printf '#define TO out\nin vec2 FragCoord; TO vec4 FragColor;')" "$still"
variation 'mainImage called by its own main' "$basic void mainImage(out vec4 c, in vec2 p) { c = vec4(p, 0.0, 1.0); }" "$still"

for change in crlf mark tabs latin comment late es compatible bare; do
    case $change in
    crlf) sed 's/$/\r/' ;;
    mark) printf '\357\273\277' && cat ;;
    tabs) sed 's/^    /\t/; s/ /\t/3' ;;
    latin) sed '1a // caf\xe9, \xc3\xa9t\xc3\xa9, \xe2\x88\x9e : c'"'"'est une "scene"' ;;
    comment) printf '/* a scene\n   by others */ // indeed\n\n' && cat ;;
    late) sed '1s/ core//' ;;
    es) sed '1s/.*/#version 300 es\nprecision highp float;/' ;;
    compatible) sed '1s/core/compatibility/' ;;
    bare) sed 1d ;;
    esac <"$scratch/scene.frag" >"$scratch/changed"
    as scene "scene_$change" "the report's form: $change" <"$scratch/changed"
done

# Each input holds what it must.
camera=(-c '1,2,3,90,0' -t 1.5)
printf '#version 330 core\nout vec4 c; void main() { c = vec4(1.0); }\n' >"$scratch/white.frag"
draw white
holds() { # TITLE DECLARATIONS CONDITION
    as white holds "the report's form: $1" "${camera[@]}" < <(printf \
        '#version 330 core\n%s\nout vec4 c;\nbool near(vec3 a, vec3 b) { return length(a - b) < 1e-5; }\nvoid main() { c = vec4(vec3(%s), 1.0); }\n' "$2" "$3")
}
holds 'Time' 'in float Time;' 'Time == 1.5'
holds 'CamPos' 'in vec3 CamPos;' 'near(CamPos, vec3(1, 2, 3))'
holds 'Ex, Ey, Ez: right, up, forward' 'in vec3 Ex, Ey, Ez;' 'near(Ex, vec3(0, 0, 1)) && near(Ey, vec3(0, 1, 0)) && near(Ez, vec3(1, 0, 0))'
holds 'fovValue and FacteurLargeur' 'in float fovValue, FacteurLargeur;' 'fovValue > 0.0 && abs(FacteurLargeur - 48.0 / 27.0) < 1e-5'
holds 'OrthoView, CustomToggle, CustomInt' 'in float OrthoView, CustomToggle, CustomInt;' 'OrthoView == 0.0 && CustomToggle == 0.0 && CustomInt == 0.0'
holds 'FragCoord' 'in vec2 FragCoord;' 'near(vec3(FragCoord, 0), vec3((2.0 * gl_FragCoord.xy - vec2(48, 27)) / 27.0, 0))'

wrong() { # PATTERN TITLE DECLARATIONS BODY
    refused wrong "$1" "the report's form: $2" < <(report_scene "$3" "$4")
}
wrong 'wrong.frag:2: in vec3 FragCoord: FragCoord is a vec2 here' 'an input of another type' 'in vec3 FragCoord; out vec4 FragColor;' "$still"
wrong 'wrong.frag:3: in int CustomInt: CustomInt is a float' 'an input on line 3' "$(printf 'in vec2 FragCoord; out vec4 FragColor;\nin vec3 Ex; in int CustomInt;')" "$still"
wrong 'wrong.frag:2: uniform vec2 iResolution: iResolution is a vec3 here' 'a uniform of another type' "$basic uniform vec2 iResolution;" "$still"
wrong 'wrong.frag:2: in vec2 MousePos: there is no such input: there are FragCoord,' 'an unknown input' "$basic in vec2 MousePos;" "$ray FragColor = vec4(MousePos, d.xy);"
wrong 'wrong.frag:16: error' 'an error in its own line' "$basic" 'FragColor = vec4(FragCoord);'
warned() {
    report_scene "$basic uniform float strength;" "${still/1.0);/1.0 - strength);}" >"$scratch/warned.frag"
    draw warned && cmp -s "$scratch/warned.png" "$scratch/scene.png" && [ "$(grep -c '' <<<"$said")" = 1 ] &&
        [[ $said =~ warned.frag:2:\ warning:\ uniform\ float\ strength\ is\ 0,\ for\ nothing\ sets\ it ]]
}
check "the report's form: a uniform that is read and that nobody sets is told of" warned
# What is left out is black, whatever the picture before: two of a row, the second all discarded.
discards() {
    printf '#version 330 core\nin float Time; out vec4 c; void main() { if (Time > 0.5) discard; c = vec4(1.0); }\n' >"$scratch/discard.frag"
    printf 'void mainImage(out vec4 c, vec2 p) { c = vec4(0.0); }\n' >"$scratch/black.frag"
    "$program" -f "$scratch/discard.frag" "${size[@]}" --frames 2 --fps 1 -o "$scratch/discard-%d.png" && draw black &&
        cmp -s "$scratch/discard-0.png" "$scratch/white.png" && cmp -s "$scratch/discard-1.png" "$scratch/black.png"
}
check 'a pixel that a shader discards is black' discards
as black unwritten 'a colour that only some pixels get' <<<'#version 330 core
in vec2 FragCoord; out vec4 c; void main() { if (FragCoord.x > 9.0) c = vec4(1.0); }'
wrong 'wrong.frag:3: out vec4 FragColor: never gets a value: write FragColor = vec4' 'a colour that gets no value' "$(printf 'in vec2 FragCoord;\nout vec4 FragColor;')" ''
wrong 'wrong.frag: writes no colour: declare out vec4 FragColor; and' 'no output' 'in vec2 FragCoord;' ''
wrong 'wrong.frag:16: error: .*FragColour' 'an output of another name' "$basic" 'FragColour = vec4(FragCoord, 0, 1);'
as scene renamed 'a macro that stands for the colour' < <(report_scene "$(printf '#define COULEUR FragColor\n%s' "$basic")" "${still/FragColor/COULEUR}")
refused views 'views.frag: cannot show the view steps: it has a main of its own' "the report's form: no views" -v steps <"$scratch/scene.frag"
colour() { "$program" -f "$scratch/$1.frag" "${size[@]}" --probe 5,5 | grep -qx '# no march is recorded; colour: [0-9]*, [0-9]*, [0-9]*'; }
check "the report's form: a probe tells the colour" colour scene

# ---- Shadertoy's form ----

toy_body='vec3 d = normalize(vec3((2.0 * p - iResolution.xy) / iResolution.y, -1.0)); c = vec4(Get_Color(vec3(0.0, 0.2, 3.0), d), 1.0);'
toy_scene() { # DECLARATIONS HEAD BODY
    report_scene "$1" '' | sed -e 1d -e '/^void main() {$/,$d'
    printf '%s\n{\n%s\n}\n' "$2" "$3"
}
head='void mainImage( out vec4 c, in vec2 p )'
toy_scene '' "$head" "$toy_body" >"$scratch/toy.frag"
check "Shadertoy's form: a scene" draw toy
tolerant() { "$BUILD/tests/compare" "$scratch/scene.png" "$scratch/toy.png" >/dev/null; }
check "the same scene in the report's form and in Shadertoy's" tolerant
draw scene -a 3 && draw toy -a 3
check "and with nine samples a pixel" tolerant
draw scene && draw toy -a 2 && mv "$scratch/toy.png" "$scratch/smooth.png" && draw toy

toy() { # TITLE DECLARATIONS HEAD BODY
    as toy variation "Shadertoy's form: $1" < <(toy_scene "$2" "$3" "$4")
}
toy 'no in' '' 'void mainImage(out vec4 c, vec2 p)' "$toy_body"
toy 'precisions in the parameters' '' 'void mainImage(out highp vec4 c, in highp vec2 p)' "$toy_body"
toy 'inout' '' 'void mainImage(inout vec4 c, in vec2 p)' "$toy_body"
toy 'a prototype, and words on lines of their own' "$head;" "$(printf 'void\nmainImage\n(out vec4 c,\n vec2 p)')" "$toy_body"
toy 'no opacity' '' "$head" "${toy_body/c = vec4(Get_Color(vec3(0.0, 0.2, 3.0), d), 1.0)/c.rgb = Get_Color(vec3(0.0, 0.2, 3.0), d)}"
toy 'colours above one and opacity of nothing' '' "$head" "$toy_body c.a = 0.0 / 0.0;"
toy 'gl_FragCoord' '' "$head" "p = gl_FragCoord.xy; $toy_body"
toy 'precision, GL_ES and HW_PERFORMANCE' "$(printf '#ifdef GL_ES\nprecision mediump float;\n#endif\nprecision highp int;\n#if HW_PERFORMANCE==0\n#error\n#endif')" "$head" "$toy_body"
toy 'macros of everything' "$(printf '#define R iResolution\n#define T iTime\n#define main0 mainImage\n#define vec4_(x) vec4(x)\n#define colour wrong\n#define clamp(x) x\n#define harness 1')" "$head" "$toy_body"
toy 'names of ours as its own' 'vec2 iPixelOffset = vec2(0); vec4 fragColour, colour; float focalLength, Time, FragCoord; vec3 rayColour(vec3 a) { return a; } mat3 iCameraRight;' "$head" "$toy_body"
toy 'initialisers of the inputs' 'float now = iTime; vec2 res = iResolution.xy;' "$head" "${toy_body//iResolution.xy/res}"
toy 'constant arrays' 'const float w[2] = float[2](0.5, 0.5); const vec2[2] v = vec2[](vec2(1), vec2(2));' "$head" "$toy_body c.a = w[1] + v[0].x;"
toy 'uniforms declared by itself' 'uniform vec3 iResolution; uniform float iTime, iTimeDelta; uniform vec4 iMouse;' "$head" "$toy_body"
toy 'every input' 'float all() { return iTime + iTimeDelta + float(iFrame) + iFrameRate + dot(iMouse, iDate); }' "$head" "$toy_body c.a = all();"
toy 'a parameter of every kind' '' 'void mainImage(inout vec4 c, inout vec2 p)' "p += 0.0; $toy_body"
toy 'const in' '' 'void mainImage(out vec4 c, const in vec2 p)' "$toy_body"
toy 'another name of mainImage' '#define MI mainImage' 'void MI(out vec4 c, vec2 p)' "$toy_body"
toy 'a whole head as a macro' "#define mainImage $head" 'mainImage' "$toy_body"
toy 'an extension' '#extension GL_OES_standard_derivatives : enable' "$head" "$toy_body"
toy 'a main that is left out' "$(printf '#if 0\nvoid main() {}\nvoid mainImage(inout vec4 c, vec2 p) {}\n#endif')" "$head" "$toy_body"
toy 'variables without a value' 'float glow;' "$head" "c *= 0.; for (float i, s; i++ < 9.; glow += s) c += s; c += glow; vec3 none; int j; $toy_body c += float(j) + none.xyzz;"
toy 'a macro that nothing uses reads iChannel0' "$(printf '#define tex(p) texture(iChannel0, p)')" "$head" "$toy_body"

for change in crlf mark latin version comment macro; do
    case $change in
    crlf) sed 's/$/\r/' ;;
    mark) printf '\357\273\277' && cat ;;
    latin) sed '1i // caf\xe9 \xe2\x88\x9e' ;;
    version) printf '// by others\n#version 300 es\nprecision highp float;\n' && cat ;;
    comment) printf '/* void main() {} */ // void main() {}\n' && cat ;;
    macro) sed "s/^$head/#define MAIN $head\nMAIN/" ;;
    esac <"$scratch/toy.frag" >"$scratch/changed"
    as toy "toy_$change" "Shadertoy's form: $change" <"$scratch/changed"
done
as smooth toy_samples "Shadertoy's form: four samples, by gl_FragCoord" -a 2 \
    < <(toy_scene '' "$head" "p = gl_FragCoord.xy; $toy_body")

# Each sample is clamped, before the four are averaged.
edge='void mainImage(out vec4 c, vec2 p) { c = vec4(vec3(step(20.6, p.x) * step(p.y, 10.4)), 1.0)'
echo "$edge; }" >"$scratch/edge.frag" && draw edge -a 2
as edge toy_edge "Shadertoy's form: samples above one count as one" -a 2 <<<"$edge * 7.0; }"

toy_holds() { # TITLE CONDITION
    as white toy_holds "Shadertoy's form: $1" -t 1.5 < <(printf 'void mainImage(out vec4 c, vec2 p) {\n c = vec4(%s);\n}\n' "$2")
}
toy_holds 'iResolution' 'iResolution == vec3(48, 27, 1)'
toy_holds 'iTime, iTimeDelta, iFrame of a file' 'iTime == 1.5 && iTimeDelta == 0.0 && iFrame == 0 && iFrameRate == 60.0'
toy_holds 'iMouse of a file' 'iMouse == vec4(0)'
toy_holds 'iDate of a file: no clock' 'iDate == vec4(1970, 0, 1, 1.5)'
toy_holds 'fragCoord at the pixels'"'"' centres' 'fract(p) == vec2(0.5) && p == gl_FragCoord.xy && all(lessThan(p, iResolution.xy))'
toy_holds 'not a number is black and 1e9 white' '0.0, 1e9, sqrt(-iTime), 1.0).yyyy + vec4(0.0'

# Pictures by --channel: upright, as numbers, which repeat. The upper row of this one is white.
echo 'void mainImage(out vec4 c, vec2 p) { c = vec4(step(1.0, p.y)); }' >"$scratch/rows.frag"
"$program" -f "$scratch/rows.frag" -s 2x2 -o "$scratch/rows.png"
channels=(--channel "0=$scratch/rows.png" --channel "3=shaders/textures/noise.png")
channel_holds() { # TITLE CONDITION
    as white channel_holds "$1" "${channels[@]}" < <(printf 'void mainImage(out vec4 c, vec2 p) {\n c = vec4(vec3(%s), texture(iChannel3, p).r + texture(iChannel0, p).r);\n}\n' "$2")
    as white channel_holds_whole "$1: a whole file" "${channels[@]}" < <(
        printf '#version 330 core\nuniform sampler2D iChannel0, iChannel3; uniform vec3 iChannelResolution[4];\nout vec4 c;\nvoid main() {\n'
        printf ' c = vec4(vec3(%s), texture(iChannel3, vec2(0.0)).r + texture(iChannel0, vec2(0.0)).r);\n}\n' "$2"
    )
}
channel_holds 'a channel stands upright' 'texture(iChannel0, vec2(0.2, 0.75)).rgb == vec3(1) && texture(iChannel0, vec2(0.7, 0.25)).rgb == vec3(0)'
channel_holds 'a channel repeats' 'texture(iChannel0, vec2(-7.2, 5.75)).r == 1.0 && texture(iChannel0, vec2(9.7, -2.75)).r == 0.0'
channel_holds 'a channel is a number, between its texels and halves' 'abs(texture(iChannel0, vec2(0.5)).r - 0.5) < 0.003 && abs(textureLod(iChannel0, vec2(0.1), 1.0).r - 0.5) < 0.003'
channel_holds 'the size of a channel' 'iChannelResolution[0] == vec3(2, 2, 1) && iChannelResolution[3] == vec3(64, 4096, 1)'
channel_holds 'a channel that is not given has no size' 'iChannelResolution[1] == vec3(0)'

toy_wrong() { # PATTERN TITLE DECLARATIONS BODY
    refused toy_wrong "$1" "Shadertoy's form: $2" < <(toy_scene "$3" "$head" "$4")
}
for name in iChannel0 iChannel3; do
    toy_wrong "^[^ ]*toy_wrong.frag:16: $name has no picture: give --channel ${name#iChannel}=FILE.png" "$name" '' "c = texture($name, p);"
done
toy_wrong 'toy_wrong.frag:16: iChannelResolution has no picture: give --channel 0=FILE.png' 'iChannelResolution' '' 'c = vec4(iChannelResolution[0], 1.0);'
toy_wrong 'toy_wrong.frag:1: iChannel1 has no picture: give --channel 1=FILE.png' 'a texture that it declares itself' 'uniform sampler2D iChannel0, iChannel1;' 'c = texture(iChannel1, p);'
toy_wrong 'toy_wrong.frag:16: iSampleRate is not offered: a shader gets no films' 'iSampleRate' '' 'c = vec4(iSampleRate);'
toy_wrong 'toy_wrong.frag:1: uniform vec2 iMouse: iMouse is a vec4 here' 'an input of another type' 'uniform highp float iTime; uniform vec2 iMouse;' "$toy_body"
toy_wrong 'toy_wrong.frag:16: error' 'an error in its own line' '' 'c = vec3(1.0);'
toy_wrong 'toy_wrong.frag:1: error' 'an error in its first line' 'float x = vec2(1.0);' "$toy_body"
head='float mainImage(out vec4 c, in vec2 p)' toy_wrong 'toy_wrong.frag:14: error' 'a mainImage that returns something' '' "$toy_body return 1.0;"
refused toy_open 'toy_open.frag:[0-9]*: error' "Shadertoy's form: a brace that is not closed" < <(sed '$d' "$scratch/toy.frag")
refused toy_views 'toy_views.frag: cannot show the view normals: it has a main of its own' "Shadertoy's form: no views" -v normals <"$scratch/toy.frag"
check "Shadertoy's form: a probe tells the colour" colour toy

# ---- Valid shaders that are hard to read: each must be white, as the specification has it ----

tricky() { # TITLE <TEXT
    as white tricky "valid: $1"
}
tricky 'an output declared behind main' <<'GLSL'
#version 330 core
void helper();
void main() { helper(); }
out vec4 c;
void helper() { c = vec4(1.0); }
GLSL
tricky 'outputs between which only the driver can choose' <<'GLSL'
#version 330 core
#if __VERSION__ >= 400
out vec4 a;
#define OUT a
#else
out vec4 b;
#define OUT b
#endif
void main() { OUT = vec4(1.0); }
GLSL
tricky 'a second output that gets no value' <<'GLSL'
#version 330 core
layout(location = 0) out vec4 c;
layout(location = 1) out vec4 bright;
void main() { c = vec4(1.0); }
GLSL
tricky 'a main renamed by a macro, and another that calls it' <<'GLSL'
#version 330 core
out vec4 c;
#define main scene
void main() { c += vec4(0.5); }
#undef main
void main() { c = vec4(0.5); scene(); }
GLSL
tricky 'a declaration that an #if divides' <<'GLSL'
#version 330 core
out vec4 c;
void main() {
    float d
#if __VERSION__ >= 400
    , e
#endif
    = 1.0;
    c = vec4(d);
}
GLSL
tricky 'declarations in cases' <<'GLSL'
#version 330 core
out vec4 c;
float f(int i) {
    switch (i) {
        case 0: float a; a = 0.5; return a;
        case 1: { float b, d = 0.25; b = d; return b + d; }
        default: int k = 3, m; m = k; return m == 3 ? 1.0 : 0.0;
    }
    return 0.0;
}
void main() { c = vec4(f(0) + f(1) == 1.0 && f(2) == 1.0); }
GLSL
tricky 'structures, arrays, prototypes, inout, shadowing, loops' <<'GLSL'
#version 330 core
out vec4 c;
struct S { float a; vec2 b[2]; } s = S(1.0, vec2[2](vec2(1), vec2(2))), none;
const float K[2] = float[](1.0, 2.0), L = 3.0;
float add(float, vec3 b, inout float c);
float same(const in float x);
float one = 1.0, two, three[2], four;
float[2] arr, brr = float[2](1.0, 2.0);
float add(float a, vec3 b, inout float c) { c += a; float x = c, y; { float x; x = 2.0; y = x; } return x + y; }
float same(const in float x) { return x; }
void main() {
    float x = 1.0, y; y = x;
    float r = add(x, vec3(0), y);
    bool ok = r == 4.0 && y == 2.0 && K[1] + L == 5.0 && brr[1] == 2.0 && s.b[1].x == 2.0;
    for (float i = 0.0, j; i < 3.0; i++) { j = i; ok = ok && j == i; }
    for (int i; i < 0;) ok = false;
    mat2 m; m = mat2(1.0); uint u; u = 3u; bvec2 bb; bb = bvec2(true); mat2x3 n; n = mat2x3(1.0);
    ok = ok && m[1][1] == 1.0 && u == 3u && all(bb) && n[1][1] == 1.0;
    if (ok) float unused; else ok = false;
    four = same(1.0);
    c = vec4(ok && four == one);
}
GLSL
tricky 'macros that declare, comments between the words' <<'GLSL'
#version 330 core
out vec4 c;
#define STRUCT struct
#define DECL(t, n) t n
#define DECLS float p; float q; \
    vec3 w;
#define REPEAT(n, body) for (int i = 0; i < n; i++) { body }
#define IF if (true)
STRUCT Sun { vec3 d; float t, u; };
void main() {
    DECL(float, a) = 1.0; DECL(float, z);
    DECLS
    float /* one, two; */ b /* = 3 */ , /**/ d // ; e
      ; b = 1.0; // b = 2.0; \
      b = 3.0;
    p = 1.0; q = p; w = vec3(q); z = 0.0; d = Sun(w, 0.0, 2.0).t;
    REPEAT(3, float e; e = 1.0; z += e;)
    IF float f;
    c = vec4(z == 3.0 && a == b && w.z == 1.0 && d == 0.0);
}
GLSL
tricky 'Shadertoy: a second mainImage with more parameters' <<'GLSL'
void mainImage(out vec4 c, const in vec2 p, float k) { c = vec4(k); }
void mainImage(out vec4 c, in vec2 p) { mainImage(c, p, 1.0); }
GLSL
tricky 'Shadertoy: structures in constant arrays, gl_FragCoord in a function' <<'GLSL'
#define STRUCT struct
STRUCT Sun { vec3 o; vec3 d; };
const Sun R[2] = Sun[](Sun(vec3(1), vec3(0)), Sun(vec3(1), vec3(1)));
vec2 place() { return gl_FragCoord.xy; }
void mainImage( out vec4 fragColor, in vec2 fragCoord )
{
    float f = distance(place(), fragCoord), g, h[3] = float[3](1., 2., 3.), k;
    g = 1.0; k = h[2];
    fragColor = vec4(f == 0.0 && k == 3.0 && R[1].o.x == g);
}
GLSL
tricky 'the course: structures and cases' <<'GLSL'
#include "main.glsl"
struct S { float a; float b; };
Ray pixelRay(vec2 s) { return Ray(vec3(0, 0, 3), vec3(0, 0, -1)); }
float sceneDistance(vec3 p) { float d; d = length(p) - 1.0; return d; }
vec3 rayColour(Ray ray)
{
    S s = S(1.0, 0.0);
    switch (int(s.b)) { case 0: float q = 1.0; return vec3(q); }
    return vec3(0.0);
}
GLSL
tricky 'a type that is a macro' <<'GLSL'
#version 330 core
#define float highp float
out vec4 c;
float one;
void main() { float two; two = 1.0; one = two; c = vec4(one); }
GLSL
tricky 'a block that a macro declares' <<'GLSL'
#version 330 core
#define BLOCK(name) layout(std140) uniform name
BLOCK(Data) { vec4 v; float k[2]; };
out vec4 c;
void main() { c = vec4(1.0) + v * k[1]; }
GLSL
tricky 'arrays and structures without a value, of every size' <<'GLSL'
#version 330 core
struct A { vec2 p[2]; bool b; };
struct B { A a[3]; int n; mat2 m; } one, more[2];
float few[3], many[1000];
out vec4 c;
void main()
{
    B two; A some[2]; int k[4];
    c = vec4(!two.a[2].b && one.a[1].p[1] == vec2(0) && more[1].m[1].y == 0.0 && some[1].p[0].x == 0.0 && few[2] == 0.0 && k[3] == 0);
    many[k[0]] = 1.0;
}
GLSL
# Each look at a text takes as long as the text. A suite that hangs is ended.
crowd() { # FORMAT: white, behind such lines, %d a number
    local i
    { for i in {1..30000}; do printf '%s\n' "${1//%d/$i}"; done; echo 'void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }'; } >"$scratch/crowd.frag"
    draw crowd && cmp -s "$scratch/crowd.png" "$scratch/white.png"
}
check 'thirty thousand uniforms' crowd 'uniform float u%d;'
check 'thirty thousand #ifdef' crowd $'#ifdef A%d\nfloat a%d;\n#endif'
block_warned() {
    printf '#version 330 core\nlayout(std140) uniform Unused { vec4 u; };\nuniform Data { vec4 v; } data;\nout vec4 c;\nvoid main() { c = vec4(1.0) + data.v; }\n' >"$scratch/block.frag"
    draw block && cmp -s "$scratch/block.png" "$scratch/white.png" && [ "$(grep -c '' <<<"$said")" = 1 ] &&
        [[ $said =~ block.frag:3:\ warning:\ what\ the\ block\ Data\ holds\ is\ 0 ]]
}
check 'a block that is read and that nobody sets is told of' block_warned

# ---- Malformed files, in every form ----

malformed() { # FORM BEGINNING
    local name=malformed_$1
    refused "$name" 'never closed: write \*/ at its end$' "$1: a comment without end" < <(printf '%s\n/*' "$2"; cat "$scratch/toy.frag")
    refused "$name" 'larger than 1 MiB: is it a shader\?$' "$1: 10 MB" < <(printf '%s\n' "$2"; head -c 10000000 /dev/zero | tr '\0' ' ')
    refused "$name" 'holds a zero byte: a shader is text, in UTF-8$' "$1: binary" < <(printf '%s\n\0\1\2' "$2")
    refused "$name" 'the file includes itself: [^ ]* -> [^ ]*: take one of these includes out$' "$1: includes itself" \
        < <(printf '%s\n#include "%s.frag"\n' "$2" "$name")
    refused "$name" 'holds a zero byte: a shader is text, in UTF-8$' "$1: a zero byte in its midst" < <(cat "$scratch/toy.frag"; printf '\0'; cat "$scratch/toy.frag")
    refused "$name" 'malformed include: write #include "name.glsl" alone on its line$' "$1: a quotation mark that is missing" < <(printf '%s\n#include "a.glsl\n' "$2")
    printf '#include "%s.frag"\n' "$name" >"$scratch/second.glsl"
    refused "$name" 'the file includes itself: [^ ]* -> [^ ]*second.glsl -> [^ ]*: take one of these includes out$' "$1: includes itself through another" \
        < <(printf '%s\n#include "second.glsl"\n' "$2")
    refused "$name" 'an array of 2000000000 elements: ' "$1: a huge array" < <(printf '%s\nfloat big[ 2000000000 ];\n' "$2")
    refused "$name" '\.\.\.$' "$1: 100000 parentheses, and no more than a glance of them" < <(printf '%s\nfloat deep = %s1.0%s;\n' "$2" "$deep" "$close")
    refused "$name" 'and [0-9]* more$' "$1: no more than 20 errors" < <(printf '%s\n' "$2"; for i in {1..99}; do echo "float e$i = none$i;"; done)
    refused "$name" 'does not|never|error' "$1: noise" < <(printf '%s\n' "$2"; head -c 3000 "$program" | tr -d '\0')
}
deep=$(printf '%100000s' '' | tr ' ' '(') close=$(tr '(' ')' <<<"$deep")
malformed course '#include "main.glsl"'
malformed whole '#version 330 core'
malformed toy 'void mainImage(out vec4 c, in vec2 p) {}'
refused empty 'empty.frag: empty$' 'an empty file' </dev/null
refused comment 'comment.frag: holds nothing but comments: a shader is code$' 'a file of comments' <<<'// to do'
unreadable() { # FILE PATTERN
    ! "$program" -f "$1" "${size[@]}" -o "$scratch/unreadable.png" 2>"$scratch/err" && [ "$(grep -c '' "$scratch/err")" = 1 ] &&
        grep -q "$2" "$scratch/err" && [ ! -e "$scratch/unreadable.png" ]
}
mkfifo "$scratch/fifo.frag" && ln -s nowhere "$scratch/broken.frag"
check 'a folder' unreadable "$scratch" ': not a regular file$'
check 'a pipe' unreadable "$scratch/fifo.frag" ': not a regular file$'
check 'a device without end' unreadable /dev/zero ': not a regular file$'
check 'a link to nowhere' unreadable "$scratch/broken.frag" ': cannot be read: '
# A sum of so many terms uses up the stack of some drivers' compilers; others draw it.
endures() {
    printf 'void mainImage(out vec4 c, vec2 p) { c = vec4(p.x%s); }\n' "$(printf '%40000s' '' | sed 's/ /+p.x/g')" >"$scratch/sum.frag"
    (ulimit -s 4096; draw sum; [ $? = 1 ] && [[ $said =~ sum.frag:\ the\ graphics\ driver\ crashed\ over\ it ]] && [ "$(grep -c '' <<<"$said")" = 1 ]) || draw sum
}
check 'a sum of 40000 terms' endures

# What hides its size from a reader ends at the memory that a driver may have, which is asked for at once, or the
# process, of which a little is filled sooner. The sanitizer ends a program that gets none in words of its own.
bomb() { draw bomb; [ $? = 1 ] && [[ $said =~ bomb.frag:\ the\ graphics\ driver\ crashed\ over\ it,\ or\ wants\ more ]] && [ "$(grep -c '' <<<"$said")" = 1 ]; }
if [ "$BUILD" = build ]; then
    printf '%s\n' 'const int N = 300000000;' 'float a[N * 4];' "$head { c = vec4(a[int(p.x)]); }" >"$scratch/bomb.frag"
    check 'constants that hide a huge array' bomb
    { echo '#define A0 p.x'; for i in {1..40}; do echo "#define A$i A$((i - 1)) + A$((i - 1))"; done
        echo "$head { c = vec4(A40); }"; } >"$scratch/bomb.frag"
    limited() { (ulimit -v 1000000; bomb); }
    check 'macros that grow without end' limited
fi

# ---- make play ----

mkdir "$scratch/project" && cp -r Makefile .make chapters shaders "$scratch/project" && ln -s "$root/$BUILD" "$scratch/project/build"
play() { (cd "$scratch/project" && FILE=${1-} .make/play.sh "${@:2}" >"$scratch/out" 2>"$scratch/err"); }
copies() { play '' -o "$scratch/play.png" "${size[@]}" && cmp -s "$scratch/project/chapters/play.frag" chapters/first_steps/play.frag; }
check 'make play makes chapters/play.frag' copies
keeps() {
    echo '// mine' >>"$scratch/project/chapters/play.frag"
    play '' -o "$scratch/play.png" "${size[@]}" && tail -n 1 "$scratch/project/chapters/play.frag" | grep -q mine
}
check 'make play keeps what is there' keeps
opens() { play "$scratch/toy.frag" -o "$scratch/opened.png" "${size[@]}" && cmp -s "$scratch/opened.png" "$scratch/toy.png"; }
check 'make play FILE opens a file' opens
missing() { ! play nowhere.frag && grep -q 'nowhere.frag: no such file' "$scratch/err" && [ ! -e "$scratch/project/nowhere.frag" ]; }
check 'make play FILE says that a file is missing' missing

# Where no window can be opened the scripts render files instead, and say so; what needs no window needs none.
runs() { (cd "$scratch/project" && .make/run.sh "$@" >"$scratch/out" 2>"$scratch/err"); }
gallery() { # NAME
    [ "$(cat "$scratch/out")" = "$(printf 'No window can be opened here: rendering into files instead.\n  build/gallery/%s.png' "$1")" ] &&
        [ "$(grep -c '' "$scratch/err")" = 1 ] && [ -s "$root/$BUILD/gallery/$1.png" ]
}
check 'make play on a display that is gone renders a file' eval "DISPLAY=:4321 WAYLAND_DISPLAY='' play '' \"\${size[@]}\" && gallery play"
check 'make run on a display that is gone renders a file' eval "DISPLAY=:4321 WAYLAND_DISPLAY='' CHAPTER=3 runs \"\${size[@]}\" && gallery 03_shadows"
check 'make run on a compositor that is gone renders a file' \
    eval "DISPLAY='' WAYLAND_DISPLAY=nowhere XDG_RUNTIME_DIR=\$scratch CHAPTER=3 runs \"\${size[@]}\" && gallery 03_shadows"
check 'make run without a display measures' eval "DISPLAY='' WAYLAND_DISPLAY='' runs --benchmark 1 \"\${size[@]}\" && grep -q '^shader  *00_' \"\$scratch/out\""
refuses() { runs -p nothing=1; [ $? = 2 ] && [ ! -s "$scratch/out" ] && [ "$(grep -c '' "$scratch/err")" = 1 ]; }
check 'make run refuses a parameter that there is not' refuses

# ---- The course's own, printed ----

# What --print-shader writes is the chapter again: the same picture, its parameters, every view.
printed() { # OPTION...
    "$program" --print-shader >"$scratch/printed.frag" &&
        "$program" "${size[@]}" -o "$scratch/chapter.png" "$@" && draw printed "$@" && [ -z "$said" ] &&
        cmp -s "$scratch/chapter.png" "$scratch/printed.png"
}
check 'a printed chapter is the chapter' printed -p biased=true
check 'with its views' printed -v steps

plan
