// The contact solver gives the bits of the scalar one in the lanes of every instruction set.
#include "math/same_bits_test.hpp"
#include "solver/isa/dispatch.hpp"
#include "solver/rows/contact_solver.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory_resource>
#include <random>
#include <string>
#include <vector>

namespace carom::detail
{

namespace
{

/// Bodies of every type and random contacts between them; one body has more contacts than there are colours.
struct RandomPile
{
    explicit RandomPile(unsigned seed) : engine(seed)
    {
        for (int i = 0; i < body_count; ++i)
        {
            const BodyType type = i % 7 == 5 ? BodyType::Kinematic : i % 7 == 6 ? BodyType::Static : BodyType::Dynamic;
            const bool moves = type != BodyType::Static;
            bodies.create({.type = type,
                           .linear_velocity = moves ? Vec2{from(-3, 3), i % 2 == 0 ? -0.0f : from(-3, 3)} : Vec2{},
                           .angular_velocity = !moves       ? 0.0f
                                               : i % 9 == 4 ? from(250, 400)
                                                            : from(-2, 2), // some whirl
                           .locks = {.x = i % 11 == 3, .y = i % 13 == 4, .rotation = i % 5 == 1}});
        }
        for (BodyMass& mass : bodies.masses)
            if (mass.inv_mass != Vec2{}) mass.inv_inertia = from(0, 3);
        for (std::uint32_t i = 1; i < body_count; ++i) connect(0, i);
        for (int i = 0; i < 200; ++i)
        {
            const std::uint32_t a = static_cast<std::uint32_t>(engine() % body_count);
            const std::uint32_t b = static_cast<std::uint32_t>(engine() % body_count);
            if (a != b && (bodies.is_dynamic(a) || bodies.is_dynamic(b))) connect(a, b);
        }
    }

    float from(float min, float max) { return std::uniform_real_distribution<float>(min, max)(engine); }

    void connect(std::uint32_t a, std::uint32_t b)
    {
        const std::uint32_t slot = contacts.create({.body_a = a, .body_b = b}, bodies);
        ContactManifold& manifold = contacts.manifolds[slot];
        manifold.surface = {.friction = from(0, 1), .restitution = engine() % 2 ? from(0, 1) : 0.0f};
        manifold.surface.rolling_resistance = from(0, 0.1f);
        manifold.surface.tangent_speed = from(-1, 1);
        manifold.count = engine() % 2 ? 1 : 2;
        const Rot q = rotation(from(-3, 3));
        manifold.normal = {q.c, q.s};
        manifold.rolling_impulse = from(-0.1f, 0.1f);
        manifold.carried_impulse = from(0, 1);
        for (std::size_t p = 0; p < 2; ++p)
        {
            manifold.arms[p] = {{from(-1, 1), from(-1, 1)}, {from(-1, 1), from(-1, 1)}};
            manifold.separation[p] = from(-0.1f, 0.05f);
            manifold.impulses[p] = {from(0, 1), from(-0.3f, 0.3f)};
        }
        give_color(slot, contacts, bodies);
    }

    static constexpr int body_count = 60;
    std::mt19937 engine;
    BodyStore bodies{*std::pmr::new_delete_resource()};
    ContactStore contacts{*std::pmr::new_delete_resource()};
    ColorLists colors() const { return {contacts, *std::pmr::new_delete_resource()}; }
};

void run(RandomPile& pile, Simd simd)
{
    std::pmr::monotonic_buffer_resource arena;
    const ContactSolverPtr rows = make_contact_solver(passes_of(simd), arena);
    ContactSolver& solver = *rows;
    const ContactConstants constants = make_contact_constants({}, 1 / 60.0f, 1 / 240.0f, 1 / 480.0f);
    solver.build(pile.colors(), pile.bodies, pile.contacts, constants);
    std::span<BodyMotion> motions = pile.bodies.motions;
    std::vector<Vec2> accelerations(motions.size(), Vec2{0, -9.81f});
    accelerations[0] = {}; // of what does not move
    solver.bounce(motions, pile.bodies.watches, accelerations);
    for (int substep = 0; substep < 3; ++substep)
    {
        solver.warm_start(motions);
        solver.solve(motions);
        for (BodyMotion& motion : motions)
        {
            motion.dp += constants.h * motion.v;
            motion.dq = normalize(Rot{1, constants.h * motion.w} * motion.dq);
        }
        solver.relax(motions);
    }
    solver.store_impulses(pile.contacts, pile.bodies.watches);
}

void expect_same_bits(const RandomPile& one, const RandomPile& wide)
{
    for (std::size_t i = 0; i < one.bodies.motions.size(); ++i)
    {
        ASSERT_TRUE(length(one.bodies.motions[i].v) < 1e12f) << "motion " << i; // a comparison of NaNs would show nothing
        ASSERT_EQ(std::memcmp(&one.bodies.motions[i], &wide.bodies.motions[i], sizeof(BodyMotion)), 0) << "motion " << i;
    }
    for (std::uint32_t slot = 0; slot < one.contacts.slots.size(); ++slot)
    {
        const ContactManifold& a = one.contacts.manifolds[slot];
        const ContactManifold& b = wide.contacts.manifolds[slot];
        ASSERT_TRUE(same_bits(a.rolling_impulse, b.rolling_impulse) && same_bits(a.carried_impulse, b.carried_impulse)) << slot;
        const ContactResult& result_a = one.contacts.results[slot];
        const ContactResult& result_b = wide.contacts.results[slot];
        ASSERT_TRUE(same_bits(result_a.total_rolling, result_b.total_rolling)) << slot;
        for (std::size_t p = 0; p < static_cast<std::size_t>(a.count); ++p)
        {
            ASSERT_TRUE(same_bits(a.impulses[p].normal, b.impulses[p].normal)) << slot;
            ASSERT_TRUE(same_bits(a.impulses[p].tangent, b.impulses[p].tangent)) << slot;
            ASSERT_TRUE(same_bits(result_a.totals[p].normal, result_b.totals[p].normal)) << slot;
            ASSERT_TRUE(same_bits(result_a.totals[p].tangent, result_b.totals[p].tangent)) << slot;
            ASSERT_TRUE(same_bits(result_a.normal_velocity[p], result_b.normal_velocity[p])) << slot;
        }
    }
}

class ContactLanes : public testing::TestWithParam<Simd>
{
};

TEST_P(ContactLanes, give_the_bits_of_one)
{
    if (!is_available(GetParam())) GTEST_SKIP() << "this machine does not have it";
    for (unsigned seed = 0; seed < 30; ++seed)
    {
        RandomPile one(seed);
        RandomPile wide(seed);
        ASSERT_FALSE(one.colors().list(overflow_color).empty());
        run(one, Simd::Scalar);
        run(wide, GetParam());
        expect_same_bits(one, wide);
        if (HasFatalFailure()) return;
    }
}

TEST_P(ContactLanes, do_not_write_what_nothing_pushes)
{
    if (!is_available(GetParam())) GTEST_SKIP() << "this machine does not have it";
    RandomPile pile(1);
    const RandomPile before(1);
    run(pile, GetParam());
    for (std::uint32_t body = 0; body < RandomPile::body_count; ++body)
    {
        if (pile.bodies.is_dynamic(body)) continue;
        ASSERT_TRUE(same_bits(pile.bodies.velocity(body).x, before.bodies.velocity(body).x));
        ASSERT_TRUE(same_bits(pile.bodies.velocity(body).y, before.bodies.velocity(body).y));
        ASSERT_TRUE(same_bits(pile.bodies.spin(body), before.bodies.spin(body)));
    }
    EXPECT_EQ(pile.bodies.motions[0].v, Vec2{});
}

INSTANTIATE_TEST_SUITE_P(All, ContactLanes, testing::ValuesIn(all_simd), [](const auto& simd) { return std::string(name_of(simd.param)); });

} // namespace
} // namespace carom::detail
