#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

enum class LeftOutKind {
  objects,  ///< some are not in the picture
  effect    ///< they are, but without something that the settings ask for
};

enum class BriefVerb {
  leaves_out,  ///< "leaves out" stands before the words
  own          ///< the words have a verb of their own
};

/// A few words on what is left out: "CSG" with "leaves out", or "rounds places in float".
struct LeftOutBrief {
  BriefVerb verb = BriefVerb::own;
  std::string words;

  bool operator==(const LeftOutBrief&) const = default;
};

/// With its verb: "leaves out CSG".
std::string brief_text(const LeftOutBrief& brief);
std::vector<std::string> brief_texts(const std::vector<LeftOutBrief>& briefs);

/// A setting that shows what is left out.
struct Remedy {
  std::string label;    ///< for a button: "Shadow map"
  std::string setting;  ///< "shadows=map"
};

/// Something of a scene that a renderer cannot show.
struct LeftOut {
  LeftOutKind kind = LeftOutKind::objects;
  LeftOutBrief brief;
  std::string sentence;  ///< a whole one, with the reason and what shows it
  std::string notice;    ///< for the line under the picture: "No shadows: traced shadows need rays."
  std::vector<Remedy> remedies;
};

/// That the surfaces of the picture get no light, and why; nullopt if they get some or need none. `subject` names the
/// renderer at the beginning of a sentence.
std::optional<LeftOut> missing_light(const SceneTraits& traits, const Settings& settings, std::string_view subject);

/// Would the picture have shadows, or reflections of the scene, if its renderer could make them?
bool asks_for_shadows(const SceneTraits& traits, const Settings& settings);
bool asks_for_reflections(const SceneTraits& traits, const Settings& settings);

}  // namespace ps
