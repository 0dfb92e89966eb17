#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>

#include "base/check.h"
#include "gui/panels/studies/chart_setup.h"
#include "gui/widgets/text_field.h"
#include "gui/widgets/widgets.h"
#include "options/difference_words.h"
#include "options/option_search.h"

namespace ps::gui {
namespace {

constexpr std::size_t most_matches = 6;  // lines under the search box

void heading(const char* text) {
  ImGui::Spacing();
  show_text(text, {Face::bold});
}

/// A button for each value of a choice or a toggle. Answers whether the chosen ones changed.
bool value_buttons(SweepAxis& axis) {
  bool changed = false, first = true;
  const std::vector<std::string> all = standard_values(*axis.option);
  for (const std::string& value : all) {
    const auto place = std::find(axis.values.begin(), axis.values.end(), value);
    const bool on = place != axis.values.end();
    const std::string label = value_label(*axis.option, value);
    if (!first) same_line_if_room(button_width(label), px(4));
    first = false;
    if (!button_on_off(value, label, on, {.tooltip = on ? "Excludes this value." : "Includes this value."})) continue;
    if (on && axis.values.size() == 1) continue;  // none at all would be no sweep
    if (on)
      axis.values.erase(place);
    else
      axis.values.push_back(value);
    // In the order of the table, whatever was clicked first.
    std::sort(axis.values.begin(), axis.values.end(), [&](const auto& a, const auto& b) {
      return std::find(all.begin(), all.end(), a) < std::find(all.begin(), all.end(), b);
    });
    changed = true;
  }
  return changed;
}

/// Numbers are typed. Invalid text leaves the values unchanged and is reported below.
void typed_values(SweepAxis& axis, std::string& text) {
  const bool changed = text_field("values", text, "", {.tooltip = "The values, with commas between them."}).changed;
  std::optional<SweepAxis> read;
  try {
    read = parse_sweep_axis(fmt::format("{}={}", axis.option->key, text));
  } catch (const InputError& error) {
    quiet_text(error.what());
  }
  if (changed && read) axis.values = read->values;
}

void swept_options(ChartSetup& setup) {
  std::optional<std::size_t> removed;
  for (std::size_t i = 0; i < setup.axes.size(); ++i) {
    SweepAxis& axis = setup.axes[i];
    const NameScope scope(axis.option->key);
    ImGui::AlignTextToFramePadding();
    show_text(axis.option->label);
    tooltip(axis.option->help.what);
    const float width = button_width("Remove");
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    if (button("remove", "Remove", Emphasis::quiet)) removed = i;
    if (axis.option->kind == OptionKind::boolean || axis.option->kind == OptionKind::choice)
      value_buttons(axis);
    else
      typed_values(axis, setup.typed[i]);
  }
  if (!removed) return;
  setup.axes.erase(setup.axes.begin() + static_cast<std::ptrdiff_t>(*removed));
  setup.typed.erase(setup.typed.begin() + static_cast<std::ptrdiff_t>(*removed));
}

bool swept(const ChartSetup& setup, const Option& option) {
  return std::any_of(setup.axes.begin(), setup.axes.end(), [&](const SweepAxis& a) { return a.option == &option; });
}

void add_option(ChartSetup& setup, const Session& session) {
  search_box("add", setup.search, "Add an option to the sweep");
  if (setup.search.empty()) return;
  std::size_t shown = 0;
  for (const Option& option : option_table()) {
    if (shown == most_matches) break;
    if (!option_matches(option, setup.search) || swept(setup, option)) continue;
    ++shown;
    const std::string reason = text_of(inactive_reason(option, session.settings(setup.side), session.traits()));
    const std::string label = fmt::format("{}: {}", option.group, option.label);
    if (!button(fmt::format("add/{}", option.key), label, Emphasis::quiet,
                {.tooltip = option.help.what, .disabled = reason}))
      continue;
    auto axes = setup.axes;
    axes.push_back({&option, standard_values(option)});
    set_axes(setup, std::move(axes));
    setup.search.clear();
    break;
  }
  if (shown == 0) quiet_text("No option matches.");
}

void comparison(ChartSetup& setup, const Session& session) {
  static constexpr std::array values{Choice{"display", "Display levels", "Errors as the screen shows them, 0 to 255."},
                                     Choice{"linear", "Linear values", "Errors of the linear colours before display."}};
  choice_of("measured-in", values, setup.values);
  static constexpr std::array parts{
      Choice{"whole", "Whole picture", "Every pixel counts."},
      Choice{"rectangle", "Dragged rectangle", "Only the rectangle counts that you dragged in a picture with Shift."}};
  choice_of("part", parts, setup.part);
  if (setup.part != ChartPart::rectangle) return;
  const auto& region = session.region();
  quiet_text(
      region ? fmt::format("{} x {} pixels from ({}, {}) on", region->width(), region->height(), region->x0, region->y0)
             : "No rectangle yet: drag one in a picture with Shift held. Until then the whole picture counts.");
}

/// Whether times compare techniques, or the programs that happen to draw them.
void machinery(ChartSetup& setup) {
  static constexpr std::array rules{
      Choice{"same", "The same code for all", "If one point cannot use the SIMD path, no point uses it."},
      Choice{"as-used", "As used", "Each point runs as in the window: times then compare code, not techniques."}};
  choice_of("machinery", rules, setup.machinery);
}

void reference(ChartSetup& setup, const PanelHost& host) {
  static constexpr std::array samples{
      Choice{"auto", "auto", "As the swept options ask: the points' own samples, or the mean over each pixel."},
      Choice{"1", "1", "The points' own samples."},
      Choice{"4", "4", "The mean of four samples over each pixel."},
      Choice{"16", "16", "The mean of sixteen samples over each pixel."},
      Choice{"64", "64", "The mean of 64 samples over each pixel."},
      Choice{"256", "256", "The mean of 256 samples over each pixel."}};
  if (setup.reference_file.empty()) {
    ImGui::AlignTextToFramePadding();
    show_text("Samples:");
    const std::string now = std::to_string(setup.reference_samples);
    int index = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (samples[i].key == now) index = static_cast<int>(i);
    // Behind "auto" the keys are the powers of 4.
    if (choice("samples", samples, index)) setup.reference_samples = index == 0 ? 0 : 1 << (2 * (index - 1));
  } else {
    quiet_text(fmt::format("The picture {}", setup.reference_file));
    if (button("render-reference", "Render one instead")) setup.reference_file.clear();
    same_line_if_room(button_width("Another picture..."));
  }
  if (button("browse", "Another picture...", Emphasis::plain,
             {.tooltip = "Compares with a picture file of the same size, such as another program's."}))
    host.ask_file({.title = "Compare with a picture",
                   .use = FileUse::open,
                   .extensions = {".png", ".ppm", ".pfm"},
                   .hint = "picture.png",
                   .answer = [&setup](const FileAnswer& file) { setup.reference_file = file.path.string(); }});
}

}  // namespace

void chart_setup_controls(ChartSetup& setup, const ChartPlan& plan, const Session& session, const PanelHost& host) {
  const NameScope scope("setup");
  heading("What is swept");
  swept_options(setup);
  add_option(setup, session);
  value_paragraph("points", !plan.error.empty() ? plan.error
                            : setup.swept == Swept::model
                                ? "The model from full to reduced, which is weighed first."
                                : fmt::format("{} point{}", plan.points.size(), plan.points.size() == 1 ? "" : "s"));
  for (const std::string& note : plan.notes) quiet_text(note);
  heading("Other options of");
  static constexpr std::array sides{Choice{"a", "A", "The options of picture A."},
                                    Choice{"b", "B", "The options of picture B."}};
  choice_of("side", sides, setup.side);
  heading("Error");
  comparison(setup, session);
  heading("Truth");
  quiet_text(settings_in_words(plan.truth));
  reference(setup, host);
  heading("Timed on");
  machinery(setup);
  heading("Timed runs of each point");
  double repeats = setup.repeats;
  if (number("repeats", repeats, {.minimum = 1, .maximum = 50, .integer = true}).changed)
    setup.repeats = static_cast<int>(repeats);
}

}  // namespace ps::gui
