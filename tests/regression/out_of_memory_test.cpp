// A memory resource that runs dry in the middle of a call: the call throws std::bad_alloc, and the world is whole.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <memory_resource>
#include <new>
#include <string>
#include <vector>

namespace carom
{

namespace
{

/// Refuses every request once its allowance is used up.
class DryingResource final : public std::pmr::memory_resource
{
public:
    int allowance = 1 << 30;
    std::size_t bytes = 0;

private:
    void* do_allocate(std::size_t size, std::size_t alignment) override
    {
        if (allowance <= 0) throw std::bad_alloc();
        --allowance;
        bytes += size;
        return std::pmr::new_delete_resource()->allocate(size, alignment);
    }
    void do_deallocate(void* memory, std::size_t size, std::size_t alignment) override
    {
        bytes -= size;
        std::pmr::new_delete_resource()->deallocate(memory, size, alignment);
    }
    bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
};

constexpr int most_requests = 40; // more than any call below makes

} // namespace

TEST(Regression, a_body_that_memory_does_not_suffice_for_leaves_no_trace)
{
    int failures = 0;
    for (int allowance = 0; allowance < most_requests; ++allowance)
    {
        DryingResource memory;
        {
            World world({.memory = &memory});
            const BodyId before = world.create_body({}, circle(1));
            const std::uint64_t hash = world.hash();
            memory.allowance = allowance;
            try
            {
                world.create_body({.name = "a name that is too long for a short string"});
            }
            catch (const std::bad_alloc&)
            {
                ++failures;
                ASSERT_EQ(world.hash(), hash) << "after " << allowance << " requests";
                ASSERT_EQ(world.bodies().size(), 1u);
            }
            memory.allowance = 1 << 30;
            const BodyId after = world.create_body({.position = {5, 0}, .name = "after"});
            ASSERT_EQ(world.body(after).position(), (Vec2{5, 0}));
            ASSERT_EQ(world.body(after).name(), "after");
            world.step(1 / 60.0f);
            ASSERT_TRUE(world.find_body(before));
        }
        ASSERT_EQ(memory.bytes, 0u);
    }
    EXPECT_GT(failures, 2);
    EXPECT_LT(failures, most_requests);
}

TEST(Regression, a_shape_that_memory_does_not_suffice_for_leaves_its_body_as_it_was)
{
    int failures = 0;
    for (int allowance = 0; allowance < most_requests; ++allowance)
    {
        DryingResource memory;
        {
            World world({.memory = &memory});
            const BodyId body = world.create_body({}, circle(1));
            const MassData mass = world.body(body).mass_data();
            memory.allowance = allowance;
            bool has_failed = false;
            try
            {
                world.create_shape(body, box(1, 1));
            }
            catch (const std::bad_alloc&)
            {
                has_failed = true;
                ++failures;
            }
            ASSERT_EQ(world.shape_count(), has_failed ? 1 : 2);
            ASSERT_EQ(world.body(body).shapes().size(), has_failed ? 1u : 2u);
            ASSERT_EQ(world.body(body).mass_data().mass == mass.mass, has_failed);
        }
        ASSERT_EQ(memory.bytes, 0u);
    }
    EXPECT_GT(failures, 0);
}

TEST(Regression, a_body_whose_shape_memory_does_not_suffice_for_is_not_left_without_it)
{
    int failures = 0;
    for (int allowance = 0; allowance < most_requests; ++allowance)
    {
        DryingResource memory;
        {
            World world({.memory = &memory});
            memory.allowance = allowance;
            bool has_failed = false;
            try
            {
                world.create_body({}, box(1, 1));
            }
            catch (const std::bad_alloc&)
            {
                has_failed = true;
                ++failures;
            }
            ASSERT_EQ(world.body_count(), has_failed ? 0 : 1);
            ASSERT_EQ(world.shape_count(), has_failed ? 0 : 1);
        }
        ASSERT_EQ(memory.bytes, 0u);
    }
    EXPECT_GT(failures, 0);
}

TEST(Regression, a_chain_that_memory_does_not_suffice_for_has_no_segments)
{
    const std::vector<Vec2> points = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
    int failures = 0;
    for (int allowance = 0; allowance < most_requests; ++allowance)
    {
        DryingResource memory;
        {
            World world({.memory = &memory});
            const BodyId body = world.create_body({.type = BodyType::Static}, circle(1));
            memory.allowance = allowance;
            bool has_failed = false;
            try
            {
                world.create_chain(body, {.points = points, .is_loop = true});
            }
            catch (const std::bad_alloc&)
            {
                has_failed = true;
                ++failures;
            }
            memory.allowance = 1 << 30;
            ASSERT_EQ(world.shape_count(), has_failed ? 1 : 7);
            ASSERT_EQ(world.body(body).shapes().size(), has_failed ? 1u : 7u);
            const ChainId next = world.create_chain(body, {.points = points});
            ASSERT_EQ(world.chain(next).segment_count(), 5);
            world.step(1 / 60.0f);
            world.destroy_chain(next);
        }
        ASSERT_EQ(memory.bytes, 0u);
    }
    EXPECT_GT(failures, 5);
}

TEST(Regression, a_field_that_memory_does_not_suffice_for_is_not_there)
{
    int failures = 0;
    for (int allowance = 0; allowance < 4; ++allowance)
    {
        DryingResource memory;
        World world({.gravity = {}, .memory = &memory});
        memory.allowance = allowance;
        bool has_failed = false;
        try
        {
            world.add_field(UniformField{{1, 0}});
        }
        catch (const std::bad_alloc&)
        {
            has_failed = true;
            ++failures;
        }
        memory.allowance = 1 << 30;
        ASSERT_EQ(world.gravity_at({}), (has_failed ? Vec2{} : Vec2{1, 0}));
    }
    EXPECT_GT(failures, 0);
}

TEST(Regression, a_world_that_memory_does_not_suffice_for_gives_everything_back)
{
    int failures = 0;
    for (int allowance = 0; allowance < most_requests; ++allowance)
    {
        DryingResource memory;
        memory.allowance = allowance;
        try
        {
            World world({.capacity = {.bodies = 10, .shapes = 10, .contacts = 10}, .memory = &memory});
        }
        catch (const std::bad_alloc&)
        {
            ++failures;
        }
        ASSERT_EQ(memory.bytes, 0u);
    }
    EXPECT_GT(failures, 3);
}

TEST(Regression, a_step_that_memory_does_not_suffice_for_leaves_a_world_that_can_be_read_and_destroyed)
{
    int failures = 0;
    for (int allowance = 0; allowance < 2 * most_requests; ++allowance)
    {
        DryingResource memory;
        {
            World world({.memory = &memory});
            world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(50, 2));
            for (int i = 0; i < 20; ++i) world.create_body({.position = {0, 0.5f + 0.9f * static_cast<float>(i)}}, box(1, 1));
            const BodyId last = world.bodies().back();
            memory.allowance = allowance;
            try
            {
                for (int i = 0; i < 3; ++i) world.step(1 / 60.0f);
            }
            catch (const std::bad_alloc&)
            {
                ++failures;
                memory.allowance = 1 << 30;
                EXPECT_EQ(world.body_count(), 21);
                EXPECT_GT(world.body(last).position().y, 15);
                EXPECT_THROW(world.step(1 / 60.0f), UsageError);
                EXPECT_THROW(world.destroy_body(last), UsageError);
                EXPECT_THROW(world.body(last).set_enabled(false), UsageError);
            }
        }
        ASSERT_EQ(memory.bytes, 0u);
    }
    EXPECT_GT(failures, 10);
}

} // namespace carom
