#!/bin/bash
# chapter.sh - `make chapter NAME=soft_shadows`: begin a chapter with the next free number.
#
# Environment: NAME. Writes chapters/NN_NAME.c and .frag, docs/NN_NAME.md, and a line in
# tests/images.txt; nothing that exists is overwritten.
set -u
. .make/chapters.sh

fail() {
    printf 'make: %s\n' "$*" >&2
    exit 1
}

[ -n "${NAME-}" ] || fail 'which name? For example: make chapter NAME=soft_shadows'
[[ $NAME =~ ^[a-z][a-z0-9_]*$ ]] || fail "NAME=$NAME: small letters, digits and _, such as soft_shadows"
last=$(stems | tail -n 1)
number=$(printf '%02d' $((10#${last%%_*} + 1)))
[ "$number" -le 99 ] || fail 'there are a hundred chapters'
stem=${number}_$NAME
title=${NAME//_/ }
title=${title^}
for file in "chapters/$stem.c" "chapters/$stem.frag" "docs/$stem.md"; do
    [ ! -e "$file" ] || fail "$file exists"
done

cat >"chapters/$stem.c" <<END || exit 1
// Chapter $number: ${title,}. One sentence on what it shows.
//
// The page is docs/$stem.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "$stem",
        .title = "$number $title",
        .shows = "A ball on a ground.",
        .camera = {.position = {0.0f, 1.4f, 5.0f}, .pan = 0.0f, .tilt = -12.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
END

cat >"chapters/$stem.frag" <<END || exit 1
// $number $title: one sentence on what it shows.

#include "main.glsl"       // main(): asks for pixelRay, then for rayColour
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere, sdBox
#include "lighting.glsl"   // lambert, encodeSRGB

uniform float ballRadius;   // 0.8 in [0.1, 2] step 0.05, scene units: radius of the ball
uniform int   maxSteps;     // 256 in [1, 1024]: steps before a ray is given up
uniform float hitThreshold; // 0.0005 in [0.00001, 0.2] step *2, scene units: distance that counts as a hit

const float FAR = 40.0; // a ray that has travelled so far sees the sky

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    float ball = sdSphere(p - vec3(0.0, ballRadius, 0.0), ballRadius);
    float ground = sdBox(p - vec3(0.0, -0.1, 0.0), vec3(2.4, 0.1, 2.4));
    return min(ball, ground);
}

vec3 rayColour(Ray ray)
{
    Hit hit = march(ray, 0.0, FAR, hitThreshold, maxSteps);
    vec3 light = mix(vec3(0.10, 0.16, 0.20), vec3(0.03, 0.05, 0.09), smoothstep(-0.4, 0.4, ray.direction.y));
    if (hit.found) {
        vec3 normal = normalAt(ray.origin + hit.t * ray.direction, 0.001);
        light = vec3(0.04, 0.06, 0.09) + vec3(0.9, 0.7, 0.5) * lambert(normal, normalize(vec3(2.0, 3.0, 2.0)));
    }
    return encodeSRGB(light);
}
END

cat >"docs/$stem.md" <<END || exit 1
# $number $title

What the chapter before left open, and what this one does about it, in three sentences.

![What is seen in the chapter's picture](../tests/references/$stem.png)

\`\`\`sh
make run CHAPTER=$number
\`\`\`

**What you need to know.** The chapters and the mathematics that this one stands on.

### L'essentiel

> 1. Première phrase.
> 2. Deuxième phrase.
> 3. Troisième phrase.
> 4. Quatrième phrase.
> 5. Cinquième phrase.

## What the report does

The section, what is right in it, and where it errs.

## The mathematics

Definitions before use. Claims with proofs. Error bounds.

## From formula to code

<!-- code: chapters/$stem.frag sceneDistance -->

## What changed since chapter $(printf '%02d' $((10#$number - 1)))

\`\`\`sh
make diff CHAPTER=$number
\`\`\`

## Parameters

<!-- parameters: $stem -->

## Experiments

**1. A prediction.** A command, what is seen, and why.

## Pitfalls

- What a reader does wrong first, and how it looks.

## Exercises

At least three, each with a hint and a solution that runs, chapters/solutions/${stem}_1.frag and so on, as in
the pages before.

## Sources

- Where it comes from.
END
printf '\n%s  -\n' "$stem" >>tests/images.txt

printf '%s\n' "chapters/$stem.c, chapters/$stem.frag, docs/$stem.md: written; tests/images.txt: its picture" \
    "next: make docs references; make run CHAPTER=$number; docs/contributing.md says the rest"
