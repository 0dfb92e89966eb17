#include "hardware/shader_listing.h"

#include <algorithm>

#include "base/check.h"
#include "base/resources.h"
#include "frame/empty_frame.h"
#include "hardware/picture_drawer.h"
#include "hardware/render.h"

namespace ps::hardware {
namespace {

/// The triangle that is seen at the centre of the pixel. Those of spheres have numbers here.
PixelId triangle_at(const Scene& scene, const View& view, Settings settings, Vec2i pixel, Prepared& prepared,
                    Progress& progress) {
  settings.multisampling = 1;
  settings.shadows = Shadows::none;
  settings.environment = Environment::none;
  RenderRequest request;
  request.channels = Channel::ids;
  request.region = TileRect{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1};
  PicturePlan plan = make_plan(scene, view, settings, request, prepared);
  for (raster::DrawObject& object : plan.objects) object.sphere = false;
  Frame frame = empty_frame<float>(view, request);
  on_gl_thread([&](Workshop& shop) {
    PictureDrawer drawer(plan, shop);
    drawer.upload();
    drawer.draw();
    shop.target->read(frame);
  });
  progress.check();
  return frame.ids.at(pixel.x, pixel.y);
}

/// Looks up the programs that draw a triangle. Nothing is drawn.
class ShaderLister : private PictureDrawer {
 public:
  using PictureDrawer::PictureDrawer;

  std::vector<ShaderDraw> list(const PixelId& id) {
    const raster::Surface<float>* surface = surface_of(id);
    if (!surface) return {};
    std::vector<ShaderDraw> draws{{"", id, program_of(*surface).texts()}};
    if (plan_.defers) {
      draws.front().pass = "what deferred shading reads";
      draws.push_back({"shading", {}, deferred_program().texts()});
    }
    return draws;
  }

 private:
  const raster::Surface<float>* surface_of(const PixelId& id) const {
    for (std::size_t i = 0; i < plan_.objects.size(); ++i) {
      const raster::DrawObject& draw = plan_.objects[i];
      const auto triangle = static_cast<std::size_t>(id.triangle);
      if (draw.object != id.object || triangle >= draw.mesh->triangles.size()) continue;
      const std::size_t slot = draw.materials.size() == 1 ? 0 : draw.mesh->triangles[triangle].material;
      return &plan_.surfaces.list[plan_.surfaces.first[i] + slot];
    }
    return nullptr;
  }
};

/// All files of the folder: an edit may make another one of them count.
std::vector<std::filesystem::path> files_on_disk() {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(shader_file(""), error))
    if (entry.path().extension() == ".glsl") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::shared_ptr<const ShaderListing> list_shaders(const Scene& scene, const View& view, const Settings& settings,
                                                  Vec2i pixel, Prepared& prepared, Progress& progress) {
  require_driver(view);
  const PixelId id = triangle_at(scene, view, settings, pixel, prepared, progress);
  auto listing = std::make_shared<ShaderListing>();
  listing->watched = files_on_disk();
  const PicturePlan plan = make_plan(scene, view, settings, {}, prepared);
  on_gl_thread([&](Workshop& shop) {
    shop.tidy();
    listing->draws = ShaderLister(plan, shop).list(id);
  });
  progress.check();
  return listing;
}

std::string reload_shaders() {
  std::string message;
  on_gl_thread([&](Workshop& shop) {
    ShaderFiles files;
    std::vector<std::unique_ptr<Program>> made;
    try {
      for (const auto& [key, kept] : shop.programs) made.push_back(make_program(kept, files, shop.context.api()));
    } catch (const InputError& error) {
      message = error.what();
      return;
    }
    std::size_t next = 0;
    for (auto& [key, kept] : shop.programs) kept.program = std::move(made[next++]);
    shop.shaders = std::move(files);
  });
  return message;
}

}  // namespace ps::hardware
