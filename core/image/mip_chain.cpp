#include "image/mip_chain.h"

#include <algorithm>

namespace ps {
namespace {

/// The source texels that one texel of the smaller picture covers along one axis, with their shares.
struct Cover {
  int first = 0;
  std::vector<double> shares;  ///< add up to 1
};

/// Cuts `from` texels into `to` equal parts. With from = 2 * to these are pairs; otherwise borders fall inside texels.
std::vector<Cover> covers(int from, int to) {
  std::vector<Cover> result(static_cast<std::size_t>(to));
  const double length = static_cast<double>(from) / to;
  for (int i = 0; i < to; ++i) {
    // Borders in units of 1/to texels, so that they are exact.
    const std::int64_t begin = std::int64_t{i} * from;
    const std::int64_t end = begin + from;
    Cover& cover = result[static_cast<std::size_t>(i)];
    cover.first = static_cast<int>(begin / to);
    for (std::int64_t x = cover.first; x * to < end; ++x) {
      const std::int64_t overlap = std::min(end, (x + 1) * to) - std::max(begin, x * to);
      cover.shares.push_back(static_cast<double>(overlap) / to / length);
    }
  }
  return result;
}

Image<Vec3f> half_size(const Image<Vec3f>& image) {
  const int width = std::max(1, image.width() / 2);
  const int height = std::max(1, image.height() / 2);
  const auto columns = covers(image.width(), width);
  const auto rows = covers(image.height(), height);
  Image<Vec3f> result(width, height);
  for (int y = 0; y < height; ++y) {
    const Cover& down = rows[static_cast<std::size_t>(y)];
    for (int x = 0; x < width; ++x) {
      const Cover& across = columns[static_cast<std::size_t>(x)];
      Vec3d sum{0, 0, 0};
      for (std::size_t j = 0; j < down.shares.size(); ++j) {
        const auto row = image.row(down.first + static_cast<int>(j));
        for (std::size_t i = 0; i < across.shares.size(); ++i)
          sum += Vec3d(row[static_cast<std::size_t>(across.first) + i]) * (across.shares[i] * down.shares[j]);
      }
      result.at(x, y) = Vec3f(sum);
    }
  }
  return result;
}

}  // namespace

MipChain make_mip_chain(std::shared_ptr<const Image<Vec3f>> base, MipLevels levels) {
  PS_ASSERT(base && !base->empty(), "a mip chain needs a picture");
  MipChain chain{std::move(base), {}};
  if (levels == MipLevels::finest_only) return chain;
  const Image<Vec3f>* last = chain.base.get();
  while (last->width() > 1 || last->height() > 1) {
    Image<Vec3f> next = half_size(*last);
    chain.reduced.push_back(std::move(next));
    last = &chain.reduced.back();
  }
  return chain;
}

}  // namespace ps
