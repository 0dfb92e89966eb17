#include "hardware/mesh_buffers.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

#include "hardware/context.h"
#include "hardware/least_recent.h"
#include "math/unit.h"
#include "scene/form_frame.h"
#include "shade/normal_mapping.h"

namespace ps::hardware {
namespace {

constexpr std::size_t most_mesh_bytes = std::size_t{1} << 30;

int width_of(Stream stream) {
  switch (stream) {
  case Stream::positions:
  case Stream::triangle_normals:
  case Stream::centres:
  case Stream::snapped:
  case Stream::along_u:
  case Stream::upwards:
    return 3;
  case Stream::uvs:
    return 2;
  case Stream::normals:
  case Stream::normals_0:
  case Stream::normals_1:
  case Stream::normals_2:
    return 4;
  }
  return 0;
}

FormBox box_around(const std::vector<Vec3d>& positions) {
  if (positions.empty()) return {Vec3d(0), Vec3d(0)};
  FormBox box{positions.front(), positions.front()};
  for (const Vec3d& p : positions) box = {glm::min(box.low, p), glm::max(box.high, p)};
  return box;
}

Vec3d own_normal(const Mesh& mesh, const MeshTriangle& triangle) {
  const auto corner = [&](std::size_t k) { return mesh.positions[triangle.position[k]]; };
  return unit_or_zero(triangle_normal(corner(0), corner(1), corner(2)));
}

/// How the texture lies on the triangle; zeros where it does not.
TangentFrame<double> frame_of(const Mesh& mesh, const MeshTriangle& triangle) {
  std::array<Vec3d, 3> positions;
  std::array<Vec2d, 3> uvs;
  for (std::size_t k = 0; k < 3; ++k) {
    if (triangle.uv[k] < 0) return {};
    positions[k] = mesh.positions[triangle.position[k]];
    uvs[k] = mesh.uvs[static_cast<std::size_t>(triangle.uv[k])];
  }
  return triangle_frame(positions, uvs).value_or(TangentFrame<double>{});
}

/// The values of one vertex of a triangle.
class CornerValues {
 public:
  CornerValues(const Mesh& mesh, const MeshBuffers& buffers) : mesh_(mesh), buffers_(buffers) {}

  void add(Stream stream, const MeshTriangle& triangle, std::size_t k, std::vector<float>& values) const {
    switch (stream) {
    case Stream::positions:
      return push(buffers_.place(mesh_.positions[triangle.position[k]]), values);
    case Stream::normals:
      return push_normal(triangle, k, values);
    case Stream::uvs: {
      const auto index = triangle.uv[k];
      const Vec2d uv = index >= 0 ? mesh_.uvs[static_cast<std::size_t>(index)] : Vec2d(0);
      values.push_back(static_cast<float>(uv.x));
      values.push_back(static_cast<float>(uv.y));
      return;
    }
    case Stream::triangle_normals:
      return push(own_normal(mesh_, triangle), values);
    case Stream::centres: {
      Vec3d sum(0);
      for (const std::uint32_t p : triangle.position) sum += buffers_.place(mesh_.positions[p]);
      return push(sum / 3.0, values);
    }
    case Stream::normals_0:
      return push_normal(triangle, 0, values);
    case Stream::normals_1:
      return push_normal(triangle, 1, values);
    case Stream::normals_2:
      return push_normal(triangle, 2, values);
    case Stream::along_u:
      return push(frame_of(mesh_, triangle).along_u, values);
    case Stream::upwards:
      return push(frame_of(mesh_, triangle).upwards, values);
    case Stream::snapped:
      break;
    }
  }

 private:
  static void push(const Vec3d& v, std::vector<float>& values) {
    for (int axis = 0; axis < 3; ++axis) values.push_back(static_cast<float>(v[axis]));
  }
  /// The fourth number encodes for the shader whose normal it is, since each kind has a matrix of its own.
  void push_normal(const MeshTriangle& triangle, std::size_t k, std::vector<float>& values) const {
    const auto index = triangle.normal[k];
    push(index >= 0 ? mesh_.normals[static_cast<std::size_t>(index)] : own_normal(mesh_, triangle), values);
    values.push_back(index >= 0 ? 1.0f : 0.0f);
  }

  const Mesh& mesh_;
  const MeshBuffers& buffers_;
};

}  // namespace

MeshBuffers::MeshBuffers(const Mesh& mesh) {
  const FormBox box = box_around(mesh.positions);
  centre_ = box.low * 0.5 + box.high * 0.5;
  const double extent = largest_component(box.high - centre_);
  if (extent > 0) scale_ = std::ldexp(1, -std::ilogb(extent));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t slot = mesh.triangles[i].material;
    if (runs_.empty() || runs_.back().slot != slot) runs_.push_back({slot, i, 0});
    ++runs_.back().count;
  }
}

MeshBuffers::~MeshBuffers() { glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data()); }

std::uint64_t MeshBuffers::missing_bytes(Stream stream, const Mesh& mesh) const {
  if (buffers_[static_cast<std::size_t>(stream)] != 0) return 0;
  return mesh.triangles.size() * 3 * static_cast<std::uint64_t>(width_of(stream)) * sizeof(float);
}

void MeshBuffers::need(Stream stream, const Mesh& mesh) {
  GLuint& buffer = buffers_[static_cast<std::size_t>(stream)];
  if (buffer != 0) return;
  std::vector<float> values;
  values.reserve(missing_bytes(stream, mesh) / sizeof(float));
  const CornerValues corners(mesh, *this);
  for (const MeshTriangle& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) corners.add(stream, triangle, k, values);
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data(), GL_STATIC_DRAW);
  bytes_ += values.size() * sizeof(float);
  check_gl("uploading a mesh");
}

void MeshBuffers::bind(Stream stream) const {
  const auto place = static_cast<GLuint>(stream);
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[place]);
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, width_of(stream), GL_FLOAT, GL_FALSE, 0, nullptr);
}

MeshBuffers& MeshStore::get(const std::shared_ptr<const Mesh>& mesh) {
  Entry& entry = entries_[mesh.get()];
  if (entry.mesh.lock() != mesh) entry = {mesh, std::make_unique<MeshBuffers>(*mesh), 0};
  entry.used = ++clock_;
  return *entry.buffers;
}

void MeshStore::tidy() {
  std::erase_if(entries_, [](const auto& entry) { return entry.second.mesh.expired(); });
  std::size_t bytes = 0;
  for (const auto& [mesh, entry] : entries_) bytes += entry.buffers->bytes();
  while (bytes > most_mesh_bytes && entries_.size() > 1) {
    const auto oldest = least_recent(entries_);
    bytes -= oldest->second.buffers->bytes();
    entries_.erase(oldest);
  }
}

}  // namespace ps::hardware
