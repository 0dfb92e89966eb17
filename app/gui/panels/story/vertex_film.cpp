#include "gui/panels/story/vertex_film.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gui/panels/pictures/picture_transform.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/redraw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double seconds_per_space = 1.6;
constexpr double hold = 0.3;                          // share of that time in which it rests in a space
constexpr double film_height = 190;                   // at scale 1
constexpr double depth_right = 0.3, depth_up = 0.22;  // where depth goes in the drawing
constexpr double end_of_film = chain_spaces - 1;

struct SpaceWords {
  const char *name, *x, *y, *z;
};
constexpr std::array<SpaceWords, chain_spaces> spaces{
    SpaceWords{"model", "x", "y", "z"}, SpaceWords{"world", "x", "y", "z"},
    SpaceWords{"camera", "right", "up", "forward"}, SpaceWords{"projection", "x / w", "y / w", "depth"},
    SpaceWords{"canvas", "x", "y", ""}};

/// A space drawn as large as its points allow: what it holds fills a box from -1 to 1.
struct Fit {
  Vec3d centre{0, 0, 0}, scale{1, 1, 1};
};

Fit fit_of(const std::vector<Vec3d>& points) {
  Vec3d low(1e300), high(-1e300);
  for (const Vec3d& p : points)
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  Fit fit;
  fit.centre = (low + high) * 0.5;
  const Vec3d half = (high - low) * 0.5;
  const double across = std::max({half.x, half.y, 1e-12});
  // Depth in world units and pixels have no common scale.
  fit.scale = {1 / across, 1 / across, 1 / std::max(across, half.z)};
  return fit;
}

Vec3d mixed(const Vec3d& a, const Vec3d& b, double share) { return a * (1 - share) + b * share; }

/// From a place of the film to the drawing's box, x right and y up.
class Lens {
 public:
  Lens(const ChainStages& stages, double time) {
    const auto space = std::min(static_cast<std::size_t>(time), chain_spaces - 2);
    const double share = time - static_cast<double>(space);
    const Fit a = fit_of(stages.points[space]), b = fit_of(stages.points[space + 1]);
    centre_ = mixed(a.centre, b.centre, share);
    // Sizes change by factors, so that the way from metres to pixels is an even one.
    for (int i = 0; i < 3; ++i) scale_[i] = std::pow(a.scale[i], 1 - share) * std::pow(b.scale[i], share);
  }
  Vec2d at(const Vec3d& p) const { return in_box((p - centre_) * scale_); }
  static Vec2d in_box(const Vec3d& p) { return {p.x + depth_right * p.z, p.y + depth_up * p.z}; }

 private:
  Vec3d centre_{0, 0, 0}, scale_{1, 1, 1};
};

void follow(Session& session, VertexFilm& film, const VertexId& vertex) {
  const Settings& settings = session.settings(inspected_side(session));
  const VertexFilm::Subject subject{session.scene().revision(), session.view(), settings, vertex,
                                    session.document().story.vertex_edits};
  if (film.made_for == subject) return;
  film.made_for = subject;
  film.stages = chain_stages(session.scene(), session.view(), settings, vertex, subject.edits);
}

/// Rests in each space for a while: a share of the time between two.
double eased(double time) {
  const double space = std::floor(time), share = time - space;
  const double moved = std::clamp((share - hold / 2) / (1 - hold), 0.0, 1.0);
  return space + moved * moved * (3 - 2 * moved);
}

void go_on(VertexFilm& film) {
  if (!film.playing) return;
  const double now = ImGui::GetTime();
  film.time += std::clamp(now - film.last, 0.0, 0.1) / seconds_per_space;
  film.last = now;
  if (film.time >= end_of_film) {
    film.time = end_of_film;
    film.playing = false;
  } else {
    redraw_after(0);
  }
}

void arrow(ImDrawList& list, ImVec2 from, const Vec2d& way, const char* name) {
  if (!*name) return;
  const ImVec2 to{from.x + px(30 * way.x), from.y - px(30 * way.y)};
  list.AddLine(from, to, colour_u32(palette().text_quiet), px(1.5));
  list.AddCircleFilled(to, px(2.5), colour_u32(palette().text_quiet));
  draw_lines({to.x + px(4), to.y - ImGui::GetFontSize() / 2}, name, palette().text_quiet);
}

void draw(const VertexFilm& film, const Area& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(area.min, area.max, colour_u32(palette().field), px(3));
  list.PushClipRect(area.min, area.max, true);
  const ChainStages& stages = *film.stages;
  const double time = eased(film.time);
  const Lens lens(stages, time);
  const double radius = 0.42 * std::min(area.width(), area.height());
  const auto place = [&](std::size_t vertex) {
    const Vec2d at = lens.at(place_at(stages, vertex, time));
    return ImVec2{area.middle().x + static_cast<float>(at.x * radius),
                  area.middle().y - static_cast<float>(at.y * radius)};
  };
  for (const auto& edge : stages.edges)
    list.AddLine(place(static_cast<std::size_t>(edge[0])), place(static_cast<std::size_t>(edge[1])),
                 colour_u32(palette().text_quiet), px(1));
  const ImVec2 followed = place(static_cast<std::size_t>(stages.followed));
  list.AddCircleFilled(followed, px(6), colour_u32(palette().text));
  list.AddCircleFilled(followed, px(4), colour_u32(palette().attention));
  const FontScope small(Face::small);
  const SpaceWords& words = spaces[static_cast<std::size_t>(std::lround(film.time))];
  const ImVec2 corner{area.min.x + px(12), area.max.y - px(14)};
  arrow(list, corner, {1, 0}, words.x);
  arrow(list, corner, {0, 1}, words.y);
  arrow(list, corner, {depth_right * 2, depth_up * 2}, words.z);
  list.PopClipRect();
}

}  // namespace

void play_film(VertexFilm& film) {
  film.playing = true;
  film.last = ImGui::GetTime();
  if (film.time >= end_of_film) film.time = 0;
}

void vertex_film(Session& session, VertexFilm& film, const VertexId& vertex, float width) {
  const NameScope scope("film");
  follow(session, film, vertex);
  go_on(film);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Area area{at, {at.x + width, at.y + px(film_height)}};
  ImGui::Dummy({width, area.height()});
  draw(film, area);
  controls().record("picture", spaces[static_cast<std::size_t>(std::lround(film.time))].name);
  if (button("play", film.playing ? "Pause" : "Play", Emphasis::plain,
             {.tooltip = "Moves the model from space to space.", .width = px(62)})) {
    if (film.playing)
      film.playing = false;
    else
      play_film(film);
  }
  ImGui::SameLine(0, px(4));
  const float rest = width - px(66);
  double time = film.time;
  if (number("time", time, {.minimum = 0, .maximum = end_of_film},
             {.tooltip = "0 model, 1 world, 2 camera, 3 projection, 4 canvas; in between on the way.", .width = rest})
          .changed) {
    film.time = time;
    film.playing = false;
  }
  static constexpr std::array choices{Choice{"model", "model", "As its file has it."},
                                      Choice{"world", "world", "Scaled, rotated, moved."},
                                      Choice{"camera", "camera", "Along the camera's axes."},
                                      Choice{"projection", "projection", "x and y divided by w; depth is kept."},
                                      Choice{"canvas", "canvas", "Pixels: depth is gone."}};
  int index = film.time == std::round(film.time) ? static_cast<int>(film.time) : -1;
  const FontScope small(Face::small);
  if (choice("space", choices, index, {.width = width})) {
    film.time = index;
    film.playing = false;
  }
}

}  // namespace ps::gui
