#include "study/comparison_json.h"

namespace ps {

nlohmann::ordered_json comparison_json(const Comparison& c) {
  nlohmann::ordered_json json{{"identical", c.identical}, {"mae", c.mae}, {"rmse", c.rmse}};
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
  c.mae = json.at("mae").get<double>();
  c.rmse = json.at("rmse").get<double>();
  if (!json.at("psnr").is_null()) c.psnr = json.at("psnr").get<double>();
  c.max = json.at("max").get<double>();
  c.ssim = json.at("ssim").get<double>();
  c.flip = json.at("flip").get<double>();
  c.differing = json.at("differing").get<std::int64_t>();
  c.not_finite = json.at("not-finite").get<std::int64_t>();
  return c;
}

}  // namespace ps
