// Experiment of chapter 12: the stone's picture read as numbers. Its bytes are what a screen takes, not
// light: taken for light they are too bright and too pale, and are encoded a second time in the end.
//
// A second sampler reads the same file; the chapter's call is led to it.
#include "main.glsl"
#include "texture.glsl"

uniform sampler2D undecoded; // "granite.png" linear repeat: the same picture, not decoded

#define textureOnPlanes(picture, p, f, weights) textureOnPlanes(undecoded, p, f, weights)
#include "12_textures.frag"
