// screen.vert - one triangle that covers the whole screen, so that the fragment shader runs once
// for every pixel.
//
// Its corners are (-1, -1), (3, -1) and (-1, 3): the square from -1 to 1 lies inside. It needs no vertex
// buffer; the index of the vertex says which corner it is.
//
// The output is for shaders with their own main; its name is taken from the report's engine. The
// course's own shaders use inputs.glsl instead.

uniform vec3 iResolution;
uniform vec2 iPixelJitter;

out vec2 FragCoord; // the screen position: y from -1 to 1, x from -aspect to aspect

void main()
{
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
    FragCoord = corner * vec2(iResolution.x / iResolution.y, 1.0) + 2.0 * iPixelJitter / iResolution.y;
}
