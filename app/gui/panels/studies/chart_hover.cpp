#include "gui/panels/studies/chart_hover.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "gui/widgets/widgets.h"
#include "image/difference.h"
#include "study/chart_style.h"

namespace ps::gui {
namespace {

constexpr double picture_side = 190;        // pixels at scale 1
constexpr double visible_difference = 160;  // levels that the largest difference is raised to
constexpr double largest_gain = 64;

int largest_difference(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgb8 p = a.pixels()[i], q = b.pixels()[i];
    largest = std::max({largest, std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
  }
  return largest;
}

bool same_size(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  return a.width() == b.width() && a.height() == b.height();
}

void prepare(ChartPreview& preview, const std::shared_ptr<const Image<Rgb8>>& picture,
             const std::shared_ptr<const Image<Rgb8>>& reference) {
  if (preview.of == picture && preview.against == reference) return;
  preview.of = picture;
  preview.against = reference;
  if (!picture) return;
  preview.picture.upload(*picture);
  preview.picture.set_shrunk(true);
  if (!reference || !same_size(*picture, *reference)) return;
  const int largest = largest_difference(*picture, *reference);
  const double wanted = largest > 0 ? std::floor(visible_difference / largest) : 1;
  preview.gain = std::clamp(wanted, 1.0, largest_gain);
  preview.difference.upload(difference_picture(*reference, *picture, {.gain = preview.gain}));
  preview.difference.set_shrunk(true);
}

void line(const char* what, const std::string& value) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  show_text(what, {.quiet = true});
  ImGui::TableNextColumn();
  show_text(value);
}

void numbers(const Chart& chart, const ChartPoint& point) {
  if (!ImGui::BeginTable("numbers", 2, ImGuiTableFlags_SizingFixedFit)) return;
  line("time", fmt::format("{:.3g} ms ({:.3g} to {:.3g})", point.time_ms.median, point.time_ms.q1, point.time_ms.q3));
  if (point.upload_ms)
    line("upload", fmt::format("{:.3g} ms ({:.3g} to {:.3g})", point.upload_ms->median, point.upload_ms->q1,
                               point.upload_ms->q3));
  const std::string title = chart_axes(chart).error_title;
  const std::string error = std::isfinite(point.error) ? fmt::format("{:.4g}", point.error) : "infinite: no error";
  line(title.c_str(), point.standing == Standing::truth ? "none: it is the truth itself" : error);
  if (point.standing == Standing::other_picture) line("shows", "another picture on purpose");
  for (const std::string& left : brief_texts(point.left_out)) line("renderer", left);
  if (point.work) line("work", fmt::format("{:.3g} million", 1e-6 * static_cast<double>(*point.work)));
  line("memory", fmt::format("{:.3g} MB", point.memory_mb));
  if (point.tie) line("tie", "noise decides whether it lies on the front");
  line("first picture", fmt::format("{:.0f} ms more", point.prepare_ms));
  ImGui::EndTable();
}

void pictures(const ChartPreview& preview) {
  const float side = px(picture_side);
  const auto w = static_cast<float>(preview.picture.width()), h = static_cast<float>(preview.picture.height());
  const float shrink = std::min(side / std::max(w, 1.f), side / std::max(h, 1.f));
  const ImVec2 size{std::round(w * shrink), std::round(h * shrink)};
  ImGui::BeginGroup();
  ImGui::Image(preview.picture.id(), size);
  show_text("picture");
  ImGui::EndGroup();
  if (preview.difference.empty()) return;
  ImGui::SameLine();
  ImGui::BeginGroup();
  ImGui::Image(preview.difference.id(), size);
  show_text(preview.gain > 1 ? fmt::format("difference, {:.0f} times", preview.gain) : "difference");
  ImGui::EndGroup();
}

}  // namespace

void chart_hover(const ChartTab& tab, const ChartPoint& point, ChartPreview& preview, const char* hint) {
  const auto found = tab.found->pictures.find(point.number);
  prepare(preview, found == tab.found->pictures.end() ? nullptr : found->second, tab.found->reference);
  begin_tooltip_at_pointer();
  ImGui::PushTextWrapPos(px(2 * picture_side + 12));
  show_text(point.what.name, {Face::bold});
  numbers(tab.chart, point);
  if (preview.of) pictures(preview);
  show_text(hint, {.quiet = true});
  ImGui::PopTextWrapPos();
  end_tooltip();
}

}  // namespace ps::gui
