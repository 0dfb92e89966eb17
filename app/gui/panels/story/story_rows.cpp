#include "gui/panels/story/story_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "inspect/describe.h"
#include "record/value_text.h"
#include "render/story/light_words.h"
#include "render/story/names.h"
#include "render/story/reason_text.h"

namespace ps::gui {
namespace {

constexpr std::string_view detail_mark = "; ";  // between the parts of an event's description

const Event& at(const std::vector<Event>& events, int index) { return events[static_cast<std::size_t>(index)]; }
int end_of(const std::vector<int>& ends, int index) { return ends[static_cast<std::size_t>(index)]; }

const TestOutcome* outcome_of(const Event& event) {
  if (const auto* sphere = std::get_if<SphereTestEvent>(&event.data)) return &sphere->outcome;
  if (const auto* triangle = std::get_if<TriangleTestEvent>(&event.data)) return &triangle->outcome;
  if (const auto* solid = std::get_if<SolidTestEvent>(&event.data)) return &solid->outcome;
  return nullptr;
}

const PixelId* tested_primitive(const EventData& data) {
  if (const auto* sphere = std::get_if<SphereTestEvent>(&data)) return &sphere->id;
  if (const auto* triangle = std::get_if<TriangleTestEvent>(&data)) return &triangle->id;
  if (const auto* solid = std::get_if<SolidTestEvent>(&data)) return &solid->id;
  return nullptr;
}

std::string ray_name(const RayEvent& ray) {
  switch (ray.kind) {
  case RayKind::eye:
    return "eye ray";
  case RayKind::shadow:
    return "shadow ray";
  case RayKind::reflection:
    return fmt::format("reflected ray {}", ray.depth);
  case RayKind::refraction:
    return fmt::format("refracted ray {}", ray.depth);
  }
  return {};
}

bool came_to_nothing(TestOutcome outcome) {
  switch (outcome) {
  case TestOutcome::accepted:
  case TestOutcome::farther:
  case TestOutcome::tie_lost:
    return false;
  case TestOutcome::missed:
  case TestOutcome::back_side:
  case TestOutcome::before_range:
  case TestOutcome::beyond_range:
  case TestOutcome::parallel:
  case TestOutcome::degenerate:
  case TestOutcome::excluded:
    return true;
  }
  return false;
}

struct Tally {
  int boxes = 0, entered = 0, misses = 0, rejects = 0;
  bool spheres = false;  ///< they bound the nodes, not boxes

  /// Whether the event is one of those that are counted.
  bool add(const Event& event) {
    if (const auto* node = std::get_if<NodeEvent>(&event.data)) {
      ++boxes;
      spheres = spheres || node->radius > 0;
      if (node->entered) ++entered;
    } else if (const auto* outcome = outcome_of(event); outcome && came_to_nothing(*outcome)) {
      ++misses;
    } else if (std::holds_alternative<RejectEvent>(event.data)) {
      ++rejects;
    } else {
      return false;
    }
    return true;
  }
  bool worth_a_run() const { return boxes >= 2 || misses > most_single_misses || rejects > most_single_misses; }
};

void append(std::string& text, const std::string& part) { text += (text.empty() ? "" : "; ") + part; }
std::string counted(int count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// "ray: 3 boxes, 7 tests", then what came of it.
std::string ray_text(const std::vector<Event>& events, const std::vector<int>& ends, const Scene& scene, int index) {
  const auto& ray = std::get<RayEvent>(at(events, index).data);
  int tests = 0;
  const PixelId* accepted = nullptr;
  bool hit = false;
  for (int child = index + 1; child < end_of(ends, index); child = end_of(ends, child)) {
    const EventData& data = at(events, child).data;
    if (const auto* outcome = outcome_of(at(events, child))) {
      ++tests;
      if (*outcome == TestOutcome::accepted) accepted = tested_primitive(data);
    }
    if (const auto* found = std::get_if<HitEvent>(&data)) {
      accepted = &found->id;
      hit = true;
    }
  }
  const std::string work = counted(tests, "test", "tests");
  switch (ray.kind) {
  case RayKind::eye:
  case RayKind::reflection:
  case RayKind::refraction:
    return fmt::format("{} {} ({})", ray_name(ray), hit ? "hits " + primitive_name(scene, *accepted) : "hits nothing",
                       work);
  case RayKind::shadow:
    // The light that it was sent to reports right after it.
    std::string name = ray_name(ray);
    const int next = end_of(ends, index);
    if (next < static_cast<int>(events.size()) && at(events, next).parent == at(events, index).parent)
      if (const auto* light = std::get_if<LightEvent>(&at(events, next).data))
        name += fmt::format(" to light {}", light->light);
    return fmt::format("{}: {} ({})", name, accepted ? "meets " + primitive_name(scene, *accepted) : "not blocked",
                       work);
  }
  return {};
}

}  // namespace

std::vector<int> subtree_ends(const std::vector<Event>& events) {
  std::vector<int> ends(events.size());
  for (std::size_t i = events.size(); i-- > 0;) {
    ends[i] = std::max(ends[i], static_cast<int>(i) + 1);
    if (const int parent = events[i].parent; parent >= 0) {
      auto& end = ends[static_cast<std::size_t>(parent)];
      end = std::max(end, ends[i]);
    }
  }
  return ends;
}

std::vector<StoryRow> story_rows(const std::vector<Event>& events, const std::vector<int>& ends, int first, int last) {
  std::vector<StoryRow> rows;
  for (int index = first; index < last;) {
    Tally tally;
    int end = index;
    while (end < last && end_of(ends, end) == end + 1 && tally.add(at(events, end))) ++end;
    if (end == index) {
      rows.push_back({index, end_of(ends, index)});
      index = end_of(ends, index);
      continue;
    }
    if (tally.worth_a_run())
      rows.push_back({index, end, true});
    else
      for (int single = index; single < end; ++single) rows.push_back({single, single + 1});
    index = end;
  }
  return rows;
}

std::string run_text(const std::vector<Event>& events, const StoryRow& run) {
  Tally tally;
  for (int i = run.first; i < run.last; ++i) tally.add(at(events, i));
  std::string text;
  if (tally.boxes > 0)
    append(text, counted(tally.boxes, tally.spheres ? "sphere visited" : "box visited",
                         tally.spheres ? "spheres visited" : "boxes visited") +
                     fmt::format(", {} entered", tally.entered));
  if (tally.misses > 0) append(text, counted(tally.misses, "primitive missed", "primitives missed"));
  for (const RejectReason reason : all_reject_reasons) {
    const auto count = static_cast<std::size_t>(
        std::count_if(events.begin() + run.first, events.begin() + run.last, [&](const Event& event) {
          const auto* reject = std::get_if<RejectEvent>(&event.data);
          return reject && reject->reason == reason;
        }));
    if (count > 0) append(text, reject_count_text(reason, count));
  }
  return text;
}

std::string row_text(const std::vector<Event>& events, const std::vector<int>& ends, const Scene& scene, int index) {
  if (std::holds_alternative<RayEvent>(at(events, index).data)) return ray_text(events, ends, scene, index);
  if (const auto* hit = std::get_if<HitEvent>(&at(events, index).data))
    return fmt::format("hit {} at t = {}", primitive_name(scene, hit->id), ps::number_text(hit->t));
  if (const auto* light = std::get_if<LightEvent>(&at(events, index).data))
    return fmt::format("light {}: {}", light->light, light_effect_text(scene, *light, LightWords::brief));
  return short_description(at(events, index), scene);
}

std::string short_description(const Event& event, const Scene& scene) {
  std::string text = describe(event, scene);
  // A line of sight may cross dozens of shadow volumes.
  if (std::holds_alternative<StencilEvent>(event.data)) text.resize(std::min(text.size(), text.find(detail_mark)));
  return text;
}

std::vector<std::string> row_details(const Event& event, const Scene& scene) {
  std::vector<std::string> lines;
  if (!std::holds_alternative<StencilEvent>(event.data)) return lines;
  const std::string text = describe(event, scene);
  for (auto from = text.find(detail_mark); from != std::string::npos;) {
    const auto begin = from + detail_mark.size();
    from = text.find(detail_mark, begin);
    lines.push_back(text.substr(begin, from == std::string::npos ? from : from - begin));
  }
  return lines;
}

EventWeight event_weight(const Event& event) {
  if (Tally().add(event)) return EventWeight::quiet;
  const bool strong = std::holds_alternative<HitEvent>(event.data) || std::holds_alternative<ShadeEvent>(event.data) ||
                      std::holds_alternative<WriteEvent>(event.data) || std::holds_alternative<PixelEvent>(event.data);
  return strong ? EventWeight::strong : EventWeight::plain;
}

}  // namespace ps::gui
