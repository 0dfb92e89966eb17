#include "support/random_settings.h"

namespace ps::test {

double share(std::mt19937& random) { return std::uniform_real_distribution<double>(0, 1)(random); }

int below(std::mt19937& random, int end) { return std::uniform_int_distribution<int>(0, end - 1)(random); }

double random_value(const Option& option, std::mt19937& random) {
  if (option.key == "threads") return below(random, 4);
  if (option.key == "reflection-depth") return below(random, 5);
  if (option.key == "samples-per-pixel") return 1 + below(random, 5);
  if (option.key == "tessellation") return 0.3 + 3 * share(random);
  if (option.key == "shadow-map-size" || option.key == "environment-size") return 8 + below(random, 24);
  if (option.key == "near") return 0.5 + share(random);
  switch (option.kind) {
  case OptionKind::boolean:
    return below(random, 2);
  case OptionKind::choice:
    return below(random, static_cast<int>(option.choices.size()));
  case OptionKind::integer:
    return option.minimum + below(random, static_cast<int>(option.maximum - option.minimum) + 1);
  case OptionKind::real:
    return option.minimum + (option.maximum - option.minimum) * share(random) * share(random) * share(random);
  }
  return 0;
}

std::string changed_settings(const Settings& settings) {
  std::string text;
  for (const std::string& one : changed_options(settings)) text += " " + one;
  return text;
}

}  // namespace ps::test
