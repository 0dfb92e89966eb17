#include "record/value_text.h"

#include <fmt/format.h>

#include <algorithm>
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

std::vector<std::string> number_row(std::span<const double> values) {
  constexpr double smallest = 1e-4, beyond = 1e7;  // what is read at a glance without an exponent
  const bool plain = std::all_of(values.begin(), values.end(), [](double value) {
    return !std::isfinite(value) || value == 0 || (std::abs(value) >= smallest && std::abs(value) < beyond);
  });
  std::vector<std::string> texts;
  for (const double value : values) {
    if (!std::isfinite(value)) {
      texts.push_back(special_text(value));
    } else if (value == 0) {
      texts.emplace_back("0");
    } else if (!plain) {
      texts.push_back(fmt::format("{:.3e}", value));
    } else {
      const int before = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
      std::string text = fmt::format("{:.{}f}", value, std::clamp(4 - before, 0, 7));
      if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
      }
      texts.push_back(std::move(text));
    }
  }
  return texts;
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
