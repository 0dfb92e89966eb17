// Lengths and directions of vectors, also where their squares leave the range of float: core/math/unit.h.

// The power of two that brings a vector with this square near enough to 1 to be squared.
float factor_for_square(float square) {
  const float up = 1.2676506002282294e30;  // 2^100
  const float down = 7.8886090522101181e-31;
  return square > down && square < up ? 1.0 : square < 1.0 ? up : down;
}

float length_of(vec3 v) {
  float factor = factor_for_square(dot(v, v));
  return length(v * factor) / factor;
}

vec3 unit_of(vec3 v) {
  vec3 near_one = v * factor_for_square(dot(v, v));
  return near_one / length(near_one);
}

// The same as drivers compute it by themselves: the last bits differ.
vec3 normalised(vec3 v) {
  return normalize(v * factor_for_square(dot(v, v)));
}

vec3 unit_or_zero(vec3 v) {
  return length_of(v) > 0.0 ? unit_of(v) : vec3(0.0);
}
