#pragma once
#include "render/renderer_table.h"

namespace ps::test {

/// A renderer as a program might bring along: every pixel shows the background in half its brightness. It counts the
/// pixels that it writes and nothing else, and uses only the exposure and the size of the picture.
AddedRenderer constant_renderer();

}  // namespace ps::test
