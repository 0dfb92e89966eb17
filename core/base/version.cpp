#include "base/version.h"

namespace pixelscope {

std::string_view version() { return PIXELSCOPE_VERSION; }

}  // namespace pixelscope
