#include "gui/session/message_list.h"

#include <algorithm>
#include <utility>

namespace ps::gui {

void MessageList::say(Message message) {
  const bool known =
      std::any_of(messages_.begin(), messages_.end(), [&](const Message& other) { return other.text == message.text; });
  if (!known) messages_.push_back(std::move(message));
}

bool MessageList::expire(double now) {
  constexpr double long_enough = 6;  // seconds
  for (auto& message : messages_)
    if (message.since < 0) message.since = now;
  const auto passing = [](const Message& message) { return message.kind == Message::Kind::information; };
  std::erase_if(messages_,
                [&](const Message& message) { return passing(message) && now - message.since > long_enough; });
  return std::any_of(messages_.begin(), messages_.end(), passing);
}

void MessageList::dismiss(std::size_t index) {
  if (index < messages_.size()) messages_.erase(messages_.begin() + static_cast<std::ptrdiff_t>(index));
}

}  // namespace ps::gui
