#include "gui/panels/studies/unsafe_line.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "options/difference_words.h"
#include "options/option.h"
#include "study/stability/experiment.h"

namespace ps::gui {
namespace {

constexpr ImGuiWindowFlags below_picture = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                           ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                           ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBackground;
constexpr double least_named = 0.005;  // percent of the pixels; less than one pixel of a common picture

void ask(Session& session, UnsafeSide& state, const Settings& settings) {
  state.asked = true;
  state.settings = settings;
  state.revision = session.scene().revision();
  state.view = session.view();
  state.measured = false;
  state.study.cancel();
  Progress progress;
  UnsafeOptions options;
  options.only_known = true;
  state.known = unsafe_settings(session.scene(), state.view, settings, progress, options);
  state.measured = state.known.empty();  // else what an earlier study found would be taken for this one's
  if (state.measured) return;
  state.study.start([scene = session.scene(), view = state.view, settings](StudyControl& control,
                                                                           const UnsafeStudy::Publish& publish) {
    UnsafeOptions measure;
    measure.priority = WorkerPriority::background;
    publish(std::make_shared<const std::vector<UnsafeSetting>>(
                unsafe_settings(scene, view, settings, control.progress(), measure)),
            {1, 1, 0});
  });
}

/// The worst finding to report; nullptr if there is none.
const UnsafeSetting* worst(const UnsafeSide& state) {
  if (!state.measured) return nullptr;
  const auto found = std::max_element(state.known.begin(), state.known.end(),
                                      [](const auto& a, const auto& b) { return a.bad_percent < b.bad_percent; });
  return found == state.known.end() || found->bad_percent < least_named ? nullptr : &*found;
}

std::string two_digits_percent(double value) { return fmt::format("{:.2g} %", value); }

/// "filter: bilinear".
std::string in_words(const UnsafeSetting& unsafe) {
  return setting_words(fmt::format("{}={}", unsafe.option, unsafe.value));
}

std::string line_text(const UnsafeSetting& unsafe) {
  return fmt::format("{} of the pixels are wrong with {}", two_digits_percent(unsafe.bad_percent), in_words(unsafe));
}

/// The same where there is little room.
std::string short_text(const UnsafeSetting& unsafe, float room) {
  const std::string share = two_digits_percent(unsafe.bad_percent), of_pixels = share + " of pixels wrong";
  std::string longer = fmt::format("{} wrong with {}", share, in_words(unsafe));
  if (text_width(longer) <= room) return longer;
  return text_width(of_pixels, Face::small) <= room ? of_pixels : share + " wrong";
}

void make_safe(Session& session, Side side, const UnsafeSetting& unsafe) {
  session.edit(fmt::format("{}: {}", letter_of(side), settings_in_words(unsafe.safe, ";")),
               [&](Document& document) { parse_assignments(unsafe.safe, side_of(document, side).settings); });
}

/// Answers the experiment that is asked for.
std::optional<std::string> details(Session& session, const UnsafeSide& state, Side side) {
  std::optional<std::string> wanted;
  for (const UnsafeSetting& unsafe : state.known) {
    const NameScope scope(unsafe.option);
    show_text(line_text(unsafe));
    if (button("why", "Why?", Emphasis::plain, {.tooltip = "Opens the experiment that shows where this fails."}))
      wanted = std::string(unsafe.experiment);
    if (unsafe.safe.empty()) continue;
    ImGui::SameLine(0, px(4));
    if (button("safe", fmt::format("Set {}", settings_in_words(unsafe.safe, ";")), Emphasis::primary))
      make_safe(session, side, unsafe);
  }
  show_text("Measured on a small picture against a rendering in double.", {.quiet = true});
  if (wanted) ImGui::CloseCurrentPopup();
  return wanted;
}

}  // namespace

void UnsafeLines::update() {
  Session& session = session_;
  if (!session.has_scene()) return;
  for (const Side side : both_sides) {
    UnsafeSide& one = sides_[index_of(side)];
    const Settings& settings = session.settings(side);
    const auto render = session.renderer(side).status().state;
    const bool busy = render == RenderState::coarse || render == RenderState::full;
    const bool changed = !one.asked || !(settings == one.settings) || !(session.scene().revision() == one.revision) ||
                         !(session.view() == one.view);
    if (changed) one.known.clear();
    if (changed && !busy) ask(session, one, settings);  // after the picture itself
    if (!one.measured && one.study.state() == StudyState::done && one.study.found()) {
      one.known = *one.study.found();
      one.measured = true;
    }
  }
}

bool UnsafeLines::draw(const Context&) {
  std::optional<std::string> wanted;
  for (const Side side : both_sides) {
    const UnsafeSide& one = sides_[index_of(side)];
    const UnsafeSetting* unsafe = worst(one);
    const auto& area = pictures_.drawn.notes[index_of(side)];
    if (!unsafe || !area || area->width() < px(120)) continue;
    const NameScope scope(side == Side::a ? "unsafe/a" : "unsafe/b");
    const float around = px(26), room = area->width() - around;
    std::string text = line_text(*unsafe);
    if (text_width(text) > room) text = short_text(*unsafe, room);
    if (text_width(text, Face::small) > room)
      text.resize(std::min(text.find(':'), text.size()));  // the tooltip names the option
    const float width = std::min(area->width(), text_width(text) + around), height = area->height();
    // A window of its own: the rows around the pictures belong to another part of the program.
    ImGui::SetNextWindowPos(area->min);
    ImGui::SetNextWindowSize({width, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(side == Side::a ? "unsafe-a" : "unsafe-b", nullptr, below_picture);
    ImGui::PopStyleVar(3);
    if (hit_area("line", {width, height}, {})) ImGui::OpenPopup("details");
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    auto& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(min, max, colour_u32(ImGui::IsItemHovered() ? palette().field_hover : palette().panel, 0.94));
    attention_bar(list, min, {min.x + px(5), max.y});
    draw_text({min.x + px(12), min.y}, {max.x - px(6), max.y}, text, palette().text, 0,
              text_width(text) > room ? Face::small : Face::body);
    controls().record("line", text);
    tooltip(line_text(*unsafe) + "\nClick for details.");
    if (ImGui::BeginPopup("details")) {
      if (auto asked = details(session_, one, side)) wanted = std::move(asked);
      ImGui::EndPopup();
    }
    ImGui::End();
  }
  if (wanted) {
    host_.send(ShowExperiment{*wanted});
    host_.send(ShowTool{"stability"});
  }
  return false;
}

void UnsafeLines::offer(Values& out) {
  for (const Side side : both_sides) {
    const std::string name = side == Side::a ? "unsafe/a/" : "unsafe/b/";
    const auto worst_now = [this, side] { return worst(sides_[index_of(side)]); };
    out.offer(name + "option", [=] { return worst_now() ? std::string_view(worst_now()->option) : ""; });
    out.offer(name + "percent", [=] { return worst_now() ? worst_now()->bad_percent : 0.0; });
  }
}

}  // namespace ps::gui
