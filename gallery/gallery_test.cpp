#include "gallery/gallery.hpp"

#include <gtest/gtest.h>

namespace carom::gallery
{

namespace
{

constexpr scenes::Viewport window = {1280, 720};
constexpr Rect whole = {{0, 0}, {1280, 720}};

/// A gallery whose camera was moved away.
struct Moved
{
    Moved()
    {
        gallery.look(window, whole);
        gallery.view.zoom_at({100, 100}, 20);
        gallery.view.pan({5000, 300});
        gallery.look(window, whole);
    }

    Gallery gallery{"planets", {}, 1};
};

} // namespace

TEST(Gallery, keeps_the_camera_in_a_restart_and_takes_the_scenes_own_in_another)
{
    Moved moved;
    Gallery& gallery = moved.gallery;
    gallery.session.restart();
    gallery.look(window, whole);
    EXPECT_GT(gallery.view.zoom(), 19);
    gallery.session.open_neighbor(1);
    gallery.look(window, whole);
    EXPECT_EQ(gallery.view.zoom(), 1);
    const scenes::Camera seen = gallery.view.camera();
    EXPECT_NEAR(distance(seen.center, gallery.session.scene().camera().center), 0, 1e-3f);
}

TEST(Gallery, does_not_stay_where_a_body_was_whose_world_is_gone)
{
    Moved moved;
    Gallery& gallery = moved.gallery;
    World& world = gallery.session.scene().world();
    const BodyId body = world.bodies().back();
    world.body(body).set_transform({7000, 7000}, 0);
    gallery.hand.select(body);
    gallery.toggle_follow();
    gallery.look(window, whole);
    EXPECT_NEAR(gallery.view.camera().center.x, 7000, 1);
    gallery.session.restart();
    gallery.look(window, whole);
    EXPECT_NEAR(distance(gallery.view.camera().center, gallery.session.scene().camera().center), 0, 1e-3f);
    EXPECT_EQ(gallery.view.zoom(), 1);
}

TEST(Gallery, follows_no_body_that_was_destroyed)
{
    Moved moved;
    Gallery& gallery = moved.gallery;
    const BodyId body = gallery.session.scene().world().bodies().back();
    gallery.hand.select(body);
    gallery.toggle_follow();
    gallery.look(window, whole);
    const Vec2 center = gallery.view.camera().center;
    gallery.session.scene().world().destroy_body(body);
    gallery.look(window, whole);
    EXPECT_FALSE(gallery.session.watched());
    EXPECT_NEAR(distance(gallery.view.camera().center, center), 0, 1e-3f) << "the picture stays";
}

} // namespace carom::gallery
