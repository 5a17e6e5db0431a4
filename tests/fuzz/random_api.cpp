// The calls, with nasty numbers, stale names and bad moments among them.
#include "tests/fuzz/random_api.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace carom::fuzz
{

namespace
{

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr std::array nasty = {nan,
                              inf,
                              -inf,
                              0.0f,
                              -0.0f,
                              -1.0f,
                              1e30f,
                              -1e30f,
                              1e-30f,
                              1e-40f,
                              1e7f,
                              1e6f,
                              std::numeric_limits<float>::max(),
                              std::numeric_limits<float>::lowest()};
constexpr int most_bodies = 150;
constexpr int most_joints = 120;

void expect_complete(const UsageError& error, const char* function)
{
    EXPECT_EQ(error.function(), function);
    EXPECT_FALSE(error.field().empty()) << error.what();
    EXPECT_FALSE(error.value().empty()) << error.what();
    EXPECT_FALSE(error.remedy().empty()) << error.what();
    EXPECT_EQ(std::string(error.what()), error.function() + ": " + error.field() + " is " + error.value() + "; " + error.remedy());
}

} // namespace

float RandomHooks::nonsense(float sense)
{
    return random_.one_in(8) ? nasty[static_cast<std::size_t>(random_.below(static_cast<int>(nasty.size())))] : sense;
}

void RandomHooks::try_to_edit()
{
    ++calls;
    if (!random_.one_in(20)) return;
    try
    {
        world->set_gravity({});
        ADD_FAILURE() << "a hook was allowed to edit the world";
    }
    catch (const UsageError& error)
    {
        ++refused;
        expect_complete(error, "set_gravity");
    }
}

bool RandomHooks::should_collide(ShapeId a, ShapeId b)
{
    try_to_edit();
    EXPECT_TRUE(world->find_shape(a) && world->find_shape(b));
    return !random_.one_in(10);
}

float RandomHooks::mix_friction(const Material&, const Material&, float mixed)
{
    try_to_edit();
    return nonsense(mixed);
}

float RandomHooks::mix_restitution(const Material&, const Material&, float mixed)
{
    try_to_edit();
    return nonsense(mixed);
}

void RandomHooks::pre_solve(PreSolve& contact)
{
    try_to_edit();
    EXPECT_GT(contact.manifold.point_count, 0);
    EXPECT_NEAR(length(contact.manifold.normal), 1, 1e-3);
    contact.is_enabled = !random_.one_in(5);
    contact.friction = nonsense(contact.friction);
    contact.restitution = nonsense(contact.restitution);
    contact.rolling_resistance = nonsense(contact.rolling_resistance);
    contact.tangent_speed = nonsense(contact.tangent_speed);
}

RandomApi::RandomApi(std::uint64_t seed) : random_(seed), hooks_(seed + 1000), world_({.memory = &hook_}), character_(CharacterDef{})
{
    hooks_.world = &world_;
    foreign_ = other_.create_body({});
}

Tally RandomApi::tally() const
{
    Tally tally = tally_;
    tally.hook_calls = hooks_.calls;
    return tally;
}

float RandomApi::number(float min, float max)
{
    return random_.one_in(60) ? nasty[static_cast<std::size_t>(random_.below(static_cast<int>(nasty.size())))] : random_.from(min, max);
}

Vec2 RandomApi::vector(float size) { return {number(-size, size), number(-size, size)}; }

Geometry RandomApi::geometry()
{
    switch (random_.below(8))
    {
    case 0: return Circle{vector(1), number(0.01f, 2)};
    case 1: return Capsule{vector(2), vector(2), number(0.01f, 1)};
    case 2: return Segment{vector(5), vector(5)};
    case 3: return box(number(0.01f, 3), number(0.01f, 3));
    case 4: return rounded_box(number(0.1f, 3), number(0.1f, 3), number(0, 0.05f));
    case 5: return offset_box(number(0.01f, 3), number(0.01f, 3), vector(2), number(-9, 9));
    case 6:
    {
        // By hand, and as a rule wrong.
        Polygon polygon = box(1, 1);
        polygon.count = random_.one_in(2) ? 4 : random_.below(20) - 5;
        polygon.radius = number(0, 1);
        if (random_.one_in(2)) polygon.vertices[static_cast<std::size_t>(random_.below(8))] = vector(2);
        return polygon;
    }
    default:
    {
        std::vector<Vec2> points;
        const int count = random_.below(10);
        for (int i = 0; i < count; ++i) points.push_back(vector(2));
        if (random_.one_in(10))
            for (Vec2& p : points) p.y = 0; // on a line
        return transformed(convex_hull(points, random_.one_in(3) ? number(0, 0.3f) : 0.0f), {vector(1), rotation(random_.from(-4, 4))});
    }
    }
}

BodyDef RandomApi::body_def()
{
    BodyDef def;
    def.type = random_.one_in(100) ? static_cast<BodyType>(7) : static_cast<BodyType>(random_.one_in(3) ? random_.below(3) : 2);
    def.position = vector(15);
    def.angle = number(-10, 10);
    if (def.type != BodyType::Static || random_.one_in(20)) def.linear_velocity = vector(10);
    if (def.type != BodyType::Static || random_.one_in(20)) def.angular_velocity = number(-10, 10);
    def.linear_damping = number(0, 1);
    def.angular_damping = number(0, 1);
    def.gravity_scale = number(-1, 2);
    def.locks = {random_.one_in(8), random_.one_in(8), random_.one_in(8)};
    def.is_attractor = random_.one_in(8);
    def.is_enabled = !random_.one_in(10);
    def.name = "a body whose name is too long for a short string";
    return def;
}

ShapeDef RandomApi::shape_def()
{
    ShapeDef def;
    def.density = number(0, 5);
    def.material = {number(0, 1), number(0, 1), number(0, 0.1f), number(-1, 1), 0};
    def.filter = {random_.bits() & 3, random_.one_in(3) ? random_.bits() & 3 : ~std::uint64_t{0}, random_.below(5) - 2};
    def.is_sensor = random_.one_in(6);
    def.contact_events = !random_.one_in(4);
    def.persist_events = random_.one_in(4);
    def.sensor_events = !random_.one_in(4);
    def.hit_events = random_.one_in(3);
    def.pre_solve = random_.one_in(3);
    return def;
}

Field RandomApi::field()
{
    switch (random_.below(3))
    {
    case 0: return UniformField{vector(5)};
    case 1: return PointField{vector(10), number(-50, 50), number(0, 1)};
    default:
        return NBodyField{number(-1, 1), number(0, 1), static_cast<NBodyMethod>(random_.one_in(30) ? 9 : random_.below(2)),
                          static_cast<NBodySources>(random_.one_in(30) ? -1 : random_.below(2)), number(0, 1.5f)};
    }
}

std::optional<Spring> RandomApi::spring()
{
    if (random_.one_in(2)) return std::nullopt;
    return Spring{number(0, 30), number(0, 2), number(-1, 1)};
}

std::optional<Range> RandomApi::range()
{
    if (random_.one_in(2)) return std::nullopt;
    const float lower = number(-2, 2);
    return Range{lower, lower + number(-0.1f, 3)};
}

std::optional<Motor> RandomApi::motor()
{
    if (random_.one_in(2)) return std::nullopt;
    return Motor{number(-10, 10), number(0, 500)};
}

JointSpec RandomApi::joint_spec()
{
    const auto motion = [this] { return static_cast<GearMotion>(random_.one_in(60) ? 7 : random_.below(2)); };
    const Spring some{number(0, 20), number(0, 2), number(-1, 1)};
    switch (random_.below(9))
    {
    case 0: return RevoluteJoint{range(), motor(), spring()};
    case 1: return PrismaticJoint{range(), motor(), spring()};
    case 2: return DistanceJoint{number(0.1f, 5), range(), spring()};
    case 3: return WeldJoint{spring(), spring()};
    case 4: return WheelJoint{spring(), range(), motor()};
    case 5: return MotorJoint{vector(2), number(-3, 3), some, number(0, 500), number(0, 500)};
    case 6: return MouseJoint{vector(10), some, number(0, 1000)};
    case 7: return GearJoint{number(-3, 3), motion(), motion()};
    default: return PulleyJoint{vector(15), vector(15), number(0.2f, 3), number(1, 30)};
    }
}

JointDef RandomApi::joint_def()
{
    JointDef def;
    def.body_a = random_.one_in(3) ? BodyId{} : body_id();
    def.body_b = body_id();
    // As often as not the two meet where the bodies are.
    const std::optional<Body> end = world_.find_body(def.body_b);
    const bool is_near = end && std::abs(end->position().x) < max_coordinate && std::abs(end->position().y) < max_coordinate;
    if (random_.one_in(2) && is_near && (!def.body_a || world_.find_body(def.body_a)))
        def = world_.joint_at(def.body_a, def.body_b, world_.body(def.body_b).position(), random_.from(-3, 3));
    else
        def.frame_a = {vector(3), rotation(random_.from(-3, 3))}, def.frame_b = {vector(3), rotation(random_.from(-3, 3))};
    if (random_.one_in(60)) def.frame_a.q = {number(-1, 1), number(-1, 1)};
    def.collide_connected = random_.one_in(2);
    if (random_.one_in(4)) def.break_force = number(0, 2000);
    if (random_.one_in(4)) def.break_torque = number(0, 2000);
    def.user_data = random_.bits();
    return def;
}

JointId RandomApi::joint_id()
{
    if (random_.one_in(60)) return {static_cast<std::uint32_t>(random_.bits()), 1, bodies_.empty() ? 1 : bodies_[0].world};
    if (joints_.empty() || random_.one_in(60)) return {};
    return joints_[static_cast<std::size_t>(random_.below(static_cast<int>(joints_.size())))];
}

BodyId RandomApi::body_id()
{
    if (random_.one_in(40)) return foreign_;
    if (bodies_.empty() || random_.one_in(60)) return {};
    return bodies_[static_cast<std::size_t>(random_.below(static_cast<int>(bodies_.size())))];
}

ShapeId RandomApi::shape_id()
{
    if (random_.one_in(60)) return {static_cast<std::uint32_t>(random_.bits()), 1, bodies_.empty() ? 1 : bodies_[0].world};
    if (shapes_.empty() || random_.one_in(60)) return {};
    return shapes_[static_cast<std::size_t>(random_.below(static_cast<int>(shapes_.size())))];
}

FieldId RandomApi::field_id()
{
    if (fields_.empty() || random_.one_in(10)) return {};
    return fields_[static_cast<std::size_t>(random_.below(static_cast<int>(fields_.size())))];
}

ChainId RandomApi::chain_id()
{
    if (chains_.empty() || random_.one_in(20)) return {};
    return chains_[static_cast<std::size_t>(random_.below(static_cast<int>(chains_.size())))];
}

template <class Call>
void RandomApi::try_call(const char* function, Call&& call)
{
    ++tally_.calls;
    const std::uint64_t before = world_.hash();
    try
    {
        call();
    }
    catch (const UsageError& error)
    {
        ++tally_.refused;
        expect_complete(error, function);
        EXPECT_EQ(world_.hash(), before) << "a refused call changed the world: " << error.what();
    }
}

void RandomApi::create()
{
    std::optional<Geometry> shape;
    try
    {
        ++tally_.calls;
        shape = geometry();
    }
    catch (const UsageError& error)
    {
        ++tally_.refused;
        expect_complete(error, error.function().c_str());
        return;
    }
    const bool is_full = world_.body_count() >= most_bodies;
    if (is_full || random_.one_in(3))
        try_call("create_shape", [&] { shapes_.push_back(world_.create_shape(body_id(), *shape, shape_def())); });
    else
        try_call("create_body", [&]
        {
            bodies_.push_back(random_.one_in(10) ? world_.create_body(body_def()) : world_.create_body(body_def(), *shape, shape_def()));
            for (const ShapeId id : world_.body(bodies_.back()).shapes()) shapes_.push_back(id);
        });
    tally_.most_bodies = std::max(tally_.most_bodies, world_.body_count());
}

void RandomApi::destroy()
{
    if (random_.one_in(2))
        try_call("destroy_shape", [&] { world_.destroy_shape(shape_id()); });
    else
        try_call("destroy_body", [&] { world_.destroy_body(body_id()); });
}

void RandomApi::edit_body()
{
    const std::optional<Body> found = world_.find_body(body_id());
    if (!found) return;
    Body body = *found;
    switch (random_.below(14))
    {
    case 0:
        return try_call("set_type",
                        [&] { body.set_type(random_.one_in(20) ? static_cast<BodyType>(-1) : static_cast<BodyType>(random_.below(3))); });
    case 1: return try_call("set_transform", [&] { body.set_transform(vector(15), number(-10, 10)); });
    case 2: return try_call("set_linear_velocity", [&] { body.set_linear_velocity(vector(20)); });
    case 3: return try_call("set_angular_velocity", [&] { body.set_angular_velocity(number(-20, 20)); });
    case 4: return try_call("set_linear_damping", [&] { body.set_linear_damping(number(0, 1)); });
    case 5: return try_call("set_angular_damping", [&] { body.set_angular_damping(number(0, 1)); });
    case 6: return try_call("set_gravity_scale", [&] { body.set_gravity_scale(number(-1, 1)); });
    case 7: return try_call("set_locks", [&] { body.set_locks({random_.one_in(2), random_.one_in(2), random_.one_in(2)}); });
    case 8: return try_call("set_is_attractor", [&] { body.set_is_attractor(random_.one_in(2)); });
    case 9: return try_call("set_enabled", [&] { body.set_enabled(!random_.one_in(3)); });
    case 10: return try_call("set_mass_data", [&] { body.set_mass_data({number(0, 10), vector(1), number(0, 10)}); });
    case 11: return try_call("reset_mass_data", [&] { body.reset_mass_data(); });
    case 12: return try_call("set_name", [&] { body.set_name("another name that is too long for a short string"); });
    default: return try_call("set_user_data", [&] { body.set_user_data(random_.bits()); });
    }
}

void RandomApi::push_body()
{
    const std::optional<Body> found = world_.find_body(body_id());
    if (!found) return;
    Body body = *found;
    switch (random_.below(6))
    {
    case 0: return try_call("apply_force", [&] { body.apply_force(vector(100), vector(10)); });
    case 1: return try_call("apply_force_to_center", [&] { body.apply_force_to_center(vector(100)); });
    case 2: return try_call("apply_torque", [&] { body.apply_torque(number(-50, 50)); });
    case 3: return try_call("apply_impulse", [&] { body.apply_impulse(vector(10), vector(10)); });
    case 4: return try_call("apply_impulse_to_center", [&] { body.apply_impulse_to_center(vector(10)); });
    default: return try_call("apply_angular_impulse", [&] { body.apply_angular_impulse(number(-5, 5)); });
    }
}

void RandomApi::edit_shape()
{
    const std::optional<Shape> found = world_.find_shape(shape_id());
    if (!found) return;
    Shape shape = *found;
    switch (random_.below(7))
    {
    case 5: return try_call("set_hit_events", [&] { shape.set_hit_events(random_.one_in(2)); });
    case 6: return try_call("set_pre_solve", [&] { shape.set_pre_solve(random_.one_in(2)); });
    case 0: return try_call("set_material", [&] { shape.set_material(shape_def().material); });
    case 1: return try_call("set_filter", [&] { shape.set_filter(shape_def().filter); });
    case 2: return try_call("set_geometry", [&] { shape.set_geometry(Circle{vector(1), number(0.1f, 2)}); });
    case 3: return try_call("set_density", [&] { shape.set_density(number(0, 5)); });
    default: return try_call("set_user_data", [&] { shape.set_user_data(random_.bits()); });
    }
}

void RandomApi::make_chain()
{
    std::vector<Vec2> points;
    const int count = random_.one_in(20) ? random_.below(3) : 2 + random_.below(12);
    Vec2 point = vector(5);
    for (int i = 0; i < count; ++i)
    {
        points.push_back(point);
        point += Vec2{number(0.1f, 2), number(-1, 1)};
    }
    std::vector<Material> materials;
    const int material_count = random_.one_in(2) ? 0 : random_.one_in(2) ? 1 : random_.below(count + 1);
    for (int i = 0; i < material_count; ++i) materials.push_back(shape_def().material);
    const ShapeDef flags = shape_def();
    try_call("create_chain", [&]
    {
        const ChainSides sides = random_.one_in(40) ? static_cast<ChainSides>(3) : static_cast<ChainSides>(random_.below(2));
        chains_.push_back(world_.create_chain(body_id(), {.points = points,
                                                          .is_loop = random_.one_in(3),
                                                          .sides = sides,
                                                          .materials = materials,
                                                          .filter = flags.filter,
                                                          .hit_events = flags.hit_events,
                                                          .pre_solve = flags.pre_solve}));
        tally_.most_chains =
            std::max(tally_.most_chains,
                     static_cast<int>(std::ranges::count_if(chains_, [&](ChainId id) { return world_.find_chain(id).has_value(); })));
        const std::vector<ShapeId> segments = world_.chain(chains_.back()).segments();
        shapes_.push_back(segments.front()); // to be edited, and refused, as shapes
        shapes_.push_back(segments.back());
    });
}

void RandomApi::edit_chain()
{
    if (random_.one_in(4)) return try_call("destroy_chain", [&] { world_.destroy_chain(chain_id()); });
    const std::optional<Chain> found = world_.find_chain(chain_id());
    if (!found) return;
    Chain chain = *found;
    EXPECT_EQ(chain.segments().size(), static_cast<std::size_t>(chain.segment_count()));
    for (const ShapeId id : chain.segments())
    {
        EXPECT_EQ(world_.shape(id).chain(), chain.id());
        EXPECT_EQ(world_.shape(id).body(), chain.body());
    }
    switch (random_.below(4))
    {
    case 0: return try_call("set_material", [&] { chain.set_material(shape_def().material); });
    case 1: return try_call("set_material", [&] { chain.set_material(random_.below(16) - 1, shape_def().material); });
    case 2: return try_call("set_filter", [&] { chain.set_filter(shape_def().filter); });
    default: return try_call("set_user_data", [&] { chain.set_user_data(random_.bits()); });
    }
}

void RandomApi::edit_rules()
{
    switch (random_.below(3))
    {
    case 0:
        return try_call("set_mixing", [&] { world_.set_mixing({static_cast<Mix>(random_.below(6)), static_cast<Mix>(random_.below(5))}); });
    case 1: return try_call("set_hit_speed", [&] { world_.set_hit_speed(number(0, 5)); });
    default: return try_call("set_hooks", [&] { world_.set_hooks(random_.one_in(2) ? &hooks_ : nullptr); });
    }
}

void RandomApi::create_joint()
{
    if (world_.joint_count() >= most_joints) return try_call("destroy_joint", [&] { world_.destroy_joint(joint_id()); });
    try_call("create_joint", [&] { joints_.push_back(world_.create_joint(joint_def(), joint_spec())); });
    tally_.most_joints = std::max(tally_.most_joints, world_.joint_count());
}

void RandomApi::edit_joint()
{
    if (random_.one_in(8)) return try_call("destroy_joint", [&] { world_.destroy_joint(joint_id()); });
    const std::optional<Joint> found = world_.find_joint(joint_id());
    if (!found) return;
    Joint joint = *found;
    switch (random_.below(6))
    {
    case 0:
    case 1:
        return try_call("set_spec", [&]
        {
            // Of the joint's own type, or not.
            JointSpec spec = joint_spec();
            for (int i = 0; i < 30 && spec.index() != joint.spec().index(); ++i) spec = joint_spec();
            joint.set_spec(spec);
        });
    case 2:
        return try_call("set_frames", [&]
        { joint.set_frames({vector(2), rotation(random_.from(-3, 3))}, {vector(2), random_.one_in(20) ? Rot{nan, 1} : Rot{}}); });
    case 3: return try_call("set_collide_connected", [&] { joint.set_collide_connected(random_.one_in(2)); });
    case 4: return try_call("set_break_limits", [&] { joint.set_break_limits(number(100, 1e5f), number(100, 1e5f)); });
    default: return try_call("set_user_data", [&] { joint.set_user_data(random_.bits()); });
    }
}

void RandomApi::edit_world()
{
    switch (random_.below(6))
    {
    case 0: return try_call("set_gravity", [&] { world_.set_gravity(vector(20)); });
    case 1:
        return try_call("add_field", [&]
        {
            if (fields_.size() < 6) fields_.push_back(world_.add_field(field()));
        });
    case 2: return try_call("set_field", [&] { world_.set_field(field_id(), field()); });
    case 3:
        return try_call("remove_field", [&]
        {
            const FieldId id = field_id();
            world_.remove_field(id);
            std::erase(fields_, id);
        });
    case 4:
        return try_call("set_broad_phase", [&]
        {
            const std::uint64_t before = world_.hash();
            world_.set_broad_phase(static_cast<BroadPhaseType>(random_.below(5)),
                                   {random_.one_in(10) ? 99 : random_.below(7), random_.one_in(10) ? 0 : 1 + random_.below(20)});
            EXPECT_EQ(world_.hash(), before);
        });
    default:
        return try_call("set_solver_tuning",
                        [&] { world_.set_solver_tuning({number(10, 60), number(1, 20), number(1, 5), number(0, 2)}); });
    }
}

void RandomApi::read()
{
    const std::optional<BodyView> body = std::as_const(world_).find_body(body_id());
    if (body)
    {
        EXPECT_TRUE(is_finite(body->position()));
        EXPECT_TRUE(is_finite(body->center_of_mass()));
        EXPECT_TRUE(std::isfinite(body->angle()));
        EXPECT_LE(body->bounds().min.x, body->bounds().max.x);
        for (const ShapeId id : body->shapes())
        {
            EXPECT_EQ(world_.shape(id).body(), body->id());
            for (const ShapeId other : world_.shape(id).touching()) EXPECT_TRUE(world_.find_shape(other));
        }
    }
    for (const JointId id : world_.joints())
    {
        const JointView joint = std::as_const(world_).joint(id);
        EXPECT_TRUE(is_finite(joint.force()) && std::isfinite(joint.torque()));
        EXPECT_TRUE(is_finite(joint.offset()) && std::isfinite(joint.angle()) && joint.error() >= 0);
        EXPECT_TRUE(world_.find_body(joint.body_b()));
        EXPECT_TRUE(!joint.body_a() || world_.find_body(joint.body_a()));
    }
    try_call("gravity_at", [&] { world_.gravity_at(vector(20)); });
    try_call("manifold", [&] { world_.manifold(shape_id(), shape_id()); });
    DebugDraw nothing;
    if (random_.one_in(20)) world_.debug_draw(nothing);
}

QueryFilter RandomApi::query_filter()
{
    return {.filter = {random_.bits() & 3, random_.one_in(3) ? random_.bits() & 3 : ~std::uint64_t{0}, random_.below(5) - 2},
            .sensors = random_.one_in(3),
            .ignored_body = body_id()};
}

Transform RandomApi::transform() { return {vector(15), random_.one_in(40) ? Rot{number(-2, 2), 0} : rotation(random_.from(-4, 4))}; }

namespace
{

void expect_sound(const World& world, const CastHit& hit)
{
    EXPECT_EQ(world.shape(hit.shape).body(), hit.body);
    EXPECT_TRUE(hit.fraction >= 0 && hit.fraction <= 1) << hit.fraction;
    EXPECT_TRUE(is_finite(hit.point) && is_finite(hit.normal));
    EXPECT_NEAR(length(hit.normal), hit.starts_inside ? 0 : 1, 1e-3f);
    EXPECT_TRUE(world.body(hit.body).is_enabled());
}

} // namespace

void RandomApi::cast()
{
    const World& world = world_;
    const Vec2 start = vector(20);
    const Vec2 sweep = vector(random_.one_in(4) ? 1000.0f : 20.0f);
    const QueryFilter filter = query_filter();
    const Geometry geometry =
        random_.one_in(2) ? Geometry{Circle{vector(1), number(0.01f, 2)}} : Geometry{Capsule{vector(2), vector(2), number(0.01f, 1)}};
    switch (random_.below(6))
    {
    case 0:
        return try_call("cast_ray", [&]
        {
            const auto hit = world.cast_ray(start, sweep, filter);
            if (hit) expect_sound(world, *hit);
            EXPECT_EQ(world.is_ray_blocked(start, sweep, filter), hit.has_value());
            const std::vector<RayHit> all = world.cast_ray_all(start, sweep, filter);
            ASSERT_EQ(all.empty(), !hit);
            EXPECT_TRUE(!hit || all.front().shape == hit->shape);
        });
    case 1: return try_call("is_ray_blocked", [&] { world.is_ray_blocked(start, sweep, filter); });
    case 2:
        return try_call("cast_ray_all", [&]
        {
            for (const RayHit& hit : world.cast_ray_all(start, sweep, filter)) expect_sound(world, hit);
        });
    case 3:
        return try_call("cast_rays", [&]
        {
            const std::array rays = {Ray{start, sweep}, Ray{sweep, start}};
            std::array<std::optional<RayHit>, 2> hits;
            world.cast_rays(rays, std::span(hits).first(random_.one_in(20) ? 1 : 2), filter);
        });
    case 4:
        return try_call("cast_circle", [&]
        {
            if (const auto hit = world.cast_circle(start, number(0.01f, 3), sweep, filter)) expect_sound(world, *hit);
        });
    default:
        return try_call("cast_shape", [&]
        {
            const Transform at = transform();
            const auto hit = world.cast_shape(geometry, at, sweep, filter);
            if (hit) expect_sound(world, *hit);
            const std::vector<CastHit> all = world.cast_shape_all(geometry, at, sweep, filter);
            ASSERT_EQ(all.empty(), !hit);
            EXPECT_TRUE(!hit || all.front().shape == hit->shape);
        });
    }
}

void RandomApi::query()
{
    const World& world = world_;
    const QueryFilter filter = query_filter();
    const Geometry geometry = Capsule{vector(2), vector(2), number(0.01f, 1)};
    int visits = 0;
    const auto count = [&visits](ShapeId) { return ++visits < 20; };
    switch (random_.below(9))
    {
    case 0: return try_call("overlapping", [&] { world.overlapping(Aabb{vector(10), vector(10) + Vec2{10, 10}}, filter); });
    case 1: return try_call("overlapping", [&] { world.overlapping(geometry, transform(), filter); });
    case 2: return try_call("shapes_at", [&] { world.shapes_at(vector(10), filter); });
    case 3: return try_call("visit_overlapping", [&] { world.visit_overlapping(geometry, transform(), count, filter); });
    case 4: return try_call("visit_shapes_at", [&] { world.visit_shapes_at(vector(10), count, filter); });
    case 5:
        return try_call("closest_point", [&]
        {
            const float reach = number(0, 30);
            const auto nearest = world.closest_point(vector(20), reach, filter);
            EXPECT_TRUE(!nearest || (nearest->distance >= 0 && nearest->distance <= reach));
        });
    case 6: return try_call("distance", [&] { EXPECT_GE(distance(geometry, transform(), circle(1), transform()).distance, 0); });
    case 7:
        return try_call("time_of_impact", [&]
        {
            const ShapeMotion a = {transform(), vector(20), number(-4, 4), vector(1)};
            const ShapeMotion b = {transform(), vector(20), number(-4, 4), vector(1)};
            const auto time = time_of_impact(geometry, a, box(1, 2), b, number(0.001f, 0.1f));
            EXPECT_TRUE(!time || (*time >= 0 && *time <= 1));
        });
    default:
        return try_call("explode", [&]
        {
            world_.explode({.center = vector(15),
                            .radius = number(0, 3),
                            .falloff = number(0, 3),
                            .impulse_per_metre = number(-5, 5),
                            .filter = filter});
        });
    }
}

void RandomApi::walk()
{
    if (random_.one_in(20))
        try_call("Character", [&]
        {
            character_ = Character({.geometry = Capsule{{0, -0.5f}, {0, number(0.1f, 1)}, number(0.1f, 0.5f)},
                                    .position = vector(15),
                                    .max_slope = number(0, 1.5f),
                                    .step_height = number(0, 0.5f),
                                    .snap_distance = number(0, 0.5f),
                                    .skin = number(0.002f, 0.05f),
                                    .push_force = number(0, 100),
                                    .filter = query_filter()});
        });
    if (random_.one_in(20)) try_call("set_position", [&] { character_.set_position(vector(15)); });
    for (int i = 0; i < 5; ++i)
        try_call("move", [&]
        {
            const Vec2 velocity = character_.move(world_, vector(10), number(0.005f, 0.03f));
            EXPECT_TRUE(is_finite(velocity) && is_finite(character_.position()));
        });
}

void RandomApi::step()
{
    try_call("step", [&]
    {
        const float dt = random_.one_in(10) ? 0.0f : number(0.002f, 0.03f);
        const StepReport report = world_.step(dt, random_.one_in(30) ? random_.below(80) - 5 : 1 + random_.below(6));
        tally_.quarantined += static_cast<int>(report.quarantined.size());
        for (const BodyId id : report.quarantined)
        {
            EXPECT_FALSE(world_.body(id).is_enabled());
            EXPECT_TRUE(is_finite(world_.body(id).position()));
            EXPECT_EQ(world_.body(id).linear_velocity(), Vec2{});
        }
        for (const JointBreak& event : world_.events().joint_break)
        {
            ++tally_.breaks;
            EXPECT_FALSE(world_.find_joint(event.joint));
            EXPECT_GE(event.force, 0);
            EXPECT_GE(event.torque, 0);
        }
        if (dt == 0) return; // nothing moves, and nobody is put aside: a huge impulse may just have made a velocity infinite
        for (const BodyId id : world_.bodies())
            EXPECT_TRUE(is_finite(world_.body(id).position()) && is_finite(world_.body(id).linear_velocity()));
    });
}

void RandomApi::edit_during_step()
{
    // Many bodies at one place make more pairs than ever before, so that the step has to allocate.
    std::vector<BodyId> crowd;
    for (int i = 0; i < 40; ++i) crowd.push_back(world_.create_body({.position = {30, 30}}, circle(1)));

    hook_.argument = this;
    hook_.action = [](void* self)
    {
        RandomApi& api = *static_cast<RandomApi*>(self);
        api.hook_.action = nullptr; // once
        const auto refuse = [&](const char* function, auto&& call)
        {
            ++api.tally_.calls;
            try
            {
                call();
                ADD_FAILURE() << function << " was allowed during a step";
            }
            catch (const UsageError& error)
            {
                ++api.tally_.refused;
                ++api.tally_.during_step;
                expect_complete(error, function);
                EXPECT_EQ(error.value(), "stepping");
            }
        };
        refuse("step", [&] { api.world_.step(0.01f); });
        refuse("create_body", [&] { api.world_.create_body({}, circle(1)); });
        refuse("cast_ray", [&] { api.world_.cast_ray({0, 0}, {1, 0}); });
        refuse("overlapping", [&] { api.world_.overlapping(circle(1), {}); });
        refuse("closest_point", [&] { api.world_.closest_point({0, 0}, 1); });
        refuse("explode", [&] { api.world_.explode({}); });
        refuse("move", [&] { api.character_.move(api.world_, {}, 0.01f); });
        refuse("create_joint", [&] { api.world_.create_joint({}, RevoluteJoint{}); });
        refuse("destroy_joint", [&] { api.world_.destroy_joint({}); });
        if (api.world_.joint_count() > 0)
            refuse("set_break_limits", [&] { api.world_.joint(api.world_.joints().front()).set_break_limits(1, 1); });
        refuse("set_gravity", [&] { api.world_.set_gravity({}); });
        refuse("set_broad_phase", [&] { api.world_.set_broad_phase(BroadPhaseType::BruteForce); });
        for (const BodyId id : api.bodies_)
        {
            const std::optional<Body> body = api.world_.find_body(id);
            if (!body) continue;
            refuse("destroy_body", [&] { api.world_.destroy_body(id); });
            refuse("set_transform", [&] { Body(*body).set_transform({}, 0); });
            refuse("apply_force_to_center", [&] { Body(*body).apply_force_to_center({1, 1}); });
            break;
        }
    };
    world_.step(0.01f);
    hook_.action = nullptr;
    for (const BodyId id : crowd) world_.destroy_body(id);
}

void RandomApi::must_refuse()
{
    ++tally_.calls;
    const BodyId stale = world_.create_body({});
    world_.destroy_body(stale);
    const std::uint64_t after_destroy = world_.hash();
    const auto refused = [&](const char* function, auto&& call)
    {
        try
        {
            call();
            ADD_FAILURE() << function << " accepted a bad argument";
        }
        catch (const UsageError& error)
        {
            ++tally_.refused;
            expect_complete(error, function);
        }
    };
    switch (random_.below(13))
    {
    case 0: refused("body", [&] { world_.body(stale); }); break;
    case 1: refused("destroy_body", [&] { world_.destroy_body(stale); }); break;
    case 2: refused("create_shape", [&] { world_.create_shape(stale, circle(1)); }); break;
    case 3: refused("body", [&] { world_.body(foreign_); }); break;
    case 4: refused("create_body", [&] { world_.create_body({.position = {nan, 0}}); }); break;
    case 5: refused("create_body", [&] { world_.create_body({.type = BodyType::Static, .linear_velocity = {1, 0}}); }); break;
    case 6: refused("circle", [&] { circle(-1); }); break;
    case 7: refused("create_body", [&] { world_.create_body({}, Circle{{}, 0}); }); break;
    case 8: refused("step", [&] { world_.step(-1); }); break;
    case 9: refused("create_chain", [&] { world_.create_chain(stale, {}); }); break;
    case 10: refused("chain", [&] { world_.chain({1u << 30, 1, stale.world}); }); break;
    case 11: refused("set_hit_speed", [&] { world_.set_hit_speed(nan); }); break;
    default: refused("step", [&] { world_.step(0.01f, 0); }); break;
    }
    EXPECT_EQ(world_.hash(), after_destroy);
}

void RandomApi::call()
{
    const int kind = random_.below(100);
    if (kind < 3)
        make_chain();
    else if (kind < 20)
        create();
    else if (kind < 25)
        destroy();
    else if (kind < 45)
        edit_body();
    else if (kind < 60)
        push_body();
    else if (kind < 67)
        edit_shape();
    else if (kind < 69)
        edit_chain();
    else if (kind < 70)
        edit_rules();
    else if (kind < 73)
        edit_world();
    else if (kind < 76)
        create_joint();
    else if (kind < 78)
        edit_joint();
    else if (kind < 79)
        read();
    else if (kind < 80)
        walk();
    else if (kind < 81)
        cast();
    else if (kind < 82)
        query();
    else if (kind < 86)
        must_refuse();
    else if (kind < 87 && random_.one_in(10))
        edit_during_step();
    else
        step();

    // Forget ids now and then, or the stale ones would crowd out the rest.
    if (bodies_.size() > 400) bodies_.erase(bodies_.begin(), bodies_.begin() + 200);
    if (chains_.size() > 60) chains_.erase(chains_.begin(), chains_.begin() + 30);
    if (joints_.size() > 400) joints_.erase(joints_.begin(), joints_.begin() + 200);
    if (shapes_.size() > 800) shapes_.erase(shapes_.begin(), shapes_.begin() + 400);
    while (world_.body_count() > most_bodies) world_.destroy_body(world_.bodies().front());
}

} // namespace carom::fuzz
