#pragma once
#include <string>
#include <variant>
#include <vector>

#include "engine/figure.h"
#include "support/refusal.h"

namespace ps::test {

/// The figure of these lines of a lesson.
inline Figure figure_of(const std::string& lines) { return read_figure("alt Words.\n" + lines, "lesson.md", 10); }

/// The fault of a description whose first line is line 10.
inline std::string figure_fault(const std::string& lines) {
  return refusal_of([&] { read_figure(lines, "lesson.md", 10); });
}

/// The marks of one kind.
template <class Mark>
std::vector<Mark> marks_of(const Figure& figure) {
  std::vector<Mark> marks;
  for (const FigureMark& mark : figure.marks)
    if (const auto* one = std::get_if<Mark>(&mark)) marks.push_back(*one);
  return marks;
}

}  // namespace ps::test
