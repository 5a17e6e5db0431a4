// The colours of a live world: they need piles that are really stepped, so the test stands here and not beside the colours.
#include "solver/rows/graph_colors.hpp"

#include "edit/edits.hpp"
#include "step/step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory_resource>
#include <random>
#include <set>

namespace carom::detail
{
namespace
{

/// Every promise about the colours of a world, checked from scratch.
void expect_valid_colors(const WorldState& world)
{
    const ColorLists colors(world.contacts, *std::pmr::new_delete_resource());
    std::size_t colored = 0;
    std::vector<std::uint32_t> masks(world.bodies.records.size(), 0);
    for (int color = 0; color < color_count; ++color)
    {
        std::set<std::uint32_t> used;
        const std::span<const std::uint32_t> list = colors.list(color);
        for (std::size_t i = 0; i < list.size(); ++i)
        {
            const Contact& contact = world.contacts.contacts[list[i]];
            ASSERT_TRUE(contact.is_live);
            ASSERT_FALSE(contact.is_sensor);
            ASSERT_EQ(contact.color, color);
            ASSERT_GT(world.contacts.manifolds[list[i]].count, 0);
            ++colored;
            if (color == overflow_color) continue;
            for (const std::uint32_t body : {contact.body_a, contact.body_b})
            {
                if (!world.bodies.is_dynamic(body)) continue;
                ASSERT_TRUE(used.insert(body).second) << "colour " << color << " has body " << body << " twice";
                masks[body] |= std::uint32_t{1} << color;
            }
        }
    }
    std::size_t with_points = 0;
    for (std::uint32_t slot = 0; slot < world.contacts.slots.size(); ++slot)
        with_points +=
            world.contacts.contacts[slot].is_live && !world.contacts.contacts[slot].is_sensor && world.contacts.manifolds[slot].count > 0;
    ASSERT_EQ(colored, with_points) << "each contact with points once";
    for (std::uint32_t body = 0; body < world.bodies.slots.size(); ++body)
    {
        if (!world.bodies.slots.is_live(body)) continue;
        ASSERT_EQ(world.bodies.records[body].color_mask, masks[body]) << "body " << body;
    }
}

std::uint32_t add_body(WorldState& world, const BodyDef& def, const Geometry& geometry, const ShapeDef& shape = {})
{
    const std::uint32_t body = create_body(world, def);
    create_shape(world, body, geometry, shape);
    return body;
}

TEST(ContactColors, NoTwoContactsOfAColourShareADynamicBodyInALivePile)
{
    WorldState world({}, *std::pmr::new_delete_resource());
    add_body(world, {.type = BodyType::Static, .position = {0, -1}}, box(40, 2));
    add_body(world, {.type = BodyType::Kinematic, .position = {0, 2}, .angular_velocity = 1}, box(6, 0.4f));
    add_body(world, {.type = BodyType::Static}, box(4, 4), {.is_sensor = true});
    std::mt19937 engine(11);
    std::vector<std::uint32_t> bodies;
    for (int i = 0; i < 200; ++i)
        bodies.push_back(add_body(world, {.position = {0.7f * static_cast<float>(i % 12) - 4, 1 + 0.7f * static_cast<float>(i / 12)}},
                                  i % 3 == 0 ? Geometry{circle(0.4f)} : Geometry{box(0.7f, 0.6f)}));
    for (int i = 0; i < 150; ++i)
    {
        step(world, 1 / 60.0f, 4);
        expect_valid_colors(world);
        if (HasFatalFailure()) return;
        const std::uint32_t victim = bodies[engine() % bodies.size()];
        switch (engine() % 4)
        {
        case 0: set_body_type(world, victim, static_cast<BodyType>(engine() % 3)); break;
        case 1: set_body_enabled(world, victim, !world.bodies.records[victim].is_enabled); break;
        case 2: set_body_transform(world, victim, {{static_cast<float>(engine() % 8) - 4, 3}, {}}); break;
        default:
            destroy_body(world, victim);
            *std::find(bodies.begin(), bodies.end(), victim) = add_body(world, {.position = {0, 12}}, circle(0.3f));
        }
        expect_valid_colors(world);
        if (HasFatalFailure()) return;
    }
}

/// A big dynamic disc with 60 small ones around it: more contacts on one body than there are colours.
TEST(ContactColors, WhatFindsNoColourOverflowsAndIsSolvedAllTheSame)
{
    WorldState world({.gravity = {}}, *std::pmr::new_delete_resource());
    const std::uint32_t hub = add_body(world, {}, circle(10));
    std::vector<std::uint32_t> rim;
    constexpr int count = 60;
    for (int i = 0; i < count; ++i)
    {
        const Vec2 out = rotate(rotation(2 * pi * static_cast<float>(i) / count), Vec2{1, 0});
        rim.push_back(add_body(world, {.position = 10.3f * out, .linear_velocity = -2 * out}, circle(0.3f)));
    }
    const StepReport report = step(world, 1 / 60.0f, 4);
    EXPECT_EQ(report.rows, count);
    EXPECT_EQ(report.overflow_rows, count - overflow_color);
    EXPECT_EQ(report.colors, overflow_color);
    expect_valid_colors(world);
    for (std::size_t i = 0; i < rim.size(); ++i)
    {
        const Vec2 out = normalize(world.bodies.poses[rim[i]].center);
        EXPECT_GT(dot(world.bodies.velocity(rim[i]), out), -0.2f) << "disc " << i << " was stopped";
    }
    destroy_body(world, hub);
    expect_valid_colors(world);
    EXPECT_EQ(ColorLists(world.contacts, *std::pmr::new_delete_resource()).size(), 0u);
}

TEST(ContactColors, ContactsWithTheGroundComeLast)
{
    WorldState world({}, *std::pmr::new_delete_resource());
    add_body(world, {.type = BodyType::Static, .position = {0, -1}}, box(40, 2));
    add_body(world, {.position = {0, 0.5f}}, box(1, 1));
    add_body(world, {.position = {0, 1.5f}}, box(1, 1));
    step(world, 1 / 60.0f, 4);
    const ColorLists colors(world.contacts, *std::pmr::new_delete_resource());
    EXPECT_EQ(colors.list(0).size(), 1u) << "box on box";
    EXPECT_EQ(colors.list(overflow_color - 1).size(), 1u) << "box on ground";
}

} // namespace
} // namespace carom::detail
