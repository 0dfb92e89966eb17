#include "gui/panels/pictures/pictures_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/panels/pictures/difference_view.h"
#include "gui/panels/pictures/handles_view.h"
#include "gui/panels/pictures/left_out_line.h"
#include "gui/panels/pictures/legend_range.h"
#include "gui/panels/pictures/orbit_ball.h"
#include "gui/panels/pictures/picture_frame.h"
#include "gui/panels/pictures/picture_gizmo.h"
#include "gui/panels/pictures/picture_text.h"
#include "gui/panels/pictures/slow_strip.h"
#include "gui/platform/imgui_version.h"
#include "gui/widgets/redraw.h"
#include "gui/widgets/widgets.h"
#include "render/left_out.h"
#include "render/renderer_table.h"
#include "render/story/names.h"

namespace ps::gui {
void picture_handles(Session& session, PicturesState& state, Side side, const Area& area, const Area& clip,
                     const std::string& prefix, bool hovered) {
  if (!session.has_scene()) return;
  picture_gizmo(session, state, side, area, clip, prefix, hovered);
  if (!state.handles || state.mouse.drag == PictureDrag::gizmo) return;
  const bool dragging = state.mouse.drag == PictureDrag::handle;
  std::string held = dragging && state.mouse.drag_side == side ? state.mouse.grabbed->path : "";
  auto all = visible_handles(session.scene(), session.view(), session.settings(side), state.drawn.transform, area);
  std::erase_if(all, [&](const Handle& handle) {
    return handle.path != held && !clip.contains(state.drawn.transform.to_window(handle.place, area));
  });
  record_handles(prefix, all, state.drawn.transform, area);
  if (!hovered || flying(state)) return;
  if (dragging && state.mouse.drag_side != side) return;
  if (!dragging && state.mouse.drag != PictureDrag::none && state.mouse.drag != PictureDrag::undecided) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (!dragging && clip.contains(mouse))
    if (const Handle* under = handle_at(all, mouse, state.drawn.transform, area)) held = under->path;
  if (!held.empty()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  draw_handles(*ImGui::GetWindowDrawList(), all, held, state.drawn.transform, area);
}

namespace {

constexpr double gap = 8;          // between two pictures
constexpr double long_wait = 500;  // milliseconds without a new pixel until that is said

PictureTransform fitted_as(PictureFit fit, Vec2i size, const Area& area) {
  PictureTransform result = fitted(size, area);
  if (fit == PictureFit::whole_place && size.x > 0 && size.y > 0)
    result.zoom =
        std::clamp(std::min(static_cast<double>(area.width()) / size.x, static_cast<double>(area.height()) / size.y),
                   smallest_zoom, largest_zoom);
  return result;
}

PictureTransform current_transform(const Document& document, Vec2i size, const Area& area, PictureFit fit) {
  if (document.view.zoom <= 0) return fitted_as(fit, size, area);
  return {document.view.zoom, {document.view.middle.x * size.x, document.view.middle.y * size.y}};
}

/// Says why a picture is empty where the scene has no object, or none that its renderer can show.
void nothing_drawn(Session& session, Side side, const Area& area) {
  if (session.scene().geometry->objects.empty() && !session.traits().canvas_items) {
    draw_notice(*ImGui::GetWindowDrawList(), area,
                "This scene is empty: every pixel is background. Drop a .scene or .obj file here, or choose one from "
                "the Scene menu.");
    return;
  }
  if (!session.renderer(side).result() || !leaves_out_all(session.traits(), session.settings(side))) return;
  draw_notice(*ImGui::GetWindowDrawList(), area, left_out(session.traits(), session.settings(side)).front().sentence);
}

/// The picture of a side: its own, or while that is asked for the one before the last change.
const ShownPicture& shown_picture(const Session& session, PicturesState& state, Side side) {
  if (state.keys.was)
    if (const ShownPicture* before = state.sides.before[index_of(side)].before(session.change())) return *before;
  return state.pictures[index_of(side)];
}

bool shows_before(const Session& session, PicturesState& state, Side side) {
  return &shown_picture(session, state, side) != &state.pictures[index_of(side)];
}

/// The line above what a side shows.
void title(Session& session, PicturesState& state, Side side, const Area& row) {
  picture_title(session, side, row, state.drawn.captions,
                shows_before(session, state, side) ? "before the last change" : "");
}

/// Hides a picture that would answer an open question. `area` is where it is seen.
void cover_whole(ImDrawList& list, Side side, const Area& area, PictureCaptions captions) {
  list.AddRectFilled(area.min, area.max, colour_u32(palette().panel));
  draw_notice(list, area, fmt::format("{} is shown after your answer.", letter_of(side)),
              captions == PictureCaptions::projected ? Face::caption : Face::body);
  controls().record(side == Side::a ? "view/a/covered" : "view/b/covered", area.min, area.max, "covered");
}

/// The picture of one side in its area, with what lies over it. `split`: window x of the divider.
void picture(Session& session, PicturesState& state, Side side, const Area& area, std::optional<float> split) {
  auto& list = *ImGui::GetWindowDrawList();
  const std::size_t index = index_of(side);
  ImGui::SetCursorScreenPos(area.min);
  {
    const Overlappable by_controls_of_the_legend;
    ImGui::InvisibleButton(side == Side::a ? "picture-a" : "picture-b",
                           {std::max(area.width(), 1.f), std::max(area.height(), 1.f)},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle | Overlappable::button_flags());
  }
  controls().record(side == Side::a ? "view/a/picture" : "view/b/picture", std::string(1, letter_of(side)));
  const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
  picture_input(session, state, side, area, split);
  state.drawn.areas[index] = area;

  const Side shown_side = state.keys.flip ? other_side(side) : side;
  const auto style_of = [&](Side which) {
    PictureStyle style;
    style.grid = state.grid;
    if (!gizmo_in_picture(session, state, which, area)) style.marked = session.pixel();
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
  const auto cover = [&](Side which) {
    if (state.drawn.covers.hidden[index_of(which)]) {
      const ImVec2 low = list.GetClipRectMin(), high = list.GetClipRectMax();
      return cover_whole(list, which,
                         {{std::max(low.x, area.min.x), area.min.y}, {std::min(high.x, area.max.x), area.max.y}},
                         state.drawn.captions);
    }
    if (!state.drawn.covers.asked || state.drawn.covers.asked->side != which) return;
    const Vec2i pixel = state.drawn.covers.asked->pixel;
    const ImVec2 at = state.drawn.transform.to_window({pixel.x + 0.5, pixel.y + 0.5}, area);
    const float radius = std::max(px(16), static_cast<float>(state.drawn.transform.zoom) * 3);
    list.AddCircleFilled(at, radius, colour_u32(palette().panel));
    list.AddCircle(at, radius, colour_u32(palette().text), 0, px(2));
    ImFont* font = theme().font(Face::heading);
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, "?");
    list.AddText(font, font->FontSize, {at.x - size.x / 2, at.y - size.y / 2}, colour_u32(palette().text), "?");
  };
  const auto draw_nan = [&](Side which) {
    if (session.shown(which) != ShownChannel::colour) return;
    const auto result = session.renderer(which).result();
    state.sides.nan_pixels[index_of(which)].draw(list, result, state.drawn.transform, area);
    const auto pixels = result ? result->frame.counters.get(Counter::nan_pixels) : std::nullopt;
    if (pixels.value_or(0) > 0)
      controls().record(which == Side::a ? "view/a/nan" : "view/b/nan", area.min, area.max,
                        fmt::format("{} pixels are not a number", *pixels));
  };
  const auto mark_last = [&](Side which) {
    if (state.drawn.covers.hidden[index_of(which)] || state.keys.was) return;
    if (const auto slow = slow_state(session, which)) slow_mark(list, *slow, state.drawn.transform, area);
  };
  list.PushClipRect(area.min, {split ? *split : area.max.x, area.max.y}, true);
  draw_picture(list, shown_picture(session, state, shown_side), state.drawn.transform, area, style_of(shown_side));
  draw_nan(shown_side);
  mark_last(shown_side);
  cover(shown_side);
  list.PopClipRect();
  if (split) {
    const Side right = other_side(shown_side);
    list.PushClipRect({*split, area.min.y}, area.max, true);
    draw_picture(list, shown_picture(session, state, right), state.drawn.transform, area, style_of(right));
    draw_nan(right);
    mark_last(right);
    cover(right);
    list.PopClipRect();
  }
  if (session.shown(shown_side) != ShownChannel::colour && !state.drawn.covers.hidden[index_of(shown_side)]) {
    ChannelLegend legend = session.renderer(shown_side).legend();
    for (auto& entry : legend.entries)
      if (entry.object >= 0) entry.meaning = object_name(session.scene(), entry.object);
    const Area seen = state.drawn.transform.seen(state.pictures[index].size(), area);
    if (const auto scale = draw_legend(list, legend, seen)) legend_range(session, state, shown_side, legend, *scale);
  }
  const auto handles_in = [&](Side which, const Area& clip) {
    if (state.drawn.covers.hidden[index_of(which)]) return;
    draw_vertex_marks(session, state.vertices, which, state.drawn.transform, area, clip);
    picture_handles(session, state, which, area, clip, which == Side::a ? "view/a" : "view/b", hovered);
  };
  if (split) {
    handles_in(side, {area.min, {*split - px(divider_reach), area.max.y}});
    handles_in(other_side(side), {{*split + px(divider_reach), area.min.y}, area.max});
  } else {
    handles_in(side, area);
  }
  draw_orbit_ball(session, state, area, side == Side::a ? "view/a/orbit" : "view/b/orbit", hovered);
  const auto status = session.renderer(shown_side).status();
  if (status.state == RenderState::failed) draw_notice(list, area, status.message);
  // Until the first pixels come, the picture before is shown.
  if (status.waited > long_wait)
    draw_notice(list, split ? Area{area.min, {*split, area.max.y}} : area,
                fmt::format("{} is being prepared ...", letter_of(shown_side)));
  if (status.state == RenderState::done && !split) nothing_drawn(session, shown_side, area);
}

/// The divider that picture_input() drags; here it is drawn and published to scripts.
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

/// The lines around a picture, and what they leave to it.
struct Framed {
  Area title, picture, footer;
};
/// `columns`: how many titles are side by side over the picture.
Framed framed(const Area& area, PictureCaptions captions, int columns = 1) {
  const PictureMargins margins = picture_margins(area.width() / static_cast<float>(columns), captions);
  const float top = area.min.y + margins.title, bottom = area.max.y - margins.footer;
  return {{area.min, {area.max.x, top}}, {{area.min.x, top}, {area.max.x, bottom}}, {{area.min.x, bottom}, area.max}};
}

constexpr float least_block = 0.6f;  // of the height that there is, for a wide picture that is zoomed into
constexpr double narrowest_title = 380, narrow_title = 200;  // at scale 1: with all in one line, and else

/// Title, picture and footer as one block in the middle of what framed() leaves to them. The lines begin where the
/// picture is seen to begin, or as far to the left as a title needs it.
Framed as_block(const Session& session, const DrawnPictures& drawn, Framed in, Vec2i picture_size) {
  if (picture_size.x <= 0) return in;
  const double zoom = fitted_as(drawn.fit, picture_size, in.picture).zoom;
  const float room = in.picture.height(), width = in.picture.width();
  const float height = std::ceil(static_cast<float>(zoom * picture_size.y));
  const float least_height = session.document().view.zoom > 0 ? room * least_block : 0;
  const float spare = std::max(std::floor((room - std::max(height, least_height)) / 2), 0.f);
  in.picture.min.y += spare;
  in.picture.max.y -= spare;
  const Area seen =
      current_transform(session.document(), picture_size, in.picture, drawn.fit).seen(picture_size, in.picture);
  const bool one_line = drawn.captions == PictureCaptions::full && width >= px(narrowest_title);
  const float least = std::min(px(one_line ? narrowest_title : narrow_title), width);
  const float left = std::min(std::floor(seen.min.x), in.picture.max.x - least);
  const float right = left + std::max(seen.max.x - left, std::min(px(narrowest_title), in.picture.max.x - left));
  in.title = {{left, in.title.min.y + spare}, {right, in.title.max.y + spare}};
  in.footer = {{left, in.footer.min.y - spare}, {right, in.footer.max.y - spare}};
  return in;
}

/// Side by side or one above the other, whichever shows the pictures larger.
Halves halves(const Area& area, Vec2i picture_size, PictureCaptions captions) {
  const float space = px(gap);
  // Equal to the pixel, so that both pictures have the same size and height.
  const float half = std::floor((area.width() - space) / 2), middle_y = std::round((area.min.y + area.max.y) / 2);
  const Halves beside{{area.min, {area.min.x + half, area.max.y}}, {{area.max.x - half, area.min.y}, area.max}};
  const Halves stacked{{area.min, {area.max.x, middle_y}}, {{area.min.x, middle_y}, area.max}};
  const double beside_zoom = fitted(picture_size, framed(beside.first, captions).picture).zoom;
  const double stacked_zoom = fitted(picture_size, framed(stacked.first, captions).picture).zoom;
  const bool tall = area.height() > area.width();  // where both show them alike, the titles have more room
  return stacked_zoom > beside_zoom || (tall && stacked_zoom == beside_zoom) ? stacked : beside;
}

/// How many window pixels a picture takes that fits an area.
double pixels_of(Vec2i picture_size, const Area& area, PictureFit fit) {
  const double zoom = fitted_as(fit, picture_size, area).zoom;
  return zoom * picture_size.x * zoom * picture_size.y;
}

/// "31 % of pixels differ"; empty while one of the pictures is still being made, shows no colours, or is covered by a
/// question, which the number might answer.
std::string difference_text(Session& session, PicturesState& state) {
  for (const Side side : both_sides)
    if (state.drawn.covers.hidden[index_of(side)] || session.shown(side) != ShownChannel::colour ||
        slow_state(session, side) ||
        (!session.file_of(side) && session.renderer(side).status().state != RenderState::done))
      return {};
  const Image<Rgb8>&a = state.pictures[0].levels, &b = state.pictures[1].levels;
  if (a.empty() || a.width() != b.width() || a.height() != b.height()) return {};
  if (std::exchange(state.sides.compared, state.versions) != state.versions) {
    std::size_t count = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) count += a.at(x, y) != b.at(x, y) ? 1 : 0;
    state.sides.differing = static_cast<double>(count) / (static_cast<double>(a.width()) * a.height());
  }
  if (state.sides.differing == 0) return "the same picture as A";
  return fmt::format("{} % of pixels differ", three_digits(100 * state.sides.differing));
}

void below(Session& session, PicturesState& state, Side side, const Area& footer, const std::string& lead = {}) {
  auto& note = state.drawn.notes[index_of(side)];
  note.reset();
  if (state.drawn.covers.hidden[index_of(side)]) return;  // its counters would answer the question as well
  if (shows_before(session, state, side)) {               // what is known is about the picture after the change
    controls().record(side == Side::a ? "view/a/footer" : "view/b/footer", footer.min, footer.max, "");
    return;
  }
  note = picture_note(footer, state.drawn.captions);
  if (note) note = left_out_line(session, side, *note);
  const std::string beside = side == Side::b && lead.empty() && state.drawn.compare != CompareMode::only_b
                                 ? difference_text(session, state)
                                 : std::string();
  picture_footer(session, side, state.sides.changes[index_of(side)], footer, state.drawn.captions, lead, beside);
}

void one_side(Session& session, PicturesState& state, Side side, const Area& area) {
  const auto [title_row, inner, footer] =
      as_block(session, state.drawn, framed(area, state.drawn.captions), state.pictures[index_of(side)].size());
  state.drawn.transform =
      current_transform(session.document(), state.pictures[index_of(side)].size(), inner, state.drawn.fit);
  const Side shown = state.keys.flip ? other_side(side) : side;
  title(session, state, shown, title_row);
  picture(session, state, side, inner, {});
  below(session, state, shown, footer);
}

void split_view(Session& session, PicturesState& state, const Area& area) {
  const auto [title_row, inner, footer] =
      as_block(session, state.drawn, framed(area, state.drawn.captions, 2), state.pictures[0].size());
  state.drawn.transform = current_transform(session.document(), state.pictures[0].size(), inner, state.drawn.fit);
  const Area seen = state.drawn.transform.seen(state.pictures[0].size(), inner);
  const float at = std::round(seen.min.x + seen.width() * static_cast<float>(session.document().split));
  const Side left = state.keys.flip ? Side::b : Side::a, right = other_side(left);
  const auto width = [&, height = title_row.height()](Side side) {
    return title_width(session, side, height, state.drawn.captions);
  };
  const Halves titles = over_parts(title_row, inner, at, width(left), width(right), px(gap));
  title(session, state, left, titles.first);
  title(session, state, right, titles.second);
  state.drawn.split_at = at;
  picture(session, state, Side::a, inner, at);
  state.drawn.areas[1] = inner;
  divider(seen, at, session.document().split);
  const Halves lines = over_parts(footer, inner, at, px(narrow_title), px(narrowest_title), px(gap));
  below(session, state, left, lines.first);
  below(session, state, right, lines.second);
}

/// A and B around the mouse, greatly enlarged, side by side.
void loupe(const PicturesState& state) {
  if (!state.keys.loupe || !state.mouse.hover || state.drawn.covers.asked || state.drawn.covers.hidden[0] ||
      state.drawn.covers.hidden[1])
    return;
  auto& list = *ImGui::GetForegroundDrawList();
  const float size = px(195), space = px(6), away = px(24);
  const ImVec2 mouse = ImGui::GetIO().MousePos, window = ImGui::GetIO().DisplaySize;
  ImVec2 corner{mouse.x + away, mouse.y + away};
  if (corner.x + 2 * size + space > window.x) corner.x = mouse.x - away - 2 * size - space;
  if (corner.y + size > window.y) corner.y = mouse.y - away - size;
  corner = {std::max(corner.x, 0.f), std::max(corner.y, 0.f)};
  for (const Side side : both_sides) {
    const float left = corner.x + static_cast<float>(index_of(side)) * (size + space);
    draw_loupe(list, state.pictures[index_of(side)], state.mouse.hover->pixel,
               {{left, corner.y}, {left + size, corner.y + size}});
    side_badge(list, {left + px(4), corner.y + px(4)}, px(20), side);
  }
}

/// The mouse is on the way to a pixel of a picture whose first story takes long: one that a graphics driver has drawn,
/// or SIMD searches, which have another tree than the story.
void prepare_story(const Session& session, RenderWorker& renderer, const Hover& hover, StoryAhead& ahead) {
  const auto result = renderer.result();
  if (!result || renderer.status().state != RenderState::done || ImGui::IsAnyMouseDown()) return;
  if (result->request.settings != session.settings(hover.side)) return;
  if (renderer_row(result->request.settings.renderer).by_driver ||
      result->frame.path.machinery == Machinery::wide_triangles)
    ahead.prepare(result->request, hover.pixel, session.work().prepared());
}

}  // namespace

void collect_pictures(Session& session, PicturesState& state) {
  update_slow_motion(session, state.slow);
  for (const Side side : both_sides) {
    auto& picture = state.pictures[index_of(side)];
    std::vector<TileRect> changed;
    if (const auto file = session.file_of(side)) {
      if (state.sides.file == file) continue;
      picture.levels = file->levels;
      changed = {{0, 0, file->levels.width(), file->levels.height()}};
    } else {
      changed = session.renderer(side).collect(picture.levels);
    }
    if (side == Side::b) state.sides.file = session.picture_b();
    const std::size_t index = index_of(side);
    if (!changed.empty()) {
      picture.upload(changed);
      ++state.versions[index];
      state.sides.fresh[index] = true;
      state.difference.stale = true;
    }
    if (state.sides.taken[index] == state.versions[index] || session.renderer(side).status().state != RenderState::done)
      continue;
    state.sides.taken[index] = state.versions[index];
    state.sides.before[index].take(picture.levels, session.shown(side), session.change());
  }
}

double pixels_on_screen(const PicturesState& state) {
  const auto seen = [&](Side side) {
    const auto& area = state.drawn.areas[index_of(side)];
    const Vec2i size = state.pictures[index_of(side)].size();
    if (!area || size.x <= 0) return 0.0;
    const Area in_sight = state.drawn.transform.seen(size, *area);
    return std::max(in_sight.width(), 0.f) * static_cast<double>(std::max(in_sight.height(), 0.f));
  };
  const auto& [a, b] = state.drawn.areas;
  const bool share_one = a && b && a->min.x == b->min.x && a->min.y == b->min.y;
  return share_one ? seen(Side::a) : seen(Side::a) + seen(Side::b);
}

void pictures_panel(Session& session, PicturesState& state, const Area& area, const PicturePlace& place) {
  state.drawn.captions = place.captions;
  state.drawn.covers = place.covers;
  state.drawn.fit = PictureFit::even_pixels;
  state.drawn.split_at.reset();
  state.drawn.areas = {};
  state.drawn.notes = {};
  state.mouse.hover.reset();
  // Only the difference asks for its number; one that comes after it was left must not keep the window from resting.
  state.difference.meter->rest();
  state.difference.meter->take_news();
  const CompareMode compared_last = std::exchange(state.drawn.compare, session.document().compare);
  const Vec2i size = state.pictures[0].size();
  const Area one = framed(area, state.drawn.captions, 2).picture;
  if (pixels_of(size, one, PictureFit::even_pixels) < place.least_pixels) state.drawn.fit = PictureFit::whole_place;
  switch (session.document().compare) {
  case CompareMode::side_by_side: {
    const auto parts = halves(area, size, state.drawn.captions);
    const Area each = framed(parts.first, state.drawn.captions).picture;
    state.drawn.fit = PictureFit::even_pixels;
    if (2 * pixels_of(size, each, PictureFit::even_pixels) < place.least_pixels)
      state.drawn.fit = PictureFit::whole_place;
    const double two = 2 * pixels_of(size, each, state.drawn.fit);
    if (place.two == TwoPictures::may_share && two < place.least_pixels &&
        pixels_of(size, one, state.drawn.fit) > two) {
      state.drawn.compare = CompareMode::split;
      split_view(session, state, area);
      break;
    }
    one_side(session, state, Side::a, parts.first);
    one_side(session, state, Side::b, parts.second);
    break;
  }
  case CompareMode::split:
    split_view(session, state, area);
    break;
  case CompareMode::difference: {
    auto [title, inner, footer] = framed(area, state.drawn.captions, 2);
    // Its tools are as high as controls are, also where titles are brief.
    inner.min.y = title.max.y = std::max(title.max.y, title.min.y + ImGui::GetFrameHeight() + px(4));
    const DifferencePlaces places = difference_places(inner, state.pictures[0].size());
    state.drawn.transform =
        current_transform(session.document(), state.pictures[0].size(), places.picture, state.drawn.fit);
    difference_view(session, state, title, places);
    for (const Side side : both_sides)  // the difference shows both
      if (state.drawn.covers.hidden[index_of(side)])
        cover_whole(*ImGui::GetWindowDrawList(), side, inner, state.drawn.captions);
    const float middle = (area.min.x + area.max.x) / 2, space = px(gap) / 2;
    below(session, state, Side::a, {footer.min, {middle - space, footer.max.y}}, "A   ");
    below(session, state, Side::b, {{middle + space, footer.min.y}, footer.max}, "B   ");
    break;
  }
  case CompareMode::only_a:
    one_side(session, state, Side::a, area);
    break;
  case CompareMode::only_b:
    one_side(session, state, Side::b, area);
    break;
  }
  if (state.drawn.compare != compared_last) redraw_after(0);  // the menu bar, which was drawn before, shows it
  loupe(state);
  if (state.mouse.hover)
    prepare_story(session, session.renderer(state.mouse.hover->side), *state.mouse.hover, state.ahead);
}

}  // namespace ps::gui
