#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document/document.h"
#include "engine/claim.h"
#include "engine/question.h"
#include "engine/state.h"
#include "engine/text.h"

/// A lesson is a folder in chapters/ with a lesson.md; chapters/README.md describes its form.

namespace ps {

struct LessonStep {
  std::string title;
  std::vector<TextBlock> blocks;
  std::vector<TextBlock> hints;  ///< what to look for
  std::vector<TextBlock> notes;  ///< for the teacher alone
  LessonState state;
  std::vector<Claim> claims;
  std::optional<LessonQuestion> question;
  std::string write;  ///< the routine of the lesson's listing that the student is to write; empty = none
};

struct Lesson {
  std::string name;  ///< the folder
  std::string title;
  std::string source;             ///< "CGFS chapter 4"
  std::string renderer;           ///< key of one that not every program has, if the lesson needs it
  std::vector<TextBlock> blocks;  ///< what introduces it
  std::vector<TextBlock> goals;   ///< each completes the sentence "You can now ..."
  std::vector<TextBlock> notes;   ///< for the teacher alone, about the lesson as a whole
  std::vector<LessonStep> steps;
};

/// The folders of chapters/ that hold a lesson.md, in alphabetical order.
std::vector<std::string> lesson_folders();
/// Names of all lessons that this program can show: in the order of the course, and behind it those that are not in it.
/// If the course cannot be read, in that of lesson_folders(). Read once, after all renderers were added.
const std::vector<std::string>& lesson_names();

/// A lesson about a renderer that this program was built without.
struct LeftOutLesson {
  std::string name, renderer;
};
const std::vector<LeftOutLesson>& lessons_left_out();

/// Why this machine cannot show what the lesson needs, such as a graphics driver that is missing; nullopt if it can.
std::optional<std::string> why_not_here(const Lesson& lesson);
/// Where a step is.
struct LessonPlace {
  std::string lesson;  ///< the folder
  int step = 0;        ///< from 0
  bool operator==(const LessonPlace&) const = default;
};
/// Reads "NAME" or "NAME/STEP", with STEP from 1. Throws InputError for an unknown lesson (naming the nearest) and for
/// what is not the number of a step; whether the lesson has that many steps is not checked.
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

}  // namespace ps
