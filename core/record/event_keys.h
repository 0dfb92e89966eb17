#pragma once
#include <string_view>

#include "base/enumerators.h"
#include "options/choice_key.h"

namespace ps {

/// Enumerators of events as keys for files: "before-range". Those that an option sets have keys of the option table.
template <class Enum>
std::string_view event_key(Enum value) {
  return enumerator_key(value);
}
inline std::string_view event_key(CanvasFill fill) { return choice_key<&Settings::canvas_fill>(fill); }
inline std::string_view event_key(Coverage strategy) { return choice_key<&Settings::coverage>(strategy); }

}  // namespace ps
