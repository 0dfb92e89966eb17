// x to the power y for x > 0. A driver's own pow() may be off by more than a level of 255 for exponents in the hundreds.
// As in core/math/power.h: log2 as a series that loses nothing where x is near 1.
float log2_of(float x) {
  int bits = floatBitsToInt(x);
  int exponent = (bits - 0x3f3504f3) >> 23;
  float mantissa = intBitsToFloat(bits - (exponent << 23));  // from sqrt(1/2) to sqrt(2)
  float s = (mantissa - 1.0) / (mantissa + 1.0);
  float z = s * s;
  float series = 1.0 / 11.0;
  series = series * z + 1.0 / 9.0;
  series = series * z + 1.0 / 7.0;
  series = series * z + 1.0 / 5.0;
  series = series * z + 1.0 / 3.0;
  series = series * z + 1.0;
  return float(exponent) + s * series * 2.88539008177792681;
}

float power(float x, float y) {
  if (y == 0.0 || x == 1.0) return 1.0;
  float p = clamp(y * log2_of(x), -120.0, 120.0);
  float n = floor(p + 0.5);
  float r = (p - n) * 0.69314718055994531;
  float e = 1.0 / 5040.0;
  e = e * r + 1.0 / 720.0;
  e = e * r + 1.0 / 120.0;
  e = e * r + 1.0 / 24.0;
  e = e * r + 1.0 / 6.0;
  e = e * r + 0.5;
  e = e * r + 1.0;
  e = e * r + 1.0;
  return e * intBitsToFloat((int(n) + 127) << 23);
}
