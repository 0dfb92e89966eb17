#include "document/permalink.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "options/option.h"

namespace ps::permalink_test {
namespace {

/// A value that the option's slider or list could give, with all digits for real numbers.
double any_value(const Option& option) {
  switch (option.kind) {
  case OptionKind::boolean:
    return *rc::gen::inRange(0, 2);
  case OptionKind::integer:
  case OptionKind::choice:
    return *rc::gen::inRange(static_cast<int>(option.minimum), static_cast<int>(option.maximum) + 1);
  case OptionKind::real:
    return option.minimum + (option.maximum - option.minimum) * (*rc::gen::inRange(0, 1'000'003) / 1'000'003.0);
  }
  return 0;
}

Settings any_settings() {
  Settings settings;
  for (const Option& option : option_table())
    if (*rc::gen::arbitrary<bool>()) option.set(settings, any_value(option));
  return settings;
}

double any_share() { return *rc::gen::inRange(0, 999'983) / 999'983.0; }

/// A coordinate of any size, with digits to the last bit.
double any_coordinate() { return *rc::gen::inRange(-1'000'000'000, 1'000'000'000) / 7919.0; }

Vec3d any_vector() { return {any_coordinate(), any_coordinate(), any_coordinate()}; }

StoryView any_story_view() {
  StoryView view;
  view.outside.preset = static_cast<SpacePreset>(*rc::gen::inRange(0, 4));
  if (*rc::gen::arbitrary<bool>())
    view.outside.orbit = SpaceOrbit{any_vector(), any_coordinate(), any_coordinate(), 0.01 + any_share()};
  // Through the camera there is no preset to speak of.
  view.outside.through_camera = view.outside.preset == SpacePreset::outside && *rc::gen::arbitrary<bool>();
  view.outside.switched = *rc::gen::arbitrary<std::string>();
  view.outside.least_contribution = any_share();
  view.outside.deepest_level = any_share() * 20;
  view.until_event = *rc::gen::arbitrary<bool>();
  view.listing_instance = *rc::gen::inRange(-1, 5000);
  if (*rc::gen::arbitrary<bool>()) view.sample = Vec2d(any_coordinate(), any_coordinate());
  view.micro_triangle = *rc::gen::inRange(-1, 500);
  if (*rc::gen::arbitrary<bool>()) view.vertex = VertexId{*rc::gen::inRange(0, 99), *rc::gen::inRange(0, 9999)};
  if (*rc::gen::arbitrary<bool>()) view.vertex_edits.order = ModelOrder::move_then_turn;
  if (*rc::gen::arbitrary<bool>()) view.vertex_edits.near = any_coordinate();
  return view;
}

/// A view of the scene from anywhere.
Camera any_camera() {
  return {any_vector(), any_vector(), any_vector(), any_vector(), 1 + any_share(), 1, 0.1 + any_share()};
}

std::vector<SceneEdit> any_edits() {
  std::vector<SceneEdit> edits(*rc::gen::inRange<std::size_t>(0, 4));
  for (SceneEdit& edit : edits) edit = {*rc::gen::arbitrary<std::string>(), *rc::gen::arbitrary<std::string>()};
  return edits;
}

Pin any_pin() {
  Pin pin{
      {*rc::gen::inRange(0, 9999), *rc::gen::inRange(0, 9999)}, any_settings(), any_settings(), any_edits(), {}, 0, 0};
  if (*rc::gen::arbitrary<bool>()) pin.camera = any_camera();
  if (*rc::gen::arbitrary<bool>()) {
    pin.width = *rc::gen::inRange(1, 16384);
    pin.height = *rc::gen::inRange(1, 16384);
  }
  return pin;
}

Document any_document() {
  Document d;
  d.scene_name = *rc::gen::arbitrary<std::string>();
  d.edits = any_edits();
  if (*rc::gen::arbitrary<bool>()) d.view.camera = any_camera();
  if (*rc::gen::arbitrary<bool>()) {
    d.view.width = *rc::gen::inRange(1, 16384);
    d.view.height = *rc::gen::inRange(1, 16384);
  }
  d.view.zoom = any_share() * 64;
  d.view.middle = {any_share(), any_share()};
  if (*rc::gen::arbitrary<bool>()) {
    const Vec2i corner{*rc::gen::inRange(0, 9999), *rc::gen::inRange(0, 9999)};
    d.view.region = TileRect{corner.x, corner.y, corner.x + *rc::gen::inRange(1, 999), corner.y + 1};
  }
  d.picture_b = *rc::gen::arbitrary<std::string>();
  d.a.settings = any_settings();
  d.b.settings = any_settings();
  const int channels = static_cast<int>(shown_channels().size());
  d.a.show = static_cast<ShownChannel>(*rc::gen::inRange(0, channels));
  d.b.show = static_cast<ShownChannel>(*rc::gen::inRange(0, channels));
  if (*rc::gen::arbitrary<bool>()) d.pixel = {*rc::gen::inRange(0, 9999), *rc::gen::inRange(0, 9999)};
  d.picked = *rc::gen::element(Side::a, Side::b);
  d.events = {*rc::gen::inRange(-1, 5000), *rc::gen::inRange(-1, 5000)};
  d.story = any_story_view();
  if (*rc::gen::arbitrary<bool>()) d.pin = any_pin();
  d.mode = *rc::gen::element(ScreenMode::lesson, ScreenMode::explore, ScreenMode::study, ScreenMode::presenter);
  d.layout.story_open = *rc::gen::arbitrary<bool>();
  d.layout.options_open = *rc::gen::arbitrary<bool>();
  d.layout.stage = *rc::gen::element(std::string(), std::string("space"), std::string("chart"));
  d.layout.filled = *rc::gen::element(std::string(), std::string("left"), std::string("right"), std::string("bottom"));
  d.compare = static_cast<CompareMode>(*rc::gen::inRange(0, 5));
  d.split = any_share();
  if (any_share() < 0.5) d.heat_range = HeatRange{ShownChannel::depth, {any_share(), 1 + any_share() * 50}};
  d.difference_gain = any_share() * 100;
  d.layout.left = any_share();
  d.layout.bottom = any_share();
  d.layout.panels = *rc::gen::arbitrary<bool>();
  d.layout.right_tab = *rc::gen::arbitrary<std::string>();
  d.layout.sweep = *rc::gen::arbitrary<std::string>();
  d.layout.experiment = *rc::gen::arbitrary<std::string>();
  d.lesson = *rc::gen::arbitrary<std::string>();
  d.step = *rc::gen::inRange(0, 100);
  return d;
}

RC_GTEST_PROP(Permalink, RoundTripKeepsEverything, ()) {
  const Document document = any_document();
  const std::string text = permalink(document);
  const Document read = parse_permalink(text);
  RC_ASSERT(read == document);
  RC_ASSERT(permalink(read) == text);
  for (const char c : text) RC_ASSERT(c > ' ' && c < 127);
}

}  // namespace
}  // namespace ps::permalink_test
