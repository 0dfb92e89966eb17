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
  value_paragraph(name, value);
}

}  // namespace

void About::draw_sheet() {
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
}

}  // namespace ps::gui
