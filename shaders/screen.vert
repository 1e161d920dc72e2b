// screen.vert - one triangle that covers the whole screen, so that the fragment shader runs once
// for every pixel.
//
// Its corners are (-1, -1), (3, -1) and (-1, 3): the square from -1 to 1 lies inside. No vertex
// buffer is needed; the number of the vertex says which corner it is.
//
// The outputs are for whole files, shaders with a main of their own. They carry the names of the
// report's engine. The course's own shaders read inputs.glsl instead.

uniform vec3  iResolution;
uniform vec2  iPixelJitter;
uniform float iTime;
uniform vec3  iCameraPosition;
uniform vec3  iCameraRight;
uniform vec3  iCameraUp;
uniform vec3  iCameraForward;
uniform float focalLength;
uniform float iOrthoView; // what Tab drives in a window where the shader is a whole file

out vec2  FragCoord;      // the screen position: y from -1 to 1, x from -aspect to aspect
out float Time;           // seconds
out vec3  Ex, Ey, Ez;     // right, up and forward of the camera
out vec3  CamPos;         // position of the camera
out float fovValue;       // focal length
out float FacteurLargeur; // width divided by height
out float OrthoView;      // 0 perspective, 1 orthographic, between them while one becomes the other
out float CustomToggle;   // always 0 here
out float CustomInt;      // always 0 here

void main()
{
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);

    FacteurLargeur = iResolution.x / iResolution.y;
    FragCoord = corner * vec2(FacteurLargeur, 1.0) + 2.0 * iPixelJitter / iResolution.y;
    Time = iTime;
    Ex = iCameraRight;
    Ey = iCameraUp;
    Ez = iCameraForward;
    CamPos = iCameraPosition;
    fovValue = focalLength;
    OrthoView = iOrthoView;
    CustomToggle = 0.0;
    CustomInt = 0.0;
}
