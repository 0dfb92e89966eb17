#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/check.h"
#include "record/field_query.h"
#include "record/story.h"

namespace ps {

/// A number of the picked pixel that a figure draws: "pixel NAME [angle | share FROM TO] EVENT: NUMBER = OWN".
struct FigureNumber {
  enum class Kind { itself, angle, share };  ///< an angle is in degrees, of a cosine
  std::string name;
  Kind kind = Kind::itself;
  double from = 0, to = 1;  ///< of a share: where it is 0 and 1
  FieldQuery query;
  double own = 0;  ///< at the step's own pixel
  SourcePlace place;
};

/// Throws InputError with file, line and column.
FigureNumber read_figure_number(std::string_view line, const SourcePlace& start);

/// Absent where the story has no such event or number.
std::optional<double> number_at(const FigureNumber& number, const PixelStory& story);

/// In a figure's other lines "@name" stands for the number of that name.
using FigureNumbers = std::map<std::string, double, std::less<>>;

/// The text with each "@name" replaced by its number: with all digits, or rounded for a reader. A minus before it
/// changes the sign. Throws InputError at a name that is not known.
std::string with_numbers(std::string_view text, const FigureNumbers& numbers, const SourcePlace& start, bool rounded);

}  // namespace ps
