#include "scenes/framing.hpp"

#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

bool is_in(const Aabb& inner, const Aabb& outer)
{
    return inner.min.x >= outer.min.x && inner.min.y >= outer.min.y && inner.max.x <= outer.max.x && inner.max.y <= outer.max.y;
}

/// How much of a picture's width or height a box takes, whichever is more.
float share(const Aabb& box, const Aabb& picture)
{
    const Vec2 size = box.max - box.min;
    const Vec2 whole = picture.max - picture.min;
    return std::max(size.x / whole.x, size.y / whole.y);
}

/// What can move and begins in the picture; what rains in from above, or waits along a course that the camera follows, does not.
std::optional<Aabb> seen_bounds(const World& world, const Aabb& picture)
{
    std::optional<Aabb> box;
    for (const BodyId id : world.bodies())
    {
        const BodyView body = world.body(id);
        if (body.type() == BodyType::Static || !is_in(body.bounds(), picture)) continue;
        box = box ? merge(*box, body.bounds()) : body.bounds();
    }
    return box;
}

} // namespace

TEST(Framing, shows_all_of_a_box_with_room_above_it)
{
    for (const Aabb& box : {Aabb{{-1, 0}, {1, 8}}, Aabb{{5, -2}, {45, 0}}, Aabb{{0, 0}, {16, 9}}})
    {
        const Camera camera = framed(box);
        const Aabb picture = visible_box(camera);
        EXPECT_TRUE(is_in(box, picture));
        EXPECT_GT(share(box, picture), 0.75f);
        EXPECT_GE(picture.max.y - box.max.y, 0.1f * camera.height) << "captions stand there";
        EXPECT_GE(camera.width, box.max.x - box.min.x);
    }
}

TEST(Framing, every_scene_fills_its_picture_with_what_moves)
{
    for (const SceneInfo& info : all_scenes())
    {
        SCOPED_TRACE(info.name);
        const std::unique_ptr<Scene> scene = make_scene(info.name);
        const Aabb picture = visible_box(scene->camera());
        const std::optional<Aabb> seen = seen_bounds(scene->world(), picture);
        ASSERT_TRUE(seen);
        const bool is_followed = info.name == "car"; // its course is longer than any picture
        EXPECT_GE(share(*seen, picture), is_followed ? 0.25f : 0.5f);
        const Aabb all = *movable_bounds(scene->world());
        if (is_followed) continue;
        EXPECT_GE(all.min.x, picture.min.x);
        EXPECT_LE(all.max.x, picture.max.x);
        EXPECT_GE(all.min.y, picture.min.y);
        const bool rains_in = info.name == "gravity" || info.name == "chain-terrain";
        EXPECT_TRUE(rains_in || all.max.y <= picture.max.y);
        EXPECT_TRUE(scene->camera().width >= all.max.x - all.min.x) << "a narrow picture shows it too";
    }
}

TEST(Framing, the_car_stays_in_the_picture)
{
    const std::unique_ptr<Scene> scene = make_scene("car");
    const BodyId first = dynamic_bodies(*scene).back();
    for (int i = 0; i < 20; ++i)
    {
        step(*scene, 30);
        EXPECT_TRUE(seen_bounds(scene->world(), visible_box(scene->camera()))) << scene->time() << " s";
    }
    EXPECT_TRUE(scene->world().find_body(first));
}

TEST(Framing, a_house_of_any_height_is_in_the_picture)
{
    for (const std::int64_t storeys : {1, 3, 5})
    {
        const std::unique_ptr<Scene> scene = make_scene("card-house", {{"storeys", storeys}});
        const Aabb picture = visible_box(scene->camera());
        EXPECT_TRUE(is_in(*movable_bounds(scene->world()), picture)) << storeys;
    }
}

} // namespace carom::scenes
