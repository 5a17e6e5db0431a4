#include "gallery/panels.hpp"

#include <gtest/gtest.h>

namespace carom::gallery
{

TEST(StatusLine, tells_times_counts_and_the_place_of_the_pointer)
{
    Gallery gallery("gravity", {}, 1);
    gallery.frames.add({.whole = 12.5});
    for (int i = 0; i < 60; ++i) gallery.session.advance(1 / 60.0);
    gallery.pointer_place = Vec2{1.25f, -3};
    const auto figures = status_figures(gallery);
    EXPECT_EQ(figures[0].text, "frame 12.5 ms");
    EXPECT_EQ(figures[1].text.substr(0, 5), "step ");
    EXPECT_NE(figures[1].text, "step 0.000 ms");
    EXPECT_EQ(figures[2].text, std::to_string(gallery.session.scene().world().body_count()) + " bodies");
    EXPECT_EQ(figures[3].text, std::to_string(gallery.session.meter().latest().contacts) + " contacts");
    EXPECT_GT(gallery.session.meter().latest().contacts, 10);
    EXPECT_EQ(figures[4].text, "x 1.25 m, y -3.00 m");
    gallery.pointer_place.reset();
    EXPECT_EQ(status_figures(gallery)[4].text.find("m,"), std::string::npos);
}

TEST(StatusLine, tells_one_thing_in_the_singular)
{
    Gallery gallery("gravity", {}, 1);
    World& world = gallery.session.scene().world();
    while (world.body_count() > 1) world.destroy_body(world.bodies().back());
    EXPECT_EQ(status_figures(gallery)[2].text, "1 body");
}

} // namespace carom::gallery
