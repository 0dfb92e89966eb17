#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <vector>

#include "math/vec.h"
#include "scene/mesh.h"

namespace ps::hardware {

/// What each vertex of a triangle carries; the numbers are the locations in vertex.glsl.
enum class Stream : unsigned {
  positions = 0,
  normals = 1,
  uvs = 2,
  triangle_normals = 3,
  centres = 4,
  normals_0 = 5,
  normals_1 = 6,
  normals_2 = 7,
  snapped = 8,  ///< not of a mesh alone: see PictureDrawer::snap_vertices()
  along_u = 9,
  upwards = 10,
};
inline constexpr std::size_t stream_count = 11;

/// Triangles of one material slot that follow each other.
struct SlotRun {
  std::uint32_t slot = 0;
  std::size_t first = 0, count = 0;
};

/// A mesh in the memory of the graphics driver: three vertices for each triangle, each with its own values, so that the
/// number of a vertex gives its triangle. A stream is uploaded when it is first asked for.
class MeshBuffers {
 public:
  explicit MeshBuffers(const Mesh& mesh);
  ~MeshBuffers();
  MeshBuffers(const MeshBuffers&) = delete;
  MeshBuffers& operator=(const MeshBuffers&) = delete;

  /// What need() would upload.
  std::uint64_t missing_bytes(Stream stream, const Mesh& mesh) const;
  /// Uploads it if it is not there yet.
  void need(Stream stream, const Mesh& mesh);
  /// Makes a stream that is there the input of its location.
  void bind(Stream stream) const;

  /// A position as vertices carry it: (position - centre) * scale. So it keeps its bits far from the model's origin,
  /// and within float's range whatever the model's size. The scale is a power of two.
  Vec3d place(const Vec3d& position) const { return (position - centre_) * scale_; }
  const Vec3d& centre() const { return centre_; }
  double scale() const { return scale_; }
  /// In the order of the triangles.
  const std::vector<SlotRun>& runs() const { return runs_; }
  std::size_t bytes() const { return bytes_; }

 private:
  Vec3d centre_{0, 0, 0};
  double scale_ = 1;
  std::vector<SlotRun> runs_;
  std::array<unsigned, stream_count> buffers_{};
  std::size_t bytes_ = 0;
};

/// The meshes that are kept. One that no scene holds any more is dropped, and beyond a gigabyte those that were not
/// used for the longest time.
class MeshStore {
 public:
  MeshBuffers& get(const std::shared_ptr<const Mesh>& mesh);
  /// Between pictures.
  void tidy();
  /// Drops them all, between pictures.
  void clear() { entries_.clear(); }
  std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    std::weak_ptr<const Mesh> mesh;
    std::unique_ptr<MeshBuffers> buffers;
    std::uint64_t used = 0;
  };
  std::map<const Mesh*, Entry> entries_;
  std::uint64_t clock_ = 0;
};

}  // namespace ps::hardware
