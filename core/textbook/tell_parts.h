#pragma once
#include "record/recorder.h"
#include "textbook/book_scene.h"
#include "textbook/watch_reader.h"

namespace ps::textbook {

/// The parts of tell_listing(), which add their events to `recorder`.
void tell_rays(const BookScene& book, const WatchReader& reader, PixelRecorder& recorder);
void tell_triangles(const BookScene& book, const WatchReader& reader, PixelRecorder& recorder);
void tell_canvas_items(const BookScene& book, const WatchReader& reader, PixelRecorder& recorder);

}  // namespace ps::textbook
