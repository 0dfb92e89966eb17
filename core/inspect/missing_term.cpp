#include "inspect/missing_term.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace ps {
namespace {

using Levels = std::array<int, 3>;
constexpr std::size_t most_leaves = 64;
constexpr int most_rounding = 1;  // levels that two programs' roundings may be apart
constexpr std::array<std::string_view, 3> channel_words{"Red", "Green", "Blue"};

Levels levels_at(const Vec3d& linear, const DisplayTransform& display) {
  const Rgb8 level = display_pixel(linear, display);
  return {level.r, level.g, level.b};
}

Levels minus(const Levels& a, const Levels& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

int largest(const Levels& levels) {
  int most = 0;
  for (const int level : levels) most = std::max(most, std::abs(level));
  return most;
}

/// "the highlight of light 1 (point)" for the row of its specular term; else what stands in it.
std::string row_name(const LedgerLine& line) {
  if (line.light.empty()) return line.term;
  const std::string part = line.kind == LedgerTerm::specular  ? "the highlight of "
                           : line.kind == LedgerTerm::diffuse ? "the diffuse light of "
                           : line.kind == LedgerTerm::ambient ? "the ambient light of "
                                                              : "";
  return part + line.light;
}

class TermSearch {
 public:
  TermSearch(const PixelStory& story, const DisplayTransform& display, Rgb8 other)
      : story_(story), display_(display), other_{other.r, other.g, other.b} {
    result_.difference = minus(other_, story.display);
  }

  MissingTerm run() {
    for (std::size_t line = 0; line < story_.ledger.size(); ++line)
      if (story_.ledger[line].value != Vec3d(0)) add_row(line);
    if (largest(result_.difference) > most_rounding) {
      try_single();
      try_unmixed();
      if (result_.change == MissingTerm::Change::none) try_pairs();
    }
    result_.sentence = sentence();
    return std::move(result_);
  }

 private:
  void add_row(std::size_t line) {
    const Vec3d value = story_.ledger[line].value;
    result_.rows.push_back({line, minus(story_.display, levels_at(story_.linear - value, display_)),
                            minus(levels_at(story_.linear + value, display_), story_.display)});
  }

  /// Keeps the rows if they explain the difference better than what is kept, or as well and are further down.
  void consider(const std::vector<std::size_t>& lines, int depth) {
    Vec3d value(0);
    for (const std::size_t line : lines) value += story_.ledger[line].value;
    for (const auto& [change, sign] :
         {std::pair{MissingTerm::Change::left_out, -1.0}, std::pair{MissingTerm::Change::counted_twice, 1.0}}) {
      const int apart = largest(minus(other_, levels_at(story_.linear + sign * value, display_)));
      if (apart > most_rounding || apart > apart_ || (apart == apart_ && depth <= depth_)) continue;
      apart_ = apart;
      depth_ = depth;
      result_.change = change;
      result_.named = lines;
    }
  }

  void try_single() {
    for (const TermRow& row : result_.rows) consider({row.line}, story_.ledger[row.line].level);
  }

  /// Without reflections a mirror's own colour has no share: local in place of local (1 - r) + reflected r.
  void try_unmixed() {
    const LedgerLine* own = nullptr;
    for (const LedgerLine& row : story_.ledger) {
      if (row.level != 0 || row.event < 0) continue;
      const EventData& data = story_.events[static_cast<std::size_t>(row.event)].data;
      const auto* mirror = std::get_if<ReflectionEvent>(&data);
      if (mirror && own && mirror->reflective > 0 && mirror->reflective < 1)
        consider_unmixed(*own,
                         story_.linear - row.value + own->value * (mirror->reflective / (1 - mirror->reflective)));
      own = &row;
    }
  }

  void consider_unmixed(const LedgerLine& own, const Vec3d& whole) {
    const int apart = largest(minus(other_, levels_at(whole, display_)));
    if (apart > most_rounding || apart >= apart_) return;
    apart_ = apart;
    result_.change = MissingTerm::Change::unmixed;
    result_.named = {static_cast<std::size_t>(&own - story_.ledger.data())};
  }

  /// Only of rows that are not sums of others.
  void try_pairs() {
    std::vector<std::size_t> leaves;
    for (const TermRow& row : result_.rows) {
      const bool sum =
          row.line + 1 < story_.ledger.size() && story_.ledger[row.line + 1].level > story_.ledger[row.line].level;
      if (!sum) leaves.push_back(row.line);
    }
    // Many samples make thousands of pairs. Two rows that explain a difference are seldom among the faintest.
    const auto light = [&](std::size_t line) { return dot(story_.ledger[line].value, story_.ledger[line].value); };
    std::stable_sort(leaves.begin(), leaves.end(), [&](std::size_t x, std::size_t y) { return light(x) > light(y); });
    leaves.resize(std::min(leaves.size(), most_leaves));
    std::sort(leaves.begin(), leaves.end());
    for (std::size_t i = 0; i < leaves.size(); ++i)
      for (std::size_t k = i + 1; k < leaves.size(); ++k)
        consider({leaves[i], leaves[k]}, story_.ledger[leaves[i]].level + story_.ledger[leaves[k]].level);
  }

  const TermRow& row_of(std::size_t line) const {
    return *std::find_if(result_.rows.begin(), result_.rows.end(),
                         [&](const TermRow& row) { return row.line == line; });
  }

  std::string sentence() const {
    const Levels& apart = result_.difference;
    if (largest(apart) == 0) return "Both pixels have the same levels.";
    std::size_t channel = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (std::abs(apart[i]) > std::abs(apart[channel])) channel = i;
    const bool grey = apart[0] == apart[1] && apart[1] == apart[2];
    const std::string amount =
        fmt::format("{}{} levels too {}", grey ? "" : fmt::format("{} is ", channel_words[channel]),
                    std::abs(apart[channel]), apart[channel] < 0 ? "dark" : "bright");
    if (largest(apart) <= most_rounding) return amount + ": rounding alone can do that.";
    if (result_.change == MissingTerm::Change::none)
      return amount + ": no row of the sum, and no two rows together, left out or counted twice, make this difference.";
    if (result_.change == MissingTerm::Change::unmixed)
      return fmt::format("{}: that is {} counted whole, and nothing reflected.", amount,
                         row_name(story_.ledger[result_.named.front()]));
    const bool twice = result_.change == MissingTerm::Change::counted_twice;
    std::string rows;
    for (const std::size_t line : result_.named) {
      const TermRow& row = row_of(line);
      rows += fmt::format("{}{}, {}", rows.empty() ? "" : ", and ", row_name(story_.ledger[line]),
                          std::abs((twice ? row.again : row.adds)[channel]));
    }
    return fmt::format("{}: that is {}{}.", amount, rows, twice ? ", counted twice" : "");
  }

  const PixelStory& story_;
  const DisplayTransform& display_;
  const Levels other_;
  MissingTerm result_;
  int apart_ = most_rounding + 1;
  int depth_ = -1;
};

}  // namespace

MissingTerm find_missing_term(const PixelStory& story, const DisplayTransform& display, Rgb8 other) {
  return TermSearch(story, display, other).run();
}

}  // namespace ps
