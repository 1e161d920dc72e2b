// json.h - writes JSON to a stream.
#ifndef JSON_H
#define JSON_H

#include <stdbool.h>
#include <stdio.h>

// Initialise a writer with {.stream = stream}.
struct json {
    FILE *stream;
    bool lines; // each member of an object is on a separate line
    bool comma; // the next value needs a comma before it
};

// Each function writes one value, or the opening or closing bracket of an object or array.
//   name     name of the member of an object; NULL in an array and for the outermost value
//   bracket  { or [ to begin, } or ] to end
//   text     UTF-8; NULL is written as ""
//   value    infinities and NaN are written as null
//   decimals digits after the point; -1 for nine significant digits
void json_begin(struct json *json, const char *name, char bracket);
void json_end(struct json *json, char bracket);
void json_text(struct json *json, const char *name, const char *text);
void json_number(struct json *json, const char *name, double value, int decimals);
void json_flag(struct json *json, const char *name, bool value);

#endif
