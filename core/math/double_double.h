#pragma once

namespace ps {

/// A number kept as the unevaluated sum of two doubles, about 106 bits. Built from additions and products alone, so
/// that the bits do not depend on whether the processor has a fused multiply-add.
struct DoubleDouble {
  double high = 0, low = 0;
};

/// a + b without error (Knuth).
inline DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// a * b without error (Dekker, with Veltkamp's split); |a| and |b| below 2^995.
inline DoubleDouble exact_product(double a, double b) {
  constexpr double splitter = 134217729.0;  // 2^27 + 1
  const double scaled_a = splitter * a;
  const double scaled_b = splitter * b;
  const double a_high = scaled_a - (scaled_a - a);
  const double b_high = scaled_b - (scaled_b - b);
  const double a_low = a - a_high;
  const double b_low = b - b_high;
  const double product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble sum = exact_sum(a.high, b.high);
  return exact_sum(sum.high, sum.low + (a.low + b.low));
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = exact_product(a.high, b.high);
  return exact_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

}  // namespace ps
