// The colours and the exponent with which a material answers light.
uniform float exponent;        // of the highlight; below 0: it has none
uniform vec4 specular_colour;  // w = 1: the highlight has this colour, 0: that of the surface
uniform vec4 ambient_colour;   // the same of ambient light

struct Tints {
  vec4 specular, ambient;  // as the uniforms, after maps of light have changed them
  float exponent;
};
