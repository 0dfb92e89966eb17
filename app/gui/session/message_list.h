#pragma once
#include <string>
#include <vector>

namespace ps::gui {

/// Something that the user should read.
struct Message {
  enum class Kind { information, warning, error } kind = Kind::information;
  std::string text;
  /// Subject of the message, with which it is replaced or removed.
  enum class About { nothing, step, scene, lesson } about = About::nothing;
  std::string file{};  ///< the scene or lesson that could not be loaded
  double since = -1;   ///< seconds on the window's clock when it was first seen; negative before
};

/// The messages that are shown, the newest last.
class MessageList {
 public:
  const std::vector<Message>& all() const { return messages_; }
  /// Adds a message unless one with this text is there.
  void say(Message message);
  void dismiss(std::size_t index);
  /// Removes all messages of which `passed` answers true.
  template <class Passed>
  void remove(Passed passed) {
    std::erase_if(messages_, passed);
  }
  /// Takes information away that has been seen for long enough; warnings and errors stay until they are dismissed.
  /// Answers whether some is still to go.
  bool expire(double now);

 private:
  std::vector<Message> messages_;
};

}  // namespace ps::gui
