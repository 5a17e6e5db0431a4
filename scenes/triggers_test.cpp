// The trigger scene: who is yellow, who stays in the field.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

const Color yellow = rgb(1.0f, 0.84f, 0.25f);

int yellow_shapes(const Scene& scene)
{
    DrawList list;
    scene.draw(list);
    int count = 0;
    for (const DrawnShape& shape : list.layer(Layer::Bodies).shapes) count += shape.paint.fill == with_alpha(yellow, 0.62f);
    return count;
}

int touching_shapes(const World& world)
{
    int count = 0;
    for (const BodyId body : world.bodies())
    {
        for (const ShapeId shape : world.body(body).shapes()) count += !world.shape(shape).touching().empty();
    }
    return count;
}

} // namespace

TEST(Triggers, shapes_are_yellow_while_they_overlap)
{
    const auto scene = make_scene("triggers");
    for (int i = 0; i < 300; ++i)
    {
        scene->step();
        if (i % 20 == 0)
        {
            EXPECT_EQ(yellow_shapes(*scene), touching_shapes(scene->world())) << "step " << i;
        }
    }
    EXPECT_GT(yellow_shapes(*scene), 0);
    EXPECT_LT(yellow_shapes(*scene), scene->world().shape_count());
}

TEST(Triggers, nothing_is_pushed)
{
    const auto scene = make_scene("triggers");
    for (int i = 0; i < 120; ++i) EXPECT_EQ(scene->step().rows, 0);
}

TEST(Triggers, shapes_stay_in_the_field)
{
    const auto scene = make_scene("triggers", {{"speed", 20}});
    const float half_height = scene->camera().height / 2.08f;
    for (int i = 0; i < 600; ++i)
    {
        scene->step();
        for (const BodyId id : scene->world().bodies())
        {
            const Vec2 place = scene->world().body(id).position();
            ASSERT_LT(std::abs(place.y), half_height + 0.5f);
            ASSERT_LT(std::abs(place.x), half_height * 16 / 9 + 0.5f);
        }
    }
}

TEST(Triggers, the_pointer_carries_a_shape)
{
    const auto scene = make_scene("triggers", {{"circles", 0}, {"boxes", 0}, {"polygons", 0}});
    scene->pointer({PointerEvent::Action::Move, PointerEvent::Button::None, {3, 2}});
    scene->step();
    EXPECT_EQ(scene->world().body(scene->world().bodies().front()).position(), (Vec2{3, 2}));
    EXPECT_EQ(yellow_shapes(*scene), 0);

    click(*scene, {3, 2});
    scene->step();
    EXPECT_EQ(yellow_shapes(*scene), 2);

    scene->pointer({PointerEvent::Action::Move, PointerEvent::Button::None, {-8, -4}});
    scene->step();
    EXPECT_EQ(yellow_shapes(*scene), 0);
}

TEST(Triggers, the_squares_of_the_quadtree_are_shown_at_first)
{
    const auto scene = make_scene("triggers");
    scene->step();
    EXPECT_EQ(scene->world().broad_phase(), BroadPhaseType::Quadtree);
    const auto squares = [&]
    {
        DrawList list;
        scene->draw(list);
        return list.layer(Layer::Background).shapes.size();
    };
    EXPECT_GT(squares(), 10u);
    scene->key("q");
    EXPECT_EQ(squares(), 1u); // the field's own border
}

} // namespace carom::scenes
