#include "gui/input/key_hint.h"

namespace ps::gui {
namespace {

const Actions*& hinting_actions() {
  static const Actions* actions = nullptr;
  return actions;
}

}  // namespace

void set_key_hints(const Actions* actions) { hinting_actions() = actions; }

std::string with_key(std::string_view sentence, std::string_view action) {
  const std::string key = hinting_actions() ? hinting_actions()->key_text(action) : std::string();
  std::string text(sentence);
  if (!key.empty()) text.insert(text.ends_with('.') ? text.size() - 1 : text.size(), " (" + key + ")");
  return text;
}

}  // namespace ps::gui
