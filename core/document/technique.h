#pragma once
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "document/document.h"
#include "options/settings.h"

namespace ps {

/// Settings as "key=value", by the way in which a picture is made. Empty for a way that does not know the technique.
struct TechniqueSettings {
  std::vector<std::string_view> rays, fragments;
};

/// One comparison: the settings that A and B get. All others are equal in both.
struct TechniqueChoice {
  std::string_view key;    ///< unique within the technique: "gouraud"
  std::string_view label;  ///< "Gouraud"
  TechniqueSettings a, b;
};

/// A technique as people name it, and the comparisons that show what it does: A with it, and B = A except this.
struct Technique {
  std::string_view key;                  ///< unique: "shadows"
  std::string_view label;                ///< "Shadows"
  std::string_view with = {};            ///< A of a switch: "with shadows"; empty where B has a choice
  std::string_view help;                 ///< one sentence about the thing to look for
  std::string_view keywords;             ///< other words that people search for, separated by commas
  std::vector<TechniqueChoice> choices;  ///< one for a switch; more where B has a choice
  std::vector<std::string_view> scenes;  ///< built-in scenes that show it, the best first
};

/// All techniques, in the order in which they are shown.
std::span<const Technique> technique_table();
/// The row with this key, or nullptr.
const Technique* find_technique(std::string_view key);

/// The settings of both pictures of a comparison.
struct TechniquePair {
  Settings a, b;
};

/// The comparison that follows from the settings that A has: with its renderer, or else with the first that knows the
/// technique; what the technique needs beside its own settings is set in both. nullopt where scene or computer cannot
/// show it.
std::optional<TechniquePair> technique_pair(const TechniqueChoice& choice, const Settings& now,
                                            const SceneTraits& traits);

/// A row and its choice, both by their place.
struct ShownTechnique {
  std::size_t technique = 0, choice = 0;
  bool operator==(const ShownTechnique&) const = default;
};
/// The comparison that a document shows, however it came about; nullopt for any other pair of pictures.
std::optional<ShownTechnique> shown_technique(const Document& document, const SceneTraits& traits);

/// What A and B of a shown comparison are called: "with shadows", "without shadows"; "Phong", "Flat".
std::array<std::string_view, 2> technique_words(const Document& document, const ShownTechnique& shown);

/// The document that shows a comparison: the scene as it is, or the first of the technique's own scenes where this one
/// cannot show it. It keeps the one before the first of several comparisons in a row. `load` reads a built-in scene.
/// Throws InputError where no scene shows it on this computer, and what `load` throws.
Document with_technique(const Document& now, const Technique& technique, const TechniqueChoice& choice,
                        const std::function<Scene(const std::string& name)>& load);
/// The document before the first of the comparisons, in the window as it is divided now; where there is none, B becomes
/// as A is.
Document without_technique(const Document& now);

}  // namespace ps
