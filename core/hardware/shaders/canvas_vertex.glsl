// Places a vertex of a shape on the canvas (CGFS ch. 6 and 7).
layout(location = 0) in vec2 canvas_place;   // pixels from the top left
layout(location = 1) in vec3 canvas_colour;

uniform vec2 canvas_size;  // pixels

CARRIED vec3 shape_colour;

void main() {
  gl_Position = vec4(2.0 * canvas_place / canvas_size - 1.0, 0.0, 1.0);
  shape_colour = canvas_colour;
}
