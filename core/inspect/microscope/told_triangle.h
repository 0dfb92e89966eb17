#pragma once
#include "inspect/microscope/microscope.h"
#include "record/story.h"

namespace ps {

/// The event of a fragments' story that tells what became of a triangle under the microscope: its fragment, or else
/// what kept it from the pixel. -1 where the story does not tell of it.
int event_of_triangle(const PixelStory& story, const MicroTriangle& triangle);

/// The triangle under the microscope that an event, or what it belongs to, is about: an index into
/// MicroReading::triangles; -1 if it is about none of them.
int triangle_of_event(const PixelStory& story, const MicroReading& reading, int event);

}  // namespace ps
