// What one option asks of the others.
#include "options.h"

#include <math.h>

#include "report.h"
#include "sequence.h"

#define FPS_DEFAULT 25.0
#define TIME_LIMIT  1e9 // as of --time

// What --frames asks of other options.
static bool complete_frames(struct options *options)
{
    bool given = options->fps > 0.0;
    if (!given)
        options->fps = FPS_DEFAULT;
    if (options->frames == 0 && given)
        report("--fps: goes with --frames N: how many pictures?");
    else if (options->frames > 0 && options->output == NULL)
        report("--frames: goes with --output, as in -o frame-%%04d.png");
    else if (options->frames > 0 && !sequence_is_name(options->output))
        report("--output '%s': with --frames the name must hold one %%d for the number, as in "
               "frame-%%04d.png",
               options->output);
    else if (options->frames > 0 && options->has_probe && options->view != SHADER_SLICE)
        report("--probe: the march of one picture: leave --frames out");
    else if (options->frames > 0 &&
             fabs(options->time) + options->frames / options->fps > TIME_LIMIT)
        report("--frames: the last time must be from -1e9 to 1e9 seconds");
    else
        return true;
    return false;
}

bool options_complete(struct options *options)
{
    bool still = options->output != NULL || options->has_probe || options->benchmark > 0;
    if (options->benchmark > 0 && (options->output != NULL || options->has_probe)) {
        report("--benchmark: writes no picture and probes no ray: leave --%s out",
               options->output != NULL ? "output" : "probe");
        return false;
    }
    if (options->width == 0) {
        options->width = still ? 640 : 960;
        options->height = still ? 360 : 540;
    }
    if (!complete_frames(options))
        return false;
    if (options->shadertoy && options->view != SHADER_PICTURE) {
        report("--print-shader=shadertoy: only the picture runs there: leave --view %s out",
               shader_view_name(options->view));
        return false;
    }
    if (!options->has_probe || (options->probe_x >= 0 && options->probe_x < options->width &&
                                options->probe_y >= 0 && options->probe_y < options->height))
        return true;
    report("--probe '%d,%d': outside the picture of %dx%d: X is from 0 to %d, Y from 0 to %d",
           options->probe_x, options->probe_y, options->width, options->height, options->width - 1,
           options->height - 1);
    return false;
}
