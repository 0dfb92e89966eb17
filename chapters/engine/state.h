#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "document/document.h"

/// The screen of a step of a lesson.

namespace ps {

/// The stage of a step that needs no tool: its pictures have all the place.
inline constexpr std::string_view pictures_stage = "pictures";

/// One part of a document as a permalink names it: "camera", "edit.light.0.position", "gain".
struct StatePart {
  std::string key, value;
  bool operator==(const StatePart&) const = default;
};

/// The screen of a step. Everything starts from the scene's own settings, so that each step can be shown
/// without those before it.
struct LessonState {
  std::string scene;  ///< name or path as load_scene takes it; "./x" in a lesson is a file beside it
  std::vector<std::string> set_a, set_b;  ///< "key=value", applied in order
  std::vector<StatePart> parts;           ///< all else that a permalink can hold, applied in order, each key once
  ScreenMode mode = ScreenMode::lesson;   ///< in which the step is shown, unless it is presented
  std::string stage;                      ///< the tool that it is about: as Layout::stage has it
};

/// The value of a part, or nullptr if the state leaves it as it is.
const std::string* part_of(const LessonState& state, std::string_view key);

/// Whether the state sets anything of the pictures: a scene, settings or parts.
bool changes_anything(const LessonState& state);

/// A document for a state alone. Throws InputError when the scene cannot be loaded or a part does not fit it.
Document state_document(const LessonState& state, const Document& now);

/// Changes the document by what `change` sets beside a scene: settings and parts. Throws InputError for a part that
/// does not fit the document's scene, which is then left as it was.
void change_document(const LessonState& change, Document& document);

}  // namespace ps
