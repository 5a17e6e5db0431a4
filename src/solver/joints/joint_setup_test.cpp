// Every Jacobian against the finite differences of its error, every curvature against the arc that it stands for. The kernels run in double
// here, so that differences can be taken.
#include "solver/joints/joint_setup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory_resource>
#include <random>
#include <string>
#include <vector>

namespace carom::detail
{

/// One lane of double precision.
struct Double
{
    Double() = default;
    Double(double value) : v(value) {}

    double v;
};

template <>
struct LaneTraits<Double>
{
    static constexpr int width = 1;
    using Mask = bool;
    using Double = detail::Double;
};

Double operator+(Double a, Double b) { return a.v + b.v; }
Double operator-(Double a, Double b) { return a.v - b.v; }
Double operator*(Double a, Double b) { return a.v * b.v; }
Double operator/(Double a, Double b) { return a.v / b.v; }
Double operator-(Double a) { return -a.v; }
bool operator>(Double a, Double b) { return a.v > b.v; }
bool operator<(Double a, Double b) { return a.v < b.v; }
Double select(bool mask, Double yes, Double no) { return mask ? yes : no; }
Double lane_max(Double a, Double b) { return a.v > b.v ? a : b; }
Double lane_min(Double a, Double b) { return a.v < b.v ? a : b; }
Double lane_sqrt(Double a) { return std::sqrt(a.v); }
Double lane_atan2(Double y, Double x) { return std::atan2(y.v, x.v); }
double& lane(Double& f, int) { return f.v; }
double lane(const Double& f, int) { return f.v; }

namespace
{

using ExactLanes = BodyLanes<Double>;
using ExactRow = JointRow<Double>;

struct Case
{
    std::string name;
    JointSpec spec;
};

const std::vector<Case> cases = {
    {"revolute", RevoluteJoint{.spring = Spring{}}},
    {"prismatic", PrismaticJoint{.spring = Spring{}}},
    {"rod", DistanceJoint{.length = 1.5f}},
    {"rope", DistanceJoint{.limit = Range{0, 2}}},
    {"weld", WeldJoint{}},
    {"weld, soft ways", WeldJoint{.linear = Spring{}}},
    {"weld, soft turns", WeldJoint{.angular = Spring{}}},
    {"wheel", WheelJoint{}},
    {"motor", MotorJoint{.offset = {0.3f, -0.2f}, .angle = 0.4f, .max_force = 10, .max_torque = 10}},
    {"mouse", MouseJoint{.target = {1, 2}, .max_force = 10}},
    {"gear", GearJoint{.ratio = -1.7f}},
    {"rack", GearJoint{.ratio = 0.6f, .motion_b = GearMotion::Slide}},
    {"two racks", GearJoint{.ratio = 2, .motion_a = GearMotion::Slide, .motion_b = GearMotion::Slide}},
    {"pulley", PulleyJoint{.ground_a = {-3, 6}, .ground_b = {4, 7}, .ratio = 1.3f, .length = 12}},
};

/// A joint between two bodies that stand anyhow, and how far they have come in the step.
struct RandomJoint
{
    RandomJoint(const JointSpec& spec, unsigned seed) : engine(seed)
    {
        for (int i = 0; i < 2; ++i)
            bodies.create({.position = {from(-2, 2), from(-2, 2)}, .angle = from(-3, 3), .angular_velocity = from(-1, 1)});
        for (std::uint32_t i = 0; i < 2; ++i)
        {
            // Centres of mass beside the origins.
            bodies.poses[i].local_center = {from(-0.5f, 0.5f), from(-0.5f, 0.5f)};
            bodies.poses[i].center = bodies.poses[i].transform * bodies.poses[i].local_center;
            bodies.masses[bodies.motion_index[i]] = {Vec2{1, 1} * from(0.3f, 3), from(0.3f, 3)};
        }
        Joint joint;
        const bool has_a = !std::holds_alternative<MouseJoint>(spec);
        joint.body_a = has_a ? 0 : null_index;
        joint.body_b = 1;
        joint.spec = spec;
        joint.frame_a = {{from(-1, 1), from(-1, 1)}, rotation(from(-3, 3))};
        joint.frame_b = {{from(-1, 1), from(-1, 1)}, rotation(from(-3, 3))};
        joint.gear_slip = from(-0.1f, 0.1f);
        std::vector<float> stiffness(bodies.masses.size());
        fill_row(start_row<Double>(&row, spec), 0, 0, joint, bodies, make_joint_constants({}, 1 / 240.0f, 1 / 240.0f), stiffness);
        row.turn = lane_atan2(row.facing.s, row.facing.c);

        a = has_a ? place() : ExactLanes{{}, 0, {}, {1, 0}};
        b = place();
        // An axis of a slide is taken as fixed over a step.
        const auto* gear = std::get_if<GearJoint>(&spec);
        if (gear && gear->motion_a == GearMotion::Slide) a.dq = {1, 0};
        if (gear && gear->motion_b == GearMotion::Slide) b.dq = {1, 0};
    }

    float from(float min, float max) { return std::uniform_real_distribution<float>(min, max)(engine); }

    ExactLanes place()
    {
        const double turn = double{from(-0.5f, 0.5f)};
        return {{from(-1, 1), from(-1, 1)}, from(-4, 4), {from(-0.3f, 0.3f), from(-0.3f, 0.3f)}, {std::cos(turn), std::sin(turn)}};
    }

    std::mt19937 engine;
    BodyStore bodies{*std::pmr::new_delete_resource()};
    ExactRow row = {};
    ExactLanes a = {};
    ExactLanes b = {};
};

/// Where a body is after a time.
ExactLanes after(const ExactLanes& body, double t)
{
    ExactLanes out = body;
    const double turn = t * body.w.v;
    out.dp = body.dp + body.v * Double(t);
    out.dq = {std::cos(turn) * body.dq.c.v - std::sin(turn) * body.dq.s.v, std::sin(turn) * body.dq.c.v + std::cos(turn) * body.dq.s.v};
    return out;
}

/// What a joint holds, measures and drives, in one list.
struct Quantity
{
    std::string name;
    double value;
    double rate; ///< as the Jacobian says
    double curvature;
};

std::vector<Quantity> quantities(ExactRow row, const ExactLanes& a, const ExactLanes& b, const JointConstants<Double>& k)
{
    linearise(row, a, b);
    for (Double& f : row.curvature) f = 0;
    bend(row, a, b, k);
    std::vector<Quantity> all;
    for (std::size_t i = 0; i < row.rigid_count; ++i)
        all.push_back({"rigid " + std::to_string(i), row.error[i].v, velocity(row.rigid[i], a, b).v, row.curvature[i].v});
    for (std::size_t i = 0; i < row.control_count; ++i)
        all.push_back(
            {"control " + std::to_string(i), row.controls[i].q.v, velocity(row.controls[i].j, a, b).v, row.controls[i].curvature.v});
    return all;
}

const JointConstants<Double> exact_constants = {1 / 240.0, 240, 50, 0.9, 0.1, 1.0};

void for_each_random_joint(const std::function<void(const Case&, RandomJoint&)>& visit)
{
    for (const Case& c : cases)
        for (unsigned seed = 0; seed < 100; ++seed)
        {
            RandomJoint joint(c.spec, seed);
            visit(c, joint);
            if (testing::Test::HasFatalFailure()) return;
        }
}

} // namespace

TEST(JointKernels, JacobiansAreTheRatesOfWhatTheyHold)
{
    for_each_random_joint([](const Case& c, RandomJoint& joint)
    {
        const double t = 1e-6;
        const auto now = quantities(joint.row, joint.a, joint.b, exact_constants);
        const auto before = quantities(joint.row, after(joint.a, -t), after(joint.b, -t), exact_constants);
        const auto later = quantities(joint.row, after(joint.a, t), after(joint.b, t), exact_constants);
        for (std::size_t i = 0; i < now.size(); ++i)
            ASSERT_NEAR((later[i].value - before[i].value) / (2 * t), now[i].rate, 1e-6 * (1 + std::abs(now[i].rate)))
                << c.name << ", " << now[i].name;
    });
}

TEST(JointKernels, CurvatureIsWhatAnArcAddsOverASubstep)
{
    for_each_random_joint([](const Case& c, RandomJoint& joint)
    {
        const double h = exact_constants.h.v;
        const auto now = quantities(joint.row, joint.a, joint.b, exact_constants);
        const auto later = quantities(joint.row, after(joint.a, h), after(joint.b, h), exact_constants);
        for (std::size_t i = 0; i < now.size(); ++i)
        {
            const double missing = (later[i].value - now[i].value) / h - now[i].rate;
            ASSERT_NEAR(now[i].curvature, missing, 1e-7 + 1e-5 * std::abs(missing)) << c.name << ", " << now[i].name;
        }
    });
}

TEST(JointKernels, CurvatureFadesOutWhereASubstepTurnsTooFar)
{
    RandomJoint joint(RevoluteJoint{}, 3);
    const auto curvature = [&](double w_a, double w_b)
    {
        joint.a.w = w_a;
        joint.b.w = w_b;
        return quantities(joint.row, joint.a, joint.b, exact_constants)[0].curvature;
    };
    EXPECT_NE(curvature(0, 16), 0);
    EXPECT_NE(curvature(20, 24), 0) << "turning together is no fold";
    EXPECT_EQ(curvature(0, 34), 0);
    EXPECT_EQ(curvature(-20, 14), 0);
    EXPECT_EQ(curvature(200, 200), 0);
    for (const double w : {1e3, 1e6, 1e12, 1e20}) EXPECT_EQ(curvature(w, -w), 0) << w;
}

TEST(JointKernels, DrivesMeasureWhereThePointIsPastItsPlace)
{
    for (unsigned seed = 0; seed < 50; ++seed)
    {
        RandomJoint motor(cases[8].spec, seed);
        linearise(motor.row, motor.a, motor.b);
        // Move B by what is missing, and nothing is.
        motor.b.dp = motor.b.dp - motor.row.drive.error;
        linearise(motor.row, motor.a, motor.b);
        EXPECT_NEAR(motor.row.drive.error.x.v, 0, 1e-12);
        EXPECT_NEAR(motor.row.drive.error.y.v, 0, 1e-12);

        RandomJoint mouse(MouseJoint{.target = {1, 2}, .max_force = 10}, seed);
        linearise(mouse.row, mouse.a, mouse.b);
        const LaneVec<Double> from_center = mouse.row.r_b;
        const double x = double{mouse.bodies.poses[1].center.x} + mouse.b.dp.x.v + from_center.x.v;
        const double y = double{mouse.bodies.poses[1].center.y} + mouse.b.dp.y.v + from_center.y.v;
        EXPECT_NEAR(mouse.row.drive.error.x.v, x - 1, 1e-5);
        EXPECT_NEAR(mouse.row.drive.error.y.v, y - 2, 1e-5);
    }
}

TEST(JointKernels, AVanishedLengthHasADirectionAllTheSame)
{
    RandomJoint joint(DistanceJoint{.length = 1}, 1);
    joint.a = joint.b = {{}, 0, {}, {1, 0}};
    joint.row.apart = {};
    linearise(joint.row, joint.a, joint.b);
    EXPECT_NEAR(dot(joint.row.rigid[0].l_b, joint.row.rigid[0].l_b).v, 1, 1e-6);
    EXPECT_NEAR(joint.row.error[0].v, -1, 1e-12);
    bend(joint.row, joint.a, joint.b, exact_constants);
    EXPECT_EQ(joint.row.curvature[0].v, 0);
}

TEST(JointSetup, EveryShapeOfRowHasAKeyOfItsOwnAndOneTypeHasOneOrder)
{
    for (const Case& c : cases)
    {
        const JointShape shape = shape_of(c.spec);
        ExactRow memory;
        const ExactRow& row = start_row<Double>(&memory, c.spec);
        EXPECT_EQ(row.rigid_count, shape.rigid) << c.name;
        EXPECT_EQ(row.control_count, shape.controls) << c.name;
        EXPECT_EQ(row.has_drive, shape.has_drive) << c.name;
        EXPECT_LE(shape.rigid, most_rigid);
        EXPECT_LE(shape.controls, most_controls);
        for (const Case& other : cases)
        {
            const JointShape s = shape_of(other.spec);
            const bool is_same =
                s.rigid == shape.rigid && s.controls == shape.controls && s.has_drive == shape.has_drive && s.has_ends == shape.has_ends;
            EXPECT_EQ(s.key() == shape.key(), is_same) << c.name << ", " << other.name;
        }
    }
}

TEST(JointSetup, ATightLinkIsSeenWithTheInertiaThatASubstepCanFollow)
{
    EXPECT_EQ(steady_inv_inertia(2, 0, 0.01f, 1), 2);
    EXPECT_EQ(steady_inv_inertia(2, -50, 0.01f, 1), 2) << "pressed, not pulled";
    EXPECT_EQ(steady_inv_inertia(2, 100, 0.01f, 1), 2) << "slow enough";
    EXPECT_NEAR(steady_inv_inertia(2, 1e6f, 0.01f, 1), 0.01f, 1e-6) << "swings at 1 / h";
    EXPECT_NEAR(steady_inv_inertia(2, 1e6f, 0.01f, 0.5f), 0.0025f, 1e-6) << "swings at 0.5 / h";
    EXPECT_EQ(steady_inv_inertia(0, 1e6f, 0.01f, 1), 0) << "does not turn at all";
}

} // namespace carom::detail
