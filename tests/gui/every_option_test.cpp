// Every row of the option table, set by its real control in the real window: the picture becomes exactly what the
// renderers make of that value without a window, and undo brings back identical bits.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>

#include "gui/program.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/golden.h"
#include "support/option_contexts.h"

namespace ps::every_option_test {
namespace {

using test::Outcome;

constexpr int width = 160, height = 120;

/// 64-bit FNV-1a over red, green and blue of all pixels, as the window publishes it.
std::string hash(const Image<Rgb8>& picture) {
  std::uint64_t value = 0xcbf29ce484222325;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      for (const int level : {picture.at(x, y).r, picture.at(x, y).g, picture.at(x, y).b})
        value = (value ^ static_cast<std::uint64_t>(level)) * 0x100000001b3;
  return fmt::format("{:016x}", value);
}

/// The commands that give an option a value as a hand would.
std::string use_control(const Option& option, const std::string& value) {
  switch (option.kind) {
  case OptionKind::boolean:
    return fmt::format("click options/a/{}\n", option.key);
  case OptionKind::choice:
    return fmt::format("choose options/a/{} {}\n", option.key, value);
  case OptionKind::integer:
  case OptionKind::real:
    return fmt::format("click options/a/{} ctrl\ntype {}\nkey Enter\n", option.key, value);
  }
  return {};
}

/// What the window must say about picture A.
std::string expectations(const Outcome& outcome) {
  std::string text = fmt::format("expect a/picture {}\n", hash(outcome.picture));
  for (std::size_t i = 0; i < counter_count; ++i) {
    const auto counter = static_cast<Counter>(i);
    const auto count = outcome.counters.get(counter);
    text += fmt::format("expect a/counter/{} {}\n", counter_key(counter), count ? std::to_string(*count) : "none");
  }
  return text;
}

/// Sets it, looks, and takes it back.
std::string try_option(const Option& option, const std::string& value, const std::string& old_value,
                       const Outcome& before, const Outcome& after) {
  return use_control(option, value) + "wait idle\n" + fmt::format("expect a/option/{} {}\n", option.key, value) +
         expectations(after) + "key Ctrl+Z\nwait idle\n" +
         fmt::format("expect a/option/{} {}\n", option.key, old_value) + expectations(before);
}

// One test for all: what each option changes is found once, which takes as long as two windows.
TEST(EveryOption, ActsThroughItsControlAndIsUndone) {
  const auto& contexts = test::option_contexts();
  std::vector<std::string> sessions(contexts.size());
  test::OptionResponses responses(width, height);
  for (const Option& option : option_table()) {
    const auto response = responses.find(option);
    if (!response) {  // only time changes: whatever its value, the picture and the counters are the same
      if (test::lacks_its_renderer(option)) continue;
      const bool speed = option.key == "threads" || option.key == "simd" || option.key == "cache-constants";
      ASSERT_TRUE(speed) << option.key << " responds nowhere";
      const Outcome same = responses.unchanged(0);
      const std::string value = option.key == "threads" ? "2" : "off";
      sessions[0] += try_option(option, value, option_text(option, responses.settings(0)), same, same);
      continue;
    }
    sessions[response->context] +=
        try_option(option, response->value, option_text(option, responses.settings(response->context)),
                   response->before, response->after);
  }
  for (std::size_t i = 0; i < contexts.size(); ++i) {
    if (sessions[i].empty()) continue;
    std::string arguments = fmt::format("{} --size {}x{}", contexts[i].scene, width, height);
    for (const auto& assignment : contexts[i].assignments) arguments += " --set " + assignment;
    const auto folder = fresh_output_folder(fmt::format("gui-every-option-{}", i));
    const auto result = test::play("draw off\nwait idle\n" + sessions[i], folder, "1024x768", arguments);
    EXPECT_EQ(result.status, 0) << arguments << '\n' << result.errors;
    EXPECT_EQ(result.errors, "");
  }
}

}  // namespace
}  // namespace ps::every_option_test
