#include "gui/panels/story/story_tree_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "gui/panels/story/event_icon.h"
#include "gui/panels/story/event_numbers.h"
#include "gui/panels/story/pin_view.h"
#include "gui/panels/story/story_rows.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "inspect/describe.h"
#include "record/value_text.h"

namespace ps::gui {
namespace {

constexpr double narrow_panel = 280;  // width at scale 1

struct TreeDrawing {
  const std::string& name;
  const PixelStory& story;
  const Scene& scene;
  StoryTreeState& state;
  const PinnedStory* pinned;
  std::vector<int> ends;
  int first = 0, last = 0;  // the page, half-open
  std::optional<int> clicked = {};

  const Event& event(int index) const { return story.events[static_cast<std::size_t>(index)]; }
  int end(int index) const { return ends[static_cast<std::size_t>(index)]; }

  /// The event as it was when the pixel was pinned; nullptr if it is new or none is pinned.
  const Event* then(int index) const {
    const int before = pinned ? pinned->step_of(index).before : -1;
    return before < 0 ? nullptr : &pinned->before->events[static_cast<std::size_t>(before)];
  }
  void numbers(int index) {
    const std::string names = fmt::format("{}/{}/number", name, index);
    if (const auto number = event_numbers(names, event(index), scene, then(index)))
      state.asked = field_query(story.events, index, number->key, number->component);
  }

  /// The parts without room in the row, a line each.
  void details(int index) const {
    int line = 0;
    for (const std::string& text : row_details(event(index), scene))
      value_paragraph(fmt::format("{}/detail/{}/{}", name, index, line++), text, {Face::small});
  }

  /// The description of an event when the pixel was pinned, below the row of the event now.
  void was(int index) const {
    if (!pinned || !pinned->step_of(index).changed) return;
    const Event* old = then(index);
    if (!old) return;  // its row says that it is new
    const std::string before = describe(*old, scene);
    if (before == describe(event(index), scene)) return;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetTreeNodeToLabelSpacing() + px(6));
    value_paragraph(fmt::format("{}/was/{}", name, index), "was: " + before, {Face::small, true});
    const ImVec2 low = ImGui::GetItemRectMin();
    mark_left({low.x - px(6), low.y}, ImGui::GetItemRectMax());
  }
  bool is_new(int index) const { return pinned && pinned->step_of(index).changed && !then(index); }
  /// Said once for all that happened inside it.
  bool says_new(int index) const { return is_new(index) && (event(index).parent < 0 || !is_new(event(index).parent)); }
  /// A bar at the left of a row: it is new, or shows the earlier value.
  void mark_left(const ImVec2& low, const ImVec2& high) const {
    attention_bar(*ImGui::GetWindowDrawList(), low, {low.x + px(4), high.y});
  }

  /// One row with its icon; answers what became of it. `rows` names it among the controls.
  TreeRow row(int index, const std::string& text, TreeKind kind, bool open, EventWeight weight) {
    const float icon = px(11);
    const TextScope look({row_face(weight), weight == EventWeight::quiet});
    const float label = ImGui::GetCursorScreenPos().x + ImGui::GetFontSize() + px(6);  // where tree_row leaves it room
    const auto result =
        tree_row(fmt::format("{}/event/{}", name, index), text, kind, state.selected == index, open, icon + px(6));
    if (is_new(index)) mark_left(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    const float middle = ImGui::GetItemRectMin().y + px(1) + ImGui::GetTextLineHeight() / 2;
    draw_event_icon(*ImGui::GetWindowDrawList(), event(index), {label + icon / 2, middle}, icon);
    return result;
  }

  /// One size for all rows; in a narrow panel smaller letters fit more into a line.
  static Face row_face(EventWeight weight) {
    const bool narrow = ImGui::GetWindowWidth() < px(narrow_panel);
    if (weight == EventWeight::strong) return narrow ? Face::small_bold : Face::bold;
    return narrow ? Face::small : Face::body;
  }

  /// A page begins in the middle of a tree: what is above it is drawn again, with the part that belongs here.
  void roots(int count) {
    int root = 0;
    while (root < count && end(root) <= first) root = end(root);
    siblings(root, count);
  }

  bool reveals(int from, int to) const { return state.reveal && state.selected >= from && state.selected < to; }

  /// Siblings; those that say little by themselves share a row.
  void siblings(int from, int to) {
    for (const StoryRow& part : story_rows(story.events, ends, std::max(from, first), std::min(to, last)))
      if (part.run)
        run(part);
      else
        node(part.first);
  }

  void run(const StoryRow& part) {
    ImGui::PushID(-1 - part.first);
    if (reveals(part.first, part.last)) ImGui::SetNextItemOpen(true);
    const std::string text = run_text(story.events, part);
    const bool open = [&] {
      const FontScope font(row_face(EventWeight::quiet));
      return tree_row(fmt::format("{}/run/{}", name, part.first), text, TreeKind::branch, false, false).open;
    }();
    ImGui::PopID();
    if (!open) return;
    for (int index = part.first; index < part.last; ++index) node(index);
    ImGui::TreePop();
  }

  void node(int index) {
    if (index >= last) return;
    const bool leaf = end(index) == index + 1;
    if (reveals(index + 1, end(index))) ImGui::SetNextItemOpen(true);
    ImGui::PushID(index);
    const auto* ray = std::get_if<RayEvent>(&event(index).data);
    const bool shut = ray && ray->kind == RayKind::shadow;  // its row and its light show its outcome
    const std::string text = row_text(story.events, ends, scene, index) + (says_new(index) ? " (new)" : "");
    const auto result = row(index, text, leaf ? TreeKind::leaf : TreeKind::branch, !shut, event_weight(event(index)));
    tooltip(describe(event(index), scene));
    if (result.clicked) clicked = state.selected == index ? -1 : index;
    if (state.reveal && state.selected == index) {
      ImGui::SetScrollHereY(0.3f);
      state.reveal = false;
    }
    was(index);
    if (state.selected == index) {
      ImGui::Indent(ImGui::GetTreeNodeToLabelSpacing());
      details(index);
      numbers(index);
      ImGui::Unindent(ImGui::GetTreeNodeToLabelSpacing());
    }
    if (result.open) {
      siblings(index + 1, end(index));
      ImGui::TreePop();
    }
    ImGui::PopID();
  }
};

void page_row(const std::string& name, StoryTreeState& state, int pages, int count) {
  if (button(name + "/page-before", "Before", Emphasis::quiet, {.disabled = state.page == 0 ? "first page" : ""}))
    --state.page;
  ImGui::SameLine();
  const int from = state.page * events_per_page + 1;
  ImGui::Text("events %d to %d of %d", from, std::min(from + events_per_page - 1, count), count);
  ImGui::SameLine();
  if (button(name + "/page-after", "After", Emphasis::quiet, {.disabled = state.page + 1 == pages ? "last page" : ""}))
    ++state.page;
}

}  // namespace

void StoryTreeState::follow(const std::shared_ptr<const PixelStory>& now, int selected_now) {
  const bool newer = now != story;
  const bool same_pixel = story && now && story->pixel == now->pixel;
  if (newer) page = selected_now >= 0 ? selected_now / events_per_page : same_pixel ? page : 0;
  if (selected_now != selected) reveal = selected_now >= 0 && !(newer && same_pixel);
  selected = selected_now;
  story = now;
}

std::optional<int> story_tree_view(const std::string& name, const PixelStory& story, const Scene& scene,
                                   StoryTreeState& state, const PinnedStory* pinned) {
  const int count = static_cast<int>(story.events.size());
  const int pages = std::max(1, (count + events_per_page - 1) / events_per_page);
  if (state.reveal && state.selected >= 0) state.page = state.selected / events_per_page;
  state.page = std::clamp(state.page, 0, pages - 1);
  if (pages > 1) page_row(name, state, pages, count);
  TreeDrawing drawing{name, story, scene, state, pinned, subtree_ends(story.events)};
  drawing.first = state.page * events_per_page;
  drawing.last = drawing.first + events_per_page;
  ImGui::PushID(name.c_str());
  drawing.roots(count);
  ImGui::PopID();
  if (drawing.clicked) state.selected = *drawing.clicked;  // it is in view
  return drawing.clicked;
}

std::string story_text(const PixelStory& story, const Scene& scene) {
  std::string text = fmt::format("pixel ({}, {}): {}\n", story.pixel.x, story.pixel.y, story.verdict);
  std::vector<int> depth(story.events.size());
  for (std::size_t i = 0; i < story.events.size(); ++i) {
    const int parent = story.events[i].parent;
    depth[i] = parent < 0 ? 0 : depth[static_cast<std::size_t>(parent)] + 1;
    text += std::string(static_cast<std::size_t>(depth[i]) * 2, ' ') + describe(story.events[i], scene) + '\n';
  }
  for (const auto& line : story.ledger)
    text += fmt::format("{}{}: {}\n", std::string(static_cast<std::size_t>(line.level) * 2, ' '), line.term,
                        vector_text(line.value));
  return text;
}

}  // namespace ps::gui
