#pragma once
#include "textbook/listing_view.h"

namespace ps::cli {

/// Prints the listing with the values that its lines had for the pixel, to the right of each line. Of each loop one
/// iteration is shown: the one around `instance` (an index as the loops' lines name it), or the one with most values
/// for -1.
void print_listing(const ListingTrace& trace, int instance);

/// The same for a source at hand, without a head.
void print_listing_rows(const ListingTrace& trace, const ListingText& text, int instance = -1);

}  // namespace ps::cli
