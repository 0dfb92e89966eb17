#include "gui/platform/graphics.h"

namespace ps::gui {
namespace {

Graphics* open_graphics = nullptr;

}  // namespace

Graphics::Graphics() { open_graphics = this; }

Graphics::~Graphics() {
  if (open_graphics == this) open_graphics = nullptr;
}

Graphics* Graphics::current() { return open_graphics; }

}  // namespace ps::gui
