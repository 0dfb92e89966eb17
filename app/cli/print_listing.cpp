#include "cli/print_listing.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "textbook/listing_view.h"

namespace ps::cli {
namespace {

constexpr std::size_t widest_code = 100;  // columns before the values begin

std::string values_text(const ListingRow& row) {
  std::string text;
  if (row.loops) text = fmt::format("[{}: {} of {}] ", row.instance, row.place, row.count);
  for (const ListingValue& value : row.values) text += fmt::format("{} = {}   ", value.name, value.value);
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

}  // namespace

void print_listing_rows(const ListingTrace& trace, const ListingText& text, int instance) {
  ListingView view(trace, text);
  if (instance >= 0) view.focus(instance);
  const std::vector<ListingRow> rows = view.rows();
  std::size_t width = 0;
  for (const ListingRow& row : rows) width = std::max(width, std::min(row.text.size(), widest_code));
  for (const ListingRow& row : rows) {
    const std::string values = values_text(row);
    if (values.empty())
      fmt::print("{:>4}  {}\n", row.number, row.text);
    else
      fmt::print("{:>4}  {:<{}}  | {}\n", row.number, row.text, width, values);
  }
  if (trace.dropped > 0) fmt::print("\n{} more values were not recorded\n", trace.dropped);
}

void print_listing(const ListingTrace& trace, int instance) {
  if (instance >= static_cast<int>(trace.instances.size()))
    throw InputError(fmt::format("--instance: found {}, expected a number below {}", instance, trace.instances.size()));
  const ListingText text = load_listing_text(trace.listing);
  const std::string file = trace.listing.bug.empty() ? "listing.cpp" : fmt::format("bugs/{}.bug", trace.listing.bug);
  fmt::print("chapters/{}/{} ({})\n\n", trace.listing.folder, file, trace.listing.listing->source);
  print_listing_rows(trace, text, instance);
}

}  // namespace ps::cli
