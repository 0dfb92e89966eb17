#include "base/version.h"

namespace ps {

std::string_view version() { return PIXELSCOPE_VERSION; }

}  // namespace ps
