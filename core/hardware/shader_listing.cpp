#include "hardware/shader_listing.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/check.h"
#include "base/resources.h"
#include "frame/empty_frame.h"
#include "hardware/definitions.h"
#include "hardware/picture_drawer.h"
#include "hardware/render_hardware.h"
#include "hardware/shader_lines.h"
#include "hardware/uniform_values.h"

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

std::string pass_words(const DrawPass& pass) {
  switch (pass.kind) {
  case DrawPass::Kind::whole:
    return "";
  case DrawPass::Kind::depth:
    return "depth alone";
  case DrawPass::Kind::geometry:
    return "what deferred shading reads";
  case DrawPass::Kind::shade:
    return "shading";
  case DrawPass::Kind::light:
    return pass.light < 0 ? "without a light" : fmt::format("light {}", pass.light);
  }
  return "";
}

/// Prepares each draw call of a triangle as for the picture, and asks what the programs have then. Nothing is drawn.
class ShaderLister : private PictureDrawer {
 public:
  ShaderLister(const PicturePlan& plan, Workshop& shop) : PictureDrawer(plan, shop) {
    // As stories do, so that the picture's own target stays.
    std::swap(shop_.target, shop_.story_picture);
    std::swap(shop_.geometry, shop_.story_geometry);
  }
  ~ShaderLister() {
    std::swap(shop_.target, shop_.story_picture);
    std::swap(shop_.geometry, shop_.story_geometry);
  }
  ShaderLister(const ShaderLister&) = delete;
  ShaderLister& operator=(const ShaderLister&) = delete;

  std::vector<ShaderDraw> list(const PixelId& id) {
    upload();
    const DrawRun* run = run_of(id);
    std::vector<ShaderDraw> draws;
    if (!run) return draws;
    for (const DrawPass& pass : draw_passes(plan_)) {
      const bool whole_picture = plan_.defers && pass.shades();
      draws.push_back(whole_picture ? of_whole_picture(pass) : of_triangle(*run, id, pass));
      draws.back().pass = pass_words(pass);
    }
    check_gl("asking for the values of uniforms");
    return draws;
  }

 private:
  const DrawRun* run_of(const PixelId& id) const {
    if (id.object < 0) return nullptr;
    const auto has = [&](const DrawRun& run) {
      if (plan_.objects[run.object].object != id.object) return false;
      for (std::size_t i = run.first; i < run.first + run.count; ++i)
        if (static_cast<int>(sorted_triangles_.empty() ? i : sorted_triangles_[i]) == id.triangle) return true;
      return false;
    };
    const auto found = std::find_if(runs_.begin(), runs_.end(), has);
    return found == runs_.end() ? nullptr : &*found;
  }

  ShaderDraw of_triangle(const DrawRun& run, const PixelId& id, const DrawPass& pass) {
    Program& program = *programs_[run.surface];
    prepare_run(program, run, pass);
    ShaderDraw draw =
        with_values(program, "vertex.glsl", "fragment.glsl",
                    hardware::definitions(plan_, plan_.surfaces.list[run.surface], shop_.driver().clip_control));
    draw.id = id;
    return draw;
  }

  ShaderDraw of_whole_picture(const DrawPass& pass) {
    Program& program = deferred_program();
    program.use();
    set_view(program);
    set_light(program, pass);
    set_geometry(program);
    return with_values(program, "whole_picture.glsl", "deferred.glsl",
                       deferred_definitions(plan_, shop_.driver().clip_control));
  }

  ShaderDraw with_values(const Program& program, const char* vertex_file, const char* fragment_file,
                         const std::string& definitions) {
    const UniformTexts values = uniform_values(program);
    ShaderDraw draw;
    draw.files[static_cast<std::size_t>(ShaderPart::vertex)] =
        shader_lines(shop_.shaders, vertex_file, definitions, values);
    draw.files[static_cast<std::size_t>(ShaderPart::fragment)] =
        shader_lines(shop_.shaders, fragment_file, definitions, values);
    return draw;
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
  PicturePlan plan = make_plan(scene, view, settings, {}, prepared);
  draw_ahead(plan, prepared, WorkerPriority::normal, progress, [](const char*) {});
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
