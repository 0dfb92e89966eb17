#pragma once
#include <array>
#include <memory>
#include <optional>

#include "gui/panels/studies/study.h"
#include "gui/platform/texture.h"
#include "inspect/missing_term.h"
#include "study/difference_by_cause.h"
#include "study/missing_feature.h"
#include "study/precision_map.h"

namespace ps::gui {

/// Which option is to blame for how much of the difference between A and B.
struct CausesTab : Study<DifferenceByCause> {
  explicit CausesTab(const PanelHost& host);
  void measure(Session& session) override;

 protected:
  void draw_result(Session& session) override;
  std::string about(const Session& session) const override;
  std::string reason_against(Session& session) const override;
  void offer_found(Values& out) const override;

 private:
  std::array<Settings, 2> compared_;  ///< the settings that the causes are about
};

/// The answer to "what is missing?", with the file and the settings that it is about.
struct MissingFound {
  std::shared_ptr<const PictureFile> file;
  Settings settings;
  MissingFeature feature;
};

/// The difference between A and a picture file in B's place: at the picked pixel by the rows of A's sum, and over the
/// picture by changes of A.
struct MissingTab : Study<MissingFound> {
  explicit MissingTab(const PanelHost& host);
  void measure(Session& session) override;

 protected:
  void draw_result(Session& session) override;
  std::string about(const Session& session) const override;
  void offer_found(Values& out) const override;
};

/// The rows of A's sum at the picked pixel beside the file in B's place; nullopt without a file, a pixel or its story.
std::optional<MissingTerm> missing_term_of(Session& session);

/// What one side's arithmetic gets wrong, with what it was measured for.
struct PrecisionFound {
  Side side = Side::a;
  std::string scene_name;
  PrecisionMap map;
  Image<Rgb8> faults, gaps;  ///< pictures of the map
};

/// What float gets wrong in a picture.
struct PrecisionTab : Study<PrecisionFound> {
  explicit PrecisionTab(const PanelHost& host);
  void measure(Session& session) override;

 protected:
  void choices(Session& session) override;
  void draw_result(Session& session) override;
  std::string about(const Session& session) const override;
  void took(Session& session) override;
  void offer_found(Values& out) const override;

 private:
  Side side_ = Side::a;
  std::array<Texture, 2> textures_;  ///< faults, gaps
};

/// One of them is shown: the precision of a picture, or what makes A and B differ, which is another question where B is
/// a file.
class WhyTab final : public StudyParts {
 public:
  explicit WhyTab(const PanelHost& host);

 private:
  CausesTab causes_;
  MissingTab missing_;
  PrecisionTab precision_;
};

}  // namespace ps::gui
