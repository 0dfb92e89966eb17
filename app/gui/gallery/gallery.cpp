#include "gui/gallery/gallery.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

#include "base/check.h"
#include "engine/markdown.h"
#include "engine/maths_specimen.h"
#include "gui/base/values.h"
#include "gui/input/actions.h"
#include "gui/panels/lesson/text_view.h"
#include "gui/session/session.h"
#include "gui/shell/shell.h"
#include "gui/widgets/option_pair.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr std::array few{Choice{"first", "first", "The first of three."}, Choice{"second", "second", "The second."},
                         Choice{"third", "third", "The third."}};
constexpr std::array many{Choice{"one", "a rather long name", ""},  Choice{"two", "another long name", ""},
                          Choice{"three", "a third long name", ""}, Choice{"four", "a fourth long name", ""},
                          Choice{"five", "a fifth long name", ""},  Choice{"six", "a sixth long name", ""}};
constexpr std::array tabs{Choice{"options", "Options", ""}, Choice{"table", "Table", ""}, Choice{"text", "Text", ""},
                          Choice{"maths", "Maths", ""}};

constexpr const char* sample_text =
    "A point is in shadow if an object blocks the light. The shadow ray starts at the point and goes to the light.\n\n"
    "N·L ≥ 0, α + β + γ = 1, x² + y² = r², 10⁻³, x₀ → x₁, 45°, ±0.5 px, ∞, 3 × 4, μs";

class Gallery : public Content {
 public:
  explicit Gallery(Shell& shell) : shell_(shell) {
    traits_.spheres = traits_.triangles = traits_.reflective = traits_.specular = traits_.casting_lights = true;
    shell.actions().add({.name = "count",
                         .label = "Count one",
                         .group = "Gallery",
                         .keys = "N",
                         .kind = ActionKind::repeat,
                         .run = [this] { ++count_; }});
    shell.actions().add({.name = "hold",
                         .label = "Held while the key is down",
                         .group = "Gallery",
                         .keys = "F",
                         .kind = ActionKind::hold,
                         .run_hold = [this](bool on) { held_ = on; }});
  }

  void draw() override {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(size);
    ImGui::Begin("##gallery", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_MenuBar |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (ImGui::BeginMenuBar()) {
      const NameScope menu("menu");
      if (begin_menu("view", "View")) {
        for (const Action& action : shell_.actions().all())
          if (action.run) menu_action(shell_.actions(), action.name);
        end_menu();
      }
      ImGui::EndMenuBar();
    }
    if (!message_.empty() && message_bar("message", MessageKind::error, message_)) message_.clear();
    const float height = ImGui::GetContentRegionAvail().y;
    ImGui::BeginChild("##left", {left_, height});
    draw_controls();
    ImGui::EndChild();
    ImGui::SameLine(0, 0);
    splitter("splitter", SplitterAxis::left_right, height, left_, px(200), size.x - px(300));
    ImGui::SameLine(0, px(8));
    ImGui::BeginChild("##right", {0, height});
    tab_row("tabs", tabs, tab_);
    if (tab_ == 0) draw_options();
    if (tab_ == 1) draw_table();
    if (tab_ == 2) show_paragraph(sample_text);
    if (tab_ == 3) draw_specimen();
    ImGui::EndChild();
    ImGui::End();
    values().publish("gallery/count", count_);
    values().publish("gallery/held", held_);
    values().publish("gallery/opened", opened_);
  }

  bool busy() const override { return false; }
  void open(const std::string& path) override {
    opened_ = path;
    message_ = path +
               ": found nothing, expected a scene. This message is long enough to need a second line in a narrow "
               "window, and stays until it is dismissed.";
  }
  void set_option(Side side, const std::string& assignment) override {
    parse_assignment(assignment, settings_[side == Side::a ? 0 : 1]);
  }
  std::optional<WindowPoint> pixel_place(Side, Vec2i) const override { return {}; }

 private:
  void draw_controls() {
    const NameScope names("gallery");
    if (button("plain", "Plain", Emphasis::plain, {.tooltip = "A button that counts."})) ++count_;
    ImGui::SameLine();
    if (button("primary", "Primary", Emphasis::primary)) ++count_;
    ImGui::SameLine();
    if (button("quiet", "Quiet", Emphasis::quiet)) ++count_;
    ImGui::SameLine();
    button("dead", "Not now", Emphasis::plain, {.tooltip = "A dead button.", .disabled = "nothing to do"});
    if (button_on_off("split", "Split", on_)) on_ = !on_;
    ImGui::SameLine();
    toggle("toggle", "Renormalise", on_, {.tooltip = "A switch."});
    bool off = true;
    toggle("dead-toggle", "Dead switch", off, {.disabled = "nothing to switch"});
    choice("few", few, few_);
    choice("many", many, many_);
    number("linear", linear_, {0, 10, OptionScale::linear, false, "px"}, {.tooltip = "Drag, wheel, or Ctrl-click."});
    number("log", log_, {0, 10, OptionScale::logarithmic, false, ""});
    number("whole", whole_, {0, 64, OptionScale::linear, true, "bounces"});
    search_box("search", search_, "Search options");
    if (progress_bar("progress", "Loading teapot.obj", 0.42)) ++count_;
    if (section("section", "Section", section_open_, "3 changed")) value_text("inside", "Inside the section");
    if (tree_row("tree", "Eye ray", TreeKind::branch, false).open) {
      tree_row("leaf", "sphere 2: t = 3.142", TreeKind::leaf, true);
      ImGui::TreePop();
    }
  }

  void draw_options() {
    const NameScope names("options");
    std::string_view group;
    ImGui::BeginChild("##options");
    for (const Option& option : option_table()) {
      if (option.group != group) {
        group = option.group;
        bool open = true;
        section("section/" + std::string(group), group, open);
      }
      option_pair(option, settings_, traits_, {.highlight = option.key == "shadow-any-hit"});
    }
    ImGui::EndChild();
  }

  void draw_table() {
    const NameScope names("table");
    if (!begin_numbers("##table", 2, {.numbers = px(90)})) return;
    for (int i = 0; i < 4; ++i) {
      numbers_row("triangle " + std::to_string(i));
      for (const double value : {1.0 / (i + 3), 12345.678 * i}) number_cell(short_number(value), full_number(value));
    }
    ImGui::EndTable();
  }

  /// The specimen of formulas as a lesson shows it.
  void draw_specimen() {
    static const StepText specimen = read_markdown(maths_specimen(), "specimen", 1);
    if (!reader_) reader_ = std::make_unique<Session>(SessionHost{});
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    std::vector<TextLine> lines;
    for (const TextBlock& block : specimen.blocks) lay_out(block, mark_of(block), Face::body, width, lines);
    for (const TextLine& line : lines) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      ImGui::SetCursorScreenPos({at.x, at.y + line.gap});
      draw_line(*reader_, line);
    }
    const float height = ImGui::GetCursorScreenPos().y - from.y;
    controls().record("specimen", from, {from.x + width, from.y + height},
                      fmt::format("{} {} {} {}", from.x, from.y, width, height));
  }

  Shell& shell_;
  std::unique_ptr<Session> reader_;  ///< what links in a text would act on
  SceneTraits traits_;
  std::array<Settings, 2> settings_;
  int count_ = 0, few_ = 0, many_ = 0, tab_ = 0;
  bool on_ = true, held_ = false, section_open_ = true;
  double linear_ = 2.5, log_ = 0.001, whole_ = 3;
  float left_ = 430;
  std::string search_, message_, opened_;
};

}  // namespace

std::unique_ptr<Content> make_gallery(Shell& shell) { return std::make_unique<Gallery>(shell); }

}  // namespace ps::gui
