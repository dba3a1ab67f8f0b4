// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/run/validation.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <set>

namespace curvdecim::test {

using namespace detail;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The refusal of what is checked; without words where it was accepted.
InputError refusal(const std::function<void()>& check) {
  try {
    check();
    return InputError("");
  } catch (const InputError& error) {
    return error;
  }
}

std::string refused(const std::function<void()>& check) { return refusal(check).what(); }

TEST(Range, TakesBothEndsAndWhatLiesBetween) {
  for (double value : {0.0, 0.5, 1.0}) EXPECT_TRUE(between(0.0, 1.0).contains(value)) << value;
  for (double value : {0.0, 1e-300, 1e308}) EXPECT_TRUE(at_least(0.0).contains(value)) << value;
}

TEST(Range, RefusesWhatLiesOutsideAndWhatIsNoNumber) {
  for (double value : {-1e-300, 1.0 + 1e-15, nan, infinity, -infinity})
    EXPECT_FALSE(between(0.0, 1.0).contains(value)) << value;
  for (double value : {-1.0, nan, infinity, -infinity})
    EXPECT_FALSE(at_least(0.0).contains(value)) << value;
  EXPECT_FALSE(above_up_to(0.0, 180.0).contains(0.0));
}

TEST(Range, IsDescribedWithItsUnit) {
  EXPECT_EQ(describe(between(0.0, 1.0)), "at least 0 and at most 1");
  EXPECT_EQ(describe(above_up_to(0.0, 180.0, "degrees")), "above 0 and at most 180 degrees");
  EXPECT_EQ(describe(Range()), "");
}

TEST(Validate, NamesTheFieldTheValueAndTheRange) {
  EdgeCollapseParams params;
  params.normal_angle = 0.0;
  const InputError error = refusal([&] { validate(params); });
  EXPECT_STREQ(error.what(),
               "normal_angle is 0; it must be above 0 and at most 180 degrees. The mesh was not "
               "changed.");
  EXPECT_EQ(error.fields, std::vector<std::string>{"normal_angle"});
}

TEST(Validate, RefusesAnEnumThatIsNoneOfItsConstants) {
  EdgeCollapseParams params;
  params.quadrics = static_cast<Quadrics>(2);
  EXPECT_EQ(refused([&] { validate(params); }),
            "quadrics is 2; it must be one of Memoryless, Accumulated. The mesh was not changed.");
  params.quadrics = static_cast<Quadrics>(-1);
  EXPECT_NE(refused([&] { validate(params); }), "");
}

TEST(Validate, TakesTheDefaults) {
  EXPECT_NO_THROW(validate(EdgeCollapseParams()));
  EXPECT_NO_THROW(validate(SphereParams()));
  EXPECT_NO_THROW(validate(VertexRemovalParams()));
  EXPECT_NO_THROW(validate(ClusteringParams()));
  EXPECT_NO_THROW(validate(ImportanceParams()));
}

TEST(Validate, OfAlphaRefusesOnlyWhatIsNotFinite) {
  CurvatureParams params;
  for (double alpha : {-1e300, -1.0, 0.0, 1e300}) {
    params.alpha = alpha;
    EXPECT_NO_THROW(validate(params)) << alpha;
  }
  for (double alpha : {nan, infinity, -infinity}) {
    params.alpha = alpha;
    EXPECT_NE(refused([&] { validate(params); }).find("alpha"), std::string::npos);
  }
}

TEST(Validate, LooksAtTheFieldsOfEveryBase) {
  EdgeCollapseParams common, shared, curvature, own;
  common.threads = -1, shared.max_error = -1.0, curvature.curvature_floor = 2.0, own.lambda = -1.0;
  EXPECT_EQ(refusal([&] { validate(common); }).fields, std::vector<std::string>{"threads"});
  EXPECT_EQ(refusal([&] { validate(shared); }).fields, std::vector<std::string>{"max_error"});
  EXPECT_EQ(refusal([&] { validate(curvature); }).fields,
            std::vector<std::string>{"curvature_floor"});
  EXPECT_EQ(refusal([&] { validate(own); }).fields, std::vector<std::string>{"lambda"});
}

TEST(Validate, RefusesPairsWithABoundAndTakesEitherAlone) {
  EdgeCollapseParams params;
  params.pair_distance = 0.1;
  EXPECT_NO_THROW(validate(params));
  params.max_error = 0.1;
  EXPECT_NE(refused([&] { validate(params); }).find("pair_distance and max_error"),
            std::string::npos);
  params.pair_distance = 0.0;
  EXPECT_NO_THROW(validate(params));
}

TEST(RequireTarget, TakesAnyOneAndRefusesNone) {
  EXPECT_NE(refused([] { require_target(EdgeCollapseParams()); }), "");
  EXPECT_NE(refused([] { require_target(ClusteringParams()); }), "");
  EdgeCollapseParams faces;
  faces.target_faces = 0;
  EXPECT_NO_THROW(require_target(faces));
  VertexRemovalParams bound;
  EXPECT_NE(refused([&] { require_target(bound); }), "");
  bound.distance_bound = 0.1;
  EXPECT_NO_THROW(require_target(bound));
}

/// The names of a struct's fields; each must come once.
template <class Params>
std::set<std::string> names_of() {
  std::set<std::string> names;
  for_each_field<Params>(
      [&](const auto& field) { EXPECT_TRUE(names.insert(field.name).second) << field.name; });
  return names;
}

TEST(Fields, HaveEveryNameOnce) {
  EXPECT_EQ(names_of<CommonParams>().size(), 6u);
  EXPECT_EQ(names_of<EdgeCollapseParams>().count("pair_distance"), 1u);
  EXPECT_EQ(names_of<SphereParams>().count("kernel_scale"), 1u);
  EXPECT_EQ(names_of<VertexRemovalParams>().count("criterion"), 1u);
  EXPECT_EQ(names_of<ClusteringParams>().count("cell_size"), 1u);
  EXPECT_EQ(names_of<ImportanceParams>().count("output"), 1u);
}

}  // namespace
}  // namespace curvdecim::test
