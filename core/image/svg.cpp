#include "image/svg.h"

#include <fmt/format.h>

#include <array>

#include "base/enumerators.h"
#include "image/codec.h"

namespace ps {
namespace {

std::string hex(const Tint& tint) {
  const Rgb8 shade = tint.role == Role::own ? tint.own : paper_shade(tint.role);
  return fmt::format("#{:02x}{:02x}{:02x}", shade.r, shade.g, shade.b);
}

/// " fill="#202020" fill-opacity="0.5"", or of another property.
std::string colour_attribute(std::string_view property, const Tint& tint) {
  std::string text = fmt::format(" {}=\"{}\"", property, hex(tint));
  if (tint.opacity < 1) text += fmt::format(" {}-opacity=\"{:.3g}\"", property, tint.opacity);
  return text;
}

std::string stroke_attributes(const Stroke& stroke) {
  std::string text = colour_attribute("stroke", stroke.tint) + fmt::format(" stroke-width=\"{:.4g}\"", stroke.width);
  if (stroke.dash != unbroken)
    text += fmt::format(" stroke-dasharray=\"{:.4g} {:.4g}\"", stroke.dash.on, stroke.dash.off);
  return text;
}

std::string attributes(const ShapeLook& look) {
  return (look.fill ? colour_attribute("fill", *look.fill) : " fill=\"none\"") +
         (look.stroke ? stroke_attributes(*look.stroke) : "");
}

std::string points_attribute(std::span<const Vec2d> points) {
  std::string text = " points=\"";
  for (const Vec2d& point : points) text += fmt::format("{:.2f},{:.2f} ", point.x, point.y);
  return text + "\"";
}

/// Attributes of a rectangle.
std::string place_attributes(const PaintArea& area) {
  return fmt::format(" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"", area.low.x, area.low.y,
                     area.width(), area.height());
}

/// Shades by Role.
constexpr std::array<Rgb8, static_cast<std::size_t>(Role::own)> shades{{{0x1a, 0x1a, 0x19},    // ink
                                                                        {0x3a, 0x3b, 0x39},    // quiet
                                                                        {0x7c, 0x7d, 0x79},    // border
                                                                        {0xd6, 0xd6, 0xd2},    // faint
                                                                        {0xff, 0xff, 0xff},    // paper
                                                                        {0x00, 0x72, 0xb2},    // a
                                                                        {0xd5, 0x5e, 0x00},    // b
                                                                        {0x00, 0x77, 0x5a},    // right
                                                                        {0xa0, 0x4a, 0x80},    // wrong
                                                                        {0xf0, 0xe4, 0x42},    // attention
                                                                        {0xe6, 0x9f, 0x00},    // light
                                                                        {0x56, 0xb4, 0xe9},    // mirror
                                                                        {0x18, 0x18, 0x18},    // dark
                                                                        {0xff, 0xff, 0xff}}};  // bright

struct SvgFace {
  double em;
  std::string_view attributes;
};
constexpr double label_em = 13, body_em = 17, heading_em = 22, script_em = 0.7 * body_em;
constexpr std::string_view plain, bold = " font-weight=\"600\"", italic = " font-style=\"italic\"";
/// Faces by Lettering.
constexpr std::array<SvgFace, enumerator_count<Lettering>()> faces{{{label_em, plain},
                                                                    {label_em, bold},
                                                                    {body_em, plain},
                                                                    {body_em, bold},
                                                                    {body_em, italic},
                                                                    {heading_em, bold},
                                                                    {script_em, plain},
                                                                    {script_em, bold},
                                                                    {script_em, italic}}};
const SvgFace& face_of(Lettering lettering) { return faces[static_cast<std::size_t>(lettering)]; }

/// Names by TextAnchor.
constexpr std::array<std::string_view, 3> anchors{"start", "middle", "end"};

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) switch (c) {
    case '<':
      safe += "&lt;";
      break;
    case '>':
      safe += "&gt;";
      break;
    case '&':
      safe += "&amp;";
      break;
    case '"':
      safe += "&quot;";
      break;
    case '\'':
      safe += "&apos;";
      break;
    default:
      safe += c;
    }
  return safe;
}

std::string base64(std::string_view bytes) {
  static constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? letters[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

double em_of(Lettering lettering) { return face_of(lettering).em; }

Rgb8 paper_shade(Role role) {
  PS_ASSERT(role != Role::own, "Role::own has no shade");
  return shades[static_cast<std::size_t>(role)];
}

SvgPainter::SvgPainter(double width, double height, std::string_view title) : Painter(1) {
  body_ = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
                      "width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
                      "font-family=\"Inter, Helvetica, Arial, sans-serif\">\n<title>{2}</title>\n"
                      "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
                      width, height, xml_escaped(title));
}

void SvgPainter::polyline(std::span<const Vec2d> points, const Stroke& stroke) {
  if (points.size() == 2)
    body_ += fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"{}/>\n", points[0].x,
                         points[0].y, points[1].x, points[1].y, stroke_attributes(stroke));
  else
    body_ += fmt::format("<polyline{} fill=\"none\"{}/>\n", points_attribute(points), stroke_attributes(stroke));
}

void SvgPainter::polygon(std::span<const Vec2d> corners, const ShapeLook& look) {
  body_ += fmt::format("<polygon{}{}/>\n", points_attribute(corners), attributes(look));
}

void SvgPainter::rectangle(const PaintArea& area, const ShapeLook& look, double rounding) {
  body_ += fmt::format("<rect{}{}{}/>\n", place_attributes(area),
                       rounding > 0 ? fmt::format(" rx=\"{:.4g}\"", rounding) : "", attributes(look));
}

void SvgPainter::circle(const Vec2d& middle, double radius, const ShapeLook& look) {
  body_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"{}/>\n", middle.x, middle.y, radius,
                       attributes(look));
}

void SvgPainter::picture(const PaintArea& area, const Image<Rgb8>& levels) {
  body_ += fmt::format("<image{} preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" "
                       "xlink:href=\"data:image/png;base64,{}\"/>\n",
                       place_attributes(area), base64(stb_encode_png(levels)));
}

void SvgPainter::begin_clip(const PaintArea& area) {
  const int id = clips_++;
  body_ += fmt::format("<clipPath id=\"clip{0}\"><rect{1}/></clipPath>\n<g clip-path=\"url(#clip{0})\">\n", id,
                       place_attributes(area));
}

void SvgPainter::end_clip() { body_ += "</g>\n"; }

void SvgPainter::begin_named(const std::function<std::string()>& words) {
  body_ += fmt::format("<g><title>{}</title>\n", xml_escaped(words()));
}

void SvgPainter::end_named() { body_ += "</g>\n"; }

TextExtent SvgPainter::extent(std::string_view text, Lettering lettering) const {
  double ems = 0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0u) == 0x80u) continue;  // a further byte of a letter
    const bool narrow = std::string_view("ijlt.,:;'|!()[]f1 -").find(c) != std::string_view::npos;
    const bool wide = std::string_view("mwMW%@").find(c) != std::string_view::npos;
    ems += narrow ? 0.35 : wide ? 0.88 : c >= 'A' && c <= 'Z' ? 0.7 : 0.6;
  }
  constexpr double ascent = 0.97, descent = 0.24;  // of Inter, in ems
  const double em = em_of(lettering);
  return {ems * em, ascent * em, descent * em};
}

void SvgPainter::write(const Vec2d& at, std::string_view words, const TextLook& look) {
  const SvgFace face = face_of(look.lettering);
  const auto put = [&](const std::string& colours) {
    body_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.4g}\" text-anchor=\"{}\"{}{}>{}</text>\n",
                         at.x, at.y, face.em, anchors[static_cast<std::size_t>(look.anchor)], face.attributes, colours,
                         xml_escaped(words));
  };
  // The rim is a text of its own: not every program that shows SVG knows paint-order, and without it the rim would
  // cover the letters.
  if (look.ground == TextGround::rim)
    put(attributes({.fill = look.ground_tint, .stroke = Stroke{.tint = look.ground_tint, .width = 3}}));
  put(colour_attribute("fill", look.tint));
}

}  // namespace ps
