// The film of a vertex: its places are those of the vertex chain, and on the way between two spaces a straight line.
#include "inspect/chain_stages.h"

#include <gtest/gtest.h>

#include <set>

#include "base/check.h"
#include "scene/load.h"

namespace chain_stages_test {
namespace {
using namespace ps;

struct Subject {
  Scene scene = load_scene("cgfs/crates");
  View view{scene.camera, 200, 200};
  VertexId vertex{0, 0};
  Subject() {
    while (!std::holds_alternative<Instance>(scene.geometry->objects[static_cast<std::size_t>(vertex.object)].shape))
      ++vertex.object;
    vertex.vertex = 2;
  }
};

TEST(ChainStages, EveryVertexIsWhereItsChainPutsIt) {
  const Subject s;
  const ChainStages stages = chain_stages(s.scene, s.view, {}, s.vertex);
  EXPECT_EQ(stages.vertices[static_cast<std::size_t>(stages.followed)], s.vertex.vertex);
  ASSERT_GE(stages.vertices.size(), 8u);
  for (std::size_t i = 0; i < stages.vertices.size(); ++i) {
    const VertexChain chain = vertex_chain(s.scene, s.view, {}, {s.vertex.object, stages.vertices[i]});
    EXPECT_EQ(place_at(stages, i, 0), chain.model);
    EXPECT_EQ(place_at(stages, i, 1), chain.world);
    EXPECT_EQ(place_at(stages, i, 2), chain.camera);
    EXPECT_EQ(place_at(stages, i, 3), Vec3d(chain.centred, chain.camera.z));
    EXPECT_EQ(place_at(stages, i, 4), Vec3d(chain.centred, 0));
    EXPECT_EQ(place_at(stages, i, 99), place_at(stages, i, 4));
    const Vec3d half = place_at(stages, i, 0.5);
    EXPECT_NEAR(half.x, (chain.model.x + chain.world.x) / 2, 1e-12);
    EXPECT_NEAR(half.z, (chain.model.z + chain.world.z) / 2, 1e-12);
  }
}

TEST(ChainStages, EdgesAreThereOnceAndThoseOfTheVertexFirst) {
  const Subject s;
  const ChainStages all = chain_stages(s.scene, s.view, {}, s.vertex);
  std::set<std::set<int>> known;
  for (const auto& edge : all.edges) EXPECT_TRUE(known.insert({edge[0], edge[1]}).second);
  EXPECT_EQ(all.edges.size(), 18u) << "of a cube's twelve triangles";
  const ChainStages few = chain_stages(s.scene, s.view, {}, s.vertex, {}, 3);
  ASSERT_EQ(few.edges.size(), 3u);
  for (const auto& edge : few.edges) EXPECT_TRUE(edge[0] == few.followed || edge[1] == few.followed);
}

TEST(ChainStages, WhatIsBehindTheCameraHasNoEdges) {
  Subject s;
  const VertexChain chain = vertex_chain(s.scene, s.view, {}, s.vertex);
  s.view.camera.position = chain.world - s.view.camera.forward * 1e-3;  // the vertex is just in front of it
  const ChainStages stages = chain_stages(s.scene, s.view, {}, s.vertex);
  for (const int vertex : stages.vertices)
    EXPECT_GT(vertex_chain(s.scene, s.view, {}, {s.vertex.object, vertex}).camera.z, 0);
  EXPECT_THROW(chain_stages(s.scene, s.view, {}, {s.vertex.object, 99999}), InputError);
}

}  // namespace
}  // namespace chain_stages_test
