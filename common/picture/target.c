#include "picture/target.h"

#include <stddef.h>

#include "report.h"

void target_open(struct target *target, const struct gl *gl)
{
    *target = (struct target){0};
    gl->GenFramebuffers(1, &target->framebuffer);
    gl->GenTextures(1, &target->texture);
}

void target_close(struct target *target, const struct gl *gl)
{
    gl->DeleteTextures(1, &target->texture);
    gl->DeleteFramebuffers(1, &target->framebuffer);
    *target = (struct target){0};
}

bool target_bind(struct target *target, const struct gl *gl, int width, int height)
{
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    if (target->width == width && target->height == height)
        return true;
    gl->BindTexture(GL_TEXTURE_2D, target->texture);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, NULL);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target->texture,
                             0);
    if (gl->CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE ||
        gl->GetError() != GL_NO_ERROR) {
        target->width = 0;
        return report(
            "float target %dx%d: the driver cannot make it: try a smaller --size or another "
            "--backend",
            width, height);
    }
    target->width = width;
    target->height = height;
    return true;
}

void target_read(const struct target *target, const struct gl *gl, float *values)
{
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl->ReadPixels(0, 0, target->width, target->height, GL_RGBA, GL_FLOAT, values);
}
