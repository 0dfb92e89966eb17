#include "frame/precision_fault.h"

namespace ps {

std::string_view precision_fault_label(PrecisionFault fault) {
  switch (fault) {
  case PrecisionFault::none:
    return "as in double";
  case PrecisionFault::false_hit:
    return "false hit";
  case PrecisionFault::missed_hit:
    return "missed hit";
  case PrecisionFault::wrong_winner:
    return "wrong winner";
  case PrecisionFault::shading:
    return "shading differs";
  }
  return {};
}

Rgb8 precision_fault_colour(PrecisionFault fault) {
  switch (fault) {  // Okabe and Ito's colours, distinct with any colour vision
  case PrecisionFault::none:
    return {40, 40, 44};
  case PrecisionFault::false_hit:
    return {213, 94, 0};
  case PrecisionFault::missed_hit:
    return {86, 180, 233};
  case PrecisionFault::wrong_winner:
    return {240, 228, 66};
  case PrecisionFault::shading:
    return {204, 121, 167};
  }
  return {};
}

}  // namespace ps
