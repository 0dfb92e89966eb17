#include <fmt/format.h>

#include "base/csv.h"
#include "inspect/describe.h"
#include "inspect/face_data.h"
#include "inspect/story_markdown.h"
#include "record/value_text.h"
#include "render/story/names.h"

namespace ps {
namespace {

/// Lines that share their first four columns.
class CsvRows {
 public:
  explicit CsvRows(std::string& text) : text_(text) {}
  std::string part, index, parent, kind;

  void add(std::string_view name, std::string_view value) {
    text_ += csv_row({part, index, parent, kind, std::string(name), std::string(value)});
  }
  void add(std::string_view name, double value) { add(name, exact_number_text(value)); }
  void add(std::string_view name, const Vec3d& value) {
    for (int i = 0; i < 3; ++i) add(fmt::format("{}[{}]", name, i), value[i]);
  }

 private:
  std::string& text_;
};

struct ValueRows {
  const Scene& scene;
  CsvRows& rows;
  std::string_view name;

  void operator()(bool v) const { rows.add(name, v ? "yes" : "no"); }
  void operator()(std::int64_t v) const { rows.add(name, fmt::format("{}", v)); }
  void operator()(double v) const { rows.add(name, v); }
  void operator()(const std::string& v) const { rows.add(name, v); }
  void operator()(const std::vector<double>& v) const {
    for (std::size_t i = 0; i < v.size(); ++i) rows.add(fmt::format("{}[{}]", name, i), v[i]);
  }
  void operator()(const std::vector<bool>& v) const {
    for (std::size_t i = 0; i < v.size(); ++i) rows.add(fmt::format("{}[{}]", name, i), v[i] ? "yes" : "no");
  }
  void operator()(const PixelId& v) const { rows.add(name, primitive_name(scene, v)); }
  void operator()(const std::vector<Texel>& v) const {
    for (std::size_t i = 0; i < v.size(); ++i) {
      const std::string one = fmt::format("{}[{}]", name, i);
      rows.add(one + ".x", static_cast<double>(v[i].x));
      rows.add(one + ".y", static_cast<double>(v[i].y));
      rows.add(one + ".level", static_cast<double>(v[i].level));
      rows.add(one + ".weight", v[i].weight);
      rows.add(one + ".colour", v[i].colour);
    }
  }
};

}  // namespace

std::string story_csv(const PixelStory& story, const Scene& scene, const Provenance& provenance) {
  std::string text = csv_row({"part", "index", "parent", "kind", "name", "value"});
  CsvRows rows(text);
  rows.part = "pixel";
  rows.add("column", static_cast<double>(story.pixel.x));
  rows.add("row", static_cast<double>(story.pixel.y));
  rows.add("verdict", story.verdict);
  rows.add("linear", story.linear);
  for (std::size_t i = 0; i < 3; ++i) rows.add(fmt::format("display[{}]", i), fmt::format("{}", story.display[i]));
  rows.part = "event";
  for (std::size_t i = 0; i < story.events.size(); ++i) {
    const Event& event = story.events[i];
    rows.index = std::to_string(i);
    rows.parent = event.parent < 0 ? "" : std::to_string(event.parent);
    rows.kind = event_kind(event.data);
    rows.add("text", describe(event, scene));
    for (const EventField& field : event_fields(event.data, scene))
      std::visit(ValueRows{scene, rows, field.key}, field.value);
  }
  rows.part = "ledger";
  rows.kind.clear();
  for (std::size_t i = 0; i < story.ledger.size(); ++i) {
    const LedgerLine& line = story.ledger[i];
    rows.index = std::to_string(i);
    rows.parent = line.event < 0 ? "" : std::to_string(line.event);
    rows.add("level", static_cast<double>(line.level));
    rows.add("term", line.term);
    rows.add("value", line.value);
  }
  rows.part = "counter";
  rows.index.clear();
  rows.parent.clear();
  for (std::size_t i = 0; i < counter_count; ++i) {
    const auto counter = static_cast<Counter>(i);
    if (const auto count = story.counters.get(counter)) rows.add(counter_key(counter), fmt::format("{}", *count));
  }
  rows.part = "provenance";
  for (const auto& [key, value] : provenance_facts(provenance)) rows.add(key, value);
  return text;
}

}  // namespace ps
