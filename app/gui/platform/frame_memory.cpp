#include "gui/platform/frame_memory.h"

#include <cstring>

namespace ps::gui {
namespace {

/// Copies what differs; answers whether anything did.
template <class T>
bool take(const ImVector<T>& from, std::vector<T>& to) {
  const auto count = static_cast<std::size_t>(from.Size);
  if (count == to.size() && (count == 0 || std::memcmp(from.Data, to.data(), count * sizeof(T)) == 0)) return false;
  to.assign(from.begin(), from.end());
  return true;
}

}  // namespace

bool FrameMemory::same_again(const ImDrawData& data) {
  const auto count = static_cast<std::size_t>(data.CmdListsCount);
  bool same = count == lists_.size() && size_.x == data.DisplaySize.x && size_.y == data.DisplaySize.y;
  size_ = data.DisplaySize;
  lists_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const ImDrawList& list = *data.CmdLists[static_cast<int>(i)];
    const bool vertices = take(list.VtxBuffer, lists_[i].vertices), indices = take(list.IdxBuffer, lists_[i].indices),
               commands = take(list.CmdBuffer, lists_[i].commands);
    same = same && !vertices && !indices && !commands;
  }
  return same;
}

}  // namespace ps::gui
