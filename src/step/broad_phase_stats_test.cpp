// What a step's report tells of the search for pairs, whatever the broad phase.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <string>

namespace carom
{

class BroadPhaseStatsTest : public testing::TestWithParam<BroadPhaseType>
{
protected:
    static constexpr float dt = 1 / 60.0f;

    BroadPhaseStatsTest()
    {
        for (int i = 0; i < 60; ++i)
            world.create_body({.position = {2 * static_cast<float>(i % 10), 2 * static_cast<float>(i / 10)}}, circle(0.5f));
    }
    int shown_nodes() const
    {
        struct Counter : DebugDraw
        {
            void broad_phase_node(const Aabb&, int) override { ++count; }
            int count = 0;
        } counter;
        world.debug_draw(counter, DrawPart::BroadPhase);
        return counter.count;
    }
    void add_three_that_overlap()
    {
        world.create_body({.position = {-5, 0}}, circle(0.5f));
        world.create_body({.position = {-5.5f, 0}}, circle(0.5f));
        world.create_body({.position = {-5, 0.5f}}, circle(0.5f));
    }

    World world{{.gravity = {}, .broad_phase = GetParam()}};
    const bool has_nodes = GetParam() != BroadPhaseType::BruteForce;
};

TEST_P(BroadPhaseStatsTest, tell_of_the_search_of_this_step)
{
    const BroadPhaseStats first = world.step(dt).broad_phase;
    EXPECT_GT(first.pairs_tested, 60u) << "all shapes are new";
    EXPECT_EQ(first.pairs_found, 0u);
    EXPECT_EQ(first.nodes > 0, has_nodes);

    add_three_that_overlap();
    const BroadPhaseStats second = world.step(dt).broad_phase;
    EXPECT_EQ(second.pairs_found, 3u);
    EXPECT_GE(second.pairs_tested, 3u);
    EXPECT_LT(second.pairs_tested, first.pairs_tested) << "few have moved";
    EXPECT_EQ(second.nodes, static_cast<std::size_t>(shown_nodes()));
}

TEST_P(BroadPhaseStatsTest, are_nought_when_nothing_has_moved_and_keep_the_nodes)
{
    const BroadPhaseStats first = world.step(dt).broad_phase;
    const int nodes = shown_nodes();
    for (int i = 0; i < 60; ++i)
    {
        const BroadPhaseStats stats = world.step(i % 2 == 0 ? dt : 0).broad_phase;
        EXPECT_EQ(stats, (BroadPhaseStats{.pairs_tested = 0, .pairs_found = 0, .nodes = first.nodes}));
        EXPECT_EQ(shown_nodes(), nodes);
    }
    EXPECT_EQ(world.awake_body_count(), 0);
}

TEST_P(BroadPhaseStatsTest, of_a_world_that_is_at_rest_while_the_broad_phase_is_changed)
{
    const BroadPhaseStats first = world.step(dt).broad_phase;
    const int nodes = shown_nodes();
    world.set_broad_phase(BroadPhaseType::BruteForce);
    EXPECT_EQ(world.step(dt).broad_phase, BroadPhaseStats{});
    world.set_broad_phase(GetParam());
    EXPECT_EQ(world.step(dt).broad_phase, (BroadPhaseStats{.pairs_tested = 0, .pairs_found = 0, .nodes = first.nodes}));
    EXPECT_EQ(shown_nodes(), nodes) << "they are made though nothing has moved";
}

INSTANTIATE_TEST_SUITE_P(Types, BroadPhaseStatsTest, testing::ValuesIn(all_broad_phases),
                         [](const auto& type) { return std::string(name_of(type.param)); });

} // namespace carom
