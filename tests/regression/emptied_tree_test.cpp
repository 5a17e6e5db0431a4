// A tree that lost its last box still held marks on nodes that were gone, and read them. Seen where the library checks indices.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace carom
{

TEST(Regression, a_world_goes_on_without_the_ground_it_had)
{
    World world({.gravity = {}});
    const auto place = [](int i) { return Vec2{static_cast<float>(i), 0}; };
    const BodyDef ground = {.type = BodyType::Static};
    std::vector<BodyId> tiles;
    for (int i = 0; i < 50; ++i) tiles.push_back(world.create_body({.type = BodyType::Static, .position = place(i)}, box(1, 1)));
    world.create_body({.position = {0, 0.9f}, .linear_velocity = {30, 0}}, circle(0.45f), {.material = {.friction = 0}});
    EXPECT_EQ(world.step(1 / 60.0f).contacts, 1);
    for (const BodyId tile : tiles) world.destroy_body(tile);
    EXPECT_EQ(world.step(1 / 60.0f).pairs, 0);
    world.create_body(ground, box(100, 1));
    EXPECT_EQ(world.step(1 / 60.0f).contacts, 1);
}

} // namespace carom
