#pragma once
#include <optional>
#include <vector>

#include "record/field_query.h"

namespace ps {

/// The number of a story that a query asks for, as a picture of that number shows it: of a rasterizer's fragments that
/// of the one that is seen. Absent where the story has no such event or number. Queries about lines of a listing have
/// none.
std::optional<double> number_of_story(const std::vector<Event>& events, const FieldQuery& query);

}  // namespace ps
