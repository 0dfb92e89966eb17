// In the real window: every scene that Pixelscope ships with opens, and every option can be set and taken back.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "gui/program.h"
#include "options/option.h"
#include "scene/load.h"
#include "support/golden.h"

namespace {

TEST(Window, OpensEveryBuiltinScene) {
  std::string script;
  for (const auto& scene : ps::builtin_scenes())
    script += fmt::format(
        "open {0}\nwait idle\nexpect scene {0}\nexpect a/state done\nexpect b/state done\nexpect messages 0\n",
        scene.name);
  const auto result = ps::test::play(script + "quit\n", ps::fresh_output_folder("gui-every-scene"), "1024x768");
  EXPECT_EQ(result.status, 0) << result.errors;
}

/// A value that the option does not have by default.
std::string other_value(const ps::Option& option) {
  ps::Settings settings;
  const double now = option.default_value();
  switch (option.kind) {
  case ps::OptionKind::boolean:
  case ps::OptionKind::choice:
    option.set(settings, now == 0 ? 1 : 0);
    break;
  case ps::OptionKind::integer:
  case ps::OptionKind::real:
    option.set(settings, now == option.minimum ? option.maximum : option.minimum);
    break;
  }
  return ps::option_text(option, settings);
}

TEST(Window, SetsEveryOptionAndUndoRestoresTheSameBits) {
  std::string script = "wait idle\nkeep a/picture FIRST\n";
  for (const auto& option : ps::option_table()) {
    const std::string value = other_value(option);
    script += fmt::format("set {0}={1}\nwait idle\nexpect a/option/{0} {1}\nexpect a/state done\n", option.key, value);
    script +=
        fmt::format("key Ctrl+Z\nwait idle\nexpect-not a/option/{} {}\nexpect a/picture $FIRST\n", option.key, value);
  }
  const auto result = ps::test::play(script + "quit\n", ps::fresh_output_folder("gui-every-option"), "1024x768",
                                     "cgfs/reflections --size 120x90");
  EXPECT_EQ(result.status, 0) << result.errors;
}

}  // namespace
