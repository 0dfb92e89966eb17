#include "record/value_text.h"
#include "record/watch.h"

namespace ps {

std::string watch_text(const WatchValue& value) {
  struct Text {
    std::string operator()(bool v) const { return v ? "true" : "false"; }
    std::string operator()(std::int64_t v) const { return std::to_string(v); }
    std::string operator()(double v) const { return number_text(v); }
    std::string operator()(const Vec2d& v) const { return vector_text(v); }
    std::string operator()(const Vec3d& v) const { return vector_text(v); }
    std::string operator()(const std::string& v) const { return v; }
  };
  return std::visit(Text{}, value);
}

}  // namespace ps
