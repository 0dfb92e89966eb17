#include "hardware/environment_maps.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <map>

#include "base/check.h"
#include "hardware/context.h"
#include "hardware/render.h"
#include "raster/environment/draw_environment.h"

namespace ps::hardware {

std::shared_ptr<const raster::EnvironmentMaps> draw_environment(const PicturePlan& plan, Prepared& prepared,
                                                                WorkerPriority priority, Progress& progress) {
  if (!plan.mirrors) return nullptr;
  RenderRequest request;
  request.priority = priority;
  Prepared own;              // the objects shown are a scene of their own; its products would push out the picture's
  constexpr int copies = 2;  // one of them in the memory of the driver
  return raster::draw_environment_maps(*plan.scene, plan.settings, prepared, copies,
                                       [&](const Scene& shown, const View& view, const Settings& plain) {
                                         return render_hardware(shown, view, plain, request, own, progress).colour;
                                       });
}

EnvironmentStore::~EnvironmentStore() { glDeleteTextures(1, &texture_); }

void EnvironmentStore::bind(const std::shared_ptr<const raster::EnvironmentMaps>& maps, int unit) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  if (texture_ == 0 || held_.lock() != maps) {
    upload(*maps);
    held_ = maps;
  }
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_);
}

void EnvironmentStore::upload(const raster::EnvironmentMaps& maps) {
  std::map<const raster::EnvironmentMap*, int> layer_of;  // objects may share one
  layers_.assign(maps.size(), -1);
  for (std::size_t i = 0; i < maps.size(); ++i)
    if (maps[i]) layers_[i] = layer_of.try_emplace(maps[i].get(), static_cast<int>(6 * layer_of.size())).first->second;
  const int faces = static_cast<int>(6 * layer_of.size());
  GLint most = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
  if (faces > most)
    throw InputError(fmt::format("environment maps with {} faces: this graphics driver holds at most {}", faces, most));
  if (texture_ == 0) glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  bool has_room = false;
  for (const auto& [environment, first] : layer_of)
    for (int face = 0; face < 6; ++face) {
      const int size = environment->size;
      if (!has_room) glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGB32F, size, size, faces, 0, GL_RGB, GL_FLOAT, nullptr);
      has_room = true;
      glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, first + face, size, size, 1, GL_RGB, GL_FLOAT,
                      environment->faces[static_cast<std::size_t>(face)].pixels().data());
    }
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  check_gl("uploading environment maps");
}

}  // namespace ps::hardware
