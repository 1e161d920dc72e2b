#include "json.h"

#include <math.h>

static void write_string(FILE *stream, const char *text)
{
    fputc('"', stream);
    for (; *text != '\0'; text++)
        if ((unsigned char)*text < ' ')
            fprintf(stream, "\\u%04x", (unsigned)*text);
        else
            fprintf(stream, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    fputc('"', stream);
}

// Write the comma and the name that precede a value.
static void begin_value(struct json *json, const char *name)
{
    fputs(json->comma ? "," : "", json->stream);
    json->comma = true;
    if (name == NULL)
        return;
    fputs(json->lines ? "\n  " : "", json->stream);
    write_string(json->stream, name);
    fputs(json->lines ? ": " : ":", json->stream);
}

void json_begin(struct json *json, const char *name, char bracket)
{
    begin_value(json, name);
    fputc(bracket, json->stream);
    json->comma = false;
}

void json_end(struct json *json, char bracket)
{
    fprintf(json->stream, json->lines ? "\n%c\n" : "%c", bracket);
    json->comma = true;
}

void json_text(struct json *json, const char *name, const char *text)
{
    begin_value(json, name);
    write_string(json->stream, text != NULL ? text : "");
}

void json_number(struct json *json, const char *name, double value, int decimals)
{
    begin_value(json, name);
    if (!isfinite(value))
        fputs("null", json->stream);
    else if (decimals < 0)
        fprintf(json->stream, "%.9g", value);
    else
        fprintf(json->stream, "%.*f", decimals, value);
}

void json_flag(struct json *json, const char *name, bool value)
{
    begin_value(json, name);
    fputs(value ? "true" : "false", json->stream);
}
