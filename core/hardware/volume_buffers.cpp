#include "hardware/volume_buffers.h"

#include <epoxy/gl.h>

#include <utility>

#include "hardware/mesh_buffers.h"

namespace ps::hardware {
namespace {

template <class Value>
unsigned uploaded(const std::vector<Value>& first, const std::vector<Value>& second) {
  unsigned buffer = 0;
  const auto bytes = [](const std::vector<Value>& values) {
    return static_cast<GLsizeiptr>(values.size() * sizeof(Value));
  };
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, bytes(first) + bytes(second), nullptr, GL_STREAM_DRAW);
  glBufferSubData(GL_ARRAY_BUFFER, 0, bytes(first), first.data());
  glBufferSubData(GL_ARRAY_BUFFER, bytes(first), bytes(second), second.data());
  return buffer;
}

}  // namespace

VolumeBuffers::VolumeBuffers(const VolumeFaces& faces)
    : object_(faces.object), outwards_(static_cast<int>(faces.outwards.places.size())),
      inwards_(static_cast<int>(faces.inwards.places.size())), numbers_(faces.outward_numbers),
      places_(uploaded(faces.outwards.places, faces.inwards.places)) {
  numbers_.insert(numbers_.end(), faces.inward_numbers.begin(), faces.inward_numbers.end());
  if (!faces.outwards.snapped.empty() || !faces.inwards.snapped.empty())
    snapped_ = uploaded(faces.outwards.snapped, faces.inwards.snapped);
}

VolumeBuffers::VolumeBuffers(VolumeBuffers&& other) noexcept
    : object_(other.object_), outwards_(other.outwards_), inwards_(other.inwards_), numbers_(std::move(other.numbers_)),
      places_(std::exchange(other.places_, 0)), snapped_(std::exchange(other.snapped_, 0)) {}

VolumeBuffers::~VolumeBuffers() {
  glDeleteBuffers(1, &places_);
  glDeleteBuffers(1, &snapped_);
}

void VolumeBuffers::bind() const {
  for (GLuint place = 0; place < stream_count; ++place) glDisableVertexAttribArray(place);
  const auto input = [](unsigned buffer, Stream stream, GLint width) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glEnableVertexAttribArray(static_cast<GLuint>(stream));
    glVertexAttribPointer(static_cast<GLuint>(stream), width, GL_FLOAT, GL_FALSE, 0, nullptr);
  };
  input(places_, Stream::positions, 4);
  if (snapped_ != 0) input(snapped_, Stream::snapped, 3);
}

}  // namespace ps::hardware
