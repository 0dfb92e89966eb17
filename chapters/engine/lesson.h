#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/check.h"
#include "base/counters.h"
#include "document/document.h"
#include "engine/text.h"
#include "inspect/predict.h"

/// A lesson is a folder in chapters/ with a lesson.md; CONTRIBUTING.md describes its form.

namespace ps {

/// The stage of a step that needs no tool: its pictures have all the place.
inline constexpr std::string_view pictures_stage = "pictures";

/// One part of a document as a permalink names it: "camera", "edit.light.0.position", "gain".
struct StatePart {
  std::string key, value;
  bool operator==(const StatePart&) const = default;
};

/// What a step puts on the screen. Everything starts from the scene's own settings, so that each step can be shown
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

/// A number that can be measured on the pictures A and B of a state.
enum class ClaimMetric {
  differing_pixels,     ///< pixels whose display levels differ between A and B
  mean_difference,      ///< mean absolute difference of A and B, display levels
  max_difference,       ///< largest difference of one channel, display levels
  counter_a,            ///< a Counter of A; the claim's argument names it
  counter_b,            ///< the same of B
  false_shadow_pixels,  ///< pixels of A in a shadow that is not there in double precision without self-hits
  red_a,                ///< display levels of the picked pixel
  green_a,
  blue_a,
  red_b,
  green_b,
  blue_b,
  object_a,  ///< index of the object that the picked pixel shows; -1 = background
  object_b,
  triangle_a,
  triangle_b
};

enum class ClaimBound { at_least, at_most, equals };

/// A statement of a lesson that a test checks: a measured number keeps a bound, and no longer does once one option is
/// set back to its default on both sides (the mutation), so that the option is what makes it true.
struct Claim {
  std::string text;
  LessonState state;
  ClaimMetric metric = ClaimMetric::differing_pixels;
  Counter counter = Counter::eye_rays;  ///< metrics counter_a and counter_b only
  ClaimBound bound = ClaimBound::at_least;
  double number = 0;
  std::string mutation;  ///< key of the option that is reset
  SourcePlace place;
};

/// A question that a step asks about its pixel before the inspector shows its story.
struct Prediction {
  Question question = Question::colour;
  std::string text;  ///< as the step puts it
};

struct LessonStep {
  std::string title;
  std::vector<TextBlock> blocks;
  std::vector<TextBlock> hints;  ///< what to look for
  LessonState state;
  std::vector<Claim> claims;
  std::optional<Prediction> prediction;
};

struct Lesson {
  std::string name;  ///< the folder
  std::string title;
  std::string source;             ///< "CGFS chapter 4"
  std::vector<TextBlock> blocks;  ///< what introduces it
  std::vector<LessonStep> steps;
};

/// Names of all lessons, in the order of their folders.
std::vector<std::string> lesson_names();
/// Where a step is.
struct LessonPlace {
  std::string lesson;  ///< the folder
  int step = 0;        ///< from 0
  bool operator==(const LessonPlace&) const = default;
};
/// Reads "NAME" or "NAME/STEP", with STEP from 1. Throws InputError for an unknown lesson (naming the nearest) and for
/// what is no step's number; whether the lesson has so many steps is not checked.
LessonPlace parse_lesson_place(std::string_view text);

/// Reads the lesson of that name. Throws InputError for an unknown name (naming the nearest) or a faulty file.
Lesson load_lesson(const std::string& name);
/// Reads the text of a lesson.md. `file` is only for messages.
Lesson parse_lesson(std::string_view text, const std::string& name, const std::string& file);

/// The document that step `step` of the lesson puts on the screen, with the layout and, where it is the same, the
/// loaded scene of `now`. Throws InputError when the scene cannot be loaded.
Document lesson_document(const Lesson& lesson, int step, const Document& now);

/// The document that a permalink encodes, with its scene. A permalink that names a lesson and no scene is one of the
/// lesson's step ("lesson=cgfs_03_light&step=2", with steps from 0). Throws InputError as parse_permalink() does, and
/// when the scene or the lesson cannot be loaded.
Document linked_document(std::string_view link);

/// A document for a state alone. Throws InputError when the scene cannot be loaded or a part does not fit it.
Document state_document(const LessonState& state, const Document& now);

/// Changes the document by what `change` sets beside a scene: settings and parts. Throws InputError for a part that
/// does not fit the document's scene, which is then left as it was.
void change_document(const LessonState& change, Document& document);

}  // namespace ps
