// The sparse solution against a dense one.
#include "solver/joints/articulation.hpp"

#include <carom/memory.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <random>
#include <vector>

namespace carom::detail
{
namespace
{

struct Mass
{
    float inv_mass = 0;
    float inv_inertia = 0;
};

/// Bodies, 0 of which is the world, and joints between them.
class Net
{
public:
    explicit Net(unsigned seed, std::pmr::memory_resource& memory = *std::pmr::new_delete_resource()) : system(memory), engine_(seed)
    {
        add_body({0, 0});
    }

    float from(float min, float max) { return std::uniform_real_distribution<float>(min, max)(engine_); }
    std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(engine_() % n); }

    std::uint32_t add_body(Mass mass)
    {
        masses_.push_back(mass);
        return static_cast<std::uint32_t>(masses_.size() - 1);
    }
    std::uint32_t add_body() { return add_body({from(0.2f, 3), from(0.2f, 3)}); }

    /// Rows in random directions.
    ArticulatedJoint& join(std::uint32_t a, std::uint32_t b, int count)
    {
        ArticulatedJoint joint;
        joint.body_a = a;
        joint.body_b = b;
        joint.count = count;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        {
            joint.j[i] = {{from(-1, 1), from(-1, 1)}, {from(-1, 1), from(-1, 1)}, from(-1, 1), from(-1, 1)};
            joint.rhs[i] = double{from(-1, 1)};
        }
        joint.inv_mass_a = Vec2{1, 1} * masses_[a].inv_mass;
        joint.inv_mass_b = Vec2{1, 1} * masses_[b].inv_mass;
        joint.inv_inertia_a = masses_[a].inv_inertia;
        joint.inv_inertia_b = masses_[b].inv_inertia;
        system.joints.push_back(joint);
        return system.joints.back();
    }

    /// A pin at arms r_a and r_b.
    ArticulatedJoint& pin(std::uint32_t a, std::uint32_t b, Vec2 r_a, Vec2 r_b)
    {
        ArticulatedJoint& joint = join(a, b, 2);
        joint.j[0] = {{1, 0}, {1, 0}, -r_a.y, -r_b.y};
        joint.j[1] = {{0, 1}, {0, 1}, r_a.x, r_b.x};
        return joint;
    }

    /// (A + S) x, where x is by joint and row; rows of joints that are not in are left out. S is 0 until the first factor().
    std::vector<double> times_a(const std::vector<double>& x) const
    {
        struct Motion
        {
            double x = 0, y = 0, w = 0;
        };
        std::vector<Motion> v(masses_.size());
        for_each_row([&](std::size_t row, const ArticulatedJoint& joint, const Jacobian<float>& j)
        {
            const double f = x[row];
            Motion& a = v[joint.body_a];
            Motion& b = v[joint.body_b];
            a.x -= f * double{j.l_a.x} * double{joint.inv_mass_a.x};
            a.y -= f * double{j.l_a.y} * double{joint.inv_mass_a.y};
            a.w -= f * double{j.s_a} * double{joint.inv_inertia_a};
            b.x += f * double{j.l_b.x} * double{joint.inv_mass_b.x};
            b.y += f * double{j.l_b.y} * double{joint.inv_mass_b.y};
            b.w += f * double{j.s_b} * double{joint.inv_inertia_b};
        });
        v[0] = {};
        std::vector<double> out(x.size());
        for_each_row([&](std::size_t row, const ArticulatedJoint& joint, const Jacobian<float>& j)
        {
            const Motion& a = v[joint.body_a];
            const Motion& b = v[joint.body_b];
            out[row] = double{j.l_b.x} * b.x + double{j.l_b.y} * b.y + double{j.s_b} * b.w - double{j.l_a.x} * a.x - double{j.l_a.y} * a.y -
                       double{j.s_a} * a.w + joint.softness[row % 3] * x[row];
        });
        return out;
    }

    std::vector<double> rhs() const
    {
        std::vector<double> all(3 * system.joints.size());
        for_each_row([&](std::size_t row, const ArticulatedJoint& joint, const Jacobian<float>&) { all[row] = joint.rhs[row % 3]; });
        return all;
    }

    void set_rhs(const std::vector<double>& all)
    {
        for (std::size_t i = 0; i < all.size(); ++i) system.joints[i / 3].rhs[i % 3] = all[i];
    }

    /// Plans, factors and solves.
    /// @return the largest error of (A + S) x = rhs among the rows that are in
    double solve()
    {
        system.plan();
        for (ArticulatedJoint& joint : system.joints)
            if (!joint.is_in) joint.rhs = {};
        const std::vector<double> wanted = rhs();
        system.factor();
        system.solve();
        const std::vector<double> got = times_a(rhs());
        double worst = 0;
        for_each_row([&](std::size_t row, const ArticulatedJoint&, const Jacobian<float>&)
        { worst = std::max(worst, std::abs(got[row] - wanted[row])); });
        return worst;
    }

    /// The same by elimination of the whole matrix, with pivoting.
    std::vector<double> solve_densely() const
    {
        std::vector<std::size_t> rows;
        for_each_row([&](std::size_t row, const ArticulatedJoint&, const Jacobian<float>&) { rows.push_back(row); });
        const std::size_t n = rows.size();
        std::vector<std::vector<double>> m(n, std::vector<double>(n + 1));
        const std::vector<double> b = rhs();
        for (std::size_t c = 0; c < n; ++c)
        {
            std::vector<double> unit(b.size());
            unit[rows[c]] = 1;
            const std::vector<double> column = times_a(unit);
            for (std::size_t r = 0; r < n; ++r) m[r][c] = column[rows[r]];
        }
        for (std::size_t r = 0; r < n; ++r) m[r][n] = b[rows[r]];
        for (std::size_t c = 0; c < n; ++c)
        {
            std::size_t best = c;
            for (std::size_t r = c; r < n; ++r)
                if (std::abs(m[r][c]) > std::abs(m[best][c])) best = r;
            std::swap(m[c], m[best]);
            for (std::size_t r = 0; r < n; ++r)
            {
                if (r == c) continue;
                const double f = m[r][c] / m[c][c];
                for (std::size_t k = c; k <= n; ++k) m[r][k] -= f * m[c][k];
            }
        }
        std::vector<double> x(b.size());
        for (std::size_t r = 0; r < n; ++r) x[rows[r]] = m[r][n] / m[r][r];
        return x;
    }

    std::size_t left_out() const
    {
        return static_cast<std::size_t>(
            std::count_if(system.joints.begin(), system.joints.end(), [](const ArticulatedJoint& j) { return j.count > 0 && !j.is_in; }));
    }

    Articulation system;

private:
    /// Every row that takes part: planned, or all while nothing is planned yet.
    template <class Visit>
    void for_each_row(const Visit& visit) const
    {
        const bool is_planned = std::any_of(system.joints.begin(), system.joints.end(), [](const ArticulatedJoint& j) { return j.is_in; });
        for (std::size_t i = 0; i < system.joints.size(); ++i)
        {
            const ArticulatedJoint& joint = system.joints[i];
            if (is_planned && !joint.is_in) continue;
            for (std::size_t k = 0; k < static_cast<std::size_t>(joint.count); ++k) visit(3 * i + k, joint, joint.j[k]);
        }
    }

    std::mt19937 engine_;
    std::vector<Mass> masses_;
};

/// Solves both ways.
void expect_dense_solution(Net& net, double tolerance, const char* what)
{
    const std::vector<double> wanted = net.rhs();
    EXPECT_LT(net.solve(), tolerance) << what;
    ASSERT_EQ(net.left_out(), 0u) << what;
    const std::vector<double> got = net.rhs();
    net.set_rhs(wanted);
    const std::vector<double> expected = net.solve_densely();
    for (std::size_t i = 0; i < got.size(); ++i)
        EXPECT_NEAR(got[i], expected[i], tolerance * (1 + std::abs(expected[i]))) << what << " " << i;
}

/// Every body hangs on an earlier one or on the world.
void add_tree(Net& net, int bodies)
{
    std::vector<std::uint32_t> all = {0};
    for (int i = 0; i < bodies; ++i)
    {
        const std::uint32_t parent = all[net.below(all.size())];
        const std::uint32_t body = net.add_body();
        const int count = 1 + static_cast<int>(net.below(3));
        if (net.below(2) == 0)
            net.join(parent, body, count);
        else
            net.join(body, parent, count);
        all.push_back(body);
    }
}

} // namespace

TEST(Articulation, SolvesRandomTrees)
{
    for (unsigned seed = 0; seed < 50; ++seed)
    {
        Net net(seed);
        add_tree(net, 1 + static_cast<int>(net.below(20)));
        expect_dense_solution(net, 1e-6, "tree");
    }
}

TEST(Articulation, SolvesLoops)
{
    for (unsigned seed = 0; seed < 50; ++seed)
    {
        Net net(seed);
        const int bodies = 3 + static_cast<int>(net.below(8));
        for (int i = 0; i < bodies; ++i) net.add_body();
        // Two rows a joint, a ring and a few chords: fewer rows than ways to move.
        const auto count = static_cast<std::uint32_t>(bodies);
        for (std::uint32_t i = 0; i < count; ++i) net.join(1 + i, 1 + (i + 1) % count, 2);
        for (std::uint32_t i = 0; i + 2 < count; i += 3) net.join(1 + i, 1 + i + 2, 1);
        expect_dense_solution(net, 1e-5, "loop");
    }
}

TEST(Articulation, SolvesSeveralJointsBetweenTwoBodiesAndHubs)
{
    for (unsigned seed = 0; seed < 30; ++seed)
    {
        Net net(seed);
        const std::uint32_t hub = net.add_body();
        for (int i = 0; i < 12; ++i) net.join(hub, net.add_body(), 2);
        net.join(hub, 1 + hub, 1);
        net.join(1 + hub, hub, 0);
        net.join(0, hub, 2);
        expect_dense_solution(net, 1e-5, "hub");
    }
}

TEST(Articulation, SolvesManySmallOnesAtOnce)
{
    Net net(3);
    for (int i = 0; i < 20; ++i) net.join(net.add_body(), net.add_body(), 1 + i % 3);
    expect_dense_solution(net, 1e-6, "apart");
}

TEST(Articulation, SolvesChainsOfWildlyDifferentMasses)
{
    // A chain of 60 pins under a weight: from as heavy as a link to a hundred thousand times.
    for (const float ratio : {1.0f, 100.0f, 1e5f})
    {
        Net net(7);
        std::uint32_t before = 0;
        for (int i = 0; i < 60; ++i)
        {
            const std::uint32_t body = net.add_body(i == 59 ? Mass{1 / ratio, 12 / ratio} : Mass{1, 12});
            net.pin(before, body, {0, before == 0 ? 0.0f : -0.5f}, {0, 0.5f});
            before = body;
        }
        expect_dense_solution(net, 1e-6, "chain");
    }
}

TEST(Articulation, RedundantRowsKeepTheEquations)
{
    for (unsigned seed = 0; seed < 30; ++seed)
    {
        // A tree of pins and welds, each joint twice, and some once more: what one says the other says again.
        Net net(seed);
        add_tree(net, 8);
        const std::size_t count = net.system.joints.size();
        for (std::size_t i = 0; i < count; ++i) net.system.joints.push_back(ArticulatedJoint(net.system.joints[i]));
        net.system.joints.push_back(ArticulatedJoint(net.system.joints[0]));
        // A right side that can be reached.
        std::vector<double> x(3 * net.system.joints.size());
        for (double& f : x) f = double{net.from(-1, 1)};
        net.set_rhs(net.times_a(x));
        EXPECT_LT(net.solve(), 1e-5) << seed;
        for (const double f : net.rhs()) ASSERT_LT(std::abs(f), 1e4) << seed;
    }
}

TEST(Articulation, AParallelogramOfPinsHasOneRowTooMany)
{
    // Two posts and a third between the ground and a beam: the third adds nothing that the first two do not hold.
    Net net(1);
    const std::uint32_t beam = net.add_body({1, 1});
    for (const float x : {-2.0f, 0.0f, 2.0f})
    {
        const std::uint32_t post = net.add_body({2, 3});
        net.pin(0, post, {0, 0}, {0, -1});
        net.pin(post, beam, {0, 1}, {x, 0});
    }
    std::vector<double> x(3 * net.system.joints.size());
    for (double& f : x) f = double{net.from(-1, 1)};
    net.set_rhs(net.times_a(x));
    EXPECT_LT(net.solve(), 1e-5);
    for (const double f : net.rhs()) EXPECT_LT(std::abs(f), 100);
}

TEST(Articulation, ARowThatCannotPushAnythingGivesNoImpulse)
{
    Net net(2);
    const std::uint32_t locked = net.add_body({0, 0});
    net.join(0, locked, 3);
    net.join(locked, net.add_body(), 2);
    net.solve();
    for (const double f : net.system.joints[0].rhs) EXPECT_EQ(f, 0);
    for (const double f : net.rhs()) EXPECT_TRUE(std::isfinite(f));
}

TEST(Articulation, LeavesOutWhatIsTooWideAndSolvesTheRest)
{
    // A cloth of 40 x 40 bodies.
    constexpr std::uint32_t side = 40;
    Net net(4);
    std::vector<std::uint32_t> bodies;
    for (std::uint32_t i = 0; i < side * side; ++i) bodies.push_back(net.add_body({1, 2}));
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x)
        {
            const std::uint32_t here = bodies[y * side + x];
            if (x + 1 < side) net.join(here, bodies[y * side + x + 1], 1);
            if (y + 1 < side) net.join(here, bodies[(y + 1) * side + x], 1);
        }
    EXPECT_LT(net.solve(), 1e-6);
    const std::size_t out = net.left_out();
    EXPECT_GT(out, 0u);
    EXPECT_LT(out, net.system.joints.size() / 2) << "most are in";
}

TEST(Articulation, PlansOnceAndThenAllocatesNothing)
{
    HeapResource memory;
    Net net(5, memory);
    add_tree(net, 200);
    const std::vector<double> wanted = net.rhs();
    net.solve();
    const std::vector<double> first = net.rhs();
    const std::size_t before = memory.stats().allocations;
    for (int i = 0; i < 3; ++i)
    {
        net.set_rhs(wanted);
        net.solve();
        EXPECT_EQ(net.rhs(), first);
    }
    EXPECT_EQ(memory.stats().allocations, before);
    // And plans anew, in the same memory, when a joint goes, is switched off, or changes its place.
    const auto again = [&]
    {
        net.set_rhs(wanted);
        return net.solve();
    };
    net.system.joints.back().count = 0;
    EXPECT_LT(again(), 1e-6);
    net.system.joints[3].count = 0;
    EXPECT_LT(again(), 1e-6);
    std::swap(net.system.joints[0], net.system.joints[9]);
    EXPECT_LT(again(), 1e-6);
    EXPECT_EQ(memory.stats().allocations, before);
}

TEST(Articulation, NothingIsSolvedQuietly)
{
    Net net(6);
    net.system.plan();
    net.system.factor();
    net.system.solve();
    net.join(0, net.add_body(), 0);
    net.solve();
    EXPECT_EQ(net.rhs(), std::vector<double>(3));
}

} // namespace carom::detail
