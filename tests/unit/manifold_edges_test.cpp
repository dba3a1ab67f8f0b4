// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/clustering/manifold_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "support/drawn_meshes.h"

namespace curvdecim::test {

using namespace detail;

namespace {

std::vector<CellFace> cell_faces(const std::vector<Face>& faces) {
  std::vector<CellFace> result;
  for (const Face& face : faces) result.push_back({face, static_cast<int>(result.size())});
  return result;
}

std::vector<bool> kept(const std::vector<Face>& faces, const std::vector<Face>& staying = {}) {
  return ManifoldEdges(cell_faces(faces), staying).run();
}

int count(const std::vector<bool>& flags) {
  return static_cast<int>(std::count(flags.begin(), flags.end(), true));
}

bool fits(const std::vector<Face>& faces, const std::vector<bool>& chosen) {
  std::map<std::pair<int, int>, int> uses;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 3 && chosen[f]; ++i)
      if (++uses[std::minmax(faces[f][i], faces[f][(i + 1) % 3])] > 2) return false;
  return true;
}

/// The most faces that fit, by trying every choice.
int most(const std::vector<Face>& faces) {
  int best = 0;
  for (unsigned choice = 0; choice < 1u << faces.size(); ++choice) {
    std::vector<bool> chosen(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) chosen[f] = choice >> f & 1;
    if (count(chosen) > best && fits(faces, chosen)) best = count(chosen);
  }
  return best;
}

TEST(ManifoldEdges, LeaveAManifoldAlone) {
  const Shape shape = torus(8, 6);
  EXPECT_EQ(count(kept(shape.faces)), shape.face_count());
}

TEST(ManifoldEdges, DropTheLastOfThreePages) {
  EXPECT_EQ(kept({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}), (std::vector<bool>{true, true, false}));
}

/// One face at three crowded edges is better dropped than three others.
TEST(ManifoldEdges, DropTheFaceThatCrowdsMost) {
  const std::vector<Face> faces = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {1, 2, 5},
                                   {1, 2, 6}, {2, 0, 7}, {2, 0, 8}};
  const std::vector<bool> result = kept(faces);
  EXPECT_FALSE(result[0]);
  EXPECT_EQ(count(result), 6);
}

TEST(ManifoldEdges, CountFacesThatStay) {
  EXPECT_EQ(kept({{0, 1, 2}, {0, 1, 3}}, {{0, 1, 4}}), (std::vector<bool>{true, false}));
}

TEST(ManifoldEdges, KeepNearlyTheMostFaces) {
  std::mt19937 random(5);
  int kept_in_all = 0, most_in_all = 0;
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<Face> faces;
    for (int f = 0; f < 12; ++f) {
      Face face;
      do
        for (int& v : face) v = static_cast<int>(random() % 5);
      while (is_degenerate(face));
      std::sort(face.begin(), face.end());
      if (std::find(faces.begin(), faces.end(), face) == faces.end()) faces.push_back(face);
    }
    const std::vector<bool> result = kept(faces);
    ASSERT_TRUE(fits(faces, result));
    kept_in_all += count(result), most_in_all += most(faces);
  }
  EXPECT_GE(kept_in_all, 0.95 * most_in_all);
}

}  // namespace
}  // namespace curvdecim::test
