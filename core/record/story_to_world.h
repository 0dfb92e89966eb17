#pragma once
#include <vector>

#include "record/events.h"
#include "scene/working_space.h"

namespace ps {

/// Turns what a kernel reported in a working space into world numbers: points, boxes and lengths. Ray parameters,
/// weights, cosines and places on the canvas are the same in both.
void story_to_world(const WorkingSpace& space, std::vector<Event>& events);

}  // namespace ps
