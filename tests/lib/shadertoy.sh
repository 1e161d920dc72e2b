# shellcheck shell=bash
# shadertoy.sh - whether an exported file is right, for suites that source it after tap.sh.

# The text that Shadertoy puts around a shader, as far as it matters.
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

# valid FILE: an exported file passes the validator as Shadertoy's, if there is one.
valid() {
    local status
    wrap "$1" >"${scratch:?}/wrapped.frag"
    command -v glslangValidator >/dev/null || return 0
    glslangValidator -S frag "${scratch:?}/wrapped.frag" >"$scratch/log" && return
    status=$?
    echo "# the validator ends with $status, for $(wc -c <"$1") bytes"
    grep ERROR "$scratch/log" | sed 's/^/# /'
    return 1
}
