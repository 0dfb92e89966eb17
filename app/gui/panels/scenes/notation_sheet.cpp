#include "gui/panels/scenes/notation_sheet.h"

#include <imgui.h>

#include "base/check.h"
#include "base/word_search.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "image/file.h"

namespace ps::gui {
namespace {

/// Text as it reads without the page's marks.
std::string plain(std::string text) {
  std::erase(text, '`');
  for (auto open = text.find("]("); open != std::string::npos; open = text.find("](")) {
    const auto close = text.find(')', open);
    text.erase(open, close == std::string::npos ? close : close - open + 1);
    if (const auto bracket = text.rfind('[', open); bracket != std::string::npos) text.erase(bracket, 1);
  }
  return text;
}

std::string words_of(const NotationPart& part) {
  std::string words;
  for (const NotationField& field : part.fields) words += field.key + " " + field.value + " " + field.meaning + " ";
  return words;
}

void cell(const std::string& text, Face face = Face::body) {
  ImGui::TableNextColumn();
  show_paragraph(text, {.face = face});
}

}  // namespace

/// A page that cannot be read is said in its place.
void NotationSheet::read_page() {
  if (!page_.parts.empty() || !fault_.empty()) return;
  try {
    page_ = scene_notation();
    for (const NotationPart& part : page_.parts) pictures_[part.name].upload(load_levels(part.picture));
  } catch (const InputError& error) {
    fault_ = error.what();
  }
}

void NotationSheet::draw_fields(const NotationPart& part) {
  if (!part.fields.empty() && ImGui::BeginTable(part.name.c_str(), 4, ImGuiTableFlags_RowBg)) {
    ImGui::TableSetupColumn("field", ImGuiTableColumnFlags_WidthStretch, 0.2f);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 0.22f);
    ImGui::TableSetupColumn("default", ImGuiTableColumnFlags_WidthStretch, 0.18f);
    ImGui::TableSetupColumn("what it is", ImGuiTableColumnFlags_WidthStretch, 0.4f);
    ImGui::TableHeadersRow();
    for (const NotationField& field : part.fields) {
      ImGui::TableNextRow();
      cell(field.key, Face::mono);
      cell(plain(field.value));
      cell(plain(field.standard));
      cell(plain(field.meaning));
      controls().record(part.name + "/" + field.key, plain(field.meaning));
    }
    ImGui::EndTable();
  }
  if (part.surface) quiet_text("Fields of a surface too: see material.");
}

/// The example beside its picture, and the fields below.
void NotationSheet::draw_part(const NotationPart& part) {
  const Texture& picture = pictures_[part.name];
  ImGui::Dummy({0, px(14)});
  show_text(part.name, {.face = Face::heading});
  show_paragraph(plain(part.text));
  const ImVec2 size{px(picture.width()), px(picture.height())};
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  add_plain_texture(*ImGui::GetWindowDrawList(), picture, corner, {corner.x + size.x, corner.y + size.y});
  ImGui::Dummy(size);
  controls().record("picture/" + part.name, corner, {corner.x + size.x, corner.y + size.y}, part.name);
  ImGui::SameLine(0, px(14));
  ImGui::BeginGroup();
  show_paragraph(part.example, {.face = Face::mono});
  ImGui::EndGroup();
  draw_fields(part);
}

void NotationSheet::add_actions(Actions& actions) {
  ActionGroup(actions, "Scene").add("scene-notation", "Scene notation: what a scene file may say", "", [this] {
    open();
    search_.clear();
  });
}

void NotationSheet::draw_sheet() {
  read_page();
  search_box("search", search_, "Search constructs and fields");
  ImGui::Dummy({0, px(4)});
  ImGui::BeginChild("##parts");
  if (!fault_.empty()) quiet_text(fault_);
  if (search_.empty()) value_paragraph("units", plain(page_.text));
  std::size_t shown = 0;
  for (const NotationPart& part : page_.parts) {
    if (!has_words(search_, {part.name, part.text, words_of(part)})) continue;
    ++shown;
    draw_part(part);
  }
  if (!page_.parts.empty() && shown == 0) quiet_text("No construct or field has these words.");
  ImGui::EndChild();
}

}  // namespace ps::gui
