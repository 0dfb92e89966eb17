#include "gui/app/story_tree_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "gui/app/event_icon.h"
#include "gui/widgets/widgets.h"
#include "inspect/describe.h"
#include "inspect/number_text.h"

namespace ps::gui {
namespace {

struct TreeDrawing {
  const std::string& name;
  const PixelStory& story;
  const Scene& scene;
  StoryCursor& cursor;
  std::vector<int> ends;
  int first = 0, last = 0;  // the page, half-open

  const Event& event(int index) const { return story.events[static_cast<std::size_t>(index)]; }
  int end(int index) const { return ends[static_cast<std::size_t>(index)]; }

  void numbers(int index) const {
    const auto fields = event_table(event(index), scene);
    if (!ImGui::BeginTable("numbers", 2, ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    for (const auto& field : fields) {
      ImGui::TableNextColumn();
      ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
      ImGui::TextUnformatted(field.name.c_str());
      ImGui::PopStyleColor();
      ImGui::TableNextColumn();
      const FontScope font(Face::mono);
      ImGui::PushTextWrapPos(0);
      ImGui::TextUnformatted(field.value.c_str());
      ImGui::PopTextWrapPos();
      if (field.exact != field.value) tooltip(field.exact);
    }
    ImGui::EndTable();
  }

  void node(int index) {
    if (end(index) <= first || index >= last) return;
    const bool leaf = end(index) == index + 1;
    const bool reveals = cursor.reveal && cursor.selected >= index && cursor.selected < end(index);
    if (reveals && index != cursor.selected) ImGui::SetNextItemOpen(true);
    ImGui::PushID(index);
    const float icon = px(11);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float label = start.x + ImGui::GetFontSize() + px(6);  // where tree_row begins its text
    // Room for the icon in front of the text, whatever the font's space is wide.
    const auto spaces = static_cast<std::size_t>(std::max(1.f, (icon + px(7)) / ImGui::CalcTextSize(" ").x + 0.5f));
    const std::string text = describe(event(index), scene);
    const auto row = tree_row(fmt::format("{}/event/{}", name, index), std::string(spaces, ' ') + text,
                              leaf ? TreeKind::leaf : TreeKind::branch, cursor.selected == index);
    const float middle = (ImGui::GetItemRectMin().y + ImGui::GetItemRectMax().y) / 2;
    tooltip(text);
    draw_event_icon(*ImGui::GetWindowDrawList(), event(index), {label + icon / 2, middle}, icon);
    if (row.clicked) cursor.selected = cursor.selected == index ? -1 : index;
    if (cursor.reveal && cursor.selected == index) {
      ImGui::SetScrollHereY(0.3f);
      cursor.reveal = false;
    }
    if (cursor.selected == index) {
      ImGui::Indent(ImGui::GetTreeNodeToLabelSpacing());
      numbers(index);
      ImGui::Unindent(ImGui::GetTreeNodeToLabelSpacing());
    }
    if (row.open) {
      for (int child = index + 1; child < end(index); child = end(child)) node(child);
      ImGui::TreePop();
    }
    ImGui::PopID();
  }
};

void page_row(const std::string& name, StoryCursor& cursor, int pages, int count) {
  if (button(name + "/page-before", "Before", Emphasis::quiet,
             {.tooltip = {}, .disabled = cursor.page == 0 ? "first page" : ""}))
    --cursor.page;
  ImGui::SameLine();
  const int from = cursor.page * events_per_page + 1;
  ImGui::Text("events %d to %d of %d", from, std::min(from + events_per_page - 1, count), count);
  ImGui::SameLine();
  if (button(name + "/page-after", "After", Emphasis::quiet,
             {.tooltip = {}, .disabled = cursor.page + 1 == pages ? "last page" : ""}))
    ++cursor.page;
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

void story_tree_view(const std::string& name, const PixelStory& story, const Scene& scene, StoryCursor& cursor) {
  const int count = static_cast<int>(story.events.size());
  const int pages = std::max(1, (count + events_per_page - 1) / events_per_page);
  if (cursor.selected >= count) cursor.selected = -1;
  if (cursor.reveal && cursor.selected >= 0) cursor.page = cursor.selected / events_per_page;
  cursor.page = std::clamp(cursor.page, 0, pages - 1);
  if (pages > 1) page_row(name, cursor, pages, count);
  TreeDrawing drawing{name, story, scene, cursor, subtree_ends(story.events)};
  drawing.first = cursor.page * events_per_page;
  drawing.last = drawing.first + events_per_page;
  ImGui::PushID(name.c_str());
  for (int root = 0; root < count; root = drawing.end(root)) drawing.node(root);
  ImGui::PopID();
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
