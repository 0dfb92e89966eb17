#pragma once
#include <imgui.h>

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "textbook/listing_source.h"

namespace ps::gui {

/// What a question for the wrong line of a listing, or a step that asks for a routine, needs of its lines.
struct LineMarks {
  int* answer = nullptr;          ///< where a clicked line's number goes while the question is open; it may be null
  std::optional<BugLine> marked;  ///< the wrong line, once that may be shown
  std::map<int, std::string> faults{};  ///< what a compiler says of lines, by their numbers
  std::string elsewhere{};              ///< what it says of no line that is shown
  int first = 0;                        ///< number of the line to look at first; 0 = as the rest says
  std::string routine{};                ///< name of the one to look at first; empty = that of the first values
  int within = 0;                       ///< number of a line whose routine is looked at first, unless one is named
  std::string remark{};                 ///< above the code, and scrolled with it; may be empty
  /// Can the picture show this value of the trace, or component of it, for every pixel? May be empty: it shows none.
  std::function<bool(int watch, int component)> can_show{};
};

/// The ground of a line: a click on it answers the open question. Leaves the cursor where it was.
void line_ground(int number, ImVec2 size, const LineMarks& marks);

/// The line as it should be, below the wrong one: text from the column `left` on, at most as wide as there is room.
void right_version(const BugLine& line, float left);

/// What a compiler says of a line, below it: text from the column `left` on.
void line_fault(int number, const std::string& text, float left);

}  // namespace ps::gui
