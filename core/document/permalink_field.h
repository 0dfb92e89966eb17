#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "document/document.h"

namespace ps::detail {

/// One thing that a permalink can hold. `text` is empty while the document has the default; `parse` throws
/// InputError for what `text` would not give.
struct PermalinkField {
  std::string_view key;
  std::optional<std::string> (*text)(const Document&);
  void (*parse)(Document&, std::string_view);
};

/// The parts about the views of the pixel's story.
std::span<const PermalinkField> story_fields();

/// Takes up a part.
using AddPart = std::function<void(std::string_view key, std::string_view value)>;
/// A part for each option that differs from its default; the keys are those of the options after `prefix`.
void add_options(std::string_view prefix, const Settings& settings, const AddPart& add);
/// The parts about the pinned pixel.
void add_pin(const Pin& pin, const AddPart& add);
/// Reads one of them; `part` is its key after "pin.", empty for "pin" itself, which comes first. Throws InputError for
/// what add_pin would not give.
void parse_pin(std::string_view part, std::string_view value, std::optional<Pin>& pin);

/// A number between two bounds, both allowed; else InputError, which names it as `what`.
double parse_in_range(std::string_view text, double low, double high, std::string_view what);
int parse_whole(std::string_view text, int low, int high, std::string_view what);

/// The number, or nullopt where it is the default.
std::optional<std::string> number_unless(double value, double standard);
std::optional<std::string> text_unless(const std::string& value, const std::string& standard);

}  // namespace ps::detail
