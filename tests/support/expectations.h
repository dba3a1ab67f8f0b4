// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/drawn_meshes.h"
#include "support/fingerprint.h"
#include "support/rich_mesh.h"
#include "vcg_ext/errors.h"
#include "vcg_ext/report.h"

// What must hold whichever filter ran: of meshes made by fill_with_attributes.
namespace curvdecim::test {

inline Shape unit_ball(int subdivisions) {
  return translated(scaled(icosphere(subdivisions), 0.5), {0.5, 0.5, 0.5});
}

inline bool is_left(const vcg::Point3d& p) { return p[0] < 0.5; }

inline std::multiset<std::string> unselected_faces(const RichMesh& mesh) {
  std::multiset<std::string> faces;
  for (const RichFace& f : mesh.face)
    if (!f.IsD() && !f.IsS()) faces.insert(bytes_of(f));
  return faces;
}

inline bool is_said(const DecimationReport& report, const std::string& words) {
  return std::any_of(report.notes.begin(), report.notes.end(), [&](const std::string& note) {
    return note.find(words) != std::string::npos;
  });
}

/// Expects that run() throws an InputError whose message has all these words, and the mesh bit for
/// bit as it was.
template <class Run>
void expect_refusal(const RichMesh& mesh, Run run, const std::vector<std::string>& words) {
  const std::string before = bytes_of(mesh);
  try {
    run();
    ADD_FAILURE() << "was accepted";
  } catch (const InputError& error) {
    const std::string message = error.what();
    for (const std::string& word : words)
      EXPECT_NE(message.find(word), std::string::npos) << message;
    EXPECT_EQ(message.back(), '.') << message;
  }
  EXPECT_EQ(bytes_of(mesh), before);
}

inline void expect_affine_attributes(const RichMesh& mesh) {
  constexpr double percent = 0.01;
  for (const RichVertex& v : mesh.vert) {
    EXPECT_NEAR(v.cQ(), affine(v.cP()), percent);
    EXPECT_NEAR(v.cR(), affine(v.cP()), percent);
    EXPECT_NEAR(v.cT().u(), v.cP()[0], 1.0 / 1024);
    EXPECT_NEAR(v.cT().v(), v.cP()[1], 1.0 / 1024);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(v.cC()[k], affine_color(v.cP())[k], 255 * percent);
  }
}

inline void expect_affine_wedges(const RichMesh& mesh) {
  for (const RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(f.cWT(i).u(), f.cP(i)[0], 1.0 / 1024);
      EXPECT_NEAR(f.cWT(i).v(), f.cP(i)[1], 1.0 / 1024);
    }
}

/// The right half gets a chart of its own, on a page of its own.
inline void put_right_half_on_a_page(RichMesh& mesh) {
  for (RichFace& f : mesh.face) {
    const bool right = (f.cP(0)[0] + f.cP(1)[0] + f.cP(2)[0]) / 3.0 > 0.5;
    for (int i = 0; i < 3 && right; ++i) f.WT(i).u() += 10.0, f.WT(i).n() = 1;
  }
}

/// After put_right_half_on_a_page: both charts are there, no face has both, and it was said.
inline void expect_two_charts(const RichMesh& mesh, const DecimationReport& report) {
  int right = 0;
  for (const RichFace& f : mesh.face) {
    right += f.cWT(0).n() == 1;
    for (int i = 0; i < 3; ++i) {
      const double u = f.cWT(i).u() - (f.cWT(0).n() == 1 ? 10.0 : 0.0);
      EXPECT_EQ(f.cWT(i).n(), f.cWT(0).n());
      EXPECT_GE(u, f.cWT(0).n() == 1 ? 0.5 : 0.0);
      EXPECT_LE(u, f.cWT(0).n() == 1 ? 1.0 : 0.5);
    }
  }
  EXPECT_GT(right, 10);
  EXPECT_LT(right, mesh.fn - 10);
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes[0].find("seams"), std::string::npos) << report.notes[0];
}

/// One chart: at a vertex all faces have the same coordinates, to the bit.
inline void expect_no_tear(const RichMesh& mesh) {
  std::map<const RichVertex*, std::pair<double, double>> seen;
  for (const RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i) {
      const std::pair<double, double> uv(f.cWT(i).u(), f.cWT(i).v());
      EXPECT_EQ(seen.try_emplace(f.cV(i), uv).first->second, uv);
    }
}

/// Every face has the quality and the colour of one face of the input, and no two of the same.
inline void expect_faces_of_the_input(const RichMesh& mesh) {
  std::set<double> seen;
  for (const RichFace& f : mesh.face) {
    const int was = static_cast<int>(f.cQ());
    EXPECT_EQ(f.cC(), vcg::Color4b(static_cast<unsigned char>(was % 256),
                                   static_cast<unsigned char>(was / 256), 1, 255));
    EXPECT_TRUE(seen.insert(f.cQ()).second);
  }
}

inline void expect_face_normals_that_fit(const RichMesh& mesh) {
  for (const RichFace& f : mesh.face) {
    const vcg::Point3d normal = ((f.cP(1) - f.cP(0)) ^ (f.cP(2) - f.cP(0))).Normalize();
    ASSERT_LT((f.cN() - normal).Norm(), 1e-9);
  }
}

inline void expect_box_that_fits(const RichMesh& mesh) {
  vcg::Box3d box;
  for (const RichVertex& v : mesh.vert) box.Add(v.cP());
  EXPECT_EQ(mesh.bbox.min, box.min);
  EXPECT_EQ(mesh.bbox.max, box.max);
}

inline void build_adjacency(RichMesh& mesh) {
  vcg::tri::UpdateTopology<RichMesh>::VertexFace(mesh);
  vcg::tri::UpdateTopology<RichMesh>::FaceFace(mesh);
}

inline void expect_no_adjacency(const RichMesh& mesh) {
  for (const RichVertex& v : mesh.vert) EXPECT_TRUE(v.cVFp() == nullptr);
  for (const RichFace& f : mesh.face)
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(f.cFFp(i) == nullptr);
}

/// run(mesh, progress) is cancelled at each of its calls in turn: it ends there, says so, and
/// leaves the mesh as it was, to the bit.
template <class Run>
void expect_cancel_leaves(const Shape& shape, Run run) {
  int calls = 0;
  RichMesh counted;
  fill_with_attributes(counted, shape);
  run(counted, [&](int, const char*) { return ++calls > 0; });
  ASSERT_GT(calls, 2);
  for (int last = 1; last <= calls; ++last) {
    RichMesh mesh;
    fill_with_attributes(mesh, shape);
    const std::string before = bytes_of(mesh);
    int call = 0;
    const auto report = run(mesh, [&](int, const char*) { return ++call < last; });
    EXPECT_EQ(report.stopped_by, StopReason::Cancelled);
    EXPECT_EQ(report.faces, report.faces_before);
    EXPECT_EQ(report.max_error, 0.0);
    EXPECT_TRUE(bytes_of(mesh) == before) << "cancelled at call " << last;
    EXPECT_EQ(call, last) << "went on after it was cancelled";
  }
}

}  // namespace curvdecim::test
