#include "gallery/blend.hpp"

#include <gtest/gtest.h>

namespace carom::gallery
{

using scenes::DrawList;
using scenes::Layer;

namespace
{

DrawList disc_at(Vec2 p)
{
    DrawList list;
    list.disc(Layer::Bodies, p, 1, {.fill = scenes::paper});
    return list;
}

/// A picture between two.
DrawList blended(const DrawList& before, DrawList after, float t)
{
    Places places;
    places.note(before);
    blend(places, t, 5, after);
    return after;
}

Vec2 place_of(const DrawList& list) { return list.layer(Layer::Bodies).shapes.front().transform.p; }

} // namespace

TEST(Blend, shows_things_between_their_places)
{
    EXPECT_EQ(place_of(blended(disc_at({0, 0}), disc_at({1, 2}), 0.25f)), (Vec2{0.25f, 0.5f}));
    EXPECT_EQ(place_of(blended(disc_at({0, 0}), disc_at({1, 2}), 1)), (Vec2{1, 2}));
}

TEST(Blend, does_not_draw_a_jump_as_a_flight) { EXPECT_EQ(place_of(blended(disc_at({0, 0}), disc_at({10, 0}), 0.5f)), (Vec2{10, 0})); }

TEST(Blend, shows_the_later_picture_when_something_came_or_became_another)
{
    DrawList two = disc_at({1, 0});
    two.disc(Layer::Bodies, {2, 0}, 1, {});
    EXPECT_EQ(place_of(blended(disc_at({0, 0}), two, 0.5f)), (Vec2{1, 0}));

    DrawList box;
    box.shape(Layer::Bodies, carom::box(1, 1), {.p = {1, 0}, .q = {}}, {});
    EXPECT_EQ(place_of(blended(disc_at({0, 0}), box, 0.5f)), (Vec2{1, 0}));
}

TEST(Blend, turns_the_short_way)
{
    const auto at = [](float angle) { return Transform{{}, rotation(angle)}; };
    EXPECT_NEAR(between(at(-3), at(3), 0.5f).q.c, -1, 1e-5f);
    const Rot half = between(at(0.2f), at(0.8f), 0.5f).q;
    EXPECT_NEAR(half.s, rotation(0.5f).s, 1e-5f);
    EXPECT_NEAR(half.c * half.c + half.s * half.s, 1, 1e-6f);
}

} // namespace carom::gallery
