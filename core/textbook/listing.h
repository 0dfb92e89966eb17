#pragma once
// The header of a student's own listing: the words of the book's chapters (its scene, canvas and mathematics), and the
// macros that show values beside the lines. Everything else that it uses comes from the standard library.
#include "record/watch.h"          // IWYU pragma: export
#include "textbook/book_canvas.h"  // IWYU pragma: export
#include "textbook/book_math.h"    // IWYU pragma: export
#include "textbook/book_scene.h"   // IWYU pragma: export

namespace ps {

/// Draws the scene; the file that includes this header defines it. Colours are those of the book, 0 to 255.
void draw_listing(const BookScene& scene, BookCanvas& canvas);

}  // namespace ps
