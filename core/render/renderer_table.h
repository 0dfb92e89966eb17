#pragma once
#include <optional>
#include <span>

#include "options/renderer_kind.h"
#include "record/renderer_row.h"

namespace ps {

/// All renderers, in the order of the option `renderer`: those of core, then those that were added.
std::span<const RendererRow> renderer_table();

/// The row of one of them.
const RendererRow& renderer_row(Renderer renderer);

/// The renderer whose pictures a graphics driver makes, or nullopt: not every program has one.
std::optional<Renderer> driver_renderer();

/// A renderer that core does not know: what the option table shows of it, and its row, whose number is filled in.
struct AddedRenderer {
  RendererKind kind;
  RendererRow row;
};

/// Adds it, under the number that is returned. For the `main` of a program, before anything else is done: the option
/// table lists all renderers when it is first used. Its texts must live as long as the program.
Renderer add_renderer(const AddedRenderer& added);

}  // namespace ps
