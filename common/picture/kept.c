#include "picture/kept.h"

#include <stdlib.h>
#include <string.h>

struct target *kept_frame(struct kept *kept, int frame)
{
    return &kept->target[frame & 1];
}

void kept_follow(struct kept *kept, char *key, int frame)
{
    bool same = kept->key != NULL && strcmp(kept->key, key) == 0;
    free(kept->key);
    kept->key = key;
    if (!same || kept->frames > frame + 1)
        kept->frames = 0;
}

bool kept_begin(struct kept *kept, const struct gl *gl, bool bytes, int width, int height)
{
    bool opened = kept->target[0].framebuffer != 0;
    GLenum format = bytes || opened ? GL_RGBA8 : target_format(gl, false);
    for (int i = 0; i < 2; i++) {
        if (kept->target[i].framebuffer == 0)
            target_open(&kept->target[i], gl, format);
        if (!target_make(&kept->target[i], gl, width, height))
            return false;
        gl->ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        gl->Clear(GL_COLOR_BUFFER_BIT);
    }
    return true;
}

void kept_free(struct kept *kept, const struct gl *gl)
{
    for (int i = 0; i < 2; i++)
        if (kept->target[i].framebuffer != 0)
            target_close(&kept->target[i], gl);
    free(kept->key);
    *kept = (struct kept){0};
}
