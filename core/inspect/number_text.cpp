#include "inspect/number_text.h"

#include <fmt/format.h>

#include <cmath>

namespace ps {
namespace {

std::string special_text(double value) {
  if (std::isnan(value)) return "NaN";
  return value > 0 ? "infinity" : "-infinity";
}

}  // namespace

std::string number_text(double value) {
  if (!std::isfinite(value)) return special_text(value);
  if (value == 0) return "0";
  return fmt::format("{:.4g}", value);
}

std::string exact_number_text(double value) {
  if (!std::isfinite(value)) return special_text(value);
  return fmt::format("{}", value);
}

std::string against_text(double value, double other) {
  if (value == other) return fmt::format("{:.9g} against the same", value);
  for (int digits = 4; digits < 17 && std::isfinite(value) && std::isfinite(other); ++digits) {
    const std::string text = fmt::format("{:.{}g}", value, digits), stored = fmt::format("{:.{}g}", other, digits);
    if (text != stored) return fmt::format("{} against {}", text, stored);
  }
  return exact_number_text(value) + " against " + exact_number_text(other);
}

std::string vector_text(const Vec2d& value) {
  return fmt::format("({}, {})", number_text(value.x), number_text(value.y));
}

std::string vector_text(const Vec3d& value) {
  return fmt::format("({}, {}, {})", number_text(value.x), number_text(value.y), number_text(value.z));
}

}  // namespace ps
