// A choice that does nothing anywhere is a lie in the panel: any two choices of an option, and the ends of its range,
// must differ in a picture or a counter of a scene that its row names. Those that have one result by design are listed
// with the reason, and have it in the scenes of all rows.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "hwy/targets.h"
#include "options/listing.h"
#include "options/option.h"
#include "options/renderer_kind.h"
#include "options/simd_choice.h"
#include "render/fast_path.h"
#include "support/emulated.h"
#include "support/option_contexts.h"

namespace ps::every_option_acts_test {
namespace {

using test::AlikeValues;

constexpr int width = 96, height = 72;

/// Values of a number in place of its largest, and why.
struct InPlaceOfMaximum {
  std::string_view option;
  OptionNumber value;
  std::string_view reason;
};
const InPlaceOfMaximum in_place_of_maximum[] = {
    {"samples-per-pixel", 16, "4096 rays a pixel take seconds"},
    {"shadow-samples", 16, "256 rays to a lamp take seconds"},
    {"shadow-map-size", 1024, "six maps of 4096 x 4096 texels take 400 MB"},
    {"stencil-bits", 4, "more than 8 bits need 256 shadows over each other"},
    {"volume-length", 1, "volumes of a million units reach as far as those without an end"},
};

/// All choices; of a number the smallest value, the default and the largest.
std::vector<OptionNumber> tried_values(const Option& option) {
  std::vector<OptionNumber> values = test::values_of(option);
  if (option.kind == OptionKind::boolean || option.kind == OptionKind::choice) return values;
  for (const InPlaceOfMaximum& other : in_place_of_maximum)
    if (other.option == option.key) values.back() = other.value;
  values.push_back(option.default_value());
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::string value_text(const Option& option, OptionNumber value) {
  if (option.kind == OptionKind::choice) return std::string(option.choices.at(static_cast<std::size_t>(value)).key);
  return fmt::format("{}", value);
}

/// Values with one result by design.
struct SameByDesign {
  std::string_view option;
  std::vector<std::string> values;
  std::string_view reason;
};

/// Choices of `simd` that run the same instructions on this processor, and those that count the same nodes and tests.
std::vector<SameByDesign> same_simd() {
  std::vector<std::string> scalar{"off"}, four, wide;
  for (const auto& [key, setting] :
       {std::pair{"auto", Simd::automatic}, {"sse4", Simd::sse4}, {"avx2", Simd::avx2}, {"avx512", Simd::avx512}}) {
    const std::int64_t have = HWY_ARCH_X86 ? processor_targets() : 0;
    if (may_use(setting, Simd::avx512, have, HWY_AVX3) || may_use(setting, Simd::avx2, have, HWY_AVX2))
      wide.push_back(key);
    else if (may_use(setting, Simd::sse4, have, HWY_SSE4))
      four.push_back(key);
    else
      scalar.push_back(key);
  }
  std::vector<SameByDesign> same{{"simd", scalar, "this processor has nothing wider: all take the clear path"},
                                 {"simd", four, "this processor has nothing wider than SSE4"},
                                 {"simd", wide, "8 and 16 lanes walk the same tree: only time differs"}};
  if (wide.empty() && four.empty())
    same.push_back({"cache-constants", {"0", "1"}, "only the fast path keeps what depends on the ray alone"});
  return same;
}

std::vector<SameByDesign> same_by_design() {
  std::vector<SameByDesign> same = same_simd();
  same.push_back({"threads", {"0", "256"}, "only time differs: pictures and counts never depend on threads"});
  for (const Option& option : option_table()) {
    if (!test::lacks_its_renderer(option)) continue;
    SameByDesign all{option.key, {}, "there is no OpenGL here"};
    for (const OptionNumber value : tried_values(option)) all.values.push_back(value_text(option, value));
    same.push_back(all);
  }
  for (const RendererKind& kind : renderer_kinds())
    if (!test::has_renderer(kind.key))
      for (const RendererKind& other : renderer_kinds())
        same.push_back({"renderer", {std::string(kind.key), std::string(other.key)}, "there is no OpenGL here"});
  same.push_back({"coverage",
                  {"edge-function", "bounding-box"},
                  "both test every sample of the box in exact integers, by edge functions or by a ray"});
  for (const ListingBug& bug : listing_bugs())
    for (const ListingBug& other : listing_bugs())
      if (bug.folder != other.folder)
        same.push_back({"listing-bug", {bug.key, other.key}, "no two listings run at the same time"});
  return same;
}

using Pair = std::pair<std::string, std::string>;

std::set<Pair> pairs_by_design(const Option& option) {
  std::set<Pair> pairs;
  for (const SameByDesign& same : same_by_design()) {
    if (same.option != option.key) continue;
    for (const OptionNumber first : tried_values(option))
      for (const OptionNumber second : tried_values(option)) {
        const auto lists = [&](OptionNumber value) {
          return std::find(same.values.begin(), same.values.end(), value_text(option, value)) != same.values.end();
        };
        if (first < second && lists(first) && lists(second))
          pairs.insert({value_text(option, first), value_text(option, second)});
      }
  }
  return pairs;
}

std::set<Pair> alike_pairs(test::OptionResponses& responses, const Option& option,
                           const std::vector<std::size_t>& contexts) {
  std::set<Pair> pairs;
  for (const AlikeValues& alike : responses.alike(option, tried_values(option), contexts))
    pairs.insert({value_text(option, alike.first), value_text(option, alike.second)});
  return pairs;
}

std::set<Pair> alike_pairs(test::OptionResponses& responses, const Option& option) {
  return alike_pairs(responses, option, test::contexts_of(option));
}

/// Graphics cards may round vertices as exactly as the processor does, and then nothing differs; llvmpipe does not.
bool may_be_the_same(const Option& option) {
  if (option.key != "vertex-snapping" || !test::has_renderer("hardware")) return false;
  Settings settings;
  parse_assignment("renderer=hardware", settings);
  return !fast_path(settings, {}, Channel::none).reason.starts_with("llvmpipe");
}

TEST(Options, AnyTwoChoicesDifferInAPictureOrACounterSomewhere) {
  test::OptionResponses responses(width, height);
  for (std::size_t i = 0; i < option_table().size(); i += test::trial_step()) {
    const Option& option = option_table()[i];
    if (may_be_the_same(option)) continue;
    const std::set<Pair> alike = alike_pairs(responses, option), by_design = pairs_by_design(option);
    for (const Pair& pair : alike)
      EXPECT_TRUE(by_design.contains(pair)) << option.key << ": " << pair.first << " and " << pair.second
                                            << " have the same result in every scene of its row";
    if (by_design.empty()) continue;
    std::vector<std::size_t> all(test::option_contexts().size());
    std::iota(all.begin(), all.end(), 0);
    const std::set<Pair> everywhere = alike_pairs(responses, option, all);
    for (const Pair& pair : by_design)
      EXPECT_TRUE(everywhere.contains(pair))
          << option.key << ": " << pair.first << " and " << pair.second << " are listed as the same, but differ";
  }
}

/// What stands in the tables must be about options and values that there are.
TEST(Options, TablesOfThisTestNameOptionsAndValues) {
  for (const InPlaceOfMaximum& other : in_place_of_maximum) {
    const Option* option = find_option(other.option);
    ASSERT_NE(option, nullptr) << other.option;
    EXPECT_TRUE(other.value >= option->minimum && other.value < option->maximum) << other.option;
  }
  for (const SameByDesign& same : same_by_design()) {
    const Option* option = find_option(same.option);
    ASSERT_NE(option, nullptr) << same.option;
    std::set<std::string> values;
    for (const OptionNumber value : tried_values(*option)) values.insert(value_text(*option, value));
    for (const std::string& value : same.values) EXPECT_TRUE(values.contains(value)) << same.option << " " << value;
  }
}

// The test of the test: options as someone might break them.

TEST(Options, AChoiceThatDoesNothingIsFound) {
  Option option = *find_option("visibility");
  option.set = [](Settings& settings, OptionNumber value) {
    const auto chosen = static_cast<Visibility>(static_cast<int>(value));
    settings.visibility = chosen == Visibility::painter ? Visibility::draw_order : chosen;
  };
  test::OptionResponses responses(width, height);
  EXPECT_EQ(alike_pairs(responses, option), (std::set<Pair>{{"painter", "draw-order"}}));
}

TEST(Options, AToggleAndANumberThatDoNothingAreFound) {
  test::OptionResponses responses(width, height);
  Option toggle = *find_option("specular");
  toggle.set = [](Settings&, OptionNumber) {};
  EXPECT_EQ(alike_pairs(responses, toggle), (std::set<Pair>{{"0", "1"}}));
  Option number = *find_option("multisampling");
  number.set = [](Settings&, OptionNumber) {};
  EXPECT_EQ(alike_pairs(responses, number), (std::set<Pair>{{"1", "8"}}));
  number.set = [](Settings& settings, OptionNumber value) {
    settings.multisampling = std::min(static_cast<int>(value), 4);
  };
  EXPECT_TRUE(responses.alike(number, {1, 2, 4}, test::contexts_of(number)).empty());
  EXPECT_EQ(responses.alike(number, {1, 4, 8}, test::contexts_of(number)).size(), 1u) << "4 and 8";
}

/// A reason not to act in any context is not an excuse.
TEST(Options, AChoiceThatIsInactiveEverywhereIsFound) {
  Option option = *find_option("highlight");
  option.choices.back().inactive = [](const Settings&, const SceneTraits&) -> std::optional<IdleReason> {
    return "never";
  };
  test::OptionResponses responses(width, height);
  EXPECT_EQ(alike_pairs(responses, option), (std::set<Pair>{{"phong", "blinn-phong"}}));
}

}  // namespace
}  // namespace ps::every_option_acts_test
