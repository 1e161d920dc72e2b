# shellcheck shell=bash
# shadertoy.sh - checks that an exported file is valid, for suites that source this file after tap.sh.

# Print a file with the relevant part of the text that Shadertoy puts around a shader.
wrap() { # FILE
    cat <<'GLSL'
#version 300 es
precision highp float;
precision highp int;
precision mediump sampler3D;
#define HW_PERFORMANCE 1
out vec4 outColor;
uniform vec3 iResolution;
uniform float iTime, iTimeDelta, iFrameRate, iChannelTime[4], iSampleRate;
uniform vec3 iChannelResolution[4];
uniform int iFrame;
uniform vec4 iMouse, iDate;
uniform sampler2D iChannel0, iChannel1, iChannel2, iChannel3;
void mainImage(out vec4 c, in vec2 f);
#line 1
GLSL
    cat "$1"
    printf 'void main() { vec4 c = vec4(0.0, 0.0, 0.0, 1.0); mainImage(c, gl_FragCoord.xy); outColor = vec4(c.rgb, 1.0); }\n'
}

# valid FILE: true if the validator accepts an exported file as a shader of Shadertoy, or if there is no validator.
valid() {
    local status
    wrap "$1" >"${scratch:?}/wrapped.frag"
    command -v glslangValidator >/dev/null || return 0
    glslangValidator -S frag "${scratch:?}/wrapped.frag" >"$scratch/log" && return
    status=$?
    echo "# the validator exits with status $status, for a file of $(wc -c <"$1") bytes"
    grep ERROR "$scratch/log" | sed 's/^/# /'
    return 1
}
