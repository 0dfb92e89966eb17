// What this program is and what it runs on: the things that a report of a fault needs.
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <hwy/highway.h>

#include "base/parallel.h"
#include "base/version.h"
#include "gui/app/app.h"
#include "gui/input/actions.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

std::string gl_text(GLenum name) {
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text ? text : "unknown";
}

/// The vectors that the fast paths use where the option `simd` leaves it to the processor.
std::string simd_target() {
#if HWY_ARCH_X86
  const std::int64_t have = hwy::SupportedTargets();
  if ((have & HWY_AVX3) != 0) return "AVX-512";
  if ((have & HWY_AVX2) != 0) return "AVX2";
  if ((have & HWY_SSE4) != 0) return "SSE4";
#endif
  return "none";
}

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

void App::about() {
  if (!about_open_) return;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(px(560), display.x - px(40)), 0});
  ImGui::SetNextWindowFocus();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(24), px(18)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(6));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette().field);
  ImGui::Begin("##about", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
  {
    const NameScope scope("about");
    {
      const FontScope title(Face::title);
      ImGui::TextUnformatted("Pixelscope");
    }
    ImGui::TextUnformatted("A microscope for pixels: one scene, two ways to draw it.");
    ImGui::Dummy({0, px(8)});
    fact("Version", std::string(version()));
    fact("Vectors", simd_target());
    fact("Threads", std::to_string(resolve_threads({})));
    fact("OpenGL", gl_text(GL_VERSION));
    fact("Renderer", gl_text(GL_RENDERER));
    ImGui::Dummy({0, px(8)});
    if (button("close", "Close", Emphasis::primary)) about_open_ = false;
  }
  const bool outside = ImGui::IsMouseClicked(0) && !ImGui::IsWindowAppearing() && !ImGui::IsWindowHovered();
  if (outside) about_open_ = false;
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

}  // namespace ps::gui
