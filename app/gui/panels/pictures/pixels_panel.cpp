#include "gui/panels/pictures/pixels_panel.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/shorten.h"
#include "render/render.h"

namespace ps::gui {
namespace {

constexpr int listed = 30, apart_by = 6;  // pixels
constexpr double column_width = 330, value_width = 52;

Image<float> count_tests(const CostRequest& request, Prepared& prepared, Progress& progress) {
  RenderRequest wanted;
  wanted.channels = Channel::tests;
  wanted.priority = WorkerPriority::background;
  return as_values(render(request.scene, request.view, request.settings, wanted, prepared, progress).tests);
}

bool same_cost(const CostRequest& a, const CostRequest& b) {
  return a.scene.revision() == b.scene.revision() && a.view == b.view && a.settings == b.settings;
}

bool still(Session& session) { return !session.busy(); }

std::string level_text(const std::optional<Rgb8>& level) {
  return level ? fmt::format("{} {} {}", level->r, level->g, level->b) : std::string("outside");
}

/// A line about a pixel that picks it when it is clicked.
bool pixel_row(Session& session, const std::string& name, Vec2i pixel, const std::string& text) {
  const FontScope font(Face::mono);
  const bool picked = session.pixel() == pixel;
  ImGui::PushID(name.c_str());
  const std::string shown = whole_words(text, ImGui::GetContentRegionAvail().x);
  const bool clicked = ImGui::Selectable(shown.c_str(), picked, 0, {0, ImGui::GetTextLineHeight()});
  ImGui::PopID();
  controls().record(name, text);
  if (shown != text) tooltip(text);
  if (clicked) session.set_pixel(pixel);
  return clicked;
}

/// Answers whether to fill the window, or no longer.
bool worst_list(Session& session, PixelsPanelState& state, const PicturesState& pictures, bool filled) {
  static constexpr std::array kinds{Choice{"difference", "A against B", "The pixels whose levels differ most."},
                                    Choice{"cost-a", "Cost of A", "The pixels of A that need most tests."},
                                    Choice{"cost-b", "Cost of B", "The pixels of B that need most tests."}};
  choice_of("ranked", kinds, state.ranked,
            {.tooltip = "The measure by which pixels are sorted.",
             .width = std::min(px(column_width - 20), ImGui::GetContentRegionAvail().x)});
  const bool words_fit = text_width("One for each neighbourhood") + px(44) <= ImGui::GetContentRegionAvail().x;
  toggle("apart", words_fit ? "One for each neighbourhood" : "Spread out", state.apart,
         {.tooltip = "Leaves out pixels within six of one that is worse, so that one edge does not fill the list."});
  const bool fill = fill_button(filled, "Shows these lists in the whole window (Esc).");
  if (state.worst.empty()) {
    show_paragraph(!still(session) || (state.ranked != PixelsPanelState::Ranked::difference && state.cost.busy())
                       ? "Working ..."
                   : state.ranked == PixelsPanelState::Ranked::difference ? "A and B are identical in display levels."
                                                                          : "No pixel needed a test.");
    return fill;
  }
  const std::string_view unit = state.ranked == PixelsPanelState::Ranked::difference ? "levels" : "tests";
  int place = 0;
  for (const RankedPixel& entry : state.worst) {
    const std::string text =
        fmt::format("{:>2}  ({:>4}, {:>4})  {:>8.0f} {}", place + 1, entry.pixel.x, entry.pixel.y, entry.value, unit);
    const bool clicked = pixel_row(session, fmt::format("worst/{}", place++), entry.pixel, text);
    if (clicked && state.ranked != PixelsPanelState::Ranked::difference)
      session.navigate([&](Document& document) {
        document.picked = state.ranked == PixelsPanelState::Ranked::cost_a ? Side::a : Side::b;
      });
    if (ImGui::IsItemHovered() && begin_tooltip()) {
      for (const Side side : both_sides) {
        const Image<Rgb8>& levels = pictures.pictures[index_of(side)].levels;
        if (!levels.contains(entry.pixel.x, entry.pixel.y)) continue;
        const Rgb8 level = levels.at(entry.pixel.x, entry.pixel.y);
        swatch({level.r, level.g, level.b});
        ImGui::SameLine();
        show_text(fmt::format("{}  {}", letter_of(side), level_text(level)));
      }
      end_tooltip();
    }
  }
  return fill;
}

/// The brightness of a pixel over its changes, A and B each a line.
void history_lines(const WatchedPixel& watched, float width, float height) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  auto& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + height}, colour_u32(palette().field), px(3));
  const std::size_t count = watched.values.size();
  for (const Side side : both_sides) {
    std::vector<ImVec2> points;
    for (std::size_t i = 0; i < count; ++i) {
      const auto& level = watched.values[i][index_of(side)];
      if (!level) continue;
      const double grey = (0.299 * level->r + 0.587 * level->g + 0.114 * level->b) / 255;
      const float x = count < 2 ? 0.5f : static_cast<float>(i) / static_cast<float>(count - 1);
      points.push_back(
          {at.x + px(4) + x * (width - px(8)), at.y + height - px(3) - static_cast<float>(grey) * (height - px(6))});
    }
    const ImU32 colour = colour_u32(side == Side::a ? palette().a : palette().b);
    list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, px(2));
    if (!points.empty()) list.AddCircleFilled(points.back(), px(3), colour);
  }
  ImGui::Dummy({width, height});
  tooltip("Brightness over the changes so far, the newest at the right: A blue, B orange.");
}

void watched_list(Session& session, PixelsPanelState& state) {
  show_text("Watched pixels", {Face::bold});
  const auto picked = session.pixel();
  const bool watched = picked && state.watched.contains(*picked);
  const bool full = !watched && state.watched.all().size() >= WatchedPixels::most_pixels;
  if (button("watch", watched ? "Stop watching" : "Watch this pixel", Emphasis::plain,
             {.tooltip = "Records the picked pixel's values while options change.",
              .disabled = !picked ? "No pixel is picked."
                          : full  ? "At most twelve pixels can be watched."
                                  : ""}))
    state.watched.toggle(*picked);
  int index = 0;
  for (const WatchedPixel& one : state.watched.all()) {
    const std::string name = fmt::format("watched/{}", index++);
    pixel_row(session, name, one.pixel, fmt::format("({}, {})", one.pixel.x, one.pixel.y));
    if (one.values.empty()) continue;
    const FontScope font(Face::mono);
    for (const Side side : both_sides) {
      const auto& now = one.values.back()[index_of(side)];
      if (side == Side::b) ImGui::SameLine(0, px(14));
      side_letter(side);
      ImGui::SameLine(0, px(5));
      if (now) {
        swatch({now->r, now->g, now->b});
        ImGui::SameLine(0, px(5));
      }
      value_text(fmt::format("{}/{}", name, side == Side::a ? "a" : "b"), level_text(now));
      const std::size_t count = one.values.size();
      if (count > 1 && one.values[count - 2][index_of(side)] != now)
        tooltip("before: " + level_text(one.values[count - 2][index_of(side)]));
    }
    history_lines(one, std::min(px(column_width - 30), ImGui::GetContentRegionAvail().x), px(30));
  }
}

/// How often each level occurs, the three channels over each other.
void histogram(const RegionStatistics& statistics, float width, float height) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  auto& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + height}, colour_u32(palette().field), px(3));
  constexpr std::size_t bins = 64, levels_each = 256 / bins;
  std::array<std::array<std::uint32_t, bins>, 3> counts{};
  std::uint32_t most = 1;
  for (std::size_t channel = 0; channel < 3; ++channel)
    for (std::size_t level = 0; level < 256; ++level) {
      std::uint32_t& bin = counts[channel][level / levels_each];
      bin += statistics.channels[channel].histogram[level];
      most = std::max(most, bin);
    }
  static constexpr std::array<ImU32, 3> colours{IM_COL32(200, 40, 40, 235), IM_COL32(30, 140, 60, 235),
                                                IM_COL32(50, 80, 220, 235)};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    std::vector<ImVec2> points;
    for (std::size_t bin = 0; bin < bins; ++bin) {
      // The root keeps rare levels visible beside a background that fills most of the picture.
      const float share = std::sqrt(static_cast<float>(counts[channel][bin]) / static_cast<float>(most));
      points.push_back({at.x + width * (static_cast<float>(bin) + 0.5f) / static_cast<float>(bins),
                        at.y + height - px(2) - share * (height - px(4))});
    }
    list.AddPolyline(points.data(), static_cast<int>(points.size()), colours[channel], 0, px(1.6));
  }
  ImGui::Dummy({width, height});
  tooltip("Number of pixels at each level of red, green and blue, dark at the left; the height is its square root.");
}

void statistics_table(const RegionStatistics& statistics, Side side) {
  const char* id = side == Side::a ? "statistics-a" : "statistics-b";
  if (!begin_numbers(id, 4, {.text = px(58), .numbers = px(value_width)})) return;
  {
    const TextScope quiet({.quiet = true});
    numbers_row("");
    for (const char* name : {"mean", "± σ", "low", "high"}) number_cell(name, name);
  }
  static constexpr std::array<const char*, 3> channels{"red", "green", "blue"};
  for (std::size_t i = 0; i < 3; ++i) {
    const ChannelStatistics& channel = statistics.channels[i];
    numbers_row(channels[i]);
    for (const double value :
         {channel.mean, channel.deviation, static_cast<double>(channel.lowest), static_cast<double>(channel.highest)})
      number_cell(short_number(value), full_number(value));
  }
  ImGui::EndTable();
}

void region_view(Session& session, PixelsPanelState& state) {
  show_text("Levels of a rectangle", {Face::bold});
  const auto& region = session.region();
  const std::string pixels = with_thousands(std::to_string(state.statistics[0].pixels));
  value_paragraph("region", region
                                ? fmt::format("columns {} to {}, rows {} to {}: {} pixels", region->x0, region->x1 - 1,
                                              region->y0, region->y1 - 1, pixels)
                                : fmt::format("The whole picture, {} pixels. Drag with Shift in a picture to choose a "
                                              "rectangle; Esc goes back to the whole picture.",
                                              pixels));
  for (const Side side : both_sides) {
    const RegionStatistics& statistics = state.statistics[index_of(side)];
    if (statistics.pixels == 0) continue;
    side_letter(side);
    statistics_table(statistics, side);
    controls().record(side == Side::a ? "mean-a" : "mean-b",
                      fmt::format("{:.4g} {:.4g} {:.4g}", statistics.channels[0].mean, statistics.channels[1].mean,
                                  statistics.channels[2].mean));
    histogram(statistics, std::min(px(column_width - 30), ImGui::GetContentRegionAvail().x), px(56));
  }
}

/// Ranks and measures anew where the pictures, or what is asked of them, have changed.
void refresh(Session& session, PixelsPanelState& state, const PicturesState& pictures) {
  using Ranked = PixelsPanelState::Ranked;
  std::shared_ptr<const Image<float>> cost;
  if (state.ranked == Ranked::difference) {
    state.cost.rest();
  } else {
    const Side side = state.ranked == Ranked::cost_a ? Side::a : Side::b;
    state.cost.request({session.scene(), session.view(), session.settings(side)});
    state.cost.take_news();
    if (!state.cost.busy()) cost = state.cost.result();
  }
  if (!still(session)) return;
  const bool same =
      state.versions == pictures.versions && state.ranked_by == state.ranked && state.ranked_apart == state.apart &&
      state.ranked_cost == cost && state.measured.has_value() == session.region().has_value() &&
      (!state.measured || (state.measured->x0 == session.region()->x0 && state.measured->y0 == session.region()->y0 &&
                           state.measured->x1 == session.region()->x1 && state.measured->y1 == session.region()->y1));
  if (same) return;
  state.versions = pictures.versions;
  state.ranked_by = state.ranked;
  state.ranked_apart = state.apart;
  state.ranked_cost = cost;
  state.measured = session.region();
  const Image<Rgb8>&a = pictures.pictures[0].levels, &b = pictures.pictures[1].levels;
  const RankingOptions options{listed, state.apart ? apart_by : 0};
  state.worst.clear();
  if (state.ranked != Ranked::difference) {
    if (cost) state.worst = rank_pixels(*cost, options);
  } else if (a.width() == b.width() && a.height() == b.height()) {
    state.worst = rank_pixels(level_differences(a, b), options);
  }
  for (const Side side : both_sides) {
    const Image<Rgb8>& levels = pictures.pictures[index_of(side)].levels;
    state.statistics[index_of(side)] =
        region_statistics(levels, session.region().value_or(TileRect{0, 0, levels.width(), levels.height()}));
  }
}

}  // namespace

PixelsPanelState::PixelsPanelState(std::function<void()> wake)
    : cost([prepared = std::make_shared<Prepared>()](
               const CostRequest& request, Progress& progress) { return count_tests(request, *prepared, progress); },
           same_cost, std::move(wake)) {}

PixelsPanel::PixelsPanel(const PanelHost& host, const PicturesState& pictures)
    : Panel(host, {.name = "pixels",
                   .use = PanelUse::study,
                   .group = ToolGroup::pixels,
                   .height = PanelHeight::tall,
                   .heading = "Pixels",
                   .brief = "Pixels",
                   .command = "Pixels: the worst ones",
                   .help = "The worst pixels, watched pixels, and the levels of a rectangle."}),
      pictures_(pictures), state_(host.wake) {}

void PixelsPanel::update() {
  if (session_.has_scene() && still(session_))
    state_.watched.note(pictures_.pictures[0].levels, pictures_.pictures[1].levels);
}

bool PixelsPanel::draw(const Context& context) {
  const NameScope scope("pixels");
  if (!session_.has_scene()) return false;
  refresh(session_, state_, pictures_);
  if (context.in_line) ImGui::NewLine();
  begin_tool_content();
  ImGui::BeginChild("pixels");
  const float room = ImGui::GetContentRegionAvail().x, height = ImGui::GetContentRegionAvail().y;
  const bool beside = room >= px(2 * column_width);
  const int columns = room >= px(3 * column_width) ? 3 : 2;
  const auto part = [&](int place, const char* name, const auto& draw) {
    if (!beside) {
      if (place > 0) ImGui::Separator();
      draw();
      return;
    }
    const float space = px(14);
    const float width = (room - space * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    if (place == 1 || (place == 2 && columns == 3)) ImGui::SameLine(0, space);
    ImGui::BeginChild(name, {width, height});
    draw();
    ImGui::EndChild();
  };
  bool fill = false;
  part(0, "worst-list", [&] { fill = worst_list(session_, state_, pictures_, context.filled); });
  if (columns == 3 || !beside) {
    part(1, "watched-list", [&] { watched_list(session_, state_); });
    part(2, "region-view", [&] { region_view(session_, state_); });
  } else {
    part(1, "others", [&] {
      watched_list(session_, state_);
      ImGui::Separator();
      region_view(session_, state_);
    });
  }
  ImGui::EndChild();
  return fill;
}

}  // namespace ps::gui
