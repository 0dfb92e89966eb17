#pragma once
#include "scene/scene_draft.h"

namespace ps {

/// Gives a name to everything that the file left without one, checks what needs the whole file, and seals the parts.
/// Throws InputError.
Scene finish_draft(SceneDraft draft);

}  // namespace ps
