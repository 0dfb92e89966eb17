#include "study/features.h"

#include <array>

#include "base/check.h"
#include "options/option.h"
#include "options/renderer_kind.h"

namespace ps {
namespace {

constexpr std::array<Feature, 8> table{{
    {"lighting", "Lighting", "lighting", "no light", "lighting", "off"},
    {"shadows", "Shadows", "shadows", "no shadows", "shadows", "none"},
    {"highlights", "Highlights", "highlights", "no highlights", "specular", "off"},
    {"reflection", "Reflected and refracted rays", "reflected rays", "", "reflection-depth", "0", "reflect"},
    {"refraction", "Refraction", "refraction", "", "refraction", "off", "refract"},
    {"attenuation", "Attenuation", "attenuation", "no attenuated light", "attenuation", "off"},
    {"textures", "Textures", "textures", "no textures", "textures", "off"},
    {"vertex-normals", "Vertex normals", "vertex normals", "no vertex normals", "normals", "triangle"},
}};

/// Of each option the cheapest value first.
const std::array<Saving, 31>& all_savings() {
  static const std::array<Saving, 31> all{{
      {"renderer", renderer_kind(renderer_for(PictureWay::fragments)).key},
      {"lighting", "off"},
      {"shadows", "none"},
      {"specular", "off"},
      {"shadow-rays", "useful"},
      {"reflection-depth", "0"},
      {"reflection-depth", "1"},
      {"reflection-depth", "2"},
      {"reflection-depth", "3"},
      {"reflection-depth", "4"},
      {"reflection-depth", "5"},
      {"reflection-depth", "6"},
      {"reflection-depth", "8"},
      {"reflection-depth", "12"},
      {"reflection-cutoff", "0.1"},
      {"reflection-cutoff", "0.05"},
      {"reflection-cutoff", "0.02"},
      {"refraction", "off"},
      {"transparency", "fixed"},
      {"attenuation", "off"},
      {"textures", "off"},
      {"texture-filter", "nearest"},
      {"texture-filter", "bilinear"},
      {"texture-filter", "mipmap"},
      {"normals", "triangle"},
      {"shading", "flat"},
      {"shading", "gouraud"},
      {"samples-per-pixel", "1"},
      {"samples-per-pixel", "4"},
      {"samples-per-pixel", "16"},
      {"precision", "float"},
  }};
  return all;
}

const Option& row(std::string_view key) {
  const Option* option = find_option(key);
  PS_ASSERT(option != nullptr, "a feature names an option of the table");
  return *option;
}

/// Place of a value among the savings of its option: cheaper ones come first. Past the end if it is none.
std::size_t rank(const Option& option, std::string_view value) {
  for (std::size_t i = 0; i < all_savings().size(); ++i)
    if (all_savings()[i].option == option.key && all_savings()[i].value == value) return i;
  return all_savings().size();
}

/// Is it cheaper than what is set now? Only then is it a saving, and no search goes in circles.
bool is_less(const Option& option, const Settings& now, const Settings& then) {
  if (option.key == "reflection-cutoff") return option.get(then) > option.get(now);  // more is left out
  if (option.kind == OptionKind::integer || option.kind == OptionKind::real) return option.get(then) < option.get(now);
  return rank(option, option_text(option, then)) < rank(option, option_text(option, now));
}

}  // namespace

std::span<const Feature> features() { return table; }

Settings without(const Feature& feature, const Settings& settings) {
  Settings less = settings;
  parse_option(row(feature.option), feature.off, less);
  return less;
}

std::optional<IdleReason> unused_reason(const Feature& feature, const Settings& settings, const SceneTraits& traits) {
  const Option& option = row(feature.option);
  if (const auto reason = inactive_reason(option, settings, traits)) return reason;
  if (option.kind == OptionKind::choice)  // such as stencil shadows of a ray tracer
    if (const Choice& choice = chosen(option, settings); choice.inactive)
      if (const auto reason = choice.inactive(settings, traits)) return reason;
  if (option.key == "shadows" && settings.shadows == Shadows::traced &&
      picture_way(settings.renderer) == PictureWay::fragments)
    return needs("shadows", Shadows::map, Shadows::stencil_depth_fail).because("fragments have no shadow rays");
  if (without(feature, settings) == settings) return "off already";
  return {};
}

bool never_used(const Feature& feature, const SceneTraits& traits) {
  return inactive_reason(row(feature.option), Settings{}, traits).has_value();
}

std::vector<Saving> savings(const Settings& settings, const SceneTraits& traits) {
  std::vector<Saving> usable;
  const TextureFilter filter = settings.texture_filter;
  const bool finest_only = sends_rays(settings.renderer) && filter != TextureFilter::nearest;
  for (const Saving& saving : all_savings()) {
    const Option* option = find_option(saving.option);
    if (!option || inactive_reason(*option, settings, traits)) continue;
    Settings then = settings;
    parse_option(*option, saving.value, then);
    if (finest_only && then.texture_filter != filter && then.texture_filter != TextureFilter::nearest)
      continue;  // to rays, all other filters are one
    if (is_less(*option, settings, then)) usable.push_back(saving);
  }
  return usable;
}

}  // namespace ps
