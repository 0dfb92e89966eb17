#pragma once
#include <map>
#include <memory>

#include "gui/work/background_study.h"
#include "study/chart.h"
#include "study/estimate.h"

namespace ps::gui {

/// A chart as far as it is measured. The points' pictures are shared among the states of one chart.
struct ChartFound {
  Chart chart;                                                 ///< its points without pictures
  std::map<int, std::shared_ptr<const Image<Rgb8>>> pictures;  ///< by the number of the point
  std::shared_ptr<const Image<Rgb8>> reference;                ///< what they are compared with
  bool complete() const;                                       ///< every point is measured
};

using ChartStudy = BackgroundStudy<ChartFound>;

/// The time that a chart will take, before it is measured.
using ChartEstimateStudy = BackgroundStudy<StudyEstimate>;
void start_estimate(ChartEstimateStudy& study, ChartRequest request);

/// Begins or goes on with a chart, whose results are kept in the request's folder.
void start_chart(ChartStudy& study, ChartRequest request);

}  // namespace ps::gui
