#include "render/story/light_terms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/enumerators.h"
#include "record/value_text.h"
#include "render/story/light_words.h"
#include "render/story/names.h"
#include "render/story/story_tree.h"

namespace ps {
namespace {

constexpr Vec3d black{0, 0, 0};

/// The colours that the terms of the illumination equation multiply.
struct SurfaceColours {
  Vec3d diffuse{0, 0, 0}, ambient{0, 0, 0}, specular{0, 0, 0};
};

SurfaceColours surface_colours(const Scene& scene, const PixelId& id, const Vec3d& textured) {
  SurfaceColours colours{textured, textured, textured};
  if (id.object < 0 || static_cast<std::size_t>(id.object) >= scene.geometry->objects.size()) return colours;
  const Material& material = material_of(scene, id.object, std::max(id.triangle, 0));
  colours.ambient = material.ambient_colour.value_or(textured);
  colours.specular = material.specular_colour.value_or(textured);
  return colours;
}

/// A white one for a light that the scene does not have.
Light light_of(const Scene& scene, int light) {
  const bool known = light >= 0 && static_cast<std::size_t>(light) < scene.lights->size();
  return known ? (*scene.lights)[static_cast<std::size_t>(light)] : Light{};
}

std::string share_prefix(double share) { return share == 1 ? "" : number_text(share) + " x "; }

/// "0.49 x red light x (1, 0, 0)" without the factors that are white.
std::string product_text(double share, double intensity, const Vec3d& light, const Vec3d& surface) {
  const std::string coloured = light == Vec3d{1, 1, 1} ? "" : " x " + vector_text(light);
  return fmt::format("{}{}{} x {}", share_prefix(share), number_text(intensity), coloured, vector_text(surface));
}

std::vector<LedgerLine> terms_of_light(const PixelStory& story, const Scene& scene, const SurfaceColours& colours,
                                       int index, double share, int level) {
  const auto& light = event_as<LightEvent>(story.events, index);
  const std::string name = light_name(scene, light.light);
  const Light source = light_of(scene, light.light);
  const auto line = [&](LedgerTerm kind, double intensity, const Vec3d& tint, const Vec3d& surface) {
    const std::string part = kind == LedgerTerm::light ? "" : fmt::format(" {}", enumerator_key(kind));
    const std::string product = product_text(share, intensity, tint, surface);
    const Vec3d value = share * intensity * tint * surface;
    return LedgerLine{level, kind, fmt::format("{}{}: {}", name, part, product), value, index, name};
  };
  std::vector<LedgerLine> lines;
  if (light.kind == LightKind::ambient) {
    if (!adds_nothing(light.diffuse))
      lines.push_back(line(LedgerTerm::light, light.diffuse, source.colour, colours.ambient));
  } else {
    if (!adds_nothing(light.ambient))
      lines.push_back(line(LedgerTerm::ambient, light.ambient, source.ambient_colour, colours.ambient));
    if (!adds_nothing(light.diffuse))
      lines.push_back(line(LedgerTerm::diffuse, light.diffuse, source.colour, colours.diffuse));
    if (!adds_nothing(light.specular))
      lines.push_back(line(LedgerTerm::specular, light.specular, highlight_colour(source), colours.specular));
  }
  if (lines.empty())
    lines.push_back({level, LedgerTerm::light,
                     fmt::format("{}: {}", name, light_effect_text(scene, light, LightWords::whole)), black, index,
                     name});
  return lines;
}

/// Terms are computed in double from numbers that the kernel rounded; they agree to float precision.
bool adds_up(const std::vector<LedgerLine>& lines, const Vec3d& total) {
  Vec3d sum = black;
  double scale = 0;
  for (const LedgerLine& line : lines) {
    sum += line.value;
    scale += std::abs(line.value.x) + std::abs(line.value.y) + std::abs(line.value.z);
  }
  const Vec3d rest = sum - total;
  return std::abs(rest.x) + std::abs(rest.y) + std::abs(rest.z) <= 1e-5 * std::max(scale, 1e-3);
}

/// The light at a vertex of the triangle, or at its centre, as it reaches the fragment, and its terms.
std::vector<LedgerLine> terms_of_point(const PixelStory& story, const Scene& scene, const SurfaceColours& colours,
                                       const ShadingEvents& shading, int index, double share, int level) {
  const auto& point = event_as<VertexLightEvent>(story.events, index);
  const double part = share * point.weight;
  std::vector<LedgerLine> terms;
  for (const int light : shading.lights)
    if (story.events[static_cast<std::size_t>(light)].parent == index)
      for (LedgerLine& line : terms_of_light(story, scene, colours, light, part, level + 1))
        terms.push_back(std::move(line));
  const Vec3d highlight = highlight_of_point(story, scene, index);
  std::string text = share_prefix(share) + point_name(point) + ": ";
  if (point.vertex) text += fmt::format("weight {} x ", number_text(point.weight));
  text += "light " + light_text(point.light + point.extra);
  if (highlight != black) text += fmt::format(" (of which highlight {})", light_text(highlight));
  text += " x " + vector_text(colours.diffuse);
  const Vec3d value = part * (point.light * colours.diffuse + point.extra);
  std::vector<LedgerLine> lines{{level, LedgerTerm::point, std::move(text), value, index}};
  if (adds_up(terms, value)) lines.insert(lines.end(), terms.begin(), terms.end());
  return lines;
}

std::vector<LedgerLine> all_light_at_once(const PixelStory& story, const ShadingEvents& shading, double share,
                                          int level) {
  const auto& shade = event_as<ShadeEvent>(story.events, shading.shade);
  std::vector<LedgerLine> lines;
  const Vec3d product = shade.local - shade.extra;
  const std::string light = shade.light == Vec3d{1, 1, 1} ? "" : vector_text(shade.light) + " of light x ";
  lines.push_back({level, LedgerTerm::all_light,
                   fmt::format("{}{}surface colour {}", share_prefix(share), light, vector_text(shade.surface)),
                   share * product, shading.shade});
  if (shade.extra != black)
    lines.push_back({level, LedgerTerm::extra_light, share_prefix(share) + "light with a colour of its own",
                     share * shade.extra, shading.shade});
  return lines;
}

}  // namespace

std::string point_name(const VertexLightEvent& point) {
  return point.vertex ? fmt::format("vertex {}", *point.vertex) : std::string("centre of the triangle");
}

Vec3d highlight_of_point(const PixelStory& story, const Scene& scene, int index) {
  const auto& point = event_as<VertexLightEvent>(story.events, index);
  const SurfaceColours colours = surface_colours(scene, point.id, {1, 1, 1});
  Vec3d sum = black;
  for (int i = index + 1; i < static_cast<int>(story.events.size()); ++i) {
    const Event& event = story.events[static_cast<std::size_t>(i)];
    if (event.parent < index) break;
    const auto* light = std::get_if<LightEvent>(&event.data);
    if (!light || event.parent != index || adds_nothing(light->specular)) continue;
    sum += light->specular * highlight_colour(light_of(scene, light->light)) * colours.specular;
  }
  return sum;
}

std::vector<LedgerLine> light_terms(const PixelStory& story, const Scene& scene, const ShadingEvents& shading,
                                    double share, int level) {
  const auto& shade = event_as<ShadeEvent>(story.events, shading.shade);
  const SurfaceColours colours = surface_colours(scene, shading.id, shade.surface);
  std::vector<LedgerLine> lines, of_level;
  for (const int index : shading.points) {
    const std::vector<LedgerLine> terms = terms_of_point(story, scene, colours, shading, index, share, level);
    of_level.push_back(terms.front());
    lines.insert(lines.end(), terms.begin(), terms.end());
  }
  if (!lines.empty() && adds_up(of_level, share * shade.local)) return lines;
  lines.clear();
  for (const int index : shading.lights)
    for (LedgerLine& line : terms_of_light(story, scene, colours, index, share, level))
      lines.push_back(std::move(line));
  if (!lines.empty() && adds_up(lines, share * shade.local)) return lines;
  return all_light_at_once(story, shading, share, level);
}

}  // namespace ps
