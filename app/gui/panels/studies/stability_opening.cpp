#include "gui/panels/studies/stability_opening.h"

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/check.h"

namespace ps::gui {

void begin_opening(StabilityOpeningStudy& study, const StabilityExperiment& experiment, double knob) {
  study.start([&experiment, knob](StudyControl& control, const StabilityOpeningStudy::Publish& publish) {
    auto opening = open_stability_point(experiment, knob, control.progress());
    if (opening) publish(std::make_shared<const StabilityOpening>(std::move(*opening)), {1, 1, 0});
  });
}

void show_opening(Session& session, const StabilityOpening& opening, const std::filesystem::path& folder) {
  std::string name = opening.scene_name;
  if (!opening.scene_text.empty()) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const auto path = folder / (opening.scene_name + ".scene");
    write_file_atomically(path, opening.scene_text);
    name = path.string();
  }
  Document document = open_document(name, opening.scene);
  document.view.camera = opening.view.camera;
  document.view.width = opening.view.width;
  document.view.height = opening.view.height;
  document.a.settings = opening.naive;
  document.b.settings = opening.robust;
  document.picked = Side::a;
  if (opening.failing) document.pixel = *opening.failing;
  session.start(std::move(document), "frames of " + opening.scene_name);  // one after the other they are one step
  session.say(Message::Kind::information,
              opening.failing
                  ? fmt::format("A: naive, B: robust. {:.3g} % of the pixels differ; one of them is picked.",
                                opening.failing_percent)
                  : "A: naive, B: robust. They agree at every pixel here.");
}

}  // namespace ps::gui
