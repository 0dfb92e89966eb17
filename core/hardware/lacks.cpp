#include "hardware/lacks.h"

#include <algorithm>

#include "hardware/gl_thread.h"
#include "hardware/picture_plan.h"

namespace ps::hardware {
namespace {

/// Which numbers of samples there are, the driver knows. It is not started for that.
bool driver_lacks_samples(OptionNumber value) {
  Settings settings;
  settings.multisampling = static_cast<int>(value);
  const int samples = sample_count(settings);
  if (samples == 1 || !driver_is_known() || !availability().driver) return false;
  const std::vector<int>& offered = availability().driver->samples;
  return std::find(offered.begin(), offered.end(), samples) == offered.end();
}

}  // namespace

std::optional<IdleReason> lacks_option(const Option& option, const Settings&) {
  const HardwareUse& use = option.known_to.hardware;
  if (!use.lacks_all()) return {};
  return IdleReason(IdleReason::Kind::renderer, use.reason);
}

std::optional<IdleReason> lacks_value(const Option& option, double value, const Settings& settings) {
  const HardwareUse& use = option.known_to.hardware;
  if (use.lacks) return use.lacks(value, settings);
  const bool lacked =
      use.as_driver_offers ? driver_lacks_samples(value) : use.first_lacked <= value && value <= use.last_lacked;
  if (use.lacks_all() || !lacked) return {};
  return IdleReason(IdleReason::Kind::renderer, use.reason);
}

}  // namespace ps::hardware
