#pragma once
#include "frame/frame.h"
#include "image/display.h"
#include "options/settings.h"

namespace ps {

/// The display transform that the settings ask for.
DisplayTransform display_transform(const Settings& settings);

/// The frame's colours as display levels, from colour_double where the frame has it.
Image<Rgb8> display_frame(const Frame& frame, const Settings& settings);

/// The same for one rectangle, written to the same place in `target`, which has the frame's size.
void display_tile(const Frame& frame, const Settings& settings, const TileRect& tile, Image<Rgb8>& target);

/// Gives the caller a finished rectangle: its display levels, then the call, as far as the request asks for them.
void finish_tile(const RenderRequest& request, const Settings& settings, const Frame& frame, const TileRect& tile);

/// The linear colour that display_frame starts from, widened to double; and its display levels.
Vec3d linear_at(const Frame& frame, Vec2i pixel);
Rgb8 display_at(const Frame& frame, const Settings& settings, Vec2i pixel);

}  // namespace ps
