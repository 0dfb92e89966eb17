// The six faces of a cube around a point: core/raster/shadow/cube_face.h.

// Numbers of the faces: +x -x +y -y +z -z.
int cube_face_of(vec3 v) {
  int axis = 0;
  if (abs(v.y) > abs(v.x)) axis = 1;
  if (abs(v.z) > abs(v[axis])) axis = 2;
  return 2 * axis + (v[axis] < 0.0 ? 1 : 0);
}

// In the face's own coordinates: along its right, up and forward.
vec3 in_face(int face, vec3 v) {
  if (face == 0) return vec3(-v.z, v.y, v.x);
  if (face == 1) return vec3(v.z, v.y, -v.x);
  if (face == 2) return vec3(v.x, -v.z, v.y);
  if (face == 3) return vec3(v.x, v.z, -v.y);
  if (face == 4) return v;
  return vec3(-v.x, v.y, -v.z);
}

vec3 out_of_face(int face, vec3 v) {
  if (face == 0) return vec3(v.z, v.y, -v.x);
  if (face == 1) return vec3(-v.z, v.y, v.x);
  if (face == 2) return vec3(v.x, v.z, -v.y);
  if (face == 3) return vec3(v.x, -v.z, v.y);
  if (face == 4) return v;
  return vec3(-v.x, v.y, -v.z);
}

// Texels from the top left of a face of size x size.
vec2 face_position(vec3 local, int size) {
  float half_size = float(size) / 2.0;
  return vec2(half_size + half_size * local.x / local.z, half_size - half_size * local.y / local.z);
}
