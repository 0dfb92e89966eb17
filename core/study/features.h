#pragma once
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "options/idle_reason.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

/// Something that a picture can do without, as a whole.
struct Feature {
  std::string_view name;    ///< "shadows"
  std::string_view label;   ///< "Shadows"
  std::string_view noun;    ///< within a sentence: "shadows"
  std::string_view absent;  ///< what a scene has that cannot use it: "no shadows"; empty: see `verb`
  std::string_view option;  ///< key of the option that switches it
  std::string_view off;     ///< the value without it
  std::string_view verb{};  ///< "reflect", where the scene cannot use it for lack of something to reflect
};
std::span<const Feature> features();

/// The settings without the feature.
Settings without(const Feature& feature, const Settings& settings);
/// Why the scene with these settings cannot use the feature (known from the scene alone, nothing is measured), or
/// nothing if it may show in the picture.
std::optional<IdleReason> unused_reason(const Feature& feature, const Settings& settings, const SceneTraits& traits);

/// Can the scene never use the feature, whatever the settings?
bool never_used(const Feature& feature, const SceneTraits& traits);

/// One way to make a picture more cheaply: a value of an option.
struct Saving {
  std::string_view option, value;
};
/// Every saving that can act: features left out, smaller depths and sample counts, cheaper filters, the other renderer.
std::vector<Saving> savings(const Settings& settings, const SceneTraits& traits);

}  // namespace ps
