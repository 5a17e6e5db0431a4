#include "gallery/keys.hpp"

#include "scenes/registry.hpp"

#include <gtest/gtest.h>

namespace carom::gallery
{

TEST(Keys, of_the_gallery_are_not_those_of_any_scene)
{
    for (const scenes::SceneInfo& info : scenes::all_scenes())
        for (const scenes::Control& control : info.controls)
            for (const KeyAction& action : key_actions())
                EXPECT_FALSE(control.kind == scenes::Control::Kind::Key && !action.needs_ctrl && scene_key(action.key) == control.input)
                    << info.name << " uses " << control.input;
}

TEST(Keys, every_key_of_a_scene_is_on_the_keyboard)
{
    std::vector<std::string> reachable = {"up", "down", "left", "right", "space"};
    for (const SDL_Keycode key : {SDLK_UP, SDLK_DOWN, SDLK_LEFT, SDLK_RIGHT, SDLK_SPACE})
        EXPECT_NE(std::find(reachable.begin(), reachable.end(), scene_key(key)), reachable.end());
    for (const scenes::SceneInfo& info : scenes::all_scenes())
    {
        for (const scenes::Control& control : info.controls)
        {
            if (control.kind != scenes::Control::Kind::Key) continue;
            const bool is_plain = control.input.size() == 1 && scene_key(control.input[0]) == control.input;
            EXPECT_TRUE(is_plain || std::find(reachable.begin(), reachable.end(), control.input) != reachable.end()) << control.input;
        }
    }
}

TEST(Keys, pause_step_restart_and_change_the_scene)
{
    Gallery gallery("planets", {}, 1);
    press_key(gallery, SDLK_p, false, false);
    EXPECT_TRUE(gallery.session.clock().is_paused());
    press_key(gallery, SDLK_p, false, true);
    EXPECT_TRUE(gallery.session.clock().is_paused()) << "a key that is held does not switch again";
    press_key(gallery, SDLK_o, false, false);
    gallery.session.advance(1);
    EXPECT_EQ(gallery.session.scene().world().step_count(), 1u);
    press_key(gallery, SDLK_r, false, false);
    EXPECT_EQ(gallery.session.scene().world().step_count(), 0u);
    press_key(gallery, SDLK_RIGHTBRACKET, false, false);
    EXPECT_EQ(gallery.session.scene().info().name, scenes::all_scenes()[1].name);
    press_key(gallery, SDLK_LEFTBRACKET, false, false);
    EXPECT_EQ(gallery.session.scene().info().name, "planets");
}

TEST(Keys, reach_the_scene)
{
    Gallery gallery("gravity", {}, 1);
    press_key(gallery, SDLK_4, false, false);
    EXPECT_EQ(gallery.session.scene().parameters().choice("kind"), "polygon");
    press_key(gallery, SDLK_c, true, false);
    EXPECT_GT(gallery.session.scene().world().body_count(), 1) << "Ctrl C is not C";
    press_key(gallery, SDLK_c, false, false);
    EXPECT_EQ(gallery.session.scene().world().body_count(), 1);
}

TEST(Keys, arrows_walk_inside_a_step_and_escape_leaves)
{
    Gallery gallery("card-house", {}, 1);
    press_key(gallery, SDLK_i, false, false);
    ASSERT_TRUE(gallery.session.is_inside());
    press_key(gallery, SDLK_RIGHT, false, false);
    press_key(gallery, SDLK_RIGHT, false, true);
    EXPECT_EQ(gallery.session.moment(), 2u);
    press_key(gallery, SDLK_LEFT, false, false);
    EXPECT_EQ(gallery.session.moment(), 1u);
    press_key(gallery, SDLK_ESCAPE, false, false);
    EXPECT_FALSE(gallery.session.is_inside());
}

TEST(Keys, follow_the_picked_body)
{
    Gallery gallery("planets", {}, 1);
    press_key(gallery, SDLK_v, false, false);
    EXPECT_FALSE(gallery.session.watched()) << "no body was under the pointer yet";
    const BodyId planet = gallery.session.scene().world().bodies().back();
    gallery.hand.select(planet);
    press_key(gallery, SDLK_v, false, false);
    EXPECT_EQ(gallery.session.watched(), planet);
    press_key(gallery, SDLK_v, false, false);
    EXPECT_FALSE(gallery.session.watched());
    press_key(gallery, SDLK_v, false, false);
    press_key(gallery, SDLK_HOME, false, false);
    EXPECT_FALSE(gallery.session.watched());
}

} // namespace carom::gallery
