// The sparse solution against a dense one.
#include "solver/joints/joint_solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

/// A joint, with the velocities that its rows are to bring about.
struct NetJoint
{
    std::uint32_t body_a;
    std::uint32_t body_b;
    JointRow<float> row;
    std::array<double, most_rigid> rhs;
    std::array<double, most_rigid> softness; ///< S, out of solve()
};

/// Bodies, 0 of which is the world, and joints between them.
class Net
{
public:
    explicit Net(unsigned seed) : engine_(seed) { add_body({0, 0}); }

    float from(float min, float max) { return std::uniform_real_distribution<float>(min, max)(engine_); }
    std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(engine_() % n); }

    std::uint32_t add_body(Mass mass)
    {
        masses_.push_back(mass);
        return static_cast<std::uint32_t>(masses_.size() - 1);
    }
    std::uint32_t add_body() { return add_body({from(0.2f, 3), from(0.2f, 3)}); }

    /// Rows in random directions.
    NetJoint& join(std::uint32_t a, std::uint32_t b, std::uint32_t count)
    {
        NetJoint joint = {a, b, {}, {}, {}};
        joint.row.rigid_count = count;
        for (std::size_t i = 0; i < count; ++i)
        {
            joint.row.rigid[i] = {{from(-1, 1), from(-1, 1)}, {from(-1, 1), from(-1, 1)}, from(-1, 1), from(-1, 1)};
            joint.rhs[i] = double{from(-1, 1)};
        }
        joint.row.inv_mass_a = {masses_[a].inv_mass, masses_[a].inv_mass};
        joint.row.inv_mass_b = {masses_[b].inv_mass, masses_[b].inv_mass};
        joint.row.inv_inertia_a = masses_[a].inv_inertia;
        joint.row.inv_inertia_b = masses_[b].inv_inertia;
        joints.push_back(joint);
        return joints.back();
    }

    /// A pin at arms r_a and r_b.
    NetJoint& pin(std::uint32_t a, std::uint32_t b, Vec2 r_a, Vec2 r_b)
    {
        NetJoint& joint = join(a, b, 2);
        joint.row.rigid[0] = {{1, 0}, {1, 0}, -r_a.y, -r_b.y};
        joint.row.rigid[1] = {{0, 1}, {0, 1}, r_a.x, r_b.x};
        return joint;
    }

    /// (A + S) x, where x is by joint and row. S is 0 until the first solve().
    std::vector<double> times_a(const std::vector<double>& x) const
    {
        struct Motion
        {
            double x = 0, y = 0, w = 0;
        };
        std::vector<Motion> v(masses_.size());
        for_each_row([&](std::size_t row, const NetJoint& joint, const Jacobian<float>& j)
        {
            const double f = x[row];
            Motion& a = v[joint.body_a];
            Motion& b = v[joint.body_b];
            a.x -= f * double{j.l_a.x} * double{joint.row.inv_mass_a.x};
            a.y -= f * double{j.l_a.y} * double{joint.row.inv_mass_a.y};
            a.w -= f * double{j.s_a} * double{joint.row.inv_inertia_a};
            b.x += f * double{j.l_b.x} * double{joint.row.inv_mass_b.x};
            b.y += f * double{j.l_b.y} * double{joint.row.inv_mass_b.y};
            b.w += f * double{j.s_b} * double{joint.row.inv_inertia_b};
        });
        v[0] = {};
        std::vector<double> out(x.size());
        for_each_row([&](std::size_t row, const NetJoint& joint, const Jacobian<float>& j)
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
        std::vector<double> all(3 * joints.size());
        for_each_row([&](std::size_t row, const NetJoint& joint, const Jacobian<float>&) { all[row] = joint.rhs[row % 3]; });
        return all;
    }

    void set_rhs(const std::vector<double>& all)
    {
        for (std::size_t i = 0; i < all.size(); ++i) joints[i / 3].rhs[i % 3] = all[i];
    }

    EliminationPlan plan() const
    {
        std::vector<PlannedJoint> planned;
        for (const NetJoint& joint : joints) planned.push_back({{joint.body_a, joint.body_b}, joint.row.rigid_count, 0});
        std::vector<std::uint8_t> can_move(masses_.size(), 1);
        can_move[0] = 0;
        return Eliminator(*std::pmr::new_delete_resource()).plan(planned, can_move, *std::pmr::new_delete_resource());
    }

    /// Plans, factors and solves. A joint without rows takes part in nothing.
    /// @return the largest error of (A + S) x = rhs
    double solve()
    {
        const EliminationPlan made = plan();
        EXPECT_FALSE(made.is_net);
        switch (made.block_rows)
        {
        case 1: return solve_in_blocks<1>(made);
        case 2: return solve_in_blocks<2>(made);
        default: return solve_in_blocks<3>(made);
        }
    }

    /// The same by elimination of the whole matrix, with pivoting.
    std::vector<double> solve_densely() const
    {
        std::vector<std::size_t> rows;
        for_each_row([&](std::size_t row, const NetJoint&, const Jacobian<float>&) { rows.push_back(row); });
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

    std::vector<NetJoint> joints;

private:
    template <std::size_t Rows>
    double solve_in_blocks(const EliminationPlan& made)
    {
        const MechanismPlan view = made.view();
        std::vector<std::uint32_t> offsets;
        for (std::size_t i = 0; i < joints.size(); ++i)
            offsets.push_back(static_cast<std::uint32_t>(reinterpret_cast<char*>(&joints[i].row) - reinterpret_cast<char*>(joints.data())));
        std::vector<double> numbers(1 + (view.joint_count + view.front_count) * Rows * Rows + 3 * view.joint_count * Rows);
        numbers[0] = loop_softness;
        const MechanismGroup group = {&view,  reinterpret_cast<char*>(joints.data()), offsets.data(), nullptr, nullptr, numbers.data(),
                                      nullptr};
        const Mechanisms<float, Rows> m(group);
        const auto joint_of = [&](std::uint32_t column) -> NetJoint& { return joints[view.columns[column].joint]; };
        const std::vector<double> wanted = rhs();
        factor(m);
        for (std::uint32_t k = 0; k < view.joint_count; ++k)
            for (std::size_t i = 0; i < Rows; ++i) m.values[k][i] = joint_of(k).rhs[i];
        substitute(m);
        for (std::uint32_t k = 0; k < view.joint_count; ++k)
            for (std::size_t i = 0; i < Rows; ++i) joint_of(k).rhs[i] = m.values[k][i], joint_of(k).softness[i] = m.softness[k][i];
        const std::vector<double> got = times_a(rhs());
        double worst = 0;
        for_each_row([&](std::size_t row, const NetJoint&, const Jacobian<float>&)
        { worst = std::max(worst, std::abs(got[row] - wanted[row])); });
        return worst;
    }

    template <class Visit>
    void for_each_row(const Visit& visit) const
    {
        for (std::size_t i = 0; i < joints.size(); ++i)
            for (std::size_t k = 0; k < joints[i].row.rigid_count; ++k) visit(3 * i + k, joints[i], joints[i].row.rigid[k]);
    }

    std::mt19937 engine_;
    std::vector<Mass> masses_;
};

/// Solves both ways.
void expect_dense_solution(Net& net, double tolerance, const char* what)
{
    const std::vector<double> wanted = net.rhs();
    EXPECT_LT(net.solve(), tolerance) << what;
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
        const std::uint32_t count = 1 + net.below(3);
        if (net.below(2) == 0)
            net.join(parent, body, count);
        else
            net.join(body, parent, count);
        all.push_back(body);
    }
}

} // namespace

TEST(Elimination, SolvesRandomTrees)
{
    for (unsigned seed = 0; seed < 50; ++seed)
    {
        Net net(seed);
        add_tree(net, 1 + static_cast<int>(net.below(20)));
        expect_dense_solution(net, 1e-6, "tree");
    }
}

TEST(Elimination, SolvesLoops)
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

TEST(Elimination, SolvesSeveralJointsBetweenTwoBodiesAndHubs)
{
    for (unsigned seed = 0; seed < 30; ++seed)
    {
        Net net(seed);
        const std::uint32_t hub = net.add_body();
        for (int i = 0; i < 12; ++i) net.join(hub, net.add_body(), 2);
        net.join(hub, 1 + hub, 1);
        net.join(0, hub, 2);
        expect_dense_solution(net, 1e-5, "hub");
    }
}

TEST(Elimination, SolvesManySmallOnesAtOnce)
{
    Net net(3);
    for (int i = 0; i < 20; ++i) net.join(net.add_body(), net.add_body(), 1 + static_cast<std::uint32_t>(i) % 3);
    expect_dense_solution(net, 1e-6, "apart");
}

TEST(Elimination, SolvesChainsOfWildlyDifferentMasses)
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

TEST(Elimination, RedundantRowsKeepTheEquations)
{
    for (unsigned seed = 0; seed < 30; ++seed)
    {
        // A tree of pins and welds, each joint twice, and some once more: what one says the other says again.
        Net net(seed);
        add_tree(net, 8);
        const std::size_t count = net.joints.size();
        for (std::size_t i = 0; i < count; ++i) net.joints.push_back(NetJoint(net.joints[i]));
        net.joints.push_back(NetJoint(net.joints[0]));
        // A right side that can be reached.
        std::vector<double> x(3 * net.joints.size());
        for (double& f : x) f = double{net.from(-1, 1)};
        net.set_rhs(net.times_a(x));
        EXPECT_LT(net.solve(), 1e-5) << seed;
        for (const double f : net.rhs()) ASSERT_LT(std::abs(f), 1e4) << seed;
    }
}

TEST(Elimination, AParallelogramOfPinsHasOneRowTooMany)
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
    std::vector<double> x(3 * net.joints.size());
    for (double& f : x) f = double{net.from(-1, 1)};
    net.set_rhs(net.times_a(x));
    EXPECT_LT(net.solve(), 1e-5);
    for (const double f : net.rhs()) EXPECT_LT(std::abs(f), 100);
}

TEST(Elimination, ARowThatCannotPushAnythingGivesNoImpulse)
{
    Net net(2);
    const std::uint32_t locked = net.add_body({0, 0});
    net.join(0, locked, 3);
    net.join(locked, net.add_body(), 2);
    net.solve();
    for (const double f : net.joints[0].rhs) EXPECT_EQ(f, 0);
    for (const double f : net.rhs()) EXPECT_TRUE(std::isfinite(f));
}

TEST(Elimination, TellsNetsFromWhatCanBeSolvedAsOne)
{
    // Cloths of bodies that are joined to their neighbours.
    const auto is_net = [](std::uint32_t width, std::uint32_t height)
    {
        Net net(4);
        std::vector<std::uint32_t> bodies;
        for (std::uint32_t i = 0; i < width * height; ++i) bodies.push_back(net.add_body({1, 2}));
        for (std::uint32_t y = 0; y < height; ++y)
            for (std::uint32_t x = 0; x < width; ++x)
            {
                const std::uint32_t here = bodies[y * width + x];
                if (x + 1 < width) net.join(here, bodies[y * width + x + 1], 1);
                if (y + 1 < height) net.join(here, bodies[(y + 1) * width + x], 1);
            }
        return net.plan().is_net;
    };
    EXPECT_FALSE(is_net(1, 500));
    EXPECT_FALSE(is_net(4, 100));
    EXPECT_TRUE(is_net(40, 40));
}

TEST(Elimination, TellsTreesFromLoops)
{
    Net net(8);
    const std::uint32_t a = net.add_body();
    const std::uint32_t b = net.add_body();
    const std::uint32_t c = net.add_body();
    net.join(a, b, 2);
    net.join(c, b, 2);
    EXPECT_FALSE(net.plan().has_loop);
    net.join(0, c, 2);
    EXPECT_FALSE(net.plan().has_loop) << "held in one place";
    Net held = net;
    held.join(a, 0, 1);
    EXPECT_TRUE(held.plan().has_loop) << "held in two";
    net.join(a, c, 1);
    EXPECT_TRUE(net.plan().has_loop) << "a ring";
}

} // namespace carom::detail
