#pragma once
#include <cstddef>
#include <optional>

#include "frame/prepared.h"
#include "record/field_inputs.h"
#include "record/field_query.h"
#include "textbook/trace_listing.h"

namespace ps {

/// The query for a value that a line had in the work for the traced pixel: on that line, within the same innermost
/// loop, and as often after others of its name. `component` is that of a vector, -1 its length. Absent where the value
/// is a word, or the line does not belong to the work for one pixel: what a triangle has once, no pixel has.
std::optional<FieldQuery> listing_query(const ListingTrace& trace, std::size_t watch, int component = -1);

/// The value of a line for every pixel, by one run of the listing. Where several works reach a pixel it is the value
/// of the one that the listing's view shows first: the one with the most values of its own, the last
/// of them.
void find_field_of_listing(const FieldInputs& asked, Image<float>& values, Prepared& prepared, Progress& progress);

}  // namespace ps
