#include "study/stability/pictures.h"

#include <algorithm>
#include <cmath>

#include "frame/display_frame.h"
#include "image/difference.h"
#include "render/render.h"
#include "scene/load.h"
#include "scene/scene_file.h"

namespace ps {
namespace {

bool fails(Rgb8 a, Rgb8 b) {
  constexpr int visible = 8;
  return largest_difference(a, b) > visible;
}

StabilityOpening load(const StabilityExperiment& experiment, double knob) {
  const StabilityPicture picture = experiment.picture(knob);
  StabilityOpening opening;
  if (picture.scene.find('\n') == std::string::npos) {
    opening.scene_name = picture.scene;
    opening.scene = load_scene(picture.scene);
  } else {
    opening.scene_name = std::string(experiment.key);
    opening.scene_text = picture.scene;
    opening.scene = parse_scene(picture.scene, opening.scene_name, ".");
  }
  opening.view = {opening.scene.camera, picture.width, picture.height};
  opening.naive = picture.naive;
  opening.robust = picture.robust;
  return opening;
}

Image<Rgb8> levels_of(const Scene& scene, const View& view, const Settings& settings, Progress& progress) {
  Prepared prepared;
  return display_frame(render(scene, view, settings, {}, prepared, progress), settings);
}

/// The failing pixel with the most failing ones around it; the first one at equal numbers.
std::optional<Vec2i> middle_of_failure(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  std::optional<Vec2i> best;
  int most = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      if (!fails(a.at(x, y), b.at(x, y))) continue;
      int around = 1;
      for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx)
          if (a.contains(x + dx, y + dy) && fails(a.at(x + dx, y + dy), b.at(x + dx, y + dy))) ++around;
      if (around > most) most = around, best = Vec2i(x, y);
    }
  return best;
}

void paste(Image<Rgb8>& strip, const Image<Rgb8>& frame, int x0, int y0) {
  for (int y = 0; y < frame.height(); ++y)
    std::copy(frame.row(y).begin(), frame.row(y).end(), strip.row(y0 + y).begin() + x0);
}

Image<Rgb8> marked(const Image<Rgb8>& naive, const Image<Rgb8>& robust) {
  Image<Rgb8> picture = naive;
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    Rgb8& p = picture.pixels()[i];
    if (fails(p, robust.pixels()[i]))
      p = {255, 255, 255};
    else
      p = {static_cast<std::uint8_t>(p.r / 4), static_cast<std::uint8_t>(p.g / 4), static_cast<std::uint8_t>(p.b / 4)};
  }
  return picture;
}

}  // namespace

std::optional<StabilityOpening> open_stability_point(const StabilityExperiment& experiment, double knob,
                                                     Progress& progress) {
  if (!experiment.picture) return {};
  StabilityOpening opening = load(experiment, knob);
  const Image<Rgb8> a = levels_of(opening.scene, opening.view, opening.naive, progress);
  const Image<Rgb8> b = levels_of(opening.scene, opening.view, opening.robust, progress);
  int failing = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) failing += fails(a.pixels()[i], b.pixels()[i]) ? 1 : 0;
  opening.failing_percent = 100.0 * failing / static_cast<double>(a.pixels().size());
  opening.failing = middle_of_failure(a, b);
  return opening;
}

std::optional<Image<Rgb8>> film_strip(const StabilityExperiment& experiment, const FilmStripOptions& options,
                                      Progress& progress) {
  if (!experiment.picture || experiment.frames.empty()) return {};
  Image<Rgb8> strip;
  int column = 0;
  for (const double knob : experiment.frames) {
    StabilityOpening opening = load(experiment, knob);
    const double shape = static_cast<double>(opening.view.width) / opening.view.height;
    opening.view.height = options.frame_height;
    opening.view.width = static_cast<int>(std::lround(options.frame_height * shape));
    const int step_x = opening.view.width + options.gap, step_y = opening.view.height + options.gap;
    if (strip.empty())
      strip = Image<Rgb8>(step_x * static_cast<int>(experiment.frames.size()) - options.gap, 3 * step_y - options.gap,
                          {255, 255, 255});
    const Image<Rgb8> naive = levels_of(opening.scene, opening.view, opening.naive, progress);
    const Image<Rgb8> robust = levels_of(opening.scene, opening.view, opening.robust, progress);
    paste(strip, naive, column * step_x, 0);
    paste(strip, robust, column * step_x, step_y);
    paste(strip, marked(naive, robust), column * step_x, 2 * step_y);
    ++column;
  }
  return strip;
}

}  // namespace ps
