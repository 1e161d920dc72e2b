// aside.h - a ray that stays in space while the picture's camera moves on: from where it starts,
// and where its steps are in the picture.
#ifndef ASIDE_H
#define ASIDE_H

#include "picture/pass.h"
#include "picture/probe.h"

// The eye of a picture as it is now: from there its rays start.
struct renderer_eye aside_eye(const struct renderer *renderer,
                              const struct renderer_inputs *inputs);

// The inputs of a picture that is seen from where the ray that is looked at starts; the same ones
// where that is the picture's own camera.
struct renderer_inputs aside_from_eye(const struct renderer_inputs *inputs);

// Is the ray that is looked at seen from elsewhere than it starts?
bool aside_seen(const struct renderer *renderer, const struct renderer_inputs *inputs);

// Find where the steps of a march are in the picture: in its pixel, or, for a ray that is seen
// from elsewhere, wherever the pixels are whose rays meet them.
//   probe  of pixel (x, y); the renderer's table still holds it. Receives places, and aside
// Returns false, reported.
bool aside_places(struct renderer *renderer, const struct renderer_inputs *inputs, int x, int y,
                  struct probe *probe);

#endif
