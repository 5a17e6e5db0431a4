// Bodies, shapes and events of a scene file in Box2D 2.4.
#include "lab/peers/box2d2/engine.hpp"

#include "lab/peers/box2d2/joints.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace carom::lab::box2d2
{

b2Vec2 vec2(Vec2 v) { return {v.x, v.y}; }

namespace
{

b2Vec2 acceleration(const FileWorld& world, Vec2 gravity)
{
    b2Vec2 sum = vec2(gravity);
    for (const Field& field : world.fields)
    {
        if (const auto* uniform = std::get_if<UniformField>(&field)) sum += vec2(uniform->acceleration);
    }
    return sum;
}

b2BodyType type_of(BodyType type)
{
    switch (type)
    {
    case BodyType::Static: return b2_staticBody;
    case BodyType::Kinematic: return b2_kinematicBody;
    default: return b2_dynamicBody;
    }
}

/// Kept with a fixture, which has no place of its own for it.
b2FixtureUserData tangent_speed_data(float speed)
{
    b2FixtureUserData data;
    data.pointer = std::bit_cast<std::uint32_t>(speed);
    return data;
}

float tangent_speed(b2Fixture& fixture) { return std::bit_cast<float>(static_cast<std::uint32_t>(fixture.GetUserData().pointer)); }

float mix(Mix rule, float a, float b)
{
    switch (rule)
    {
    case Mix::Average: return (a + b) / 2;
    case Mix::Minimum: return std::min(a, b);
    case Mix::Maximum: return std::max(a, b);
    case Mix::Product: return a * b;
    default: return std::sqrt(a * b);
    }
}

/// @throws Lacking when the engine would merge corners; it aborts when too few are left
b2PolygonShape polygon_of(const Polygon& polygon)
{
    const auto count = static_cast<std::size_t>(polygon.count);
    std::array<b2Vec2, max_polygon_vertices> corners;
    for (std::size_t i = 0; i < count; ++i)
    {
        corners[i] = vec2(polygon.vertices[i]);
        for (std::size_t j = 0; j < i; ++j)
            if (b2Distance(corners[i], corners[j]) <= b2_linearSlop / 2) throw Lacking("polygons with corners within 2.5 mm");
    }
    b2PolygonShape made;
    made.Set(corners.data(), polygon.count);
    if (made.m_count != polygon.count) throw Lacking("polygons with corners in line");
    return made;
}

/// The point before the first one of a chain, or after the last: an open chain goes on in line, which makes its end smooth.
b2Vec2 beyond(Vec2 end, Vec2 next) { return {2 * end.x - next.x, 2 * end.y - next.y}; }

} // namespace

void Surfaces::BeginContact(b2Contact* contact)
{
    b2Fixture& a = *contact->GetFixtureA();
    b2Fixture& b = *contact->GetFixtureB();
    contact->SetFriction(mix(mixing_.friction, a.GetFriction(), b.GetFriction()));
    contact->SetRestitution(mix(mixing_.restitution, a.GetRestitution(), b.GetRestitution()));
    contact->SetTangentSpeed(tangent_speed(a) + tangent_speed(b));
}

Engine::Engine(const SceneFile& file) : file_(file), world_(acceleration(file.world, file.world.gravity)), surfaces_(file.world.mixing)
{
    const auto needs = [&](const char* word) { return std::find(file.needs.begin(), file.needs.end(), word) != file.needs.end(); };
    world_.SetAllowSleeping(file.world.sleep.is_enabled);
    world_.SetContinuousPhysics(file.world.continuous);
    if (needs("mixing") || needs("tangent_speed")) world_.SetContactListener(&surfaces_);
    has_breakable_joints_ = needs("breakable_joints");
    create(file.bodies, file.joints);
}

void Engine::create(const std::vector<FileBody>& bodies, const std::vector<FileJoint>& joints)
{
    for (const FileBody& body : bodies) create_body(body);
    for (const FileJoint& joint : joints)
    {
        if (!joint.body_a && !ground_)
        {
            const b2BodyDef def;
            ground_ = world_.CreateBody(&def);
        }
        b2Body& a = joint.body_a ? body(*joint.body_a) : *ground_;
        joints_.push_back({&joint, nullptr});
        make_joint(joints_.size() - 1, joint.spec, a, body(joint.body_b));
    }
}

void Engine::make_joint(std::size_t number, const JointSpec& spec, b2Body& a, b2Body& b)
{
    JointPlace& place = joints_[number];
    place.joint = create_joint(world_, *place.made_as, spec, a, b);
    place.joint->GetUserData().pointer = number;
}

void Engine::create_body(const FileBody& body)
{
    b2BodyDef def;
    def.type = type_of(body.def.type);
    def.position = vec2(body.def.position);
    def.angle = body.def.angle;
    def.linearDamping = body.def.linear_damping;
    def.angularDamping = body.def.angular_damping;
    def.gravityScale = body.def.gravity_scale;
    def.allowSleep = body.def.can_sleep;
    def.awake = body.is_awake;
    def.fixedRotation = body.def.locks.rotation;
    def.bullet = body.def.is_bullet;
    def.enabled = body.def.is_enabled;
    b2Body& made = *world_.CreateBody(&def);
    for (const FileShape& shape : body.shapes) create_shape(made, shape);
    for (const FileChain& chain : body.chains) create_chain(made, chain);
    if (body.mass_data)
    {
        const b2Vec2 center = vec2(body.mass_data->center);
        // The engine's inertia is about the origin of the body.
        const b2MassData data = {body.mass_data->mass, center, body.mass_data->inertia + body.mass_data->mass * b2Dot(center, center)};
        made.SetMassData(&data);
    }
    if (body.is_awake && body.def.type != BodyType::Static)
    {
        // After the shapes, since each of them moves the centre of mass, whose velocity this is.
        made.SetLinearVelocity(vec2(body.def.linear_velocity));
        made.SetAngularVelocity(body.def.angular_velocity);
    }
    bodies_.push_back(&made);
}

void Engine::create_shape(b2Body& body, const FileShape& shape)
{
    if (const auto* circle = std::get_if<Circle>(&shape.geometry))
    {
        b2CircleShape made;
        made.m_p = vec2(circle->center);
        made.m_radius = circle->radius;
        add_fixture(body, made, shape.def.material, shape.def);
    }
    else if (const auto* segment = std::get_if<Segment>(&shape.geometry))
    {
        b2EdgeShape made;
        made.SetTwoSided(vec2(segment->p1), vec2(segment->p2));
        add_fixture(body, made, shape.def.material, shape.def);
    }
    else if (const auto* polygon = std::get_if<Polygon>(&shape.geometry))
    {
        add_fixture(body, polygon_of(*polygon), shape.def.material, shape.def);
    }
}

/// As the engine's chains are made, of edges that know their neighbours; but each has a material of its own.
void Engine::create_chain(b2Body& body, const FileChain& chain)
{
    const std::vector<Vec2>& points = chain.points;
    const std::size_t count = points.size();
    const std::size_t segments = chain.def.is_loop ? count : count - 1;
    ShapeDef def;
    def.filter = chain.def.filter;
    for (std::size_t i = 0; i < segments; ++i)
    {
        const Vec2 p1 = points[i];
        const Vec2 p2 = points[(i + 1) % count];
        const bool has_before = chain.def.is_loop || i > 0;
        const bool has_after = chain.def.is_loop || i + 1 < segments;
        b2EdgeShape made;
        if (chain.def.sides == ChainSides::TwoSided)
            made.SetTwoSided(vec2(p1), vec2(p2));
        else
            made.SetOneSided(has_before ? vec2(points[(i + count - 1) % count]) : beyond(p1, p2), vec2(p1), vec2(p2),
                             has_after ? vec2(points[(i + 2) % count]) : beyond(p2, p1));
        const std::size_t material = chain.materials.size() > 1 ? i : 0;
        add_fixture(body, made, chain.materials.empty() ? Material{} : chain.materials[material], def);
    }
}

void Engine::add_fixture(b2Body& body, const b2Shape& shape, const Material& material, const ShapeDef& def)
{
    b2FixtureDef made;
    made.shape = &shape;
    made.userData = tangent_speed_data(material.tangent_speed);
    made.friction = material.friction;
    made.restitution = material.restitution;
    made.restitutionThreshold = file_.world.solver.restitution_threshold * file_.world.length_unit;
    made.density = def.density;
    made.isSensor = def.is_sensor;
    made.filter.categoryBits = static_cast<uint16>(def.filter.category);
    made.filter.maskBits = static_cast<uint16>(def.filter.mask);
    made.filter.groupIndex = static_cast<int16>(def.filter.group);
    body.CreateFixture(&made);
}

void Engine::before_step(int step)
{
    for (; next_event_ < file_.events.size() && file_.events[next_event_].step <= step; ++next_event_) play(file_.events[next_event_]);
}

void Engine::play(const FileEvent& event)
{
    for (const int number : event.destroy_joints)
    {
        JointPlace& place = joints_[static_cast<std::size_t>(number)];
        if (place.joint) world_.DestroyJoint(place.joint); // else it broke
        place.joint = nullptr;
    }
    for (const int number : event.destroy_bodies) destroy_body(number);
    create(event.create_bodies, event.create_joints);
    if (event.set_world && event.set_world->gravity) world_.SetGravity(acceleration(file_.world, *event.set_world->gravity));
    for (const SetBody& change : event.set_bodies) set(change);
    for (const SetJoint& change : event.set_joints) set(change);
}

void Engine::destroy_body(int number)
{
    b2Body*& body = bodies_[static_cast<std::size_t>(number)];
    for (const b2JointEdge* edge = body->GetJointList(); edge; edge = edge->next)
        joints_[edge->joint->GetUserData().pointer].joint = nullptr;
    world_.DestroyBody(body); // and its joints
    body = nullptr;
}

void Engine::set(const SetBody& set)
{
    b2Body& b = body(set.body);
    if (set.type) b.SetType(type_of(*set.type));
    if (set.position || set.angle) b.SetTransform(set.position ? vec2(*set.position) : b.GetPosition(), set.angle.value_or(b.GetAngle()));
    if (set.linear_velocity) b.SetLinearVelocity(vec2(*set.linear_velocity));
    if (set.angular_velocity) b.SetAngularVelocity(*set.angular_velocity);
    if (set.linear_damping) b.SetLinearDamping(*set.linear_damping);
    if (set.angular_damping) b.SetAngularDamping(*set.angular_damping);
    if (set.gravity_scale) b.SetGravityScale(*set.gravity_scale);
    if (set.locks) b.SetFixedRotation(set.locks->rotation);
    if (set.can_sleep) b.SetSleepingAllowed(*set.can_sleep);
    if (set.is_bullet) b.SetBullet(*set.is_bullet);
    if (set.is_enabled) b.SetEnabled(*set.is_enabled);
    if (set.is_awake) b.SetAwake(*set.is_awake);
}

void Engine::set(const SetJoint& set)
{
    JointPlace& place = joints_[static_cast<std::size_t>(set.joint)];
    if (!place.joint || change_joint(*place.joint, set)) return;
    b2Body& a = *place.joint->GetBodyA();
    b2Body& b = *place.joint->GetBodyB();
    world_.DestroyJoint(place.joint);
    make_joint(static_cast<std::size_t>(set.joint), *set.spec, a, b);
}

void Engine::step() { world_.Step(file_.time_step, velocity_iterations, position_iterations); }

void Engine::break_joints()
{
    if (!has_breakable_joints_) return;
    const float rate = 1 / file_.time_step;
    for (JointPlace& place : joints_)
    {
        if (!place.joint) continue;
        const JointDef& def = place.made_as->def;
        const bool holds = place.joint->GetReactionForce(rate).Length() <= def.break_force &&
                           std::abs(place.joint->GetReactionTorque(rate)) <= def.break_torque;
        if (holds) continue;
        world_.DestroyJoint(place.joint);
        place.joint = nullptr;
    }
}

int Engine::cast_rays() const
{
    struct Nearest final : b2RayCastCallback
    {
        bool hit = false;
        float ReportFixture(b2Fixture* fixture, const b2Vec2&, const b2Vec2&, float fraction) override
        {
            if (fixture->IsSensor() || !(fixture->GetFilterData().maskBits & 1)) return -1;
            hit = true;
            return fraction;
        }
    };
    int hits = 0;
    for (const Ray& ray : file_.rays)
    {
        if (ray.sweep == Vec2{}) continue; // the engine asserts on it
        Nearest nearest;
        world_.RayCast(&nearest, vec2(ray.start), vec2(ray.start) + vec2(ray.sweep));
        if (nearest.hit) ++hits;
    }
    return hits;
}

std::vector<std::optional<BodySample>> Engine::bodies() const
{
    std::vector<std::optional<BodySample>> samples;
    for (const b2Body* body : bodies_)
    {
        if (!body)
        {
            samples.emplace_back();
            continue;
        }
        const b2Vec2 place = body->GetPosition();
        const b2Vec2 velocity = body->GetLinearVelocity();
        samples.push_back(BodySample{place.x, place.y, body->GetAngle(), velocity.x, velocity.y, body->GetAngularVelocity()});
    }
    return samples;
}

} // namespace carom::lab::box2d2
