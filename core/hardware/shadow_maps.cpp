#include "hardware/shadow_maps.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "base/check.h"
#include "hardware/context.h"
#include "hardware/render.h"
#include "raster/shadow/draw_maps.h"

namespace ps::hardware {
namespace {

Vec4f with(const Vec3d& v, double fourth) { return Vec4f(Vec3f(v), static_cast<float>(fourth)); }

/// As shadows.glsl reads them.
std::vector<Vec4f> about(const raster::ShadowMaps& maps) {
  std::vector<Vec4f> values;
  int layer = 0;
  for (const raster::ShadowMap& map : maps) {
    values.push_back(with(map.position, map.size > 0 ? layer : -1));
    values.push_back(with(map.frame.right, map.half));
    values.push_back(with(map.frame.up, map.cube ? 1 : 0));
    values.push_back(with(map.frame.forward, 0));
    layer += static_cast<int>(map.faces.size());
  }
  return values;
}

int number_of_faces(const raster::ShadowMaps& maps) {
  int faces = 0;
  for (const raster::ShadowMap& map : maps) faces += static_cast<int>(map.faces.size());
  return faces;
}

}  // namespace

std::shared_ptr<const raster::ShadowMaps> draw_maps(const PicturePlan& plan, Prepared& prepared,
                                                    WorkerPriority priority, Progress& progress) {
  if (!plan.maps_shadows) return nullptr;
  const Settings& asked = plan.settings;
  Key key = raster::shadow_maps_key("hardware-shadow-maps", *plan.scene, asked);
  key.add(asked.vertex_snapping);
  return prepared.get<raster::ShadowMaps>(key, [&] {
    return raster::draw_shadow_maps(
        *plan.scene, asked, [&](const Scene& casters, const View& view, const Settings& plain) {
          Settings settings = plain;
          settings.renderer = asked.renderer;
          settings.vertex_snapping = asked.vertex_snapping;
          Prepared own;  // six views would push the picture's own products out of the shared one
          RenderRequest request;
          request.channels = Channel::depth;
          request.priority = priority;
          return render_hardware(casters, view, settings, request, own, progress).depth;
        });
  });
}

MapStore::~MapStore() {
  glDeleteTextures(1, &texture_);
  glDeleteBuffers(1, &block_);
}

void MapStore::bind(const std::shared_ptr<const raster::ShadowMaps>& maps, int unit, unsigned block) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  if (texture_ == 0 || held_.lock() != maps) {
    upload(*maps);
    held_ = maps;
  }
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_);
  glBindBufferBase(GL_UNIFORM_BUFFER, block, block_);
}

void MapStore::upload(const raster::ShadowMaps& maps) {
  const int faces = number_of_faces(maps);
  GLint most = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
  if (faces > most)
    throw InputError(fmt::format("shadow maps with {} faces: this graphics driver holds at most {}", faces, most));
  if (texture_ == 0) glGenTextures(1, &texture_);
  if (block_ == 0) glGenBuffers(1, &block_);
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  int layer = 0;
  for (const raster::ShadowMap& map : maps)
    for (const Image<float>& face : map.faces) {
      if (layer == 0)
        glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R32F, map.size, map.size, faces, 0, GL_RED, GL_FLOAT, nullptr);
      glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer++, map.size, map.size, 1, GL_RED, GL_FLOAT,
                      face.pixels().data());
    }
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const std::vector<Vec4f> values = about(maps);
  glBindBuffer(GL_UNIFORM_BUFFER, block_);
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(Vec4f)), values.data(),
               GL_STREAM_DRAW);
  check_gl("uploading shadow maps");
}

}  // namespace ps::hardware
