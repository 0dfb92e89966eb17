#pragma once
#include "inspect/microscope/microscope.h"
#include "record/story.h"

namespace ps {

/// The event with the outcome of a triangle in the microscope: its fragment, or the reason for its rejection. -1 if the
/// story has none.
int event_of_triangle(const PixelStory& story, const MicroTriangle& triangle);

/// The triangle under the microscope that an event, or what it belongs to, is about: an index into
/// MicroReading::triangles; -1 if it is about none of them.
int triangle_of_event(const PixelStory& story, const MicroReading& reading, int event);

}  // namespace ps
