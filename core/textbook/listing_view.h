#pragma once
#include <map>
#include <string>
#include <vector>

#include "textbook/trace_listing.h"

namespace ps {

/// A line of a listing as it is shown: without the watches, which are behind the line that they belong to.
struct ListingLine {
  int number = 0;  ///< in the file, from 1
  std::string text;
};

/// The routine in a listing's source: what is in its unnamed namespace.
struct ListingText {
  std::vector<ListingLine> lines;
  /// Index into `lines` to which line n of the file belongs; -1 outside the routine.
  std::vector<int> shown_at;
};

ListingText parse_listing(const std::string& source);
/// Reads the listing, with its bug if it names one. Throws InputError as listing_source() does.
ListingText load_listing_text(const NamedListing& listing);

/// A value beside a line.
struct ListingValue {
  std::string name, value;
  int watch = -1;  ///< its place in the trace
};

/// One line with what it had in the instances that are chosen.
struct ListingRow {
  std::string text;
  int number = 0;
  std::vector<ListingValue> values;
  bool loops = false;        ///< instances begin here, and can be stepped through
  std::string instance;      ///< the chosen one: "sphere green"; empty if none of them is on the way to what is shown
  int place = 0, count = 0;  ///< the chosen one counted from 1 among those that it is beside
  bool dimmed = false;       ///< it says where the lines behind it come from
};

/// Which instance of each loop is shown. There is always one of each that fits the others as well as can be.
class ListingView {
 public:
  /// `trace` and `text` must outlive the view. Begins at the work for the pixel with the most values, the last of them.
  ListingView(const ListingTrace& trace, const ListingText& text);

  /// All lines with their values.
  std::vector<ListingRow> rows() const;
  /// Shows the next (by = 1) or the previous (by = -1) instance of the loop on this row; stops at the ends.
  void step(std::size_t row, int by);
  /// Shows this instance and all around it.
  void focus(int instance);
  int focus() const { return focus_; }

 private:
  bool inside(int instance, int outer) const;
  int shared_depth(int a, int b) const;
  void choose();

  const ListingTrace& trace_;
  const ListingText& text_;
  std::vector<int> depth_;                     // of each instance
  std::map<int, std::vector<int>> instances_;  // by source line, in their order
  std::map<int, int> chosen_;                  // by source line
  int focus_ = -1;
};

}  // namespace ps
