#include "image/svg.h"

#include <fmt/format.h>

#include "image/codec.h"

namespace ps {
namespace {

std::string attributes(const SvgStyle& style) {
  std::string text = style.fill.empty() ? " fill=\"none\"" : fmt::format(" fill=\"{}\"", style.fill);
  if (!style.stroke.empty()) text += fmt::format(" stroke=\"{}\" stroke-width=\"{:.4g}\"", style.stroke, style.width);
  if (!style.dash.empty()) text += fmt::format(" stroke-dasharray=\"{}\"", style.dash);
  if (style.opacity < 1) text += fmt::format(" opacity=\"{:.3g}\"", style.opacity);
  return text;
}

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

SvgDrawing::SvgDrawing(double width, double height, std::string_view title) {
  body_ = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
                      "width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
                      "font-family=\"Inter, Helvetica, Arial, sans-serif\">\n<title>{2}</title>\n"
                      "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
                      width, height, xml_escaped(title));
}

void SvgDrawing::line(const Vec2d& from, const Vec2d& to, const SvgStyle& style) {
  body_ += fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"{}/>\n", from.x, from.y, to.x,
                       to.y, attributes(style));
}

void SvgDrawing::polygon(const std::vector<Vec2d>& corners, const SvgStyle& style) {
  body_ += "<polygon points=\"";
  for (const Vec2d& corner : corners) body_ += fmt::format("{:.2f},{:.2f} ", corner.x, corner.y);
  body_ += fmt::format("\"{}/>\n", attributes(style));
}

void SvgDrawing::circle(const Vec2d& middle, double radius, const SvgStyle& style) {
  body_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"{}/>\n", middle.x, middle.y, radius,
                       attributes(style));
}

void SvgDrawing::text(const Vec2d& at, std::string_view words, double size, SvgAnchor anchor, bool bold) {
  const std::string_view name = anchor == SvgAnchor::start ? "start" : anchor == SvgAnchor::middle ? "middle" : "end";
  body_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.4g}\" text-anchor=\"{}\"{} fill=\"#202020\">{}"
                       "</text>\n",
                       at.x, at.y, size, name, bold ? " font-weight=\"bold\"" : "", xml_escaped(words));
}

void SvgDrawing::picture(const Vec2d& low, const Vec2d& high, const Image<Rgb8>& levels) {
  body_ += fmt::format("<image x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
                       "preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" "
                       "xlink:href=\"data:image/png;base64,{}\"/>\n",
                       low.x, low.y, high.x - low.x, high.y - low.y, base64(stb_encode_png(levels)));
}

void SvgDrawing::begin_clip(const Vec2d& low, const Vec2d& high) {
  const int id = clips_++;
  body_ += fmt::format("<clipPath id=\"clip{}\"><rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"/>"
                       "</clipPath>\n<g clip-path=\"url(#clip{})\">\n",
                       id, low.x, low.y, high.x - low.x, high.y - low.y, id);
}

void SvgDrawing::end_clip() { body_ += "</g>\n"; }

}  // namespace ps
