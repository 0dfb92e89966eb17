#include "textbook/listing_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "textbook/listing_source.h"

namespace ps {
namespace {

constexpr std::size_t most_values = 4;  // of one name on one line

std::string_view without_indent(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

bool ends_statement(std::string_view line) {
  const auto last = line.find_last_not_of(" \t\r");
  return last != std::string_view::npos && line[last] == ';';
}

}  // namespace

ListingText parse_listing(const std::string& source) {
  const std::vector<std::string> lines = listing_lines(source);
  ListingText text;
  text.shown_at.assign(lines.size() + 1, -1);
  bool inside = false, watch = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view line = without_indent(lines[i]);
    if (line == "namespace {") {
      inside = true;
      continue;
    }
    if (line == "}  // namespace") break;
    if (!inside) continue;
    if (watch || line.substr(0, 3) == "PS_") {
      watch = !ends_statement(line);
    } else if (!line.empty() || (!text.lines.empty() && !text.lines.back().text.empty())) {
      text.lines.push_back({static_cast<int>(i) + 1, lines[i]});
    }
    text.shown_at[i + 1] = static_cast<int>(text.lines.size()) - 1;
  }
  while (!text.lines.empty() && without_indent(text.lines.back().text).empty()) text.lines.pop_back();
  return text;
}

ListingText load_listing_text(const NamedListing& listing) { return parse_listing(listing_source(listing)); }

ListingView::ListingView(const ListingTrace& trace, const ListingText& text) : trace_(trace), text_(text) {
  const auto& instances = trace.instances;
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const int parent = instances[i].parent;
    depth_.push_back(parent < 0 ? 0 : depth_[static_cast<std::size_t>(parent)] + 1);
    instances_[instances[i].line].push_back(static_cast<int>(i));
  }
  std::vector<int> watched(instances.size());
  for (const Watch& watch : trace.watches)
    if (watch.instance >= 0) ++watched[static_cast<std::size_t>(watch.instance)];
  for (std::size_t i = 0; i < instances.size(); ++i) {
    if (instances[i].name != "pixel") continue;
    if (focus_ < 0 || watched[i] >= watched[static_cast<std::size_t>(focus_)]) focus_ = static_cast<int>(i);
  }
  choose();
}

bool ListingView::inside(int instance, int outer) const {
  while (instance >= 0 && instance != outer) instance = trace_.instances[static_cast<std::size_t>(instance)].parent;
  return instance == outer;
}

/// How many instances there are around both.
int ListingView::shared_depth(int a, int b) const {
  while (a >= 0 && !inside(b, a)) a = trace_.instances[static_cast<std::size_t>(a)].parent;
  return a < 0 ? -1 : depth_[static_cast<std::size_t>(a)];
}

/// For each loop the instance around the focus; else the one that shares most with it, is least deep, and comes first.
void ListingView::choose() {
  chosen_.clear();
  for (const auto& [line, candidates] : instances_) {
    int best = -1, best_shared = 0, best_depth = 0;
    for (const int candidate : candidates) {
      const int depth = depth_[static_cast<std::size_t>(candidate)];
      const bool around = focus_ >= 0 && inside(focus_, candidate);
      const int shared = focus_ < 0 ? -1 : shared_depth(focus_, candidate);
      const bool better = best < 0 || shared > best_shared || (shared == best_shared && !around && depth < best_depth);
      if (better) {
        best = candidate;
        best_shared = shared;
        best_depth = depth;
      }
    }
    chosen_[line] = best;
  }
}

void ListingView::focus(int instance) {
  focus_ = instance;
  choose();
}

std::vector<ListingRow> ListingView::rows() const {
  std::vector<ListingRow> rows;
  for (const ListingLine& line : text_.lines) rows.push_back({line.text, line.number, {}, false, {}, 0, 0});
  const auto row_of = [&](int line) -> ListingRow* {
    if (line < 0 || static_cast<std::size_t>(line) >= text_.shown_at.size()) return nullptr;
    const int at = text_.shown_at[static_cast<std::size_t>(line)];
    return at < 0 || static_cast<std::size_t>(at) >= rows.size() ? nullptr : &rows[static_cast<std::size_t>(at)];
  };
  for (const auto& [line, chosen] : chosen_) {
    ListingRow* row = row_of(line);
    if (!row) continue;
    row->loops = true;
    const WatchInstance& shown = trace_.instances[static_cast<std::size_t>(chosen)];
    row->instance = fmt::format("{} {}", shown.name, watch_text(shown.value));
    std::vector<int> beside;
    for (const int candidate : instances_.at(line))
      if (trace_.instances[static_cast<std::size_t>(candidate)].parent == shown.parent) beside.push_back(candidate);
    const auto& counted = beside.size() > 1 ? beside : instances_.at(line);
    row->count = static_cast<int>(counted.size());
    row->place = static_cast<int>(std::find(counted.begin(), counted.end(), chosen) - counted.begin()) + 1;
  }
  for (std::size_t i = 0; i < trace_.watches.size(); ++i) {
    const Watch& watch = trace_.watches[i];
    if (watch.instance >= 0) {
      const int line = trace_.instances[static_cast<std::size_t>(watch.instance)].line;
      if (chosen_.at(line) != watch.instance) continue;
    }
    ListingRow* row = row_of(watch.line);
    if (!row) continue;
    const std::size_t same = static_cast<std::size_t>(std::count_if(
        row->values.begin(), row->values.end(), [&](const ListingValue& v) { return v.name == watch.name; }));
    if (same < most_values)
      row->values.push_back({std::string(watch.name), watch_text(watch.value), static_cast<int>(i)});
  }
  return rows;
}

void ListingView::step(std::size_t row, int by) {
  for (const auto& [line, candidates] : instances_) {
    if (text_.shown_at.at(static_cast<std::size_t>(line)) != static_cast<int>(row)) continue;
    const auto now = std::find(candidates.begin(), candidates.end(), chosen_.at(line));
    const auto place = std::clamp<std::ptrdiff_t>(now - candidates.begin() + by, 0,
                                                  static_cast<std::ptrdiff_t>(candidates.size()) - 1);
    return focus(candidates[static_cast<std::size_t>(place)]);
  }
}

}  // namespace ps
