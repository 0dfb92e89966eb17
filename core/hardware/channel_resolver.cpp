#include "hardware/channel_resolver.h"

#include <epoxy/gl.h>

#include <array>

#include "hardware/context.h"
#include "hardware/picture_units.h"

namespace ps::hardware {

ChannelResolver::ChannelResolver() : program_("whole_picture.glsl", "sample_channels.glsl", Api::desktop, "") {}

void ChannelResolver::resolve(const Framebuffer& target) {
  constexpr std::array<const char*, 3> names{"seen_samples", "normal_samples", "weight_samples"};
  program_.use();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const int unit = geometry_unit + static_cast<int>(i);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, target.channel_samples(i));
    program_.set(names[i], unit);
  }
  for (const GLenum test : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_BLEND}) glDisable(test);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  target.bind_resolved();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glColorMaski(0, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  for (std::size_t i = 0; i < names.size(); ++i) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(geometry_unit) + static_cast<GLenum>(i));
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
  }
  check_gl("copying the channels of samples");
}

}  // namespace ps::hardware
