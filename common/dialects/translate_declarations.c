#include "dialects/translation.h"

#include <string.h>

#include "dialects/tool_inputs.h"
#include "shader/parameter.h"

static bool is_used(const struct declared *at)
{
    return at->code->name[at->name->name].last > at->name - at->code->statement;
}

static bool refuse_type(struct translation *t, const struct declared *at, const struct input *input)
{
    return shader_refuse(
        t->source, at->name->line, "%s %s%s %s: %s is a %s here%s",
        at->kind == DECLARED_IN ? "in" : "uniform", at->type->text,
        declared_is_array(at) ? "[]" : "", at->word, at->word, input->type,
        input->meaning < INPUT_VALUES ? ": declare it as float, int, vec2, vec3 or vec4" : "");
}

static bool store(struct translation *t, struct declared *at, const char *storage)
{
    declared_store(at, &t->edits, t->exported ? "" : storage);
    return true;
}

// Leave a name out of the text for Shadertoy, which declares the name itself or does not need it. A
// name that cannot be left out gets the prefix shader_.
static bool leave_out(struct translation *t, struct declared *at)
{
    if (at->name == at->first && at->end->sign == ';') {
        edits_cut(&t->edits, at->begin, at->end);
        return true;
    }
    edits_add(&t->edits, at->name->begin, 0, "shader_");
    return store(t, at, "");
}

static void cut_value(struct translation *t, const struct declared *at)
{
    if (at->value != NULL && at->end->kind != GLSL_END)
        edits_cut(&t->edits, at->value, at->end - 1);
}

// The first channel that no sampler of the text reads yet; -1 if all four are taken.
static int free_channel(const struct translation *t)
{
    bool taken[5] = {false};
    const struct input *input;
    int channel = 0;
    for (int i = 0; (input = tool_inputs_row(i)) != NULL; i++)
        if (input->meaning == INPUT_CHANNEL && glsl_mentions(t->code, input->name) > 0)
            taken[input->channel] = true;
    for (int i = 0; i < t->source->sampler_count; i++)
        taken[t->source->samplers[i].channel < 0 ? 4 : t->source->samplers[i].channel] = true;
    while (channel < 4 && taken[channel])
        channel++;
    return channel < 4 ? channel : -1;
}

// Add a sampler to those of the source. On Shadertoy, it is one of the four channels.
static bool add_sampler(struct translation *t, const char *name, const struct input *input,
                        int line)
{
    const char *type = input != NULL ? tool_inputs_sampler(t->source, input) : "sampler2D";
    int channel = input != NULL                             ? input->channel
                  : shader_read_of(t->source, name) != NULL ? -1
                                                            : free_channel(t);
    channel = inputs_add_sampler(t->source, (struct shader_sampler){name, type, channel, line});
    return channel >= 0 || !t->exported ||
           shader_refuse(t->source, line, "%s: a fifth picture: Shadertoy has four channels", name);
}

// Add the samplers whose sizes an input tells.
static void add_sizes(struct translation *t, const struct input *size)
{
    const struct input *input;
    for (int i = 0; (input = tool_inputs_row(i)) != NULL && tool_inputs_is_shadertoy(input); i++)
        if (input->meaning == INPUT_CHANNEL && !tool_inputs_lacks(t->source, input) &&
            (size->channel < 0 || size->channel == input->channel))
            add_sampler(t, input->name, input, 0);
}

// Let the file have one pass, which draws the same text for the next frame.
static void read_last_picture(struct shader_source *source, const struct input *input)
{
    struct shader_read *read = &source->links.read[0];
    snprintf(read->name, sizeof read->name, "%s", input->name);
    read->filter = input->text[0];
    read->pass = source->pass_count = 1;
    source->links.shown = true;
    source->links.repeat = input->text[1] == 'r';
}

static bool take_sampler(struct translation *t, struct declared *at, const struct input *input)
{
    bool used = is_used(at), channel = input != NULL && input->meaning == INPUT_CHANNEL;
    bool last = used && input != NULL && input->meaning == INPUT_LAST;
    bool silent = input != NULL && input->meaning >= INPUT_SILENT && !last;
    bool plain = glsl_is(at->type, "sampler2D") && !declared_is_array(at);
    int line = at->name->line;
    if (t->web && glsl_is(at->type, "sampler1D"))
        t->mark[at->name->name] |= MARK_LINE;
    if (used && glsl_is(at->type, "samplerCube"))
        return shader_refuse(t->source, line,
                             "%s: cube maps are not supported: a picture is a sampler2D", at->word);
    if (used && channel && !plain)
        return refuse_type(t, at, input);
    if (used && !silent && !plain)
        return shader_refuse(t->source, line,
                             "%s %s%s has no picture: a picture is a sampler2D: declare uniform "
                             "sampler2D %s; and give --channel 0=FILE.png",
                             at->type->text, at->word, declared_is_array(at) ? "[]" : "", at->word);
    if (used && (channel ? tool_inputs_lacks(t->source, input) : silent && t->exported))
        return tool_inputs_refuse(t->source, input, line);
    if (last)
        read_last_picture(t->source, input);
    if (!silent && plain && !add_sampler(t, at->word, channel ? input : NULL, line))
        return false;
    if (!t->exported)
        declared_store(at, &t->edits, "uniform");
    else if (at->name == at->first)
        edits_cut(&t->edits, at->begin, glsl_skip(t->code, at->end, ";"));
    return true;
}

// Accept an image to which a shader writes. Desktop drivers support such images; WebGL does not.
static bool take_image(struct translation *t, struct declared *at)
{
    if (!t->web)
        return true;
    return is_used(at)
               ? shader_refuse(t->source, at->name->line,
                               "%s: WebGL has no images that a shader can write to", at->word)
               : leave_out(t, at);
}

// Translate the declaration of an input whose value is the same for all pixels.
static bool take_value(struct translation *t, struct declared *at, const struct shader_input *in)
{
    if (in->input->meaning == INPUT_ZERO && at->value != NULL)
        return store(t, at, "");
    inputs_add(t->source, *in);
    cut_value(t, at);
    return t->exported && tool_inputs_is_own(in) ? leave_out(t, at) : store(t, at, "uniform");
}

// Translate the declaration of an input that differs from pixel to pixel.
static bool take_position(struct translation *t, struct declared *at, const struct shader_input *in)
{
    if (in->input != NULL && in->input->meaning == INPUT_POSITION)
        inputs_add(t->source, *in);
    else if (is_used(at))
        return shader_refuse(t->source, at->name->line,
                             "in %s %s: comes from a vertex shader of its own program, and none "
                             "runs here: %s",
                             at->type->text, at->word,
                             glsl_is(at->type, "vec2")
                                 ? "call it v_texcoord if it is the position in the picture"
                                 : "compute it in the shader");
    return store(t, at, "in");
}

static bool take_uniform(struct translation *t, struct declared *at, const struct shader_input *in)
{
    const struct input *input = in->input;
    if (input != NULL && input->meaning == INPUT_CHANNEL_SIZE) {
        bool array = declared_is_array(at), row = input->channel < 0;
        if (array != row || !glsl_is(at->type, row ? "vec3" : "vec2"))
            return refuse_type(t, at, input);
        inputs_add(t->source, *in);
        add_sizes(t, input);
    }
    if (input != NULL && is_used(at) && tool_inputs_lacks(t->source, input))
        return tool_inputs_refuse(t->source, input, at->name->line);
    if (t->exported && input != NULL && tool_inputs_is_shadertoy(input))
        return leave_out(t, at);
    if (!parameter_declared(t->source, at->name))
        return store(t, at, at->value != NULL ? "" : "uniform");
    cut_value(t, at);
    t->wraps = t->exported;
    return store(t, at, "uniform");
}

static bool take_input(struct translation *t, struct declared *at)
{
    struct shader_input in = {.input = tool_inputs_find(at->word), .declared = true};
    const struct input *input = in.input;
    bool typed = inputs_type(at->type->text, &in) && !declared_is_array(at);
    bool varies = at->kind == DECLARED_IN;
    const char *type = at->type->text;
    if (at->type->macro || at->name->macro || (varies && strncmp(at->word, "gl_", 3) == 0))
        return true;
    if (!varies &&
        (strstr(type, "sampler") != NULL || (input != NULL && input->meaning == INPUT_CHANNEL)))
        return take_sampler(t, at, input);
    if (!varies && strstr(type, "image") != NULL)
        return take_image(t, at);
    bool value = input != NULL && input->meaning < INPUT_VALUES;
    bool position = varies && input != NULL && input->meaning == INPUT_POSITION;
    if ((value && !typed) || (position && (!typed || in.integer)))
        return refuse_type(t, at, input);
    return value    ? take_value(t, at, &in)
           : varies ? take_position(t, at, &in)
                    : take_uniform(t, at, &in);
}

// Turn a block of inputs, as in KodeLife, into a structure that main fills in.
static bool take_block(struct translation *t, const struct declared *at)
{
    static const struct {
        const char *word, *value;
    } members[] = {{"coord", "%s"}, {"uv", "%s"}, {"position", "2.0 * %s - 1.0"}};
    static const char *const types[] = {"vec2", "vec3", "vec4", NULL}, *const rest[] = {
                                                                           "", ", 1.0",
                                                                           ", 0.0, 1.0"};
    const struct glsl_token *end = glsl_partner(t->code, at->end), *name = end + 1;
    char value[128];
    if (name->kind != GLSL_WORD)
        return shader_refuse(t->source, at->name->line,
                             "in %s { }: name the block after its closing brace", at->word);
    edits_replace(&t->edits, at->type - 1, "struct");
    edits_add(&t->edits, name->begin, 0, "; %s ", at->word);
    for (const struct glsl_token *m = at->end + 1; m < end; m++) {
        size_t i = 0;
        if (!glsl_is_any(m, types) || m[1].kind != GLSL_WORD)
            continue;
        const char *member = m[1].text;
        while (i < COUNT(members) && strstr(member, members[i].word) == NULL)
            i++;
        if (i == COUNT(members))
            continue;
        snprintf(value, sizeof value, members[i].value,
                 t->exported ? "(gl_FragCoord.xy / iResolution.xy)"
                             : "(harnessFragCoord.xy / harnessResolution.xy)");
        fprintf(t->begin, "%s.%s=%s(%s%s);", name->text, member, m->text, value,
                rest[m->text[3] - '2']);
    }
    t->blocks = true;
    return true;
}

// Turn the members of any other block, which nothing sets, into variables, because WebGL draws
// nothing while a block has no buffer.
static bool open_block(struct translation *t, const struct declared *at)
{
    const struct glsl_token *end = glsl_partner(t->code, at->end), *last = at->type - 1;
    if (end[1].kind == GLSL_WORD) { // with an instance name, the block can become a structure
        edits_add(&t->edits, at->begin->begin, last->begin + last->length - at->begin->begin,
                  "struct");
        return true;
    }
    edits_cut(&t->edits, at->begin, at->end);
    edits_cut(&t->edits, end, end + (end[1].sign == ';'));
    return true;
}

// Turn an output into a variable for Shadertoy. If an #if selects one of several outputs, add a
// function for each of them, always with the same name.
static void export_output(struct translation *t, struct declared *at, bool certain)
{
    const struct glsl_token *end = glsl_skip(t->code, at->end, ";");
    store(t, at, "");
    if (!certain && end->sign == ';' && (at->layout == NULL || declared_is_first(at)))
        edits_add(&t->edits, end->begin + 1, 0, " vec4 shaderShown() { return vec4(%s.rgb, 1.0); }",
                  at->word);
}

// The first live mention of a word, outside parentheses, in a macro that contains more than this
// word. Returns NULL if there is none.
static const struct glsl_token *find_hidden(const struct glsl *code, const char *word)
{
    int depth = 0;
    for (const struct glsl_token *t = code->item; t->kind != GLSL_END; t++) {
        bool alone = t > code->item + 2 && glsl_is(t - 2, "define") &&
                     (!t[1].directive || t[1].kind == GLSL_HASH);
        depth = t->kind == GLSL_HASH ? 0 : depth + (t->sign == '(') - (t->sign == ')');
        if (t->directive && t->live && depth == 0 && !alone && glsl_is(t, word))
            return t;
    }
    return NULL;
}

// Refuse to export a declaration that is in a macro.
static bool check_macros(const struct translation *t)
{
    const struct glsl_token *out = NULL, *uniform = find_hidden(t->code, "uniform");
    if (!t->toy && declared_output(t->code).kind == DECLARED_NONE)
        out = find_hidden(t->code, "out");
    const struct glsl_token *hidden = out != NULL ? out : uniform;
    return hidden == NULL ||
           shader_refuse(t->source, hidden->line,
                         "%s in a macro: Shadertoy accepts the text only if each declaration is "
                         "written out",
                         hidden->text);
}

static bool check_outputs(struct translation *t, const struct outputs *outputs)
{
    static const char *const colours[] = {"vec4", "vec3", NULL};
    const struct declared *shown = &outputs->shown, *second = &outputs->second;
    if (outputs->count > 1 && !outputs->placed)
        return shader_refuse(t->source, second->name->line,
                             "out %s %s: a second output: write layout(location = 0) before the "
                             "output that is the picture",
                             second->type->text, second->word);
    return outputs->count == 0 || shown->type->macro || glsl_is_any(shown->type, colours) ||
           shader_refuse(t->source, shown->name->line,
                         "out %s %s: a picture is made of colours: write out vec4 %s;",
                         shown->type->text, shown->word, shown->word);
}

bool translation_declarations(struct translation *t)
{
    struct declared at = {.code = t->code};
    struct outputs outputs = declared_outputs(t->code, false);
    bool done = (t->toy || check_outputs(t, &outputs)) && (!t->exported || check_macros(t));
    while (done && declared_next(&at)) {
        if (at.kind == DECLARED_IN || at.kind == DECLARED_UNIFORM)
            done = take_input(t, &at);
        else if (at.kind == DECLARED_BLOCK && glsl_is(at.type - 1, "in"))
            done = take_block(t, &at);
        else if (at.kind == DECLARED_BLOCK && t->web)
            done = open_block(t, &at);
        else if (at.kind == DECLARED_OUT && !t->toy && t->exported)
            export_output(t, &at, outputs.count > 0);
        else if (at.kind == DECLARED_OUT && !t->toy && outputs.count == 1)
            store(t, &at, "out");
    }
    t->old = !t->toy && declared_output(t->code).kind == DECLARED_NONE &&
             glsl_mentions(t->code, "gl_FragColor") + glsl_mentions(t->code, "gl_FragData") > 0;
    return done;
}

// True if the driver may need the declaration of a word: the text mentions it where it is not a
// macro, or only the driver knows whether it is one.
static bool may_need(const struct glsl *code, const char *word)
{
    return glsl_mentions(code, word) > 0 &&
           (glsl_find(code, word) != NULL || glsl_name(code, word)->defined == GLSL_PERHAPS);
}

void translation_undeclared(struct translation *t)
{
    const struct input *input;
    for (int i = 0; (input = tool_inputs_row(i)) != NULL; i++) {
        const struct glsl_token *mention = glsl_find(t->code, input->name);
        if (!may_need(t->code, input->name) || input->meaning == INPUT_POSITION ||
            (input->meaning >= INPUT_SILENT && !tool_inputs_is_shadertoy(input)) ||
            tool_inputs_lacks(t->source, input) || declared_anywhere(t->code, input->name))
            continue;
        bool channel = input->meaning == INPUT_CHANNEL;
        if (channel)
            add_sampler(t, input->name, input, mention != NULL ? mention->line : 0);
        else
            inputs_add(t->source, inputs_default(input));
        if (input->meaning == INPUT_CHANNEL_SIZE)
            add_sizes(t, input);
        const char *type = channel ? tool_inputs_sampler(t->source, input) : input->type;
        int length = (int)strcspn(type, "[");
        if (!t->exported || (!channel && !tool_inputs_is_shadertoy(input)))
            fprintf(t->inputs, "%s%.*s %s%s;\n", t->exported ? "" : "uniform ", length, type,
                    input->name, type + length);
    }
}
