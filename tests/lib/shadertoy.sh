# shellcheck shell=bash
# shadertoy.sh - checks that an exported file is valid, for suites that source this file after tap.sh.

# Print a file with the relevant part of the text that Shadertoy puts around a shader.
wrap() { # FILE
    sed '/^\/\/ ---- the shader/,$d' tests/lib/shadertoy.glsl
    cat "$1"
    sed '1,/^\/\/ ---- the shader/d' tests/lib/shadertoy.glsl
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
