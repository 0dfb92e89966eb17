#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <type_traits>

#include "base/check.h"
#include "base/enumerators.h"
#include "base/machine.h"
#include "options/option.h"
#include "options/rows.h"
#include "raytrace/base/embree_triangles.h"
#include "support/settings_with.h"

namespace ps::options_test {
namespace {

enum class Fruit { apple, pear, plum };
static_assert(enumerator_count<Fruit>() == 3 && enumerator_count<TriangleTest>() == triangle_test_rows.size());

bool kebab_case(std::string_view key) {
  if (key.empty() || !std::islower(static_cast<unsigned char>(key.front())) || key.back() == '-') return false;
  for (const char c : key)
    if (c != '-' && !std::islower(static_cast<unsigned char>(c)) && !std::isdigit(static_cast<unsigned char>(c)))
      return false;
  return key.find("--") == std::string_view::npos;
}

/// Values worth trying: the ends of the range, the default, and some between.
std::vector<double> values_of(const Option& option) {
  std::vector<double> values;
  switch (option.kind) {
  case OptionKind::boolean:
    return {0, 1};
  case OptionKind::choice:
    for (std::size_t i = 0; i < option.choices.size(); ++i) values.push_back(static_cast<double>(i));
    return values;
  case OptionKind::integer:
    for (double v = option.minimum; v <= option.maximum; ++v) values.push_back(v);
    return values;
  case OptionKind::real:
    for (int i = 0; i <= 7; ++i) values.push_back(option.minimum + (option.maximum - option.minimum) * (i / 7.0));
    values.push_back(option.default_value());
    return values;
  }
  return values;
}

TEST(OptionTable, KeysAndLabelsAreUniqueAndWellFormed) {
  std::set<std::string_view> keys;
  std::set<std::pair<std::string_view, std::string_view>> labels;
  for (const Option& option : option_table()) {
    EXPECT_TRUE(keys.insert(option.key).second) << option.key;
    EXPECT_TRUE(labels.insert({option.group, option.label}).second) << option.label;
    EXPECT_TRUE(kebab_case(option.key)) << option.key;
    EXPECT_FALSE(option.label.empty()) << option.key;
    EXPECT_FALSE(option.group.empty()) << option.key;
    EXPECT_EQ(find_option(option.key), &option);
  }
  EXPECT_EQ(find_option("no-such-option"), nullptr);
}

TEST(OptionTable, EveryRowIsExplained) {
  for (const Option& option : option_table()) {
    EXPECT_FALSE(option.help.what.empty()) << option.key;
    EXPECT_FALSE(option.help.source.empty()) << option.key;
    std::set<std::string_view> keys;
    for (const Choice& choice : option.choices) {
      EXPECT_TRUE(keys.insert(choice.key).second) << option.key;
      EXPECT_TRUE(kebab_case(choice.key) || std::isdigit(static_cast<unsigned char>(choice.key.front()))) << choice.key;
      EXPECT_FALSE(choice.label.empty()) << choice.key;
      EXPECT_FALSE(choice.help.empty()) << option.key << " " << choice.key;
    }
  }
}

TEST(OptionTable, OnlyChoicesHaveThem) {
  for (const Option& option : option_table())
    EXPECT_EQ(option.choices.empty(), option.kind != OptionKind::choice) << option.key;
}

TEST(OptionTableDeathTest, ARowWithoutAChoiceForEachEnumeratorEndsTheProgram) {
  const OptionFacts& facts = *find_option("fill-rule");
  const std::vector<Choice> two{{"top-left", "top-left", ""}, {"inclusive", "inclusive", ""}};
  EXPECT_DEATH(rows::choice<&Settings::fill_rule>(facts, two), "choices of fill-rule");
}

TEST(OptionTable, DefaultsLieInRange) {
  for (const Option& option : option_table()) {
    if (option.kind == OptionKind::boolean) continue;
    EXPECT_GE(option.default_value(), option.minimum) << option.key;
    EXPECT_LE(option.default_value(), option.maximum) << option.key;
    EXPECT_LT(option.minimum, option.maximum) << option.key;
  }
}

TEST(OptionTable, TextKeepsEveryValue) {
  for (const Option& option : option_table())
    for (const double value : values_of(option)) {
      Settings settings;
      option.set(settings, value);
      EXPECT_EQ(option.get(settings), value) << option.key;
      Settings read;
      parse_option(option, option_text(option, settings), read);
      EXPECT_EQ(read, settings) << option.key << " = " << option_text(option, settings);
    }
}

/// A row whose setter writes another row's member would pass every other test.
TEST(OptionTable, EachRowMovesItsOwnMemberAlone) {
  for (const Option& option : option_table())
    for (const double value : values_of(option)) {
      Settings settings;
      option.set(settings, value);
      for (const Option& other : option_table()) {
        if (&other != &option) {
          EXPECT_EQ(other.get(settings), other.default_value()) << option.key << " " << other.key;
        }
      }
      EXPECT_EQ(settings == Settings{}, value == option.default_value()) << option.key;
    }
}

TEST(OptionTable, RefusesWhatIsOutOfRange) {
  Settings settings;
  for (const Option& option : option_table()) {
    EXPECT_THROW(parse_option(option, "", settings), InputError) << option.key;
    EXPECT_THROW(parse_option(option, "nonsense", settings), InputError) << option.key;
    if (option.kind == OptionKind::integer || option.kind == OptionKind::real) {
      for (const char* bad : {"nan", "inf", "1e400", "1 ", "0x1", "-1e31"}) {
        EXPECT_THROW(parse_option(option, bad, settings), InputError) << option.key << " " << bad;
      }
    }
    if (option.kind == OptionKind::integer) {
      EXPECT_THROW(parse_option(option, "1.5", settings), InputError) << option.key;
    }
  }
  EXPECT_EQ(settings, Settings{});
}

TEST(OptionTable, AValueThatCannotActSaysWhy) {
  const Option& accelerator = *find_option("accelerator");
  const Option& slab_test = *find_option("slab-test");
  SceneTraits traits;
  traits.triangles = true;
  Settings settings;
  for (const Choice& choice : accelerator.choices)
    EXPECT_FALSE(inactive_choice_reason(accelerator, choice, settings, traits));
  settings.precision = Precision::float64;
  for (const Choice& choice : accelerator.choices)
    EXPECT_EQ(inactive_choice_reason(accelerator, choice, settings, traits).has_value(), choice.key == "embree")
        << choice.key;
  EXPECT_FALSE(inactive_value_reason(accelerator, settings, traits));
  settings.renderer = Renderer::textbook;
  EXPECT_TRUE(inactive_reason(accelerator, settings, traits));
  settings.renderer = Renderer::ray_tracer;
  if (!has_embree()) return;
  settings.accelerator = Accelerator::embree;
  EXPECT_TRUE(inactive_value_reason(accelerator, settings, traits));
  EXPECT_FALSE(inactive_reason(slab_test, settings, traits)) << "the tree of boxes serves";
  settings.precision = Precision::float32;
  EXPECT_FALSE(inactive_value_reason(accelerator, settings, traits));
  EXPECT_TRUE(inactive_reason(slab_test, settings, traits)) << "Embree has boxes of its own";
  traits.spheres = true;
  EXPECT_FALSE(inactive_reason(slab_test, settings, traits)) << "spheres stand in a tree of boxes";
}

TEST(OptionTable, ChangedOptionsRebuildTheSettings) {
  Settings settings;
  settings.reflection_depth = 7;
  settings.self_hit = SelfHit::epsilon;
  settings.gamma = 2.2;
  Settings rebuilt = settings_with({}, changed_options(settings));
  EXPECT_EQ(rebuilt, settings);
  EXPECT_EQ(changed_options(settings).size(), 3u);
  EXPECT_TRUE(changed_options(Settings{}).empty());
}

// A chart of any option needs to know what its errors are measured against, and the settings that it names must exist.
// A row that leaves one of them out does not compile.
static_assert(!std::is_default_constructible_v<FastLimits> && !std::is_default_constructible_v<HardwareUse>);
static_assert(!std::is_default_constructible_v<OptionExperiments> && !std::is_default_constructible_v<SeenScenes>);

TEST(OptionTable, EachSaysWhatTheHardwareRendererDoesIfFragmentsUseIt) {
  for (const Option& option : option_table()) {
    const HardwareUse& use = option.known_to.hardware;
    if (option.acts_for != ActsFor::readers) {
      EXPECT_EQ(use.asked, acts_for(option.acts_for, PictureWay::fragments)) << option.key;
    }
    const bool lacks = use.first_lacked <= use.last_lacked || use.as_driver_offers;
    EXPECT_EQ(use.reason.empty(), !lacks) << option.key;
  }
}

// Two limits of one place would be named in the order of the table's rows, which says nothing of code.
TEST(OptionTable, FastLimitsOfOnePlaceHaveOneReason) {
  std::map<std::pair<FastCode, int>, std::string> reasons;
  for (const Option& option : option_table())
    for (const FastLimit& limit : option.known_to.fast.list) {
      EXPECT_FALSE(limit.reason.empty()) << option.key;
      EXPECT_NE(limit.known.empty(), limit.reached == nullptr) << option.key;
      EXPECT_EQ(reasons.try_emplace({limit.code, limit.place}, limit.reason).first->second, limit.reason) << option.key;
    }
  EXPECT_EQ((reasons.at({FastCode::sphere_packets, 120})), "packets need accelerator = bvh or none");
}

TEST(OptionTable, EachDeclaresItsTruth) {
  for (const Option& option : option_table()) {
    EXPECT_NE(option.truth.kind, TruthKind::undeclared) << option.key;
    std::string_view rest = option.truth.exact;
    EXPECT_TRUE(option.truth.kind != TruthKind::exact || !rest.empty()) << option.key;
    while (!rest.empty()) {
      const std::string_view one = rest.substr(0, rest.find(';'));
      const auto bar = one.find('|');
      Settings settings;
      EXPECT_NO_THROW(parse_assignment(one.substr(0, bar), settings)) << option.key;
      if (bar != std::string_view::npos) {
        const std::string other(one.substr(0, one.find('=') + 1));
        EXPECT_NO_THROW(parse_assignment(other + std::string(one.substr(bar + 1)), settings)) << option.key;
      }
      rest.remove_prefix(std::min(one.size() + 1, rest.size()));
    }
  }
  for (const char* key : {"multisampling", "mip-bias", "anisotropy", "shadow-filter"})
    EXPECT_EQ(find_option(key)->truth.kind, TruthKind::pixel_average) << key;
}

}  // namespace
}  // namespace ps::options_test
