#include "gui/panels/options/waking_cache.h"

namespace ps::gui {

const Waking* WakingCache::find(const Session& session, const Option& option, Side side) {
  if (revision_ != session.revision()) known_.clear();
  revision_ = session.revision();
  const auto [found, fresh] = known_.try_emplace({&option, side});
  Waking& waking = found->second;
  if (fresh) waking = waking_of(option, session.settings(side), session.traits());
  return waking.reason.empty() ? nullptr : &waking;
}

}  // namespace ps::gui
