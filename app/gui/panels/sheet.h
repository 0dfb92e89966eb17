#pragma once
#include <imgui.h>

#include <utility>

#include "gui/panels/panel.h"

namespace ps::gui {

/// A panel over the whole window (widgets/overlay.h), which a click beside it, its button and Esc close.
class Sheet : public Panel {
 public:
  bool draw(const Context& context) final;
  void offer(Values& out) override;
  bool close() override { return std::exchange(open_, false); }

 protected:
  struct Look {
    const char* title = "";  ///< with a button that closes; empty: draw_sheet() draws its own line
    ImVec2 size;             ///< the largest at scale 1; as high as its content where the height is 0
  };
  Sheet(const PanelHost& host, std::string_view name, const Look& look)
      : Panel(host, {.name = name, .place = PanelPlace::over}), look_(look) {}

  void open() { open_ = just_opened_ = true; }
  /// Whether what it shows is still there; else it closes.
  virtual bool has_subject() { return true; }
  virtual void draw_sheet() = 0;

  bool open_ = false;
  bool just_opened_ = false;  ///< the key or click that did so does not count

 private:
  Look look_;
};

}  // namespace ps::gui
