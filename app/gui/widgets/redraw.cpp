#include "gui/widgets/redraw.h"

#include <algorithm>

namespace ps::gui {
namespace {
double wish = -1;
}

void redraw_after(double seconds) { wish = wish < 0 ? seconds : std::min(wish, seconds); }

double take_redraw_wish() {
  const double result = wish;
  wish = -1;
  return result;
}

}  // namespace ps::gui
