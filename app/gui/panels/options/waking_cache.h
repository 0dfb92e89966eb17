#pragma once
#include <map>
#include <utility>

#include "gui/session/session.h"
#include "options/waking.h"

namespace ps::gui {

/// What options that cannot act need. Searching the table takes long for a frame, so answers are kept until the
/// document changes.
class WakingCache {
 public:
  /// nullptr where the option acts in this picture.
  const Waking* find(const Session& session, const Option& option, Side side);

 private:
  std::map<std::pair<const Option*, Side>, Waking> known_;
  std::uint64_t revision_ = 0;
};

}  // namespace ps::gui
