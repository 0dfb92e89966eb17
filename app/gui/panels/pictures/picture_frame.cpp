#include "gui/panels/pictures/picture_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "gui/panels/pictures/picture_text.h"
#include "gui/widgets/draw.h"
#include "render/left_out.h"

namespace ps::gui {
namespace {

constexpr double narrow = 380;  ///< pictures below this width, at scale 1, get two lines above and below
constexpr double note = 24;     ///< height of the row for a note

const std::vector<Choice>& channel_choices() {
  static const std::vector<Choice> choices = [] {
    std::vector<Choice> result;
    for (const auto& row : shown_channels()) result.push_back({row.key, row.label, row.help});
    return result;
  }();
  return choices;
}

float width_of(Face face, const std::string& text) {
  ImFont* font = theme().font(face);
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
}

/// Text that ends with "..." where it does not fit.
void clipped_text(ImDrawList& list, Face face, ImVec2 at, float width, ImU32 colour, std::string text) {
  ImFont* font = theme().font(face);
  if (width_of(face, text) > width) {
    const auto is_continuation = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
    while (!text.empty() && width_of(face, text + "...") > width) {
      while (!text.empty() && is_continuation(text.back())) text.pop_back();
      if (!text.empty()) text.pop_back();
    }
    text += "...";
  }
  list.AddText(font, font->FontSize, at, colour, text.c_str());
}

/// Cuts at a space so that the first part fits the width; answers the rest.
std::string take_line(Face face, std::string& text, float width) {
  const FontScope font(face);
  const std::size_t length = in_lines(text, width).find('\n');
  if (length == std::string::npos) return {};
  std::string rest = text.substr(length + 1);
  text.resize(length);
  return rest;
}

/// One thing in the line below a picture.
struct FooterItem {
  std::string name;  ///< empty = it shows the counters
  std::string text;
  std::string tooltip;
  bool attention = false;
};

std::vector<FooterItem> footer_items(Session& session, Side side, const std::string& lead) {
  if (const auto file = session.picture_b(); side == Side::b && file)
    return {{{}, fmt::format("{}{} x {} pixels", lead, file->levels.width(), file->levels.height()), file->path}};
  const auto status = session.renderer(side).status();
  const auto result = session.renderer(side).result();
  const std::string text = footer_text(status, result.get());
  const std::string counters = result ? counters_text(*result) : std::string();
  std::vector<FooterItem> items;
  FooterItem left{"left-out", {}, {}, true};
  for (const LeftOut& one : left_out(session.traits(), session.settings(side))) {
    left.text += (left.text.empty() ? "" : ", ") + one.brief;
    left.tooltip += (left.tooltip.empty() ? "" : "\n") + one.sentence;
  }
  if (!left.text.empty()) items.push_back(std::move(left));
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find("   ", from), text.size());
    const bool alarm = text.find("NaN", from) < to;  // comes first, where no ellipsis reaches it
    items.insert(alarm ? items.begin() : items.end(), {{}, text.substr(from, to - from), counters, alarm});
    from = text.find_first_not_of(' ', to);
  }
  if (!lead.empty() && !items.empty()) items.front().text = lead + items.front().text;
  return items;
}

/// A triangle that says: look here.
void attention_mark(ImDrawList& list, ImVec2 corner, float size) {
  const ImVec2 top{corner.x + size / 2, corner.y}, left{corner.x, corner.y + size},
      right{corner.x + size, corner.y + size};
  list.AddTriangleFilled(top, right, left, colour_u32(palette().attention));
  list.AddTriangle(top, right, left, colour_u32(palette().text), px(1.2));
}

}  // namespace

PictureMargins picture_margins(float width) {
  const float notes = px(note);
  return width < px(narrow) ? PictureMargins{px(66), px(46) + notes} : PictureMargins{px(34), px(26) + notes};
}

Area picture_note(const Area& footer) {
  return {{footer.min.x, footer.min.y + px(3)}, {footer.max.x, footer.min.y + px(note)}};
}

void side_badge(ImDrawList& list, ImVec2 corner, float size, Side side) {
  const ImVec4 colour = side == Side::a ? palette().a : palette().b;
  list.AddRectFilled(corner, {corner.x + size, corner.y + size}, colour_u32(colour), px(3));
  const char text[2] = {letter_of(side), 0};
  ImFont* font = theme().font(Face::bold);
  const float height = font->FontSize;
  const ImVec2 extent = font->CalcTextSizeA(height, FLT_MAX, 0, text);
  list.AddText(font, height, {corner.x + (size - extent.x) / 2, corner.y + (size - extent.y) / 2},
               colour_u32(palette().on_accent), text);
}

void picture_title(Session& session, Side side, const Area& row) {
  const NameScope scope(side == Side::a ? "view/a" : "view/b");
  auto& list = *ImGui::GetWindowDrawList();
  const bool two_lines = row.width() < px(narrow);
  const float line = two_lines ? row.height() - ImGui::GetFrameHeight() - px(3) : row.height();
  const float size = px(22), top = row.min.y + (line - size) / 2;
  const float choice_width = std::min(px(124), row.width() * 0.45f), space = px(8);
  side_badge(list, {row.min.x, top}, size, side);

  const auto file = side == Side::b ? session.picture_b() : nullptr;
  const CompareMode compare = session.document().compare;
  const bool single = compare == CompareMode::only_a || compare == CompareMode::only_b;
  const Settings* other = single || session.picture_b() ? nullptr : &session.settings(other_side(side));
  const std::string text = file ? "file " + std::filesystem::path(file->path).filename().string()
                                : title_text(session.settings(side), session.traits(), other);
  const ImU32 colour = colour_u32(side == Side::a ? palette().a_text : palette().b_text);
  const float text_left = row.min.x + size + space;
  const float text_top = top + (size - theme().font(Face::bold)->FontSize) / 2;
  if (two_lines) {
    const float room = row.max.x - text_left;
    const Face face = width_of(Face::bold, text) <= room ? Face::bold : Face::small;
    std::string first = text;
    const std::string rest = take_line(face, first, room);
    const float first_top = rest.empty() ? text_top : row.min.y;
    clipped_text(list, face, {text_left, first_top}, room, colour, first);
    clipped_text(list, face, {text_left, first_top + px(15)}, room, colour, rest);
  } else {
    clipped_text(list, Face::bold, {text_left, text_top}, row.max.x - choice_width - space - text_left, colour, text);
  }

  ImGui::SetCursorScreenPos(row.min);
  ImGui::InvisibleButton(side == Side::a ? "title-a" : "title-b",
                         {std::max(row.width() - choice_width - space, 1.f), row.height()});
  controls().record("title", text);
  tooltip(text + "\nDouble-click: this picture fills the window, and back.");
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0))
    session.navigate([&](Document& document) {
      const CompareMode alone = side == Side::a ? CompareMode::only_a : CompareMode::only_b;
      const bool filled = document.compare == alone && !document.layout.panels;
      document.compare = filled ? CompareMode::side_by_side : alone;
      document.layout.panels = filled;
    });

  const float choice_room = two_lines ? ImGui::GetFrameHeight() + px(6) : line;
  ImGui::SetCursorScreenPos({row.max.x - choice_width, row.max.y - (choice_room + ImGui::GetFrameHeight()) / 2});
  int shown = static_cast<int>(session.shown(side));
  if (choice("show", channel_choices(), shown,
             {.tooltip = "What this picture shows.", .disabled = {}, .width = choice_width}))
    session.edit(fmt::format("{} shows {}", letter_of(side), channel_choices()[static_cast<std::size_t>(shown)].label),
                 [&](Document& document) { side_of(document, side).show = static_cast<ShownChannel>(shown); });
}

void picture_footer(Session& session, Side side, const Area& row, const std::string& lead) {
  const NameScope scope(side == Side::a ? "view/a" : "view/b");
  auto& list = *ImGui::GetWindowDrawList();
  const float between = px(14), mark = px(11), height = theme().font(Face::small)->FontSize + px(3);
  ImVec2 at{row.min.x, row.min.y + px(note) + px(3)};
  std::string all;
  for (const FooterItem& item : footer_items(session, side, lead)) {
    all += (all.empty() ? "" : "   ") + item.text;
    const float inset = item.attention ? mark + px(5) : 0, width = inset + width_of(Face::small, item.text);
    if (at.x > row.min.x && at.x + width > row.max.x && at.y + 2 * height <= row.max.y) at = {row.min.x, at.y + height};
    const float room = row.max.x - at.x;
    if (room < px(24)) continue;
    if (item.attention) attention_mark(list, {at.x, at.y + px(2)}, mark);
    clipped_text(list, Face::small, {at.x + inset, at.y}, room - inset,
                 colour_u32(item.attention ? palette().text : palette().text_quiet), item.text);
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy({std::min(width, room), height});
    if (!item.name.empty()) controls().record(item.name, item.text);
    tooltip(item.tooltip);
    at.x += width + between;
  }
  controls().record("footer", row.min, row.max, all);

  const auto status = session.renderer(side).status();
  if (status.state != RenderState::full || status.fraction <= 0) return;
  const float width = row.width() * static_cast<float>(status.fraction);
  list.AddRectFilled(row.min, {row.min.x + width, row.min.y + px(3)},
                     colour_u32(side == Side::a ? palette().a : palette().b));
}

}  // namespace ps::gui
