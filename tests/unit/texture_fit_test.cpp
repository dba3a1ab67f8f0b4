// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/refine/texture_fit.h"

#include <gtest/gtest.h>

#include "support/drawn_meshes.h"
#include "support/texture.h"
#include "support/working_mesh.h"
#include "vcg_ext/refine/edge_flips.h"

namespace curvdecim::test {

namespace {

const Parallel one_thread(1);
constexpr int center = 12;  // of a 4 x 4 grid

/// A flat input of 32 x 32 cells and a mesh of 4 x 4, with textures and matched samples.
class FlatTexture {
 public:
  template <class GiveTexture>
  explicit FlatTexture(GiveTexture give_texture)
      : FlatTexture(textured(4, give_texture), textured(32, give_texture)) {}

  FlatTexture(WorkingMesh coarse, const WorkingMesh& fine)
      : mesh(std::move(coarse)),
        input_(copy_input(fine, QuadricPlan(), one_thread)),
        area_(total_area(input_)),
        limits_(area_, faces()),
        input_tree_(input_, input_.face_count(), one_thread),
        mesh_tree_(mesh, faces(), one_thread),
        of_input_(input_, area_, faces(), one_thread),
        of_mesh_(input_, input_tree_, area_, faces()),
        near_(faces(), SurfacePoint::none) {
    of_input_.match(mesh_tree_, faces(), limits_, one_thread);
    of_mesh_.match(mesh, near_, limits_, one_thread);
  }

  void fit(int vertex) {
    std::vector<std::uint8_t> free(mesh.position.size(), 0);
    free[vertex] = 1;
    TextureFit(mesh, input_, free, one_thread).run(of_input_, of_mesh_);
  }

  int flip(double attribute_weight) {
    mesh.texture_scale2 = 1.0;
    const MoveGuard guard(mesh, input_, input_tree_, FaceLimits());
    const TextureDrift drift(mesh, input_, attribute_weight);
    return EdgeFlips(mesh, of_input_, of_mesh_, guard, drift, nullptr).run(near_, one_thread);
  }

  template <class GiveTexture>
  static WorkingMesh textured(int cells, GiveTexture give_texture) {
    WorkingMesh grid = working_mesh(plane_grid(cells));
    give_texture(grid);
    return grid;
  }

  WorkingMesh mesh;

 private:
  int faces() const { return mesh.connectivity.face_slots(); }

  InputSurface input_;
  const double area_;
  const MatchLimits limits_;
  TriangleTree<InputSurface> input_tree_;
  TriangleTree<WorkingMesh> mesh_tree_;
  InputSamples of_input_;
  MeshSamples of_mesh_;
  const std::vector<int> near_;
};

const auto one_chart = [](WorkingMesh& mesh) { give_plane_texture(mesh); };
const auto two_charts = [](WorkingMesh& mesh) { give_plane_texture(mesh, 0.5); };

TEST(TextureFit, BringsACoordinateBack) {
  FlatTexture flat(one_chart);
  flat.mesh.texture[center] += Vector2(0.1, -0.05);
  flat.fit(center);
  EXPECT_LT((flat.mesh.texture[center] - Vector2(0.5, 0.5)).norm(), 1e-6);
}

TEST(TextureFit, IsTheBestForTheWholeFaces) {
  const auto squares = [](WorkingMesh& mesh) {
    give_texture(mesh, [&](int f, int i) {
      const Vector3 p = mesh.triangle(f)[i];
      return Vector2(p.x() * p.x(), p.y());
    });
  };
  FlatTexture flat(squares);
  ASSERT_EQ(flat.mesh.texture[center].x(), 0.25);
  flat.fit(center);
  EXPECT_LT(flat.mesh.texture[center].x(), 0.25);  // a chord lies above a parabola
  const double chord_above = 0.25 * 0.25;          // more than it is at its middle
  EXPECT_GT(flat.mesh.texture[center].x(), 0.25 - chord_above);
}

TEST(TextureFit, LeavesOutlinesAndOthersThanAreFree) {
  FlatTexture flat(two_charts);
  for (int v : {0, 6, center}) {  // a corner, inside, on the seam
    const Vector2 wrong = flat.mesh.texture[v] += Vector2(0.01, 0.01);
    flat.fit(v == 6 ? 7 : v);
    EXPECT_EQ(flat.mesh.texture[v], wrong);
  }
}

/// The input's seam is at x = 0.4375, the mesh's, with vertex 7 on its left, at 0.5; beyond it u is
/// a little more.
TEST(TextureFit, HearsNothingFromBeyondASeam) {
  const auto cut_at = [](double cut) {
    return [=](WorkingMesh& mesh) {
      give_texture(mesh, [&](int f, int i) {
        const Triangle t = mesh.triangle(f);
        return Vector2(t[i].x() + (center_of(t).x() > cut ? 0.05 : 0.0), t[i].y());
      });
    };
  };
  WorkingMesh mesh = FlatTexture::textured(4, cut_at(0.5));
  const WorkingMesh input = FlatTexture::textured(32, cut_at(0.4375));
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f)  // of the same charts
    mesh.face_origin[f] = center_of(mesh.triangle(f)).x() < 0.5 ? 0 : input.face_origins - 1;
  FlatTexture flat(std::move(mesh), input);
  flat.fit(7);
  EXPECT_LT((flat.mesh.texture[7] - Vector2(0.25, 0.5)).norm(), 1e-6);
}

TEST(TextureFit, TurnsNoFaceOver) {
  FlatTexture flat([](WorkingMesh& mesh) {  // what lies in the middle is drawn on the right
    give_texture(mesh, [&](int f, int i) {
      const Vector3 p = mesh.triangle(f)[i];
      const bool is_inside = std::max(std::abs(p.x() - 0.5), std::abs(p.y() - 0.5)) < 0.24;
      return Vector2(p.x() + (is_inside ? 0.6 : 0.0), p.y());
    });
  });
  const Vector2 before = flat.mesh.texture[center] = Vector2(0.5, 0.5);
  flat.fit(center);
  EXPECT_EQ(flat.mesh.texture[center], before);
}

/// Over a plane no flip lowers the error of the surface. In the texture u is the distance from the
/// line x + y = 1, across which diagonals of cells run.
TEST(EdgeFlips, FollowTheTextureAsFarAsItCounts) {
  const auto folded = [](WorkingMesh& mesh) {
    give_texture(mesh, [&](int f, int i) {
      const Vector3 p = mesh.triangle(f)[i];
      return Vector2(std::abs(p.x() + p.y() - 1.0), p.y());
    });
  };
  EXPECT_EQ(FlatTexture(folded).flip(0.0), 0);
  EXPECT_GT(FlatTexture(folded).flip(1.0), 0);
}

}  // namespace
}  // namespace curvdecim::test
