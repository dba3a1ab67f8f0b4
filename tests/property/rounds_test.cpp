// SPDX-License-Identifier: GPL-3.0-or-later
// Collapses in rounds, on meshes that are large enough for it, are as sound as those one by one.
#include <gtest/gtest.h>

#include <set>

#include "support/decimation.h"
#include "support/fingerprint.h"
#include "support/mesh_group.h"
#include "support/properties.h"
#include "support/rich_mesh.h"

namespace curvdecim::test {
namespace {

/// A target that is reached within the rounds.
constexpr int last_in_rounds = 2 * 4096;

EdgeCollapseParams with_scheduler(Scheduler scheduler, int faces) {
  EdgeCollapseParams params = to_faces(faces);
  params.preset = Preset::Custom;
  params.scheduler = scheduler;
  return params;
}

Shape by(Scheduler scheduler, const Shape& shape, int faces) {
  return decimated(shape, with_scheduler(scheduler, faces)).shape;
}

void expect_sound(const Shape& before, const EdgeCollapseParams& params) {
  const Shape after = decimated(before, params).shape;
  EXPECT_PRED2(keeps_topology, topology(before), topology(after));
  EXPECT_TRUE(all_finite(after));
  EXPECT_LT(after.face_count(), before.face_count());
}

// --- on any large mesh ---------------------------------------------------------------------------

class LargeMesh : public testing::TestWithParam<NamedShape> {
 protected:
  const Shape& before_ = GetParam().shape;
  const int target_ = (before_.face_count() + last_in_rounds) / 2;  // well within the rounds
};

TEST_P(LargeMesh, IsDecimatedInRounds) {
  EXPECT_FALSE(by(Scheduler::Rounds, before_, target_) == by(Scheduler::Lazy, before_, target_));
}

TEST_P(LargeMesh, KeepsItsTopology) {
  for (int target : {target_, before_.face_count() / 10}) expect_sound(before_, to_faces(target));
}

TEST_P(LargeMesh, MeetsATargetOfFacesExactlyOrOneBelow) {
  for (int target : {target_, target_ + 1, before_.face_count() - 2, before_.face_count() - 3}) {
    const auto [after, report] = decimated(before_, to_faces(target));
    EXPECT_LE(after.face_count(), target);
    EXPECT_GE(after.face_count(), target - 1);
    EXPECT_EQ(report.faces, after.face_count());
    EXPECT_EQ(report.vertices, after.vertex_count());
    EXPECT_EQ(report.stopped_by, StopReason::Target);
  }
}

TEST_P(LargeMesh, MeetsATargetOfVerticesExactly) {
  EdgeCollapseParams params;
  for (int vertices : {before_.vertex_count() - 1, target_ / 2 + 1}) {
    params.target_vertices = vertices;
    EXPECT_EQ(decimated(before_, params).shape.vertex_count(), vertices);
  }
}

TEST_P(LargeMesh, GivesTheSameBitsOnAnyNumberOfThreads) {
  for (CurvatureOf of : {CurvatureOf::Input, CurvatureOf::Current}) {
    EdgeCollapseParams params = to_faces(target_);
    params.curvature_of = of, params.threads = 1;
    const Shape expected = decimated(before_, params).shape;
    for (int threads : {2, 3, 8}) {
      params.threads = threads;
      EXPECT_EQ(decimated(before_, params).shape, expected) << threads << " threads";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, LargeMesh,
                         testing::Values(NamedShape{"noisy_sphere", noisy_sphere(5, 0.01)},
                                         NamedShape{"torus", torus(128, 64)},
                                         NamedShape{"plane_grid", plane_grid(72)},
                                         NamedShape{"saddle", saddle(72)},
                                         NamedShape{"open_cylinder", open_cylinder(96, 64)},
                                         NamedShape{"klein_bottle", klein_bottle(96, 56)},
                                         NamedShape{"three_pages", book(3, 44)}),
                         name_of);

TEST(Rounds, AreNotForASmallMesh) {
  for (const Shape& shape : {noisy_sphere(2, 0.01), saddle(20)}) {
    const int half = shape.face_count() / 2;
    EXPECT_EQ(by(Scheduler::Rounds, shape, half), by(Scheduler::Lazy, shape, half));
  }
}

TEST(Rounds, OfASingleCollapseDoTheCheapest) {
  const Shape shape = noisy_sphere(5, 0.01);
  const int target = shape.face_count() - 2;
  EXPECT_EQ(by(Scheduler::Rounds, shape, target), by(Scheduler::Lazy, shape, target));
}

// --- what must be as it was ----------------------------------------------------------------------

RichMesh& filled(RichMesh& mesh, const Shape& shape) {
  fill_with_attributes(mesh, shape);
  return mesh;
}

std::multiset<std::string> outside(const RichMesh& mesh) {
  std::multiset<std::string> faces;
  for (const RichFace& f : mesh.face)
    if (!f.IsD() && !f.IsS()) faces.insert(bytes_of(f));
  return faces;
}

TEST(Rounds, LeaveFacesOutsideTheSelectionAsTheyAre) {
  RichMesh mesh;
  filled(mesh, plane_grid(90));
  const int selected = select_faces(mesh, [](const vcg::Point3d& p) { return p[0] + p[1] < 1.0; });
  const int others = mesh.fn - selected;
  const auto before = outside(mesh);
  EdgeCollapseParams params = to_faces(selected / 2);
  params.selected_only = true;
  decimate(mesh, params);
  EXPECT_EQ(outside(mesh), before);
  EXPECT_LE(mesh.fn - others, selected / 2);
  EXPECT_GE(mesh.fn - others, selected / 2 - 1);
}

TEST(Rounds, CancelledInTheMiddleLeaveTheMeshAsItWas) {
  const Shape shape = scaled(translated(noisy_sphere(5, 0.01), {1.5, 1.5, 1.5}), 0.3);
  RichMesh mesh;
  const std::string before = bytes_of(filled(mesh, shape));
  int in_all = 0;
  RichMesh other;
  decimate(filled(other, shape), to_faces(last_in_rounds),
           [&](int, const char*) { return ++in_all > 0; });
  for (int last : {1, 2, in_all / 2, in_all - 1}) {
    int calls = 0, percent_at_last = 0;
    const DecimationReport report =
        decimate(mesh, to_faces(last_in_rounds), [&](int percent, const char*) {
          percent_at_last = percent;
          return ++calls < last;
        });
    EXPECT_EQ(report.stopped_by, StopReason::Cancelled);
    EXPECT_EQ(calls, last) << "went on after it was cancelled";
    EXPECT_EQ(bytes_of(mesh), before) << "cancelled at call " << last;
    EXPECT_EQ(percent_at_last > 0, last > 2);
  }
}

}  // namespace
}  // namespace curvdecim::test
