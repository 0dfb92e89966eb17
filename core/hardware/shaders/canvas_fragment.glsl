// A fragment of a shape on the canvas; how it is mixed with what is there, blending decides.
CARRIED vec3 shape_colour;

layout(location = 0) out vec4 fragment_colour;

void main() {
  fragment_colour = vec4(shape_colour, 1.0);
}
