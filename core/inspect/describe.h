#pragma once
#include <string>
#include <vector>

#include "record/events.h"
#include "scene/scene.h"

namespace ps {

/// One line of a table about an event.
struct FieldText {
  std::string name;   ///< "shading normal"
  std::string value;  ///< numbers with four significant digits
  std::string exact;  ///< the same with all digits, for a tooltip and for copying
};

/// An event as a line of text: "light 2 (point): blocked by sphere 3 (blue)". Names come from the scene.
std::string describe(const Event& event, const Scene& scene);

/// All that is known about an event, as names and values: the fields of event_fields() of inspect/face_data.h.
std::vector<FieldText> event_table(const Event& event, const Scene& scene);

}  // namespace ps
