#include "scene/solid.h"

namespace ps {
namespace {

template <class Node, class Part>
void collect(Node& node, std::vector<Part*>& parts) {
  if (node.children.empty()) parts.push_back(&node.part);
  for (auto& child : node.children) collect(child, parts);
}

}  // namespace

std::vector<const Solid*> csg_parts(const CsgNode& root) {
  std::vector<const Solid*> parts;
  collect(root, parts);
  return parts;
}

std::vector<Solid*> csg_parts(CsgNode& root) {
  std::vector<Solid*> parts;
  collect(root, parts);
  return parts;
}

bool is_flat(const Form& form) {
  return std::holds_alternative<Plane>(form) || std::holds_alternative<Rectangle>(form);
}

}  // namespace ps
