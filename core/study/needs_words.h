#pragma once
#include <span>
#include <string>
#include <string_view>

#include "study/needs.h"

namespace ps {

/// "The scene 'Crates'": a scene's name as the subject of a sentence. Of a path the last part without its extension.
std::string scene_subject(std::string_view scene_name);

/// What the scene needs, in at most three sentences: "The scene 'Crates' needs lighting and shadows. It can do without
/// vertex normals; it has nothing to reflect or refract. Textures are off." A feature is needed if is_needed() says so.
/// Empty until every feature was tried.
std::string needs_sentence(std::string_view scene_name, const Needs& needs);

/// The features that are not used, those with the same reason together: "Not in use: textures (the scene has no
/// texture); shadows and highlights (needs lighting = on)." Empty where all are used.
std::string unused_sentence(std::span<const FeatureShare> shares);

/// Why the advice is to keep the settings.
std::string keep_sentence();
/// Said where Needs::within_tolerance is false.
std::string not_enough_sentence(const Needs& needs);
/// How far the settings as they are lie from the truth, and what that is.
std::string truth_sentence(const Needs& needs);

/// How visible a difference of that worst_tile_flip() is: "no difference", "hard to see", "visible" or "obvious".
std::string_view tolerance_words(double tolerance);

}  // namespace ps
