#pragma once
#include <array>
#include <string>

#include "base/progress.h"
#include "document/document.h"

namespace ps {

/// The pictures that a step shows, beside each other, with captions that say how they differ. Those in `covered` would
/// answer the step's question and are left out. Throws InputError where one cannot be made, and Cancelled.
std::string pictures_html(const Document& document, const std::array<bool, 2>& covered, Progress& progress);

}  // namespace ps
