#include "render/channel_picture.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "frame/display_frame.h"
#include "image/heat_colour.h"

namespace channel_picture_test {
namespace {

using ps::Image;
using ps::Rgb8;
using ps::ShownChannel;
using ps::Vec3f;

/// Three pixels: nothing, a front face, a back face.
ps::Frame three_pixels() {
  ps::Frame frame;
  frame.colour = Image<Vec3f>(3, 1, Vec3f(0.5f));
  frame.depth = Image<float>(3, 1, std::numeric_limits<float>::infinity());
  frame.normal = Image<Vec3f>(3, 1);
  frame.barycentric = Image<Vec3f>(3, 1);
  frame.uv = Image<ps::Vec2f>(3, 1);
  frame.ids = Image<ps::PixelId>(3, 1);
  frame.facing = Image<float>(3, 1);
  frame.overdraw = Image<std::uint32_t>(3, 1);
  frame.tests = Image<std::uint32_t>(3, 1, 12);
  frame.mip = Image<float>(3, 1, -1);
  frame.shadow = Image<std::uint32_t>(3, 1);
  frame.samples = Image<std::uint32_t>(3, 1, 1);
  frame.direction = Image<Vec3f>(3, 1, Vec3f(0, 0, 1));
  frame.shadow_map = Image<float>(3, 1, -1);
  frame.stencil = Image<std::int32_t>(3, 1);
  frame.environment = Image<Vec3f>(3, 1, Vec3f(-1));
  frame.precision = Image<ps::PrecisionFault>(3, 1, ps::PrecisionFault::none);
  frame.depth_gap = Image<float>(3, 1, std::numeric_limits<float>::infinity());
  frame.field = Image<float>(3, 1, std::numeric_limits<float>::quiet_NaN());
  frame.precision.at(1, 0) = ps::PrecisionFault::missed_hit;
  frame.depth_gap.at(1, 0) = 0.5f;
  frame.depth_gap.at(2, 0) = 4096;
  frame.shadow_map.at(1, 0) = 4;
  frame.shadow_map.at(2, 0) = std::numeric_limits<float>::infinity();
  frame.stencil.at(2, 0) = 3;
  frame.environment.at(1, 0) = {1, 0, 0};
  frame.depth.at(1, 0) = 2;
  frame.depth.at(2, 0) = 6;
  frame.normal.at(1, 0) = {1, 0, 0};
  frame.normal.at(2, 0) = {0, 0, -1};
  frame.barycentric.at(1, 0) = {1, 0, 0};
  frame.uv.at(1, 0) = {1.25f, -0.25f};
  frame.ids.at(1, 0) = {0, 3};
  frame.ids.at(2, 0) = {2, 5};
  frame.facing.at(1, 0) = 1;
  frame.facing.at(2, 0) = -1;
  frame.overdraw.at(2, 0) = 4;
  frame.mip.at(1, 0) = 2.5f;
  frame.shadow.at(2, 0) = 0b110;
  return frame;
}

constexpr Rgb8 black{0, 0, 0};

TEST(ChannelPicture, RowsHaveKeysThatReadBack) {
  std::set<std::string_view> keys;
  for (const auto& row : ps::shown_channels()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_EQ(ps::parse_shown_channel(row.key), row.channel);
    EXPECT_FALSE(row.label.empty());
    EXPECT_EQ(row.help.back(), '.');
  }
  EXPECT_THROW(ps::parse_shown_channel("Depth"), ps::InputError);
  EXPECT_THROW(ps::parse_shown_channel(""), ps::InputError);
}

// With only the channels that a row asks for, every picture has the frame's size, a title and readable values.
TEST(ChannelPicture, NeedsNoMoreThanItsRowSays) {
  for (const auto& row : ps::shown_channels()) {
    ps::Frame frame = three_pixels();
    if (!has(row.needs, ps::Channel::depth)) frame.depth = {};
    if (!has(row.needs, ps::Channel::normal)) frame.normal = {};
    if (!has(row.needs, ps::Channel::barycentric)) frame.barycentric = {};
    if (!has(row.needs, ps::Channel::uv)) frame.uv = {};
    if (!has(row.needs, ps::Channel::ids)) frame.ids = {};
    if (!has(row.needs, ps::Channel::facing)) frame.facing = {};
    if (!has(row.needs, ps::Channel::overdraw)) frame.overdraw = {};
    if (!has(row.needs, ps::Channel::tests)) frame.tests = {};
    if (!has(row.needs, ps::Channel::mip)) frame.mip = {};
    if (!has(row.needs, ps::Channel::shadow)) frame.shadow = {};
    if (!has(row.needs, ps::Channel::shadow_map)) frame.shadow_map = {};
    if (!has(row.needs, ps::Channel::stencil)) frame.stencil = {};
    if (!has(row.needs, ps::Channel::environment)) frame.environment = {};
    if (!has(row.needs, ps::Channel::precision)) frame.precision = {};
    if (!has(row.needs, ps::Channel::depth_gap)) frame.depth_gap = {};
    if (!has(row.needs, ps::Channel::field)) frame.field = {};
    const auto result = ps::channel_picture(frame, row.channel, {});
    EXPECT_EQ(result.levels.width(), 3) << row.key;
    EXPECT_EQ(result.legend.title, row.label);
    EXPECT_TRUE(result.legend.heat || !result.legend.entries.empty() || row.channel == ShownChannel::colour);
    for (int x = 0; x < 3; ++x) EXPECT_NE(ps::channel_value_text(frame, row.channel, {}, {x, 0}), "") << row.key;
    std::visit([](const auto& floats) { EXPECT_EQ(floats.width(), 3); }, ps::channel_floats(frame, row.channel));
  }
}

TEST(ChannelPicture, HeatMapsSpanTheirRange) {
  const auto frame = three_pixels();
  const auto depth = ps::channel_picture(frame, ShownChannel::depth, {});
  EXPECT_TRUE(depth.legend.heat);
  EXPECT_EQ(depth.legend.low, 2);
  EXPECT_EQ(depth.legend.high, 6);
  EXPECT_EQ(depth.legend.unit, "world units");
  EXPECT_EQ(depth.levels.at(0, 0), black);
  EXPECT_EQ(depth.levels.at(1, 0), ps::heat_colour(0));
  EXPECT_EQ(depth.levels.at(2, 0), ps::heat_colour(1));
  const auto shared = ps::channel_picture(frame, ShownChannel::depth, {}, ps::ValueRange{0, 8});
  EXPECT_EQ(shared.legend.high, 8);
  EXPECT_EQ(shared.levels.at(1, 0), ps::heat_colour(0.25));

  const auto overdraw = ps::channel_picture(frame, ShownChannel::overdraw, {});
  EXPECT_EQ(overdraw.legend.low, 0) << "counts start at nothing";
  EXPECT_EQ(overdraw.legend.high, 4);
  EXPECT_EQ(overdraw.levels.at(0, 0), ps::heat_colour(0));
  EXPECT_EQ(overdraw.levels.at(2, 0), ps::heat_colour(1));
  EXPECT_EQ(ps::channel_picture(frame, ShownChannel::mip, {}).levels.at(0, 0), black);
  EXPECT_EQ(ps::channel_picture(frame, ShownChannel::shadow, {}).legend.high, 2);
  EXPECT_EQ(ps::channel_range(frame, ShownChannel::tests), (ps::ValueRange{12, 12}));
  EXPECT_FALSE(ps::channel_range(frame, ShownChannel::normal));
}

TEST(ChannelPicture, DirectionsWeightsAndIdsHaveTheirColours) {
  const auto frame = three_pixels();
  const auto shown = [&](ShownChannel channel, int x) {
    return ps::channel_picture(frame, channel, {}).levels.at(x, 0);
  };
  EXPECT_EQ(shown(ShownChannel::colour, 1), ps::display_at(frame, {}, {1, 0}));
  EXPECT_EQ(shown(ShownChannel::normal, 0), black);
  EXPECT_EQ(shown(ShownChannel::normal, 1), (Rgb8{255, 128, 128}));
  EXPECT_EQ(shown(ShownChannel::normal, 2), (Rgb8{128, 128, 0}));
  EXPECT_EQ(shown(ShownChannel::direction, 0), (Rgb8{128, 128, 255}));
  EXPECT_EQ(shown(ShownChannel::barycentric, 1), (Rgb8{255, 0, 0}));
  EXPECT_EQ(shown(ShownChannel::uv, 1), (Rgb8{64, 191, 0}));
  EXPECT_EQ(shown(ShownChannel::object, 1), ps::id_colour(0));
  EXPECT_EQ(shown(ShownChannel::object, 2), ps::id_colour(2));
  EXPECT_EQ(shown(ShownChannel::object, 0), black);
  EXPECT_NE(shown(ShownChannel::triangle, 1), shown(ShownChannel::triangle, 2));
  EXPECT_EQ(shown(ShownChannel::hit, 0), black);
  EXPECT_EQ(shown(ShownChannel::hit, 1), (Rgb8{255, 255, 255}));
  const Rgb8 front = shown(ShownChannel::facing, 1), back = shown(ShownChannel::facing, 2);
  EXPECT_GT(front.b, front.r);
  EXPECT_GT(back.r, back.b);
}

TEST(ChannelPicture, FaultsStandOutAndAreCounted) {
  const auto frame = three_pixels();
  const auto faults = ps::channel_picture(frame, ShownChannel::precision, {});
  EXPECT_EQ(faults.levels.at(1, 0), ps::precision_fault_colour(ps::PrecisionFault::missed_hit));
  for (const int x : {0, 2}) EXPECT_LE(faults.levels.at(x, 0).r, 85) << "what is right is dimmed";
  ASSERT_EQ(faults.legend.entries.size(), 5u);
  EXPECT_EQ(faults.legend.entries[1].meaning, "missed hit: 1 px");
  EXPECT_EQ(faults.legend.entries[4].meaning, "as in double: 2 px");

  const auto gaps = ps::channel_picture(frame, ShownChannel::depth_gap, {});
  EXPECT_EQ(gaps.levels.at(0, 0), (Rgb8{255, 255, 255})) << "no second surface";
  EXPECT_EQ(gaps.levels.at(1, 0), (Rgb8{220, 30, 30})) << "one depth for both";
  EXPECT_EQ(gaps.levels.at(2, 0), ps::heat_colour(0.5)) << "half of 24 bits";
  EXPECT_EQ(gaps.legend.low, 1);
  EXPECT_EQ(gaps.legend.high, 16777216);
  EXPECT_EQ(gaps.legend.entries[0].meaning, "below 1, the same depth: 1 px");
}

TEST(ChannelPicture, NanAndInfinityStandOut) {
  auto frame = three_pixels();
  frame.colour.at(0, 0).g = std::numeric_limits<float>::quiet_NaN();
  frame.colour.at(1, 0).r = std::numeric_limits<float>::infinity();
  const auto picture = ps::channel_picture(frame, ShownChannel::nan, {}).levels;
  EXPECT_EQ(picture.at(0, 0), (Rgb8{255, 0, 255}));
  EXPECT_EQ(picture.at(1, 0), (Rgb8{255, 140, 0}));
  EXPECT_EQ(picture.at(2, 0).r, picture.at(2, 0).b);
}

TEST(ChannelPicture, ValuesReadAsText) {
  const auto frame = three_pixels();
  const auto text = [&](ShownChannel channel, int x) { return ps::channel_value_text(frame, channel, {}, {x, 0}); };
  EXPECT_EQ(text(ShownChannel::colour, 0), "128 128 128");
  EXPECT_EQ(text(ShownChannel::depth, 0), "nothing");
  EXPECT_EQ(text(ShownChannel::depth, 2), "z 6");
  EXPECT_EQ(text(ShownChannel::triangle, 2), "object 2, triangle 5");
  EXPECT_EQ(text(ShownChannel::shadow, 1), "lit");
  EXPECT_EQ(text(ShownChannel::shadow_map, 0), "no map here");
  EXPECT_EQ(text(ShownChannel::shadow_map, 1), "depth 4");
  EXPECT_EQ(text(ShownChannel::shadow_map, 2), "sees nothing");
  EXPECT_EQ(text(ShownChannel::stencil, 2), "3");
  EXPECT_EQ(text(ShownChannel::environment, 0), "no map here");
  EXPECT_EQ(text(ShownChannel::precision, 0), "as in double");
  EXPECT_EQ(text(ShownChannel::precision, 1), "missed hit");
  EXPECT_EQ(text(ShownChannel::depth_gap, 0), "no second surface");
  EXPECT_EQ(text(ShownChannel::depth_gap, 1), "second surface 0.5 ulp behind");
  EXPECT_EQ(text(ShownChannel::shadow, 2), "blocked: light 1, 2");
  EXPECT_EQ(text(ShownChannel::tests, 0), "12");
  EXPECT_EQ(text(ShownChannel::samples, 0), "1");
  EXPECT_EQ(text(ShownChannel::direction, 0), "(0, 0, 1)");
  EXPECT_EQ(text(ShownChannel::mip, 0), "no texture");
  EXPECT_EQ(text(ShownChannel::mip, 1), "level 2.5");
}

double luminance(Rgb8 c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

TEST(HeatColour, GetsLighterAllTheWay) {
  for (int i = 1; i <= 100; ++i)
    EXPECT_GT(luminance(ps::heat_colour(i / 100.0)), luminance(ps::heat_colour((i - 1) / 100.0)) - 0.5) << i;
  EXPECT_EQ(ps::heat_colour(0), (Rgb8{0x00, 0x20, 0x4d}));
  EXPECT_EQ(ps::heat_colour(1), (Rgb8{0xff, 0xea, 0x46}));
  EXPECT_EQ(ps::heat_colour(-1), ps::heat_colour(0));
  EXPECT_EQ(ps::heat_colour(7), ps::heat_colour(1));
  EXPECT_EQ(ps::heat_colour(std::numeric_limits<double>::quiet_NaN()), ps::heat_colour(0));
}

TEST(IdColour, NeighboursDifferClearly) {
  const auto distance = [](Rgb8 a, Rgb8 b) { return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b); };
  for (std::uint32_t i = 0; i < 2000; ++i) {
    for (std::uint32_t j = i + 1; j < i + 4; ++j)
      EXPECT_GT(distance(ps::id_colour(i), ps::id_colour(j)), 60) << i << " and " << j;
    EXPECT_GT(luminance(ps::id_colour(i)), 40);
    EXPECT_LT(luminance(ps::id_colour(i)), 245);
  }
}

}  // namespace
}  // namespace channel_picture_test
