#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision mediump sampler3D;
#define HW_PERFORMANCE 1
out vec4 outColor;
uniform vec3 iResolution;
uniform float iTime, iTimeDelta, iFrameRate, iChannelTime[4], iSampleRate;
uniform vec3 iChannelResolution[4];
uniform int iFrame;
uniform vec4 iMouse, iDate;
uniform sampler2D iChannel0;
uniform sampler2D iChannel1;
uniform sampler2D iChannel2;
uniform sampler2D iChannel3;
void mainImage(out vec4 c, in vec2 f);
#line 1
// ---- the shader ----
void main() { vec4 c = vec4(0.0, 0.0, 0.0, 1.0); mainImage(c, gl_FragCoord.xy); outColor = vec4(c.rgb, 1.0); }
