// How arguments are drawn, and their limits.
#include "tests/fuzz/random_arguments.hpp"

#include <algorithm>
#include <cmath>

namespace carom::fuzz
{

float RandomArguments::unjudged(float min, float max)
{
    return random.one_in(60) ? nasty[static_cast<std::size_t>(random.below(static_cast<int>(nasty.size())))] : random.from(min, max);
}

float RandomArguments::number(float min, float max, Limits good)
{
    const float value = unjudged(min, max);
    expect(value >= good.least && value <= good.most); // false for NaN
    return value;
}

Vec2 RandomArguments::vector(float size, Limits good) { return {number(-size, size, good), number(-size, size, good)}; }

Transform RandomArguments::transform()
{
    const Vec2 p = vector(15);
    if (!random.one_in(40)) return {p, rotation(random.from(-4, 4))};
    const Rot q = {unjudged(-2, 2), 0};
    expect(std::abs(q.c * q.c - 1) < 1e-3f);
    doubt(std::abs(q.c * q.c - 1) < 2e-3f);
    return {p, q};
}

// ---- shapes ----

Geometry RandomArguments::circle_by_hand()
{
    const Vec2 center = vector(1);
    return Circle{center, number(0.01f, 2, radius)};
}

void RandomArguments::judge_ends(Vec2 p1, Vec2 p2)
{
    const double apart = std::hypot(double{p2.x} - double{p1.x}, double{p2.y} - double{p1.y});
    expect(!(apart < 0.00099)); // NaN is judged elsewhere
    doubt(apart < 0.00101);
}

/// A thin capsule has an area for long, by its length.
float RandomArguments::capsule_radius(float min, float max)
{
    const float value = number(min, max, {1e-38f, max_coordinate});
    doubt(value < radius.least);
    return value;
}

Geometry RandomArguments::capsule_by_hand(float size)
{
    const Capsule capsule = {vector(size), vector(size), capsule_radius(0.01f, 1)};
    judge_ends(capsule.p1, capsule.p2);
    return capsule;
}

Geometry RandomArguments::rounded()
{
    const Limits side = {0.001f, max_coordinate};
    const float width = number(0.1f, 3, side);
    const float height = number(0.1f, 3, side);
    const float rounding = number(0, 0.05f, {0, max_coordinate});
    const float spare = std::min(width, height) / 2 - rounding;
    expect(!(spare < 0.49e-3f));
    doubt(spare < 0.51e-3f);
    return rounded_box(width, height, rounding);
}

Geometry RandomArguments::offset()
{
    const Limits side = {0.001f, max_coordinate};
    const float width = number(0.01f, 3, side);
    const float height = number(0.01f, 3, side);
    const Vec2 center = vector(2);
    const float angle = number(-9, 9, finite);
    doubt(std::max({std::abs(width), std::abs(height), std::abs(center.x), std::abs(center.y)}) > 10); // rounding may spoil a thin box
    return offset_box(width, height, center, angle);
}

/// As a rule wrong.
Geometry RandomArguments::polygon_by_hand()
{
    is_by_hand_ = true;
    Polygon polygon = box(1, 1);
    polygon.count = random.one_in(2) ? 4 : random.below(20) - 5;
    expect(polygon.count == 4); // the other corners are at the middle, and of three corners a normal is wrong
    polygon.radius = number(0, 1, {0, max_coordinate});
    if (!random.one_in(2)) return polygon;
    const std::size_t moved = static_cast<std::size_t>(random.below(8));
    const Vec2 before = polygon.vertices[moved];
    polygon.vertices[moved] = {unjudged(-2, 2), unjudged(-2, 2)};
    if (moved >= 4) return polygon; // not in use
    expect(distance(polygon.vertices[moved], before) < 0.01f);
    doubt();
    return polygon;
}

Geometry RandomArguments::hull()
{
    std::vector<Vec2> points;
    const int count = random.below(10);
    expect(count >= 3);
    doubt(); // points may be too near, or nearly on a line
    for (int i = 0; i < count; ++i) points.push_back(vector(2));
    if (random.one_in(10))
    {
        for (Vec2& p : points) p.y = 0; // on a line
        expect(false);
    }
    const float rounding = random.one_in(3) ? number(0, 0.3f, {0, max_coordinate}) : 0.0f;
    const Polygon made = convex_hull(points, rounding);
    return transformed(made, {vector(1), rotation(random.from(-4, 4))});
}

Geometry RandomArguments::geometry()
{
    const Limits side = {0.001f, max_coordinate};
    is_by_hand_ = false;
    switch (random.below(8))
    {
    case 0: is_by_hand_ = true; return circle_by_hand();
    case 1: is_by_hand_ = true; return capsule_by_hand();
    case 2:
    {
        is_by_hand_ = true;
        const Segment segment = {vector(5), vector(5)};
        judge_ends(segment.p1, segment.p2);
        return segment;
    }
    case 3:
    {
        const float width = number(0.01f, 3, side);
        return box(width, number(0.01f, 3, side));
    }
    case 4: return rounded();
    case 5: return offset();
    case 6: return polygon_by_hand();
    default: return hull();
    }
}

Material RandomArguments::material()
{
    return {number(0, 1, rate), number(0, 1, share), number(0, 0.1f, rate), number(-1, 1, speed), random.bits()};
}

void RandomArguments::judge_density(const Geometry& geometry, float density)
{
    expect(density >= 0 && density <= finite.most);
    if (verdict() == Verdict::Refuse || density == 0 || std::holds_alternative<Segment>(geometry)) return;
    if (verdict() == Verdict::Either && is_by_hand_) return; // may be no shape at all
    const MassData unit = mass_of(geometry, 1);
    const double mass = double{unit.mass} * double{density};
    const double inertia = double{unit.inertia} * double{density};
    expect(mass > 0.99e-12 && mass < 1.01e20 && inertia > 0 && inertia < 1.01e20);
    doubt(mass < 1.01e-12 || mass > 0.99e20 || inertia < 1e-36 || inertia > 0.99e20);
}

ShapeDef RandomArguments::shape_def(const Geometry& geometry)
{
    ShapeDef def;
    def.material = material();
    def.filter = {random.bits() & 3, random.one_in(3) ? random.bits() & 3 : ~std::uint64_t{0}, random.below(5) - 2};
    def.is_sensor = random.one_in(6);
    def.contact_events = !random.one_in(4);
    def.persist_events = random.one_in(4);
    def.sensor_events = !random.one_in(4);
    def.hit_events = random.one_in(3);
    def.pre_solve = random.one_in(3);
    def.density = unjudged(0, 5);
    judge_density(geometry, def.density);
    return def;
}

BodyDef RandomArguments::body_def()
{
    BodyDef def;
    def.type = random.one_in(3) ? one_of<BodyType>(3, 30) : BodyType::Dynamic;
    def.position = vector(15);
    def.angle = number(-10, 10, finite);
    const bool may_move = def.type != BodyType::Static;
    if (may_move || random.one_in(20)) def.linear_velocity = vector(10, speed);
    if (may_move || random.one_in(20)) def.angular_velocity = number(-10, 10, speed);
    expect(may_move || (def.linear_velocity == Vec2{} && def.angular_velocity == 0));
    def.linear_damping = number(0, 1, rate);
    def.angular_damping = number(0, 1, rate);
    def.gravity_scale = number(-1, 2, factor);
    def.locks = {random.one_in(8), random.one_in(8), random.one_in(8)};
    def.can_sleep = !random.one_in(8);
    def.is_bullet = random.one_in(8);
    def.is_attractor = random.one_in(8);
    def.is_enabled = !random.one_in(10);
    def.name = "a body whose name is too long for a short string";
    def.user_data = random.bits();
    return def;
}

QueryFilter RandomArguments::query_filter(BodyId ignored)
{
    return {.filter = {random.bits() & 3, random.one_in(3) ? random.bits() & 3 : ~std::uint64_t{0}, random.below(5) - 2},
            .sensors = random.one_in(3),
            .ignored_body = ignored};
}

// ---- fields and joints ----

Field RandomArguments::field()
{
    switch (random.below(3))
    {
    case 0: return UniformField{vector(5, factor)};
    case 1: return PointField{vector(10), number(-50, 50, strength), number(0, 1, {0, max_coordinate})};
    default:
        return NBodyField{number(-1, 1, strength), number(0, 1, {0, max_coordinate}), one_of<NBodyMethod>(2, 30),
                          one_of<NBodySources>(2, 30), number(0, 1.5f, {0, 1.5f})};
    }
}

Spring RandomArguments::spring() { return {number(0, 30, {0, 1e4f}), number(0, 2, rate), number(-1, 1, coordinate)}; }

std::optional<Spring> RandomArguments::maybe_spring() { return random.one_in(2) ? std::nullopt : std::optional(spring()); }

std::optional<Range> RandomArguments::maybe_range(Limits good)
{
    if (random.one_in(2)) return std::nullopt;
    const float lower = number(std::max(-2.0f, good.least), 2, good);
    const float upper = lower + unjudged(-0.1f, 3);
    expect(upper >= lower && upper <= good.most);
    return Range{lower, upper};
}

std::optional<Motor> RandomArguments::maybe_motor()
{
    if (random.one_in(2)) return std::nullopt;
    return Motor{number(-10, 10, speed), number(0, 500, force)};
}

JointSpec RandomArguments::joint_spec()
{
    constexpr Limits turns = {-1e5f, 1e5f};
    switch (random.below(9))
    {
    case 0: return RevoluteJoint{maybe_range(turns), maybe_motor(), maybe_spring()};
    case 1: return PrismaticJoint{maybe_range(coordinate), maybe_motor(), maybe_spring()};
    case 2: return DistanceJoint{number(0.1f, 5, {0.001f, max_coordinate}), maybe_range({0, max_coordinate}), maybe_spring()};
    case 3: return WeldJoint{maybe_spring(), maybe_spring()};
    case 4: return WheelJoint{maybe_spring(), maybe_range(coordinate), maybe_motor()};
    case 5: return MotorJoint{vector(2), number(-3, 3, {-pi, pi}), spring(), number(0, 500, force), number(0, 500, force)};
    case 6: return MouseJoint{vector(10), spring(), number(0, 1000, force)};
    case 7:
    {
        const float ratio = unjudged(-3, 3);
        expect(std::abs(ratio) >= 1e-6f && std::abs(ratio) <= 1e6f);
        return GearJoint{ratio, one_of<GearMotion>(2, 60), one_of<GearMotion>(2, 60)};
    }
    default: return PulleyJoint{vector(15), vector(15), number(0.2f, 3, {1e-6f, 1e6f}), number(1, 30, {0.001f, 2 * max_coordinate})};
    }
}

Transform RandomArguments::frame()
{
    Transform frame = {{unjudged(-3, 3), unjudged(-3, 3)}, rotation(random.from(-3, 3))};
    if (random.one_in(60)) frame.q = {unjudged(-1, 1), unjudged(-1, 1)};
    judge_frame(frame);
    return frame;
}

void RandomArguments::judge_frame(const Transform& frame)
{
    const auto is_near = [](float x) { return std::abs(x) <= max_coordinate; };
    expect(is_near(frame.p.x) && is_near(frame.p.y));
    const float error = std::abs(frame.q.c * frame.q.c + frame.q.s * frame.q.s - 1);
    expect(error < 1.1e-3f);
    doubt(error > 0.9e-3f);
}

float RandomArguments::break_limit(float min, float max)
{
    const float limit = unjudged(min, max);
    expect(limit > 0); // infinity is good
    return limit;
}

} // namespace carom::fuzz
