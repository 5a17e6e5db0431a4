// The rough test must let through all that the exact one finds.
#include "geometry/random_shapes.hpp"
#include "solver/continuous/stays_apart.hpp"
#include "solver/continuous/swept_path.hpp"

#include <carom/shape.hpp>

#include <gtest/gtest.h>

namespace carom::detail
{

namespace
{

Sweep random_sweep(RandomShapes& random)
{
    Sweep sweep;
    sweep.local_center = random.point(0.5f);
    sweep.center_start = random.point(3);
    sweep.center_end = sweep.center_start + random.point(8);
    sweep.q_start = rotation(random.uniform(-pi, pi));
    sweep.turn = random.uniform(-pi, pi);
    return sweep;
}

} // namespace

TEST(SweptPath, LetsThroughWhateverMeetsAndHoldsBackMostThatDoesNot)
{
    RandomShapes random(7);
    int met = 0;
    int missed = 0;
    int held_back = 0;
    for (int i = 0; i < 8000; ++i)
    {
        const Geometry a = random.geometry_of(i % 4, 0.5f);
        const Geometry b = random.geometry_of(i / 4 % 4, 0.5f);
        const Sweep way_a = random_sweep(random);
        const Sweep way_b = random_sweep(random);
        const bool meets = time_of_impact(convex_points(a), way_a, convex_points(b), way_b, Tolerances{}.impact_distance).has_value();
        const bool passes = may_pass_through(path_of(extent_of(a), way_a), path_of(extent_of(b), way_b), 0, 0, Tolerances{}.linear_slop);
        EXPECT_TRUE(passes || !meets) << i;
        // So it is for what is left of A without its outermost part.
        const float depth = 0.25f * inner_radius(a);
        const bool core_meets = time_of_impact(core_of(a, depth), way_a, convex_points(b), way_b, Tolerances{}.impact_distance).has_value();
        EXPECT_TRUE(may_pass_through(path_of(extent_of(a), way_a), path_of(extent_of(b), way_b), 0, depth, Tolerances{}.linear_slop) ||
                    !core_meets)
            << i;
        met += meets;
        missed += !meets;
        held_back += !passes;
    }
    EXPECT_GT(met, 500);
    EXPECT_GT(2 * held_back, missed);
}

TEST(SweptPath, HoldsBackWhatMovesTogether)
{
    const Geometry disc = Circle{{}, 0.5f};
    const Sweep a = {.local_center = {}, .center_start = {0, 0}, .center_end = {10, 0}, .q_start = {}, .turn = 0};
    const Sweep b = {.local_center = {}, .center_start = {1.01f, 0}, .center_end = {10.9f, 0}, .q_start = {}, .turn = 0};
    EXPECT_FALSE(may_pass_through(path_of(extent_of(disc), a), path_of(extent_of(disc), b), 0.25f, 0, Tolerances{}.linear_slop));
    EXPECT_TRUE(may_pass_through(path_of(extent_of(disc), a), path_of(extent_of(disc), b), 0.1f, 0, Tolerances{}.linear_slop));
}

TEST(StaysApart, holds_back_nothing_that_meets_and_most_that_slides_along)
{
    RandomShapes random(11);
    int missed = 0;
    int held_back = 0;
    for (int i = 0; i < 20000; ++i)
    {
        const ConvexPoints a = core_of(random.geometry_of(i % 4, 0.5f), 0.05f);
        const ConvexPoints b = convex_points(random.geometry_of(i / 4 % 4, 0.5f));
        Sweep way_a = random_sweep(random);
        Sweep way_b = random_sweep(random);
        if (i % 3 == 0) way_a.turn *= 0.02f, way_b.turn *= 0.02f, way_a.center_end = way_a.center_start + random.point(0.5f);
        const bool is_apart = stays_apart(a, way_a, b, way_b, Tolerances{}.impact_distance + Tolerances{}.linear_slop);
        const bool meets = time_of_impact(a, way_a, b, way_b, Tolerances{}.impact_distance).has_value();
        EXPECT_FALSE(is_apart && meets) << i;
        missed += !meets;
        held_back += is_apart;
    }
    EXPECT_GT(2 * held_back, missed);

    // A box that rolls off another: none of its turns is too large to be told from one that goes in.
    const ConvexPoints core_of_roller = core_of(box(1, 1), 0.1f);
    const Sweep rolls = {.local_center = {}, .center_start = {0, 1}, .center_end = {0, 1.2f}, .q_start = {}, .turn = 0.5f};
    const Sweep tips = {.local_center = {}, .center_start = {0, 1}, .center_end = {0, 1}, .q_start = {}, .turn = 0.5f};
    const Sweep lies = {.local_center = {}, .center_start = {}, .center_end = {}, .q_start = {}, .turn = 0};
    EXPECT_TRUE(stays_apart(core_of_roller, rolls, convex_points(box(1, 1)), lies, 0.01f));
    EXPECT_FALSE(stays_apart(core_of_roller, tips, convex_points(box(1, 1)), lies, 0.01f));

    // A box that slides along a floor, however far it goes.
    const ConvexPoints core = core_of(box(1, 1), 0.1f);
    const ConvexPoints floor = convex_points(box(100, 1));
    const Sweep slide = {.local_center = {}, .center_start = {0, 1}, .center_end = {20, 0.99f}, .q_start = {}, .turn = 0.01f};
    const Sweep still = {.local_center = {}, .center_start = {}, .center_end = {}, .q_start = {}, .turn = 0};
    EXPECT_TRUE(stays_apart(core, slide, floor, still, 0.01f));
    const Sweep fall = {.local_center = {}, .center_start = {0, 1}, .center_end = {20, 0.8f}, .q_start = {}, .turn = 0};
    EXPECT_FALSE(stays_apart(core, fall, floor, still, 0.01f));
}

TEST(StaysApart, a_core_whose_faces_have_crossed_is_not_taken_for_apart)
{
    RandomShapes random(17);
    int missed = 0;
    int held_back = 0;
    for (int i = 0; i < 20000; ++i)
    {
        const Geometry geometry = random.geometry_of(3, 0.5f);
        const ConvexPoints a = core_of(geometry, 0.95f * inner_radius(geometry));
        const ConvexPoints b = convex_points(random.geometry_of(i % 4, 0.5f));
        Sweep way_a = random_sweep(random);
        Sweep way_b = random_sweep(random);
        way_a.center_start = random.point(1), way_b.center_start = random.point(1);
        way_a.center_end = way_a.center_start + random.point(0.3f), way_b.center_end = way_b.center_start + random.point(0.3f);
        way_a.turn *= 0.1f, way_b.turn *= 0.1f;
        const bool is_apart = stays_apart(a, way_a, b, way_b, Tolerances{}.impact_distance + Tolerances{}.linear_slop);
        const bool meets = time_of_impact(a, way_a, b, way_b, Tolerances{}.impact_distance).has_value();
        EXPECT_FALSE(is_apart && meets) << i;
        missed += !meets;
        held_back += is_apart;
    }
    EXPECT_GT(2 * held_back, missed);
}

TEST(StaysApart, a_disc_that_stays_beyond_a_face_does_not_meet_the_polygon)
{
    RandomShapes random(13);
    int missed = 0;
    int beyond = 0;
    for (int i = 0; i < 8000; ++i)
    {
        const Geometry geometry = random.geometry_of(3, 0.5f);
        const auto* polygon = std::get_if<Polygon>(&geometry);
        ASSERT_TRUE(polygon);
        const Transform place = {random.point(3), rotation(random.uniform(-pi, pi))};
        const Sweep still = {.local_center = {}, .center_start = place.p, .center_end = place.p, .q_start = place.q, .turn = 0};
        Sweep way = random_sweep(random);
        way.local_center = {};
        const float radius = 0.3f;
        const float least = radius + polygon->radius + distance_apart(Tolerances{});
        const bool is_beyond = stays_beyond_a_face(*polygon, place, way.center_start, way.center_end, least);
        const Geometry disc = circle(radius);
        const bool meets =
            time_of_impact(convex_points(disc), way, convex_points(geometry), still, Tolerances{}.impact_distance).has_value();
        EXPECT_FALSE(is_beyond && meets) << i;
        missed += !meets;
        beyond += is_beyond;
    }
    EXPECT_GT(2 * beyond, missed);
}

} // namespace carom::detail
