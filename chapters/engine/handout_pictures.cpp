#include "engine/handout_pictures.h"

#include <fmt/format.h>

#include "frame/display_frame.h"
#include "image/codec.h"
#include "image/file.h"
#include "image/svg.h"
#include "options/difference_words.h"
#include "options/renderer_kind.h"
#include "render/render.h"
#include "render/slow_motion.h"

namespace ps {
namespace {

Image<Rgb8> picture_of(const Document& document, Side side, Prepared& prepared, Progress& progress) {
  if (side == Side::b && !document.picture_b.empty()) return load_levels(document.picture_b);
  const SideState& state = side_of(document, side);
  RenderRequest request;
  request.channels = shown_channel(state.show).needs;
  request.region = document.view.region;
  const View view = view_of(document);
  const auto slow = given_slow_motion(state.slow_motion, state.settings, scene_traits(document.scene), state.show);
  const Frame frame =
      slow ? render_slowly(document.scene, view, state.settings, *slow, request, prepared, progress).frame
           : render(document.scene, view, state.settings, request, prepared, progress);
  if (state.show == ShownChannel::colour) return display_frame(frame, state.settings);
  return channel_picture(frame, state.show, state.settings).levels;
}

/// "A shading: flat": settings that the other picture does not have, or the renderer where all are equal.
std::string caption(const Document& document, Side side) {
  const SideState& state = side_of(document, side);
  std::string words;
  const auto add = [&](const std::string& more) { words += fmt::format("{}{}", words.empty() ? "" : ", ", more); };
  if (state.show != ShownChannel::colour) add(std::string(shown_channel(state.show).label));
  const std::string difference = difference_words(state.settings, side_of(document, other_side(side)).settings);
  if (side == Side::b && !document.picture_b.empty())
    add(document.picture_b);
  else
    add(difference.empty() ? std::string(renderer_label(state.settings.renderer)) : difference);
  if (const auto& slow = state.slow_motion) add(fmt::format("after {} {}", slow->at, slow_unit(slow->unit).many));
  return fmt::format("<b>{}</b> {}", side == Side::a ? "A" : "B", xml_escaped(words));
}

constexpr int least_width = 240;  // in pixels of the page: below it the pixels of a picture cannot be seen one by one

/// A small picture with each pixel as a square of as many pixels as it takes to be `least_width` wide.
Image<Rgb8> as_printed(const Image<Rgb8>& levels) {
  const int side = levels.empty() ? 1 : (least_width + levels.width() - 1) / levels.width();
  Image<Rgb8> printed(levels.width() * side, levels.height() * side);
  for (int y = 0; y < printed.height(); ++y)
    for (int x = 0; x < printed.width(); ++x) printed.at(x, y) = levels.at(x / side, y / side);
  return printed;
}

std::string figure(const Image<Rgb8>& small, std::string_view letter, const std::string& caption) {
  const Image<Rgb8> levels = as_printed(small);
  return fmt::format("<figure><img alt=\"picture {}\" width=\"{}\" height=\"{}\" src=\"data:image/png;base64,{}\"/>"
                     "<figcaption>{}</figcaption></figure>\n",
                     letter, levels.width(), levels.height(), base64(stb_encode_png(levels)), caption);
}

}  // namespace

std::string pictures_html(const Document& document, const std::array<bool, 2>& covered, Progress& progress) {
  Prepared prepared;
  std::string html = "<div class=\"pictures\">\n";
  for (const Side side : {Side::a, Side::b}) {
    if (document.compare == (side == Side::a ? CompareMode::only_b : CompareMode::only_a)) continue;
    const std::string_view letter = side == Side::a ? "A" : "B";
    if (covered[side == Side::a ? 0 : 1])
      html += fmt::format("<figure><div class=\"covered\">{} is shown in the program after your answer.</div>"
                          "<figcaption>{}</figcaption></figure>\n",
                          letter, caption(document, side));
    else
      html += figure(picture_of(document, side, prepared, progress), letter, caption(document, side));
  }
  return html + "</div>\n";
}

}  // namespace ps
