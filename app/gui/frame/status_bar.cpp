#include "gui/frame/status_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "gui/session/pixel_words.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/redraw.h"
#include "gui/widgets/shorten.h"
#include "gui/widgets/widgets.h"
#include "options/renderer_kind.h"
#include "render/channel_picture.h"
#include "render/story/names.h"

namespace ps::gui {
namespace {

constexpr float most_for_news = 0.6f;  // of the line
constexpr double patience = 0.4;       // seconds of work before it is shown

bool rendering(Session& session, Side side) {
  const auto state = session.renderer(side).status().state;
  return state == RenderState::coarse || state == RenderState::full;
}

MessageKind kind_of(Message::Kind kind) {
  switch (kind) {
  case Message::Kind::information:
    return MessageKind::information;
  case Message::Kind::warning:
    return MessageKind::warning;
  case Message::Kind::error:
    return MessageKind::error;
  }
  return MessageKind::information;
}

void progress(Session& session, float width) {
  if (session.loader().loading()) {
    const std::filesystem::path path = session.loader().name();
    const std::string name = path.has_extension() ? path.filename() : path;  // scenes of the program have none
    if (progress_bar("progress", "loading " + name, -1, width)) session.loader().cancel();
    return;
  }
  const bool a = rendering(session, Side::a), b = rendering(session, Side::b);
  double fraction = 1;
  for (const Side side : both_sides)
    if (rendering(session, side)) fraction = std::min(fraction, session.renderer(side).status().fraction);
  const char* label = a && b ? "rendering A and B" : a ? "rendering A" : "rendering B";
  if (progress_bar("progress", label, fraction, width))
    for (const Side side : both_sides) session.renderer(side).cancel();
}

/// Where the camera is and where it looks.
std::string camera_text(const Camera& camera) {
  const auto vector = [](const Vec3d& v) { return fmt::format("({:.3f}, {:.3f}, {:.3f})", v.x, v.y, v.z); };
  return fmt::format("camera {}   looks along {}   {} move, Esc ends", vector(camera.position), vector(camera.forward),
                     keyboard_layout().labels_of_places(fly_keys));
}

constexpr float most_for_messages = 0.35f;  // of the window's height; more of them is scrolled to

bool passes(const Message& message) { return message.kind == Message::Kind::information; }

std::string newest_news(const Session& session) {
  const auto& messages = session.messages().all();
  const auto newest = std::find_if(messages.rbegin(), messages.rend(), passes);
  return newest == messages.rend() ? std::string() : newest->text;
}

/// Behind a bar of its own, so that it is not taken for what is under the mouse. The first words, where not all fit.
void news_line(const std::string& news, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight();
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + px(1)}, {at.x + px(3), at.y + height},
                                            colour_u32(palette().line_strong));
  ImGui::SetCursorScreenPos({at.x + px(10), at.y});
  show_text(whole_words(news, width - px(9)));
  tooltip(news);
  controls().record("news", at, {at.x + width, at.y + height}, news);
}

/// As many of a text's parts, between wide blanks, as fit; as many of the first one's words, where that is too long.
std::string parts_in_room(std::string text, float room) {
  while (text_width(text) > room) {
    const std::size_t last = text.rfind("   ");
    if (last == std::string::npos) break;
    text.resize(last);
  }
  text = whole_words(text, room);
  return text_width(text) <= room ? text : std::string();
}

Face face_of(const StatusHint& hint) { return hint.kind == StatusHint::Kind::task ? Face::bold : Face::body; }

float hint_width(const StatusHint& hint) { return text_width(hint.text, face_of(hint)); }

void hint_line(const StatusHint& hint, float room) {
  const TextScope look({face_of(hint), hint.kind != StatusHint::Kind::task});
  const std::string shown = parts_in_room(hint.text, room);
  show_text(shown);
  if (shown != hint.text) tooltip(hint.text);
  controls().record("hint", hint.text);
}

void hover_line(const std::string& hover, float room) {
  const FontScope font(Face::mono);
  show_text(parts_in_room(hover, room));
  controls().record("hover", hover);
}

}  // namespace

std::string hover_text(Session& session, const PicturesState& pictures) {
  if (!pictures.mouse.hover) return {};
  const auto [side, pixel] = *pictures.mouse.hover;
  const auto result = session.renderer(side).result();
  if (pictures.drawn.covers.asked && pictures.drawn.covers.asked->pixel == pixel)
    return "Answer first; then this pixel is shown.";
  const auto& levels = pictures.pictures[index_of(side)].levels;
  if (!levels.contains(pixel.x, pixel.y)) return {};
  const Rgb8 level = levels.at(pixel.x, pixel.y);
  const std::string place = pixel_words(session, pixel);
  std::string text = fmt::format("{}   {}   {} {} {}", letter_of(side), place, level.r, level.g, level.b);
  if (session.file_of(side)) return text;
  if (session.document().compare == CompareMode::difference) {
    const auto& others = pictures.pictures[1].levels;
    if (!others.contains(pixel.x, pixel.y)) return text;
    const Rgb8 b = others.at(pixel.x, pixel.y);
    return fmt::format("{}   A {} {} {}   B {} {} {}   B − A {:+} {:+} {:+}", place, level.r, level.g, level.b, b.r,
                       b.g, b.b, b.r - level.r, b.g - level.g, b.b - level.b);
  }
  const bool fresh = result && result->frame.width() == levels.width() && result->frame.height() == levels.height();
  if (!fresh) return text;
  const ShownChannel channel = session.shown(side);
  if (channel != ShownChannel::colour && (result->channels | shown_channel(channel).needs) == result->channels)
    text += "   " + channel_value_text(result->frame, channel, session.settings(side), pixel);
  const bool knows_objects = !runs_listing(result->request.settings.renderer);  // a listing makes colours alone
  if (knows_objects && has(result->channels, Channel::ids)) {
    const PixelId id = result->frame.ids.at(pixel.x, pixel.y);
    text += "   " + (id.object < 0 ? std::string("background") : primitive_name(result->request.scene, id));
  }
  return text;
}

void status_bar(Session& session, const PicturesState& pictures, StatusBarState& state, const StatusHint& hint) {
  const NameScope scope("status");
  const double now = ImGui::GetTime();
  const bool working = session.loader().loading() || rendering(session, Side::a) || rendering(session, Side::b);
  if (!working)
    state.busy_since = -1;
  else if (state.busy_since < 0)
    state.busy_since = now;
  const bool shown = working && now - state.busy_since >= patience;
  const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x, gap = px(12);
  const float progress_width = std::min(px(330), std::max(px(290), width / 2));
  const float room = width - (shown ? progress_width + gap : 0);
  const std::string news = newest_news(session);
  const float wanted = news.empty() ? 0 : text_width(news) + px(10),
              news_width = std::min(wanted, room * most_for_news);
  state.news_cut = news_width < wanted;

  const std::string hover = flying(pictures) ? camera_text(session.view().camera) : hover_text(session, pictures);
  ImGui::AlignTextToFramePadding();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line_room = room - (news.empty() ? 0 : news_width + gap);
  ImGui::PushClipRect(at, {at.x + line_room, at.y + px(40)}, true);
  if (hover.empty()) {
    hint_line(hint, line_room);
  } else {
    // By a fixed width, so that the task does not come and go with the lengths of numbers.
    const float beside = hint_width(hint) + gap;
    const bool both = hint.kind == StatusHint::Kind::task && line_room - beside >= px(200);
    if (both) {
      hint_line(hint, line_room);
      ImGui::SameLine(0, gap);
    }
    hover_line(hover, line_room - (both ? beside : 0));
  }
  ImGui::PopClipRect();
  if (!news.empty()) {
    ImGui::SameLine(left + room - news_width);
    news_line(news, news_width);
  }
  if (!shown) return;
  ImGui::SameLine(left + width - progress_width);
  progress(session, progress_width);
}

void message_bars(Session& session, StatusBarState& state, float left, float right, float bottom) {
  if (session.messages().expire(ImGui::GetTime())) redraw_after(1);
  const auto& messages = session.messages().all();
  const float before = std::exchange(state.bars_height, 0.f);
  // News that their line would cut off are shown whole, over the panels, as they pass.
  const std::string cut = state.news_cut ? newest_news(session) : "";
  const auto elsewhere = [&](const Message& message) { return passes(message) && message.text != cut; };
  if (std::all_of(messages.begin(), messages.end(), elsewhere)) {
    if (before > 0) redraw_after(0);
    return;
  }
  ImGui::SetNextWindowPos({left, bottom}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSize({right - left, 0});
  const float most = ImGui::GetIO().DisplaySize.y * most_for_messages;
  ImGui::SetNextWindowSizeConstraints({right - left, 0}, {right - left, most});
  ImGui::Begin("messages", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_AlwaysAutoResize);
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (elsewhere(messages[i])) continue;
    if (!message_bar(fmt::format("message/{}", i), kind_of(messages[i].kind), messages[i].text)) continue;
    session.messages().dismiss(i);
    break;
  }
  state.bars_height = std::all_of(messages.begin(), messages.end(), passes) ? 0 : ImGui::GetWindowSize().y;
  if (state.bars_height != before) redraw_after(0);
  ImGui::End();
}

}  // namespace ps::gui
