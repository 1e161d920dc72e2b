// Solution to exercise 21.1: Fresnel's formula for water, instead of Schlick's.
//
// The chapter's call to schlickShare becomes a call to waterShare.
#include "main.glsl"
#include "fresnel.glsl"

float waterShare(float facing, float straight)
{
    return fresnelShare(facing, 1.0 / 1.333);
}

#define schlickShare waterShare
#include "21_a_landscape.frag"
