// inputs.glsl - the inputs that the harness passes to a shader for each picture, and the position of a pixel.
//
// The names are those of Shadertoy where Shadertoy has the same input.

uniform vec3  iResolution;     // size of the picture in pixels (x, y), and 1
uniform float iTime;           // time of the picture, seconds
uniform float iTimeDelta;      // time since the previous picture, seconds
uniform int   iFrame;          // index of the picture, from zero
uniform vec4  iMouse;          // the mouse, in pixels: last position with a button held, and position of the press
uniform vec4  iDate;           // year, month from zero, day, seconds since midnight
uniform vec3  iCameraPosition; // the eye, scene units
uniform vec3  iCameraRight;    // the camera's orthonormal basis:
uniform vec3  iCameraUp;       //   right x up = -forward
uniform vec3  iCameraForward;  //
uniform vec2  iPixelOffset;    // offset from a pixel of this draw call to a sample's position in the picture
uniform int   iSample;         // index of this sample in its pixel, from zero
uniform int   iSamples;        // samples per pixel: the square of --samples

// The pixel of the picture that this ray belongs to, (0, 0) at the bottom left. It is the same for all samples
// of the pixel, in every tile. main sets iPixel.
ivec2 iPixel = ivec2(0);

// The position of a point of the picture on the screen: y from -1 (bottom) to 1 (top), x from -aspect
// to aspect, in the same unit on both axes.
//   pixel    in pixels; (0, 0) is the bottom left corner of the picture, and pixel centres are at .5
//   formula  (2 pixel - resolution) / resolution.y
vec2 screenPosition(vec2 pixel)
{
    return (2.0 * pixel - iResolution.xy) / iResolution.y;
}
