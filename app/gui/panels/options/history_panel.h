#pragma once
#include "gui/panels/options/work_log.h"
#include "gui/panels/panel.h"
#include "gui/work/thumbnails.h"

namespace ps::gui {

/// Every step of the history with small pictures of A and B, oldest first; a click goes there. Steps that were undone
/// stay in the list until another change takes their place.
class HistoryPanel final : public Panel {
 public:
  explicit HistoryPanel(const PanelHost& host);
  bool draw(const Context& context) override;
  void add_actions(Actions& actions) override;
  void offer(Values& out) override;
  void update() override { log_.update(session_); }
  bool busy() const override { return thumbnails_.busy(); }
  void take(const PanelMessage& message) override {
    if (std::holds_alternative<ShowOptions>(message)) open_ = false;
  }
  /// Shown in place of the options.
  bool open() const { return open_; }
  bool close() override { return std::exchange(open_, false); }

 private:
  bool open_ = false;
  Thumbnails thumbnails_;
  WorkLog log_;
  std::size_t shown_place_ = 0;  ///< the step that was last scrolled to
  std::size_t shown_count_ = 0;
};

}  // namespace ps::gui
