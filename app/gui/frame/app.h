#pragma once
#include <memory>
#include <optional>
#include <string>

#include "gui/base/content.h"
#include "gui/frame/first_document.h"

namespace ps::gui {

class Shell;

/// Everything inside the window: the panels in their places, with what goes on in the background brought up to date.
class App final : public Content {
 public:
  App(Shell& shell, const AppOptions& options, Document first);
  ~App() override;

  void draw() override;
  bool busy() const override;
  bool animating() const override;
  void open(const std::string& path_or_name) override;
  void drop(const std::string& path, std::optional<WindowPoint> at) override;
  void set_option(Side side, const std::string& assignment) override;
  std::optional<WindowPoint> pixel_place(Side side, Vec2i pixel) const override;
  bool may_close() override;
  void ended_from_outside() override;
  void warn(const std::string& sentence) override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ps::gui
