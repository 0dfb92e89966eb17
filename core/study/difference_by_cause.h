#pragma once
#include <functional>
#include <string>
#include <vector>

#include "render/render.h"
#include "study/control.h"
#include "study/metric.h"

namespace ps {

struct CauseRequest {
  Scene scene;
  View view;
  Settings a, b;
  ErrorOptions error;  ///< how pictures are compared with A's
  int orders = 24;     ///< random orders, each also backwards, where there are too many options for all of them
  std::uint32_t seed = 1;
  WorkerPriority priority = WorkerPriority::normal;
};

/// One option in which A and B differ.
struct CauseShare {
  std::string option;    ///< key
  std::string from, to;  ///< its values in A and in B
  double share = 0;      ///< its part of the whole difference; the parts add up to it
  double alone = 0;      ///< difference from A when only this option is taken over from B
  double without = 0;    ///< difference from A when all others are taken over: what is left without it
  std::string note;      ///< why it was not measured ("only speed changes"); empty if it was
};

struct DifferenceByCause {
  double total = 0;  ///< between the pictures of A and B, in the metric's unit
  std::string metric;
  std::vector<CauseShare> causes;  ///< largest share first
  int renders = 0;
  bool every_order = true;  ///< false: means over random orders
};

/// Which option is to blame for how much of the difference. An option's part depends on which others were switched
/// before it, so it is the mean over all orders of switching them from A's value to B's (Shapley 1953): exact for up to
/// six options, else over random orders and their reverses. PSNR counts as RMSE and SSIM as 1 - SSIM, so that the whole
/// is 0 for equal pictures. Throws Cancelled.
DifferenceByCause difference_by_cause(const CauseRequest& request, StudyControl& control,
                                      const std::function<void(const StudyStatus&)>& update = {});

}  // namespace ps
