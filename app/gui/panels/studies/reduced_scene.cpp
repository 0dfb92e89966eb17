#include "gui/panels/studies/reduced_scene.h"

#include <fmt/format.h>

#include <system_error>

#include "base/check.h"
#include "frame/display_frame.h"
#include "image/file.h"
#include "render/render.h"
#include "scene/load.h"
#include "study/model/model_files.h"

namespace ps::gui {

void open_reduced(Session& session, std::shared_ptr<const ModelNeeds> needs, const Settings& before,
                  const std::filesystem::path& folder) {
  const Document now = session.document();
  const std::string name = std::filesystem::path(now.scene_name).stem().string();
  const auto make = [now, needs = std::move(needs), before, folder, name] {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw InputError(fmt::format("{}: {}", folder.string(), error.message()));
    const View view = view_of(now);
    Document next = now;
    next.scene_name = (folder / (name + "-reduced.scene")).string();
    next.picture_b = (folder / (name + "-full.png")).string();
    save_reduced(*needs, view, next.scene_name);
    save_image(next.picture_b, display_frame(render(now.scene, view, before), before));
    next.edits.clear();
    next.pin.reset();
    next.events = {-1, -1};
    next.before_technique.reset();
    next.picked = Side::a;
    next.view.region.reset();
    next.a.settings = next.b.settings = needs->settings;
    attach_scene(next, load_scene(next.scene_name));
    return next;
  };
  session.loader().load(name, make, LoadReason::open);
}

}  // namespace ps::gui
