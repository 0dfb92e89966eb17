#pragma once
#include <string>
#include <utility>

#include "base/check.h"
#include "gui/session/session.h"

namespace ps::gui {

/// A choice of a tab that the document keeps: a lesson's step or a link asks for it there, and the tab reports its
/// choice, so that a link restores it.
class LayoutChoice {
 public:
  explicit LayoutChoice(std::string Layout::*member) : member_(member) {}

  /// Calls choose(asked) where the document asks for something else than before. Its InputError becomes a message.
  template <class Choose>
  void follow(Session& session, Choose&& choose) {
    const std::string asked = session.document().layout.*member_;
    if (asked == seen_) return;
    seen_ = asked;
    try {
      choose(asked);
    } catch (const InputError& error) {
      session.say(Message::Kind::error, error.what());
    }
  }
  void keep(Session& session, std::string chosen) {
    if (chosen == seen_) return;
    seen_ = std::move(chosen);
    session.navigate([&](Document& document) { document.layout.*member_ = seen_; });
  }

 private:
  std::string Layout::*member_;
  std::string seen_;
};

}  // namespace ps::gui
