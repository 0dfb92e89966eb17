#include "gui/theme/shade.h"

#include "image/svg.h"

namespace ps::gui {

ImVec4 shade(const Palette& palette, Role role) {
  switch (role) {
  case Role::ink:
    return palette.text;
  case Role::quiet:
    return palette.text_quiet;
  case Role::border:
    return palette.line_strong;
  case Role::faint:
    return palette.line;
  case Role::paper:
    return palette.field;
  case Role::a:
    return palette.a;
  case Role::b:
    return palette.b;
  case Role::right:
    return palette.right_mark;
  case Role::wrong:
    return palette.wrong_mark;
  case Role::attention:
    return palette.attention;
  case Role::light:
  case Role::mirror:
  case Role::dark:
  case Role::bright:  // the same everywhere
  case Role::own:     // paper_shade() ends the program
    break;
  }
  const Rgb8 same = paper_shade(role);
  return {static_cast<float>(same.r) / 255, static_cast<float>(same.g) / 255, static_cast<float>(same.b) / 255, 1};
}

}  // namespace ps::gui
