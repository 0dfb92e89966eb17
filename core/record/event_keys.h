#pragma once
#include <string_view>

#include "record/events.h"

namespace ps {

/// Enumerators of events as keys for files, in kebab-case: "before-range". Enumerators that an option sets have the
/// keys of the option table.
std::string_view event_key(TestOutcome outcome);
std::string_view event_key(RejectReason reason);
std::string_view event_key(RayKind kind);
std::string_view event_key(TextureUse use);
std::string_view event_key(FragmentEvent::Depth depth);
std::string_view event_key(FragmentEvent::Pass pass);
std::string_view event_key(LightKind kind);
std::string_view event_key(CanvasFill fill);
std::string_view event_key(Coverage strategy);

}  // namespace ps
