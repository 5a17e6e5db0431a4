// Chains as things of a world: made, read, changed and taken away.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace carom
{

namespace
{

const std::vector<Vec2> line = {{3, 0}, {2, 0}, {1, 0.5f}, {0, 0}};

template <class Call>
std::string message_of(Call&& call)
{
    try
    {
        call();
    }
    catch (const UsageError& error)
    {
        return error.what();
    }
    return "accepted";
}

struct ChainTest : testing::Test
{
    World world;
    BodyId ground = world.create_body({.type = BodyType::Static});
};

} // namespace

TEST_F(ChainTest, an_open_chain_has_a_segment_less_than_points_and_a_loop_as_many)
{
    const ChainId open = world.create_chain(ground, {.points = line});
    const ChainId loop = world.create_chain(ground, {.points = line, .is_loop = true, .sides = ChainSides::OneSided, .user_data = 7});
    EXPECT_EQ(world.chain(open).segment_count(), 3);
    EXPECT_EQ(world.chain(loop).segment_count(), 4);
    EXPECT_EQ(world.chain(loop).segments().size(), 4u);
    EXPECT_EQ(world.shape_count(), 7);
    EXPECT_TRUE(world.chain(loop).is_loop());
    EXPECT_EQ(world.chain(loop).sides(), ChainSides::OneSided);
    EXPECT_EQ(world.chain(open).sides(), ChainSides::TwoSided);
    EXPECT_EQ(world.chain(loop).user_data(), 7u);
    EXPECT_EQ(world.chain(open).body(), ground);

    const std::vector<ShapeId> segments = world.chain(loop).segments();
    for (std::size_t i = 0; i < 4; ++i)
    {
        const Segment& segment = std::get<Segment>(world.shape(segments[i]).geometry());
        EXPECT_EQ(segment.p1, line[i]);
        EXPECT_EQ(segment.p2, line[(i + 1) % 4]);
        EXPECT_EQ(world.shape(segments[i]).chain(), loop);
    }
    const ShapeId other = world.create_shape(ground, circle(1));
    EXPECT_EQ(world.shape(other).chain(), ChainId{});
}

TEST_F(ChainTest, each_segment_may_have_its_own_material)
{
    const std::vector<Material> materials = {{.friction = 0.1f}, {.friction = 0.2f}, {.friction = 0.3f}};
    const ChainId chain = world.create_chain(ground, {.points = line, .materials = materials});
    EXPECT_EQ(world.chain(chain).material(1).friction, 0.2f);
    world.chain(chain).set_material(1, {.friction = 0.9f});
    EXPECT_EQ(world.chain(chain).material(0).friction, 0.1f);
    EXPECT_EQ(world.chain(chain).material(1).friction, 0.9f);
    world.chain(chain).set_material(world.chain(chain).material(2)); // one of those that change
    for (int i = 0; i < 3; ++i) EXPECT_EQ(world.chain(chain).material(i).friction, 0.3f);
    EXPECT_EQ(message_of([&] { world.chain(chain).set_material(3, {}); }), "set_material: segment is 3; give a value from 0 to 2");
}

TEST_F(ChainTest, a_chain_is_destroyed_as_a_whole_and_with_its_body)
{
    const ChainId chain = world.create_chain(ground, {.points = line, .is_loop = true});
    const std::vector<ShapeId> segments = world.chain(chain).segments();
    EXPECT_EQ(message_of([&] { world.destroy_shape(segments[1]); }), "destroy_shape: shape is a segment of a chain; destroy the chain");
    EXPECT_EQ(message_of([&] { world.shape(segments[1]).set_geometry(circle(1)); }),
              "set_geometry: shape is a segment of a chain; make another chain");
    world.destroy_chain(chain);
    EXPECT_EQ(world.shape_count(), 0);
    EXPECT_FALSE(world.find_chain(chain));
    EXPECT_FALSE(world.find_shape(segments[0]));
    EXPECT_THROW(world.chain(chain), UsageError);

    const ChainId again = world.create_chain(ground, {.points = line});
    EXPECT_NE(again, chain);
    world.destroy_body(ground);
    EXPECT_FALSE(world.find_chain(again));
    EXPECT_EQ(world.shape_count(), 0);
}

TEST_F(ChainTest, what_lies_on_it_falls_when_it_goes_and_the_end_is_told)
{
    const ChainId chain = world.create_chain(ground, {.points = line});
    const BodyId ball = world.create_body({.position = {1, 1.1f}}, circle(0.5f));
    while (world.events().contact_begin.empty()) world.step(1 / 60.0f);
    world.destroy_chain(chain);
    world.step(1 / 60.0f);
    EXPECT_FALSE(world.events().contact_end.empty());
    for (int i = 0; i < 60; ++i) world.step(1 / 60.0f);
    EXPECT_LT(world.body(ball).position().y, 0);
}

TEST_F(ChainTest, only_its_own_contacts_end_when_it_goes)
{
    world.create_shape(ground, offset_box(6, 1, {-10, -0.5f}));
    const ChainId chain = world.create_chain(ground, {.points = line});
    std::vector<BodyId> balls;
    for (const float x : {-12.0f, 1.0f, -10.0f, 2.0f, -8.0f}) balls.push_back(world.create_body({.position = {x, 1.1f}}, circle(0.5f)));
    for (int i = 0; i < 60; ++i) world.step(1 / 60.0f);
    const auto touches = [&](BodyId body) { return !world.shape(world.body(body).shapes()[0]).touching().empty(); };
    for (const BodyId ball : balls) ASSERT_TRUE(touches(ball)) << ball.index;
    world.destroy_chain(chain);
    for (std::size_t i = 0; i < balls.size(); ++i) EXPECT_EQ(touches(balls[i]), i % 2 == 0) << i;
    world.step(1 / 60.0f);
    EXPECT_TRUE(world.events().contact_begin.empty());
    ASSERT_FALSE(world.events().contact_end.empty());
    for (const ContactEnd& end : world.events().contact_end)
    {
        EXPECT_FALSE(world.find_shape(end.shape_a) && world.find_shape(end.shape_b)) << "both are still there";
    }
}

TEST_F(ChainTest, a_filter_of_the_chain_is_of_all_its_segments)
{
    const ChainId chain = world.create_chain(ground, {.points = line});
    const BodyId ball = world.create_body({.position = {1, 1.1f}}, circle(0.5f));
    world.chain(chain).set_filter({.mask = 0});
    for (int i = 0; i < 120; ++i) world.step(1 / 60.0f);
    EXPECT_LT(world.body(ball).position().y, -1);
}

TEST_F(ChainTest, refuses_bad_points_by_name)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::uint64_t before = world.hash();
    std::vector<Vec2> points(20);
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = {static_cast<float>(i), 0};
    const auto message = [&](const ChainDef& def) { return message_of([&] { world.create_chain(ground, def); }); };

    points[17].x = nan;
    EXPECT_EQ(message({.points = points}), "create_chain: points[17].x is nan; give finite points");
    points[17].x = 2e6f;
    EXPECT_EQ(message({.points = points}), "create_chain: points[17].x is 2e+06; give a value from -1e+06 to 1e+06");
    points[17] = points[16];
    EXPECT_EQ(message({.points = points}), "create_chain: points[17] is (16, 0); give neighbours that are at least 1 mm apart");
    const std::vector<Vec2> two = {{0, 0}, {1, 0}};
    EXPECT_EQ(message({.points = two, .is_loop = true}), "create_chain: points.size is 2; give a value from 3 to 1000000");
    EXPECT_EQ(message({}), "create_chain: points.size is 0; give a value from 2 to 1000000");
    const std::vector<Vec2> closed = {{0, 0}, {1, 0}, {1, 1}, {0, 0}};
    EXPECT_EQ(message({.points = closed, .is_loop = true}),
              "create_chain: points[0] is (0, 0); give neighbours that are at least 1 mm apart");

    const std::vector<Material> materials = {{}, {.friction = -1}, {}};
    EXPECT_EQ(message({.points = line, .materials = materials}), "create_chain: materials[1].friction is -1; give a value from 0 to 1e+06");
    const std::vector<Material> bad_first = {{.friction = -1}, {}, {}};
    EXPECT_EQ(message({.points = line, .materials = bad_first}), "create_chain: materials[0].friction is -1; give a value from 0 to 1e+06");
    EXPECT_EQ(message({.points = line, .materials = std::span(materials).first(2)}),
              "create_chain: materials.size is 2; give none, one, or one for each segment");
    EXPECT_EQ(message({.points = line, .sides = static_cast<ChainSides>(5)}), "create_chain: sides is 5; give a ChainSides");
    EXPECT_EQ(world.hash(), before);
}

TEST_F(ChainTest, ten_thousand_segments_come_and_go_quickly)
{
    std::vector<Vec2> points;
    for (int i = 0; i < 10000; ++i) points.push_back({0.1f * static_cast<float>(i), 0});
    for (int round = 0; round < 3; ++round) world.destroy_chain(world.create_chain(ground, {.points = points}));
    EXPECT_EQ(world.shape_count(), 0);
}

TEST_F(ChainTest, a_copy_of_the_world_has_it_too_and_goes_on_to_the_same_bits)
{
    struct Slippery : ContactHooks
    {
        void pre_solve(PreSolve& contact) override { contact.friction = contact.manifold.points[0].position.x > 1.5f ? 0.0f : 1.0f; }
    } hooks;
    const std::vector<Material> materials = {{.friction = 0.1f}, {.friction = 0.2f}, {.friction = 0.3f}};
    const ChainId chain =
        world.create_chain(ground, {.points = line, .sides = ChainSides::OneSided, .materials = materials, .hit_events = true});
    for (int i = 0; i < 4; ++i)
        world.create_body({.position = {0.5f + 0.7f * static_cast<float>(i), i % 2 == 0 ? 2.0f : -1.0f},
                           .linear_velocity = {0, i % 2 == 0 ? 0.0f : 8.0f}},
                          circle(0.3f), {.pre_solve = true});
    world.set_hit_speed(2);
    world.set_mixing({.friction = Mix::Average});
    world.set_hooks(&hooks);
    for (int i = 0; i < 15; ++i) world.step(1 / 60.0f);

    World copy = world.copy();
    copy.set_hooks(&hooks); // those are not copied
    EXPECT_EQ(copy.hit_speed(), 2);
    EXPECT_EQ(copy.mixing().friction, Mix::Average);
    EXPECT_EQ(copy.chain(copy.translated(chain)).segments().size(), 3u);
    for (int i = 0; i < 60; ++i)
    {
        world.step(1 / 60.0f);
        copy.step(1 / 60.0f);
        ASSERT_EQ(world.hash(), copy.hash()) << "step " << i;
        ASSERT_EQ(world.events().contact_hit.size(), copy.events().contact_hit.size());
    }
    copy.destroy_chain(copy.translated(chain));
    EXPECT_TRUE(world.find_chain(chain));
}

} // namespace carom
