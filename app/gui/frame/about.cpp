#include "gui/frame/about.h"

#include "base/machine.h"
#include "gui/platform/window.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

void fact(const char* name, const std::string& value) {
  ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
  ImGui::TextUnformatted(name);
  ImGui::PopStyleColor();
  ImGui::SameLine(px(150));
  ImGui::PushTextWrapPos(0);
  value_text(name, value);
  ImGui::PopTextWrapPos();
}

}  // namespace

void About::draw() {
  if (!open) return;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(px(560), display.x - px(40)), 0});
  ImGui::SetNextWindowFocus();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(24), px(16)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(6));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette().field);
  ImGui::Begin("##about", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
  {
    const NameScope scope("about");
    {
      const FontScope title(Face::heading);
      ImGui::TextUnformatted("Pixelscope");
    }
    ImGui::TextUnformatted("A microscope for pixels: one scene, several ways to draw it.");
    ImGui::Dummy({0, px(8)});
    static const Machine machine = this_machine();  // asks the system
    fact("Version", machine.version);
    fact("Processor", machine.processor);
    fact("Vectors", machine.simd);
    fact("Threads", std::to_string(machine.threads));
    const GraphicsDriver driver = graphics_driver();
    fact("Graphics", driver.version);
    fact("Renderer", driver.renderer);
    ImGui::Dummy({0, px(8)});
    if (button("close", "Close", Emphasis::primary)) open = false;
  }
  const bool outside = ImGui::IsMouseClicked(0) && !ImGui::IsWindowAppearing() && !ImGui::IsWindowHovered();
  if (outside) open = false;
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

}  // namespace ps::gui
