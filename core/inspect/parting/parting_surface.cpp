#include "inspect/parting/fragment_fate.h"
#include "inspect/parting/parting_parts.h"
#include "record/value_text.h"
#include "render/story/names.h"
#include "render/story/story_tree.h"

namespace ps::parting {
namespace {

bool same_texels(const StoryPair& c, const TextureEvent& a, const TextureEvent& b) {
  if (a.texels.size() != b.texels.size()) return false;
  for (std::size_t i = 0; i < a.texels.size(); ++i) {
    const Texel &x = a.texels[i], &y = b.texels[i];
    if (x.x != y.x || x.y != y.y || x.level != y.level || !c.same(x.weight, y.weight)) return false;
  }
  return true;
}

const FragmentEvent* fragment_of(const StoryPair& c, const Sighting& a, const Sighting& b) {
  if (const auto* fragment = event_at<FragmentEvent>(c.a.story, a.seen)) return fragment;
  return event_at<FragmentEvent>(c.b.story, b.seen);
}

/// The first key of the list that can explain a difference, if any.
std::optional<std::string_view> first_explaining(const StoryPair& c, std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys)
    if (explains(c, key)) return key;
  return std::nullopt;
}

/// Light comes out differently although nothing is in its way: which rule of light, normals or interpolation differs.
Parting light_differs(const StoryPair& c, int event_a, int event_b, const Sighting& a, const Sighting& b,
                      const std::string& what) {
  const auto says = [&](PartingCause cause, const std::string& why) {
    return Parting{cause, what + why + ".", event_a, event_b};
  };
  if (const auto key = first_explaining(
          c, {"shading", "normals", "normal-transform", "renormalise", "normal-mapping", "mapped-normals"}))
    return says(PartingCause::shading_position, because(c, {*key}));
  if (const auto key =
          first_explaining(c, {"lighting", "illumination", "highlight", "diffuse", "specular", "attenuation"}))
    return says(PartingCause::light_model, because(c, {*key}));
  if (explains(c, "interpolation")) return says(PartingCause::interpolation, because(c, {"interpolation"}));
  if (explains(c, "precision")) return says(PartingCause::precision, because(c, {"precision"}));
  if (const Option* option = differing_option(c, {"Shading"}))
    return says(PartingCause::light_model, because(c, option));
  if (c.two_ways() && !because(c, {"tessellation"}).empty())
    return says(PartingCause::tessellation, because(c, {"tessellation"}));
  if (const Option* option = differing_in_what_is_seen(c))
    return says(PartingCause::shading_position, because(c, option));
  if (c.two_rasterizers())
    return says(PartingCause::interpolation, ": the two renderers interpolate with arithmetic of their own");
  if (c.two_ways()) {
    const FragmentEvent* fragment = fragment_of(c, a, b);
    if (fragment && is_tessellated(c.scene, fragment->id))
      return says(PartingCause::tessellation,
                  ": the ray shades a point of the exact surface, the fragment a point of a flat triangle");
    return says(PartingCause::shading_position, ": ray and fragment shade slightly different points");
  }
  return says(PartingCause::unexplained, ", unexplained");
}

/// Rays trace shadows whatever algorithm the option names; fragments have no rays to trace.
bool computes_shadows(const StorySide& side) {
  const Shadows shadows = side.settings.shadows;
  return shadows != Shadows::none && (sends_rays(side.story.renderer) || shadows != Shadows::traced);
}

/// An option that decides whether a light reaches the point, or which point it is.
const Option* differing_for_shadows(const StoryPair& c) {
  if (const Option* option = differing_option(c, {"Shadows"})) return option;
  if (const Option* option = differing_in_what_is_seen(c)) return option;
  return differing_option(c, {"Shading"});
}

std::optional<Parting> part_at_blocker(const StoryPair& c, int index_a, int index_b) {
  const auto& a = event_as<LightEvent>(c.a.story.events, index_a);
  const auto& b = event_as<LightEvent>(c.b.story.events, index_b);
  if (a.blocker.has_value() == b.blocker.has_value()) return std::nullopt;
  // A light that the surface faces away from adds nothing, blocked or not.
  if (c.same(a.diffuse, b.diffuse) && c.same(a.specular, b.specular)) return std::nullopt;
  const bool in_a = a.blocker.has_value();
  const PixelId blocker = in_a ? *a.blocker : *b.blocker;
  const std::string light = light_name(c.scene, a.light);
  const std::string text = fmt::format("{} is blocked by {} in {} and reaches the point in {}", light,
                                       primitive_name(c.scene, blocker), in_a ? "A" : "B", in_a ? "B" : "A");
  const auto says = [&](PartingCause cause, const std::string& why) {
    return Parting{cause, text + why + ".", index_a, index_b};
  };
  if (explains(c, "shadows")) return says(PartingCause::missing_shadow, because(c, {"shadows"}));
  if (c.a.story.renderer != c.b.story.renderer) {
    const Option* option = c.with_listing() ? nullptr : differing_for_shadows(c);
    if (option) return says(PartingCause::missing_shadow, because(c, option));
    if (c.with_listing()) return says(PartingCause::missing_shadow, ": only one of the two renderers computes shadows");
    for (const StorySide* side : {&c.a, &c.b})
      if (!computes_shadows(*side))
        return says(PartingCause::missing_shadow,
                    fmt::format(": only one of the two renderers computes shadows, for shadows is {} in {}",
                                option_text(*find_option("shadows"), side->settings), side == &c.a ? "A" : "B"));
    return says(PartingCause::missing_shadow, ": the renderers compute shadows with different algorithms");
  }
  if (const auto key = first_explaining(c, {"self-hit", "shadow-epsilon", "epsilon-unit"}))
    return says(PartingCause::epsilon, because(c, {*key}));
  if (const auto key = first_explaining(c, {"precision", "sphere-test", "triangle-test", "triangle-epsilon"}))
    return says(PartingCause::precision, because(c, {*key}));
  return says(PartingCause::unexplained, ", unexplained");
}

/// A shadow map or shadow volume covers the point in one picture only, or more of the point.
std::optional<Parting> part_at_shadow(const StoryPair& c, int index_a, int index_b) {
  const auto& a = event_as<LightEvent>(c.a.story.events, index_a);
  const auto& b = event_as<LightEvent>(c.b.story.events, index_b);
  if (c.same(a.visible, b.visible) || (c.same(a.diffuse, b.diffuse) && c.same(a.specular, b.specular)))
    return std::nullopt;
  const auto reaches = [](double visible) {
    return visible > 0 ? fmt::format("{} %", number_text(100 * visible)) : std::string("0 %");
  };
  const std::string text = fmt::format("{}: {} of it reaches the point in A and {} in B", light_name(c.scene, a.light),
                                       reaches(a.visible), reaches(b.visible));
  const auto says = [&](PartingCause cause, const std::string& why) {
    return Parting{cause, text + why + ".", index_a, index_b};
  };
  if (const auto key = first_explaining(c, {"shadows", "shadow-samples", "shadow-pattern", "volume-caps",
                                            "volume-length", "volume-depth-clamp", "stencil-bits", "shadow-map-size",
                                            "shadow-bias", "shadow-slope-bias", "shadow-filter", "near", "far"}))
    return says(PartingCause::missing_shadow, because(c, {*key}));
  if (const Option* option = differing_for_shadows(c)) return says(PartingCause::missing_shadow, because(c, option));
  if (c.two_rasterizers()) return says(PartingCause::missing_shadow, ": the two renderers round differently");
  if (c.two_ways()) {
    const bool maps = c.a.settings.shadows == Shadows::map && c.b.settings.shadows == Shadows::map;
    return says(PartingCause::missing_shadow,
                maps ? ": ray and fragment look up slightly different points of the shadow map"
                     : ": the renderers compute shadows with different algorithms");
  }
  return std::nullopt;
}

}  // namespace

std::optional<Parting> part_at_texture(const StoryPair& c, const Sighting& a, const Sighting& b) {
  if (a.textures.empty() && b.textures.empty()) return std::nullopt;
  if (a.textures.empty() || b.textures.empty())
    return Parting{PartingCause::texture,
                   fmt::format("Only {} reads a texture{}.", a.textures.empty() ? "B" : "A", because(c, {"textures"})),
                   a.textures.empty() ? a.seen : a.textures.front(), b.textures.empty() ? b.seen : b.textures.front()};
  const int index_a = a.textures.front(), index_b = b.textures.front();
  const auto& read_a = event_as<TextureEvent>(c.a.story.events, index_a);
  const auto& read_b = event_as<TextureEvent>(c.b.story.events, index_b);
  if (c.same(read_a.result, read_b.result)) return std::nullopt;
  const auto says = [&](PartingCause cause, const std::string& text) {
    return Parting{cause, text + ".", index_a, index_b};
  };
  if (explains(c, "interpolation"))
    return says(PartingCause::interpolation,
                fmt::format("The texture is read at ({}, {}) in A and at ({}, {}) in B", number_text(read_a.uv.x),
                            number_text(read_a.uv.y), number_text(read_b.uv.x), number_text(read_b.uv.y)) +
                    because(c, {"interpolation"}));
  const bool texels_known = !read_a.texels.empty() && !read_b.texels.empty();
  if (explains(c, "texture-filter") || explains(c, "texture-wrap") || explains(c, "anisotropy"))
    return says(PartingCause::filter,
                (texels_known ? fmt::format("A blends {} texels and B {}", read_a.texels.size(), read_b.texels.size())
                              : std::string("A and B filter the texture differently")) +
                    because(c, {"texture-filter", "texture-wrap", "anisotropy"}));
  const Option* seen = differing_in_what_is_seen(c);
  if (!c.same(read_a.level, read_b.level)) {
    std::string why = because(c, {"mip-bias", "renderer"});
    if (why.empty()) why = because(c, seen);
    return says(
        PartingCause::level,
        fmt::format("A reads mip level {} and B level {}", number_text(read_a.level), number_text(read_b.level)) + why);
  }
  if (explains(c, "precision"))
    return says(PartingCause::precision, "The texels' weights differ" + because(c, {"precision"}));
  if (!texels_known)
    return says(
        PartingCause::filter,
        fmt::format("The texture is {} in A and {} in B: the two renderers filter it with arithmetic of their own",
                    vector_text(read_a.result), vector_text(read_b.result)));
  if (!same_texels(c, read_a, read_b)) {
    const Option* option = differing_option(c, {"Textures"});
    if (!option) option = seen;
    return says(PartingCause::filter, "A and B read different texels" + because(c, option));
  }
  return says(PartingCause::unexplained, "Unexplained: the same texels give different colours");
}

std::optional<Parting> part_at_light(const StoryPair& c, const Sighting& a, const Sighting& b) {
  const LightPlaces places = light_places(c, a, b);
  if (places.differ && places.same_light) return std::nullopt;
  if (a.lights.size() != b.lights.size())
    return light_differs(
        c, a.seen, b.seen, a, b,
        places.differ ? places.text
                      : fmt::format("A evaluates {} lights and B {} lights here", a.lights.size(), b.lights.size()));
  for (std::size_t i = 0; i < a.lights.size(); ++i) {
    if (auto found = part_at_blocker(c, a.lights[i], b.lights[i])) return found;
    if (auto found = part_at_shadow(c, a.lights[i], b.lights[i])) return found;
    const auto& light_a = event_as<LightEvent>(c.a.story.events, a.lights[i]);
    const auto& light_b = event_as<LightEvent>(c.b.story.events, b.lights[i]);
    if (c.same(light_a.diffuse, light_b.diffuse) && c.same(light_a.specular, light_b.specular)) continue;
    return light_differs(c, a.lights[i], b.lights[i], a, b,
                         places.differ ? places.text
                                       : fmt::format("{} adds {} in A and {} in B", light_name(c.scene, light_a.light),
                                                     number_text(light_a.diffuse + light_a.specular),
                                                     number_text(light_b.diffuse + light_b.specular)));
  }
  const auto* shade_a = event_at<ShadeEvent>(c.a.story, a.shade);
  const auto* shade_b = event_at<ShadeEvent>(c.b.story, b.shade);
  if (shade_a && shade_b && !(c.same(shade_a->light, shade_b->light) && c.same(shade_a->extra, shade_b->extra)))
    return light_differs(
        c, a.shade, b.shade, a, b,
        fmt::format("The light is {} in A and {} in B", vector_text(shade_a->light), vector_text(shade_b->light)));
  return std::nullopt;
}

}  // namespace ps::parting
