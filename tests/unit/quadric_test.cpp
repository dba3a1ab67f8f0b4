// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/geometry/quadric.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace curvdecim::test {

using namespace detail;

namespace {

class Random {
 public:
  double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(engine_); }
  Vector3 vector() { return {number(), number(), number()}; }

 private:
  std::mt19937 engine_{5};
};

Eigen::Matrix3d dense(const Symmetric3& m) {
  return (Eigen::Matrix3d() << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz).finished();
}

TEST(Symmetric3, OuterProductIsWeighted) {
  const Vector3 n(1, 2, 3);
  EXPECT_EQ(dense(Symmetric3::outer(n, 2.0)), 2.0 * n * n.transpose());
}

TEST(Symmetric3, MultipliesAddsAndTracesLikeAMatrix) {
  Random random;
  const Symmetric3 a =
      Symmetric3::outer(random.vector(), 1.0) + Symmetric3::outer(random.vector(), 3.0);
  const Vector3 v = random.vector();
  EXPECT_LT((a * v - dense(a) * v).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(a.trace(), dense(a).trace());
  EXPECT_EQ(dense(a.plus_diagonal(2.0)), dense(a) + 2.0 * Eigen::Matrix3d::Identity());
}

TEST(Factorization3, SolvesAPositiveDefiniteSystem) {
  Random random;
  for (int round = 0; round < 100; ++round) {
    Symmetric3 a;
    for (int i = 0; i < 3; ++i) a += Symmetric3::outer(random.vector(), 1.0);
    a = a.plus_diagonal(1e-3 * a.trace());
    const Vector3 x = random.vector();
    EXPECT_LT((Factorization3(a).solve(a * x) - x).norm(), 1e-11);
  }
}

TEST(Quadric, OfAPlaneIsTheSquaredDistance) {
  const Quadric q = Quadric::plane(Vector3(0, 0, 1), 2.0, 3.0);
  EXPECT_EQ(q.value(Vector3(7, 8, 2)), 0.0);
  EXPECT_EQ(q.value(Vector3(7, 8, 4)), 3.0 * 4.0);
  EXPECT_EQ(q.value(Vector3(0, 0, 0)), 3.0 * 4.0);
}

TEST(Quadric, IsAdditive) {
  Random random;
  const Quadric p = Quadric::plane(random.vector().normalized(), 0.3, 2.0);
  const Quadric q = Quadric::plane(random.vector().normalized(), -0.7, 5.0);
  const Vector3 x = random.vector();
  EXPECT_NEAR((p + q).value(x), p.value(x) + q.value(x), 1e-14);
}

TEST(Quadric, IsTheSameFunctionFromAnotherOrigin) {
  Random random;
  for (int round = 0; round < 100; ++round) {
    const Quadric q = Quadric::plane(random.vector().normalized(), random.number(), 2.0) +
                      Quadric::plane(random.vector().normalized(), random.number(), 1.0);
    const Vector3 step = random.vector(), x = random.vector();
    EXPECT_NEAR(q.with_origin_moved(step).value(x - step), q.value(x), 1e-13);
  }
}

}  // namespace
}  // namespace curvdecim::test
