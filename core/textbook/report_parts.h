#pragma once
#include "record/recorder.h"
#include "textbook/book_scene.h"
#include "textbook/watch_reader.h"

namespace ps::textbook {

/// The parts of listing_events(), which add their events to `recorder`.
void report_rays(const BookScene& book, const WatchReader& reader, PixelRecorder& recorder);
void report_triangles(const BookScene& book, const WatchReader& reader, PixelRecorder& recorder);
void report_canvas_items(const BookScene& book, const WatchReader& reader, PixelRecorder& recorder);

}  // namespace ps::textbook
