// The mass-ratio scene: a heavy box stays on a light one, and a heavy ball does not stretch its chain.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace carom::scenes
{

TEST(MassRatio, a_box_of_200_stays_on_a_light_one)
{
    const auto scene = make_scene("mass-ratio", {{"heaviest", 200.0}, {"tower", 1}});
    scene->world().set_sleep_tuning({.is_enabled = false});
    std::vector<BodyId> heavy;
    for (const BodyId id : scene->world().bodies())
        if (scene->world().body(id).mass_data().mass > 190 && scene->world().body(id).position().x < 0) heavy.push_back(id);
    ASSERT_EQ(heavy.size(), 1u);
    EXPECT_LT(farthest_way(*scene, heavy, 600), 0.1f);
}

TEST(MassRatio, a_ball_of_1000_stretches_its_chain_by_less_than_one_percent)
{
    const auto scene = make_scene("mass-ratio");
    float most = 0;
    for (int i = 0; i < 600; ++i)
    {
        scene->step();
        const std::vector<JointId> joints = scene->world().joints();
        float gaps = 0;
        for (std::size_t j = joints.size() - 11; j < joints.size(); ++j) gaps += scene->world().joint(joints[j]).error();
        most = std::max(most, gaps);
    }
    EXPECT_LT(most, 0.06f); // of 6 m
}

} // namespace carom::scenes
