#include "study/comparison_json.h"

#include <limits>

#include "study/json_log.h"

namespace ps {

nlohmann::ordered_json comparison_json(const Comparison& c) {
  nlohmann::ordered_json json{
      {"identical", c.identical}, {"identical-levels", c.identical_levels}, {"mae", c.mae}, {"rmse", c.rmse}};
  if (c.psnr)
    json["psnr"] = *c.psnr;
  else
    json["psnr"] = nullptr;
  json["max"] = c.max;
  json["ssim"] = c.ssim;
  json["flip"] = c.flip;
  json["differing"] = c.differing;
  json["not-finite"] = c.not_finite;
  return json;
}

Comparison comparison_from_json(const nlohmann::ordered_json& json) {
  Comparison c;
  c.identical = json.at("identical").get<bool>();
  c.identical_levels = json.value("identical-levels", c.identical);  // logs of earlier versions have levels alone
  constexpr double any_double = std::numeric_limits<double>::max();
  constexpr int any_int = std::numeric_limits<int>::max();  // pixels of a picture
  c.mae = json_number(json, "mae", 0, any_double);
  c.rmse = json_number(json, "rmse", 0, any_double);
  if (!json.at("psnr").is_null()) c.psnr = json_number(json, "psnr", -any_double, any_double);
  c.max = json_number(json, "max", 0, any_double);
  c.ssim = json_number(json, "ssim", -1.000001, 1.000001);  // rounding aside
  c.flip = json_number(json, "flip", 0, 1.000001);
  c.differing = json_integer(json, "differing", 0, any_int);
  c.not_finite = json_integer(json, "not-finite", 0, any_int);
  return c;
}

}  // namespace ps
