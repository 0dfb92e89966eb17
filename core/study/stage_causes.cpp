#include "study/stage_causes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "frame/display_frame.h"
#include "options/option.h"
#include "render/renderer_table.h"
#include "study/stage_repair.h"

namespace ps {
namespace {

struct CauseText {
  StageCause cause;
  std::string_view label, help;
  Rgb8 colour;
};

constexpr std::array cause_texts{
    CauseText{StageCause::none, "none", "The pixels are equal within one level of 255.", {38, 38, 38}},
    CauseText{StageCause::coverage,
              "coverage",
              "Equal once the rasterizer takes from the other renderer which triangles cover the sample.",
              {230, 159, 0}},
    CauseText{StageCause::depth_tie,
              "depth tie",
              "Equal once the rasterizer takes the other renderer's depths.",
              {213, 94, 0}},
    CauseText{StageCause::clipping,
              "clipping",
              "Equal once the rasterizer takes the triangle as the other renderer has clipped it.",
              {204, 121, 167}},
    CauseText{StageCause::interpolation,
              "interpolation",
              "Equal once the rasterizer takes the other renderer's interpolated values.",
              {86, 180, 233}},
    CauseText{StageCause::filtering,
              "filtering",
              "Equal once the rasterizer takes what the other renderer has read from textures and maps.",
              {0, 158, 115}},
    CauseText{StageCause::missing_effect,
              "missing effect",
              "Equal once the rasterizer leaves out what the other renderer does not do under its options.",
              {240, 228, 66}},
    CauseText{StageCause::unexplained, "unexplained", "No repair makes the pixel equal.", {255, 255, 255}}};

const CauseText& cause_text(StageCause cause) { return cause_texts[static_cast<std::size_t>(cause)]; }

/// The sum over the channels, and the largest of them.
struct LevelDifference {
  int sum = 0, largest = 0;
};

LevelDifference level_difference(const Rgb8& a, const Rgb8& b) {
  const int r = std::abs(a.r - b.r), g = std::abs(a.g - b.g), blue = std::abs(a.b - b.b);
  return {r + g + blue, std::max({r, g, blue})};
}

void count_pixel(StageShare& share, bool colour, bool id, double error) {
  ++share.pixels;
  share.colours += colour;
  share.ids += id;
  share.error += error;
}

bool gives_stages(const Settings& settings) { return renderer_row(settings.renderer).stage_values != nullptr; }

/// Core's own renderer of fragments: it takes over after each stage of the other one.
bool is_rasterizer(const Settings& settings) {
  return draws_fragments(settings.renderer) && !renderer_kind(settings.renderer).added;
}

}  // namespace

std::string_view stage_cause_label(StageCause cause) { return cause_text(cause).label; }
std::string_view stage_cause_help(StageCause cause) { return cause_text(cause).help; }
Rgb8 stage_cause_colour(StageCause cause) { return cause_text(cause).colour; }

double StageSplit::part(StageCause cause) const {
  return whole.pixels == 0 ? 0 : static_cast<double>(share(cause).pixels) / static_cast<double>(whole.pixels);
}

std::optional<std::string> why_no_stages(const SceneTraits& traits, const Settings& a, const Settings& b) {
  if (!((gives_stages(a) && is_rasterizer(b)) || (gives_stages(b) && is_rasterizer(a))))
    return "One picture needs renderer = rasterizer, and the other a renderer that gives the values of its stages, "
           "such "
           "as hardware.";
  for (const Settings* settings : {&a, &b}) {
    if (const auto reason = renderer_kind(settings->renderer).inactive
                                ? renderer_kind(settings->renderer).inactive(*settings, traits)
                                : std::nullopt)
      return std::string(*reason);
    if (settings->draw != Draw::filled) return "Lines and points have no stages to compare: set draw = filled.";
  }
  return {};
}

std::optional<Renderer> renderer_with_stages() {
  for (const RendererRow& row : renderer_table())
    if (row.stage_values) return row.renderer;
  return {};
}

StageRequest stage_request(const Scene& scene, const View& view, const Settings& a, const Settings& b) {
  StageRequest request;
  request.scene = scene;
  request.view = view;
  request.other = gives_stages(a) ? a : b;
  request.ours = gives_stages(a) ? b : a;
  return request;
}

StageSplit split_by_stage(const StageRequest& request, StudyControl& control,
                          const std::function<void(const StudyStatus&)>& update) {
  Prepared prepared;
  const auto frame_of = [&](const Settings& settings) {
    RenderRequest how;
    how.channels = Channel::ids;
    return render(request.scene, request.view, settings, how, prepared, control.progress());
  };
  const Frame theirs = frame_of(request.other), ours = frame_of(request.ours);
  std::unique_ptr<StageRepair> repair;  // made for the first pixel that differs
  const Image<Rgb8> a = display_frame(theirs, request.other), b = display_frame(ours, request.ours);
  StageSplit split;
  split.causes = Image<StageCause>(a.width(), a.height());
  for (int y = 0; y < a.height(); ++y) {
    control.wait_here();
    if (update) update({y, a.height(), -1});
    for (int x = 0; x < a.width(); ++x) {
      const LevelDifference difference = level_difference(a.at(x, y), b.at(x, y));
      const bool colour = difference.largest > request.bound, id = theirs.ids.at(x, y) != ours.ids.at(x, y);
      if (!colour && !id) continue;
      if (!repair) repair = std::make_unique<StageRepair>(request, prepared, control);
      const RepairedPixel found = repair->cause_of({x, y}, a.at(x, y));
      split.causes.at(x, y) = found.cause;
      const double error = colour ? difference.sum : 0;
      count_pixel(split.shares[static_cast<std::size_t>(found.cause)], colour, id, error);
      count_pixel(split.whole, colour, id, error);
      if (colour) split.largest = std::max(split.largest, difference.largest);
      if (found.cause == StageCause::coverage) split.edge_distance = std::max(split.edge_distance, found.edge_distance);
    }
  }
  return split;
}

Image<Rgb8> stage_picture(const StageSplit& split) {
  Image<Rgb8> picture(split.causes.width(), split.causes.height());
  std::transform(split.causes.pixels().begin(), split.causes.pixels().end(), picture.pixels().begin(),
                 stage_cause_colour);
  return picture;
}

}  // namespace ps
