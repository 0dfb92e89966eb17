#include "gui/app/pictures_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gui/app/handles_view.h"
#include "gui/app/picture_text.h"
#include "gui/widgets/widgets.h"
#include "image/metrics.h"
#include "inspect/names.h"

namespace ps::gui {
namespace {

constexpr double title_height = 34, footer_height = 26, gap = 10;

PictureTransform current_transform(const Document& document, Vec2i size, const Area& area) {
  if (document.view.zoom <= 0) return fitted(size, area);
  return {document.view.zoom, {document.view.middle.x * size.x, document.view.middle.y * size.y}};
}

const std::vector<Choice>& channel_choices() {
  static const std::vector<Choice> choices = [] {
    std::vector<Choice> result;
    for (const auto& row : shown_channels()) result.push_back({row.key, row.label, row.help});
    return result;
  }();
  return choices;
}

/// The letter of a side on its colour.
void badge(ImDrawList& list, ImVec2 corner, float size, Side side) {
  const ImVec4 colour = side == Side::a ? palette().a : palette().b;
  list.AddRectFilled(corner, {corner.x + size, corner.y + size}, colour_u32(colour), px(3));
  const char text[2] = {letter_of(side), 0};
  ImFont* font = theme().font(Face::bold);
  const float height = font->FontSize;
  const ImVec2 extent = font->CalcTextSizeA(height, FLT_MAX, 0, text);
  list.AddText(font, height, {corner.x + (size - extent.x) / 2, corner.y + (size - extent.y) / 2},
               colour_u32(palette().on_accent), text);
}

/// Text that ends with "..." where it does not fit.
void clipped_text(ImDrawList& list, Face face, ImVec2 at, float width, ImU32 colour, std::string text) {
  ImFont* font = theme().font(face);
  const float size = font->FontSize;
  const auto width_of = [&](const std::string& t) { return font->CalcTextSizeA(size, FLT_MAX, 0, t.c_str()).x; };
  if (width_of(text) > width) {
    const auto is_continuation = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
    while (!text.empty() && width_of(text + "...") > width) {
      while (!text.empty() && is_continuation(text.back())) text.pop_back();
      if (!text.empty()) text.pop_back();
    }
    text += "...";
  }
  list.AddText(font, size, at, colour, text.c_str());
}

/// The line above a picture: letter, what it is made with, and which channel is shown.
void title(Session& session, Side side, const Area& row) {
  const NameScope scope(side == Side::a ? "view/a" : "view/b");
  auto& list = *ImGui::GetWindowDrawList();
  const float size = px(22), top = row.min.y + (row.height() - size) / 2;
  badge(list, {row.min.x, top}, size, side);
  const float choice_width = std::min(px(124), row.width() * 0.39f);
  const float text_left = row.min.x + size + px(8);
  const ImVec4 colour = side == Side::a ? palette().a_text : palette().b_text;
  const std::string text = title_text(session.settings(side), session.traits());
  clipped_text(list, Face::bold, {text_left, top + (size - theme().font(Face::bold)->FontSize) / 2},
               row.max.x - choice_width - px(8) - text_left, colour_u32(colour), text);

  ImGui::SetCursorScreenPos(row.min);
  ImGui::InvisibleButton(side == Side::a ? "title-a" : "title-b", {row.width() - choice_width - px(8), row.height()});
  controls().record("title", text);
  tooltip(text + "\nDouble-click: this picture fills the window, and back.");
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0))
    session.navigate([&](Document& document) {
      const CompareMode alone = side == Side::a ? CompareMode::only_a : CompareMode::only_b;
      const bool filled = document.compare == alone && !document.layout.panels;
      document.compare = filled ? CompareMode::side_by_side : alone;
      document.layout.panels = filled;
    });

  ImGui::SetCursorScreenPos({row.max.x - choice_width, row.min.y + (row.height() - ImGui::GetFrameHeight()) / 2});
  int shown = static_cast<int>(session.shown(side));
  if (choice("show", channel_choices(), shown,
             {.tooltip = "What this picture shows.", .disabled = {}, .width = choice_width}))
    session.edit(fmt::format("{} shows {}", letter_of(side), channel_choices()[static_cast<std::size_t>(shown)].label),
                 [&](Document& document) { side_of(document, side).show = static_cast<ShownChannel>(shown); });
}

/// The line below a picture: how long it took and what it cost; a thin bar while it is being made.
void footer(Session& session, Side side, const Area& row, const std::string& before = {}) {
  auto& list = *ImGui::GetWindowDrawList();
  const auto status = session.renderer(side).status();
  const auto result = session.renderer(side).result();
  const std::string text = before + footer_text(status, result.get());
  clipped_text(list, Face::small, {row.min.x, row.min.y + px(5)}, row.width(), colour_u32(palette().text_quiet), text);
  ImGui::SetCursorScreenPos(row.min);
  ImGui::Dummy({row.width(), row.height()});
  controls().record(side == Side::a ? "view/a/footer" : "view/b/footer", text);
  if (result) tooltip(counters_text(*result));
  if (status.state != RenderState::full || status.fraction <= 0) return;
  const float width = row.width() * static_cast<float>(status.fraction);
  list.AddRectFilled(row.min, {row.min.x + width, row.min.y + px(3)},
                     colour_u32(side == Side::a ? palette().a : palette().b));
}

struct Split {
  float at = 0;  ///< window x of the divider
};

/// Lights and spheres that can be dragged, while the mouse is in the picture.
void handles(Session& session, PicturesState& state, Side side, const Area& area, bool hovered) {
  const auto all = visible_handles(session.scene(), session.view(), session.settings(side), state.transform, area);
  record_handles(side == Side::a ? "view/a" : "view/b", all, state.transform, area);
  const bool busy = state.drag != PictureDrag::none && state.drag != PictureDrag::undecided;
  if (!hovered || flying(state) || (busy && state.drag != PictureDrag::handle)) return;
  std::string held;
  if (state.drag == PictureDrag::handle)
    held = state.grabbed->path;
  else if (const Handle* under = handle_at(all, ImGui::GetIO().MousePos, state.transform, area))
    held = under->path;
  if (!held.empty()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  draw_handles(*ImGui::GetWindowDrawList(), all, held, state.transform, area);
}

/// The picture of one side in its area, with what lies over it.
void picture(Session& session, PicturesState& state, Side side, const Area& area, std::optional<Split> split) {
  auto& list = *ImGui::GetWindowDrawList();
  const std::size_t index = index_of(side);
  ImGui::SetCursorScreenPos(area.min);
  ImGui::InvisibleButton(
      side == Side::a ? "picture-a" : "picture-b", {std::max(area.width(), 1.f), std::max(area.height(), 1.f)},
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  controls().record(side == Side::a ? "view/a/picture" : "view/b/picture", std::string(1, letter_of(side)));
  const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
  picture_input(session, state, side, area, split ? std::optional(split->at) : std::nullopt);
  state.areas[index] = area;

  const Side shown_side = state.flip ? other_side(side) : side;
  const auto style_of = [&](Side which) {
    PictureStyle style;
    style.grid = state.grid;
    style.marked = session.pixel();
    style.region = session.region();
    const ShownChannel channel = session.shown(which);
    const auto result = session.renderer(which).result();
    if (channel != ShownChannel::colour && result &&
        (result->channels | shown_channel(channel).needs) == result->channels)
      style.text_at = [result, channel, settings = session.settings(which)](Vec2i pixel) {
        return result->frame.colour.contains(pixel.x, pixel.y)
                   ? channel_value_text(result->frame, channel, settings, pixel)
                   : std::string();
      };
    return style;
  };
  const auto draw_nan = [&](Side which) {
    if (session.shown(which) == ShownChannel::colour)
      state.nan_pixels[index_of(which)].draw(list, session.renderer(which).result(), state.transform, area);
  };
  list.PushClipRect(area.min, {split ? split->at : area.max.x, area.max.y}, true);
  draw_picture(list, state.pictures[index_of(shown_side)], state.transform, area, style_of(shown_side));
  draw_nan(shown_side);
  list.PopClipRect();
  if (split) {
    const Side right = other_side(shown_side);
    list.PushClipRect({split->at, area.min.y}, area.max, true);
    draw_picture(list, state.pictures[index_of(right)], state.transform, area, style_of(right));
    draw_nan(right);
    list.PopClipRect();
  }
  if (session.shown(shown_side) != ShownChannel::colour) {
    ChannelLegend legend = session.renderer(shown_side).legend();
    for (auto& entry : legend.entries)
      if (entry.object >= 0) entry.meaning = object_name(session.scene(), entry.object);
    draw_legend(list, legend, area);
  }
  if (session.has_scene() && state.handles && !split) handles(session, state, side, area, hovered);
  const auto status = session.renderer(shown_side).status();
  if (status.state == RenderState::failed) draw_notice(list, area, status.message);
}

/// What picture_input() drags; here it is drawn and told to scripts.
void divider(const Area& area, float at, double share) {
  controls().record("pictures/divider", {at - px(divider_reach), area.min.y}, {at + px(divider_reach), area.max.y},
                    short_number(share));
  auto& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({at - px(2.5), area.min.y}, {at + px(2.5), area.max.y}, IM_COL32(0, 0, 0, 160));
  list.AddRectFilled({at - px(1.5), area.min.y}, {at + px(1.5), area.max.y}, IM_COL32(255, 255, 255, 255));
  const ImVec2 middle{at, area.middle().y};
  list.AddCircleFilled(middle, px(13), IM_COL32(255, 255, 255, 255));
  list.AddCircle(middle, px(13), IM_COL32(0, 0, 0, 200), 0, px(1.5));
  for (const float sense : {-1.f, 1.f})
    list.AddTriangleFilled({at + sense * px(9), middle.y}, {at + sense * px(4), middle.y - px(5)},
                           {at + sense * px(4), middle.y + px(5)}, IM_COL32(40, 40, 40, 255));
}

void make_difference(Session& session, PicturesState& state) {
  if (!state.difference_stale) return;
  const auto &a = state.pictures[0].levels, &b = state.pictures[1].levels;
  if (a.empty() || a.width() != b.width() || a.height() != b.height()) return;
  state.identical = a == b;
  state.difference.levels = difference_picture(a, b, {session.document().difference_gain, state.difference_mode});
  state.difference.upload({{0, 0, a.width(), a.height()}});
  state.difference_stale = false;
  state.difference_fresh = true;
}

/// One picture of what parts A and B, with its gain.
void difference_view(Session& session, PicturesState& state, const Area& row, const Area& area) {
  const NameScope scope("difference");
  make_difference(session, state);
  auto& list = *ImGui::GetWindowDrawList();
  ImGui::SetCursorScreenPos({row.min.x, row.min.y + (row.height() - ImGui::GetFrameHeight()) / 2});
  ImGui::AlignTextToFramePadding();
  {
    const FontScope font(Face::bold);
    ImGui::TextUnformatted(state.difference_mode == DifferenceMode::absolute ? "|B − A|" : "B − A");
  }
  ImGui::SameLine();
  double gain = session.document().difference_gain;
  const auto edit = number(
      "gain", gain, {.minimum = 1, .maximum = 256, .scale = OptionScale::logarithmic, .unit = "x"},
      {.tooltip = "Differences are multiplied by this before they are shown.", .disabled = {}, .width = px(140)});
  if (edit.changed) {
    session.navigate([&](Document& document) { document.difference_gain = gain; });
    state.difference_stale = true;
  }
  ImGui::SameLine();
  bool sign = state.difference_mode == DifferenceMode::sign;
  if (toggle("sign", "signed", sign,
             {.tooltip = "Grey where equal, lighter where B is brighter, darker where A is."})) {
    state.difference_mode = sign ? DifferenceMode::sign : DifferenceMode::absolute;
    state.difference_stale = true;
  }

  ImGui::SetCursorScreenPos(area.min);
  ImGui::InvisibleButton("picture-difference", {std::max(area.width(), 1.f), std::max(area.height(), 1.f)},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  controls().record("picture", state.identical ? "identical" : "different");
  picture_input(session, state, Side::a, area, {});
  state.areas[0] = area;
  PictureStyle style;
  style.grid = state.grid;
  style.marked = session.pixel();
  style.region = session.region();
  draw_picture(list, state.flip ? state.pictures[1] : state.difference, state.transform, area, style);
  if (state.identical && !session.busy()) draw_notice(list, area, "A and B are identical.");
}

Area with_margins(const Area& area, Area& title_row, Area& footer_row) {
  title_row = {area.min, {area.max.x, area.min.y + px(title_height)}};
  footer_row = {{area.min.x, area.max.y - px(footer_height)}, area.max};
  return {{area.min.x, title_row.max.y}, {area.max.x, footer_row.min.y}};
}

struct Halves {
  Area first, second;
};
/// Side by side or one above the other, whichever shows the pictures larger.
Halves halves(const Area& area, Vec2i picture_size) {
  const float space = px(gap);
  const float middle_x = std::round((area.min.x + area.max.x) / 2),
              middle_y = std::round((area.min.y + area.max.y) / 2);
  const Halves beside{{area.min, {middle_x - space / 2, area.max.y}}, {{middle_x + space / 2, area.min.y}, area.max}};
  const Halves stacked{{area.min, {area.max.x, middle_y}}, {{area.min.x, middle_y}, area.max}};
  Area title_row, footer_row;
  const double beside_zoom = fitted(picture_size, with_margins(beside.first, title_row, footer_row)).zoom;
  const double stacked_zoom = fitted(picture_size, with_margins(stacked.first, title_row, footer_row)).zoom;
  return stacked_zoom > beside_zoom ? stacked : beside;
}

void one_side(Session& session, PicturesState& state, Side side, const Area& area) {
  Area title_row, footer_row;
  const Area inner = with_margins(area, title_row, footer_row);
  state.transform = current_transform(session.document(), state.pictures[index_of(side)].size(), inner);
  const Side shown = state.flip ? other_side(side) : side;
  title(session, shown, title_row);
  picture(session, state, side, inner, {});
  footer(session, shown, footer_row);
}

void split_view(Session& session, PicturesState& state, const Area& area) {
  Area title_row, footer_row;
  const Area inner = with_margins(area, title_row, footer_row);
  state.transform = current_transform(session.document(), state.pictures[0].size(), inner);
  const Area whole = state.transform.picture_area(state.pictures[0].size(), inner);
  const float low = std::max(whole.min.x, inner.min.x), high = std::min(whole.max.x, inner.max.x);
  const float at = std::round(low + (high - low) * static_cast<float>(session.document().split));
  const float middle = (area.min.x + area.max.x) / 2, space = px(gap) / 2;
  const Side left = state.flip ? Side::b : Side::a;
  title(session, left, {title_row.min, {middle - space, title_row.max.y}});
  title(session, other_side(left), {{middle + space, title_row.min.y}, title_row.max});
  picture(session, state, Side::a, inner, Split{at});
  state.areas[1] = inner;
  divider({{inner.min.x, std::max(inner.min.y, whole.min.y)}, {inner.max.x, std::min(inner.max.y, whole.max.y)}}, at,
          session.document().split);
  footer(session, left, {footer_row.min, {middle - space, footer_row.max.y}});
  footer(session, other_side(left), {{middle + space, footer_row.min.y}, footer_row.max});
}

/// A and B around the mouse, greatly enlarged, side by side.
void loupe(const PicturesState& state) {
  if (!state.loupe || !state.hover) return;
  auto& list = *ImGui::GetForegroundDrawList();
  const float size = px(195), space = px(6), away = px(24);
  const ImVec2 mouse = ImGui::GetIO().MousePos, window = ImGui::GetIO().DisplaySize;
  ImVec2 corner{mouse.x + away, mouse.y + away};
  if (corner.x + 2 * size + space > window.x) corner.x = mouse.x - away - 2 * size - space;
  if (corner.y + size > window.y) corner.y = mouse.y - away - size;
  corner = {std::max(corner.x, 0.f), std::max(corner.y, 0.f)};
  for (const Side side : both_sides) {
    const float left = corner.x + static_cast<float>(index_of(side)) * (size + space);
    draw_loupe(list, state.pictures[index_of(side)], state.hover->pixel,
               {{left, corner.y}, {left + size, corner.y + size}});
    badge(list, {left + px(4), corner.y + px(4)}, px(20), side);
  }
}

}  // namespace

void collect_pictures(Session& session, PicturesState& state) {
  for (const Side side : both_sides) {
    auto& picture = state.pictures[index_of(side)];
    const auto changed = session.renderer(side).collect(picture.levels);
    if (changed.empty()) continue;
    picture.upload(changed);
    state.fresh[index_of(side)] = true;
    state.difference_stale = true;
  }
}

void pictures_panel(Session& session, PicturesState& state, const Area& area) {
  state.areas = {};
  state.hover.reset();
  switch (session.document().compare) {
  case CompareMode::side_by_side: {
    const auto parts = halves(area, state.pictures[0].size());
    one_side(session, state, Side::a, parts.first);
    one_side(session, state, Side::b, parts.second);
    break;
  }
  case CompareMode::split:
    split_view(session, state, area);
    break;
  case CompareMode::difference: {
    Area title_row, footer_row;
    const Area inner = with_margins(area, title_row, footer_row);
    state.transform = current_transform(session.document(), state.pictures[0].size(), inner);
    difference_view(session, state, title_row, inner);
    const float middle = (area.min.x + area.max.x) / 2;
    footer(session, Side::a, {footer_row.min, {middle, footer_row.max.y}}, "A   ");
    footer(session, Side::b, {{middle, footer_row.min.y}, footer_row.max}, "B   ");
    break;
  }
  case CompareMode::only_a:
    one_side(session, state, Side::a, area);
    break;
  case CompareMode::only_b:
    one_side(session, state, Side::b, area);
    break;
  }
  loupe(state);
}

}  // namespace ps::gui
