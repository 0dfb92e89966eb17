#include "textbook/book_canvas.h"

namespace ps {

void BookCanvas::note(const Vec2i& place, const Vec3d& colour) { writes_->push_back({place, colour}); }

}  // namespace ps
