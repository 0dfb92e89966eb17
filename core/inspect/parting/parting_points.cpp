#include <algorithm>
#include <array>

#include "inspect/parting/parting_parts.h"
#include "record/value_text.h"
#include "render/story/light_terms.h"
#include "render/story/light_words.h"
#include "render/story/names.h"
#include "render/story/story_tree.h"

namespace ps::parting {
namespace {

constexpr double one_level = 1.0 / 255;  // of a display; less highlight than that is not seen

/// The brightest highlight among some LightEvents.
struct Highlight {
  int light = -1;  ///< of the scene
  double specular = one_level;
};

Highlight brightest(const PixelStory& story, const std::vector<int>& lights) {
  Highlight found;
  for (const int index : lights) {
    const auto& light = event_as<LightEvent>(story.events, index);
    if (light.specular > found.specular) found = {light.light, light.specular};
  }
  return found;
}

Vec3d light_of(const VertexLightEvent& point) { return point.light + point.extra; }

/// At how many of the points the light has a highlight that is seen.
std::size_t catching(const PixelStory& story, const std::vector<int>& points, int light) {
  return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](int point) {
    const auto lights = events_below<LightEvent>(story.events, point);
    return std::any_of(lights.begin(), lights.end(), [&](int index) {
      const auto& event = event_as<LightEvent>(story.events, index);
      return event.light == light && event.specular >= one_level;
    });
  }));
}

/// "0.31 x 0.82 + 0.33 x 0.71 + 0.36 x 0.64 = 0.72"
std::string mixture_text(const PixelStory& story, const std::vector<int>& points, const Vec3d& sum) {
  std::string text;
  for (const int index : points) {
    const auto& point = event_as<VertexLightEvent>(story.events, index);
    text += fmt::format("{}{} x {}", text.empty() ? "" : " + ", number_text(point.weight), light_text(light_of(point)));
  }
  return text + " = " + light_text(sum);
}

/// How one side got the light of the pixel. `light` is the one whose highlight is spoken of, -1 for none.
std::string side_text(const Scene& scene, const PixelStory& story, const Sighting& seen, const std::vector<int>& points,
                      int light, std::string_view letter) {
  const auto& shade = event_as<ShadeEvent>(story.events, seen.shade);
  const Vec3d sum = shade.light + shade.extra;
  if (points.size() == 1)
    return fmt::format("{} takes the light at the centre of the triangle for all of it, {}", letter, light_text(sum));
  if (points.size() == 3) {
    std::string text =
        fmt::format("{} mixes the light of three vertices, {}", letter, mixture_text(story, points, sum));
    if (light < 0) return text;
    constexpr std::array<std::string_view, 4> how_many{"none", "one", "two", "all three"};
    const std::size_t count = std::min<std::size_t>(catching(story, points, light), 3);
    return text + fmt::format(", {} of which catch{} the highlight of {}", how_many[count], count > 1 ? "" : "es",
                              light_name(scene, light));
  }
  std::string text = fmt::format("{} evaluates the light at the pixel itself and gets {}", letter, light_text(sum));
  const Highlight highlight = brightest(story, seen.lights);
  if (light >= 0 && highlight.light == light)
    text +=
        fmt::format(", of which {} is the highlight of {}", number_text(highlight.specular), light_name(scene, light));
  return text;
}

std::vector<int> points_of(const PixelStory& story, const Sighting& seen) {
  return seen.seen < 0 ? std::vector<int>() : events_below<VertexLightEvent>(story.events, seen.seen);
}

}  // namespace

LightPlaces light_places(const StoryPair& c, const Sighting& a, const Sighting& b) {
  const auto points_a = points_of(c.a.story, a), points_b = points_of(c.b.story, b);
  const auto* shade_a = event_at<ShadeEvent>(c.a.story, a.shade);
  const auto* shade_b = event_at<ShadeEvent>(c.b.story, b.shade);
  // A listing does not say where it computes its light.
  if (points_a.size() == points_b.size() || !shade_a || !shade_b || c.with_listing()) return {};
  LightPlaces places;
  places.differ = true;
  places.same_light = c.same(shade_a->light, shade_b->light) && c.same(shade_a->extra, shade_b->extra);
  const Highlight in_a = brightest(c.a.story, a.lights), in_b = brightest(c.b.story, b.lights);
  const int light = in_a.specular > in_b.specular ? in_a.light : in_b.light;
  places.text = side_text(c.scene, c.a.story, a, points_a, light, "A") + "; " +
                side_text(c.scene, c.b.story, b, points_b, light, "B");
  return places;
}

}  // namespace ps::parting
