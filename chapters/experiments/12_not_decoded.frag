// Experiment of chapter 12: the granite's texture is read without being decoded. Its bytes are
// values for a screen, not light. When they are used as light, they are too bright and too pale,
// and at the end they are encoded a second time.
//
// A second sampler reads the same file; the chapter's call is redirected to it.
#include "main.glsl"
#include "texture.glsl"

uniform sampler2D undecoded; // "granite.png" linear repeat: the same picture, not decoded

#define textureOnPlanes(picture, p, f, weights) textureOnPlanes(undecoded, p, f, weights)
#include "12_textures.frag"
