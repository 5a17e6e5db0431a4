// Arguments that lie inside the world that the call changes: a view's reference handed back to the world it came from.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <string>

namespace carom
{

TEST(Regression, a_new_shape_may_copy_the_geometry_of_another_by_reference)
{
    World world;
    const BodyId first = world.create_body({}, box(2, 4));
    const ShapeId original = world.body(first).shapes()[0];
    for (int i = 0; i < 200; ++i) // often enough for the store to grow several times
    {
        const BodyId body = world.create_body({}, world.shape(original).geometry());
        EXPECT_EQ(world.body(body).mass_data().mass, world.body(first).mass_data().mass);
        const ShapeId second = world.create_shape(body, world.shape(original).geometry());
        ASSERT_EQ(world.shape(second).bounds(), world.shape(original).bounds());
        ASSERT_FLOAT_EQ(world.body(body).mass_data().mass, 2 * world.body(first).mass_data().mass);
    }
}

TEST(Regression, a_new_body_may_take_the_name_of_another_by_view)
{
    World world;
    const BodyId first = world.create_body({.name = "short"}); // short names lie within the record, which moves
    for (int i = 0; i < 200; ++i)
    {
        const BodyId body = world.create_body({.name = world.body(first).name()});
        ASSERT_EQ(world.body(body).name(), "short");
    }
}

TEST(Regression, a_body_may_be_renamed_to_a_part_of_its_own_name)
{
    World world;
    Body body = world.body(world.create_body({.name = "a name that is too long for a short string"}));
    body.set_name(body.name().substr(2, 4));
    EXPECT_EQ(body.name(), "name");
}

} // namespace carom
