// Every getter and setter of bodies and shapes.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace carom
{

namespace
{

template <class Call>
void expect_refused(const char* field, Call&& call)
{
    try
    {
        call();
        ADD_FAILURE() << "accepted a bad " << field;
    }
    catch (const UsageError& error)
    {
        EXPECT_EQ(error.field(), field) << error.what();
    }
}

class ViewsTest : public testing::Test
{
protected:
    World world{{.gravity = {}}};
};

} // namespace

TEST_F(ViewsTest, ABodyReadsBackWhatItWasMadeOf)
{
    const BodyId id = world.create_body({.type = BodyType::Kinematic,
                                         .position = {1, 2},
                                         .angle = 0.5f,
                                         .linear_velocity = {3, 4},
                                         .angular_velocity = 5,
                                         .linear_damping = 6,
                                         .angular_damping = 7,
                                         .gravity_scale = 8,
                                         .locks = {.x = true},
                                         .is_attractor = true,
                                         .is_enabled = false,
                                         .name = "lift",
                                         .user_data = 9});
    const BodyView body = std::as_const(world).body(id);
    EXPECT_EQ(body.id(), id);
    EXPECT_EQ(body.type(), BodyType::Kinematic);
    EXPECT_EQ(body.position(), (Vec2{1, 2}));
    EXPECT_EQ(body.transform().p, (Vec2{1, 2}));
    EXPECT_NEAR(body.angle(), 0.5f, 1e-6);
    EXPECT_EQ(body.center_of_mass(), (Vec2{1, 2}));
    EXPECT_EQ(body.linear_velocity(), (Vec2{3, 4}));
    EXPECT_EQ(body.angular_velocity(), 5);
    EXPECT_EQ(body.velocity_at({1, 3}), (Vec2{-2, 4}));
    EXPECT_EQ(body.linear_damping(), 6);
    EXPECT_EQ(body.angular_damping(), 7);
    EXPECT_EQ(body.gravity_scale(), 8);
    EXPECT_EQ(body.locks(), (MotionLocks{.x = true}));
    EXPECT_TRUE(body.is_attractor());
    EXPECT_FALSE(body.is_enabled());
    EXPECT_EQ(body.name(), "lift");
    EXPECT_EQ(body.user_data(), 9u);
    EXPECT_EQ(body.shape_count(), 0u);
    EXPECT_EQ(body.bounds(), (Aabb{{1, 2}, {1, 2}}));
    EXPECT_EQ(body.mass_data().mass, 0);
}

TEST_F(ViewsTest, ABodyTakesChanges)
{
    Body body = world.body(world.create_body({}, box(2, 2)));
    body.set_transform({5, 6}, 1);
    EXPECT_EQ(body.position(), (Vec2{5, 6}));
    EXPECT_NEAR(body.angle(), 1, 1e-6);
    EXPECT_EQ(body.center_of_mass(), (Vec2{5, 6}));
    EXPECT_NEAR(body.bounds().max.x, 5 + std::cos(1.0f) + std::sin(1.0f), 1e-5) << "at once";
    body.set_linear_velocity({1, 2});
    body.set_angular_velocity(3);
    body.set_linear_damping(4);
    body.set_angular_damping(5);
    body.set_gravity_scale(-6);
    body.set_is_attractor(true);
    body.set_name("crate");
    body.set_user_data(7);
    EXPECT_EQ(body.linear_velocity(), (Vec2{1, 2}));
    EXPECT_EQ(body.angular_velocity(), 3);
    EXPECT_EQ(body.linear_damping(), 4);
    EXPECT_EQ(body.angular_damping(), 5);
    EXPECT_EQ(body.gravity_scale(), -6);
    EXPECT_TRUE(body.is_attractor());
    EXPECT_EQ(body.name(), "crate");
    EXPECT_EQ(body.user_data(), 7u);
    body.set_locks({.y = true, .rotation = true});
    EXPECT_EQ(body.linear_velocity(), (Vec2{1, 0}));
    EXPECT_EQ(body.angular_velocity(), 0);
    body.set_type(BodyType::Static);
    EXPECT_EQ(body.type(), BodyType::Static);
    EXPECT_EQ(body.linear_velocity(), Vec2{});
    body.set_enabled(false);
    EXPECT_FALSE(body.is_enabled());
}

TEST_F(ViewsTest, a_density_is_refused_that_gives_too_little_or_too_much_mass_or_inertia)
{
    const auto create = [&](const Geometry& geometry, float density) { world.create_body({}, geometry, {.density = density}); };
    const Geometry plank = box(1e5f, 0.01f); // of 1000 m^2, and 8e8 m^2 for its inertia
    EXPECT_NO_THROW(create(box(1, 1), 1e-12f));
    EXPECT_NO_THROW(create(box(1, 1), 1e20f));
    EXPECT_NO_THROW(create(plank, 1e8f));
    EXPECT_NO_THROW(create(plank, 0));
    EXPECT_NO_THROW(create(segment({0, 0}, {1, 0}), 1e30f)) << "a segment has no mass";
    EXPECT_THROW(create(box(1, 1), 0.9e-12f), UsageError);
    EXPECT_THROW(create(box(1, 1), 1.1e20f), UsageError);
    EXPECT_THROW(create(plank, 1e10f), UsageError) << "1e13 kg, and 8e21 kg m^2";
}

TEST_F(ViewsTest, a_kinematic_body_that_becomes_dynamic_keeps_its_velocity_and_no_force)
{
    World space({.gravity = {}});
    Body body = space.body(space.create_body({.type = BodyType::Kinematic, .linear_velocity = {1, 2}}, box(1, 1)));
    body.set_type(BodyType::Dynamic);
    EXPECT_EQ(body.force(), Vec2{});
    EXPECT_EQ(body.torque(), 0);
    space.step(1 / 60.0f);
    EXPECT_EQ(body.linear_velocity(), (Vec2{1, 2}));
    EXPECT_EQ(body.angular_velocity(), 0);
}

TEST_F(ViewsTest, ForcesGatherUntilTheStepAndImpulsesActAtOnce)
{
    Body body = world.body(world.create_body({.position = {1, 0}}, box(1, 1), {.density = 2}));
    body.apply_force({1, 0}, {1, 2});
    body.apply_force_to_center({0, 4});
    body.apply_torque(5);
    EXPECT_EQ(body.force(), (Vec2{1, 4}));
    EXPECT_EQ(body.torque(), 3) << "5 - 2 m times 1 N";
    world.step(0);
    EXPECT_EQ(body.force(), (Vec2{1, 4})) << "a step of no time uses up nothing";
    world.step(0.5f);
    EXPECT_EQ(body.force(), Vec2{});
    EXPECT_EQ(body.torque(), 0);
    EXPECT_NEAR(body.linear_velocity().x, 0.25f, 1e-6);
    EXPECT_NEAR(body.linear_velocity().y, 1, 1e-6);
    EXPECT_NEAR(body.angular_velocity(), 0.5f * 3 / body.mass_data().inertia, 1e-4);

    const float w = body.angular_velocity();
    body.apply_impulse_to_center({2, 0});
    EXPECT_NEAR(body.linear_velocity().x, 1.25f, 1e-6);
    body.apply_angular_impulse(1);
    EXPECT_NEAR(body.angular_velocity(), w + 1 / body.mass_data().inertia, 1e-4);
    const Vec2 above = body.center_of_mass() + Vec2{0, 1};
    body.apply_impulse({1, 0}, above);
    EXPECT_NEAR(body.linear_velocity().x, 1.75f, 1e-6);
    EXPECT_NEAR(body.angular_velocity(), w, 1e-4);
}

TEST_F(ViewsTest, ForcesAndImpulsesDoNothingToWhatCannotBePushed)
{
    for (const BodyDef& def : {BodyDef{.type = BodyType::Static}, BodyDef{.type = BodyType::Kinematic}, BodyDef{.is_enabled = false}})
    {
        Body body = world.body(world.create_body(def, box(1, 1)));
        body.apply_force({1, 1}, {3, 0});
        body.apply_torque(1);
        body.apply_impulse({1, 1}, {3, 0});
        body.apply_angular_impulse(1);
        EXPECT_EQ(body.force(), Vec2{});
        EXPECT_EQ(body.linear_velocity(), Vec2{});
        EXPECT_EQ(body.angular_velocity(), 0);
        world.step(0.1f);
        EXPECT_EQ(body.position(), Vec2{});
    }
}

TEST_F(ViewsTest, MassFollowsShapesDensityGeometryAndOverride)
{
    Body body = world.body(world.create_body({}, box(1, 1)));
    const ShapeId left = body.shapes()[0];
    const ShapeId right = world.create_shape(body.id(), offset_box(1, 1, {2, 0}));
    EXPECT_FLOAT_EQ(body.mass_data().mass, 2);
    EXPECT_FLOAT_EQ(body.center_of_mass().x, 1);
    EXPECT_FLOAT_EQ(body.mass_data().inertia, 2 * (1 / 6.0f + 1));
    world.shape(right).set_density(3);
    EXPECT_FLOAT_EQ(body.mass_data().mass, 4);
    EXPECT_FLOAT_EQ(body.center_of_mass().x, 1.5f);
    world.shape(right).set_geometry(offset_box(2, 1, {2, 0}));
    EXPECT_FLOAT_EQ(body.mass_data().mass, 7);
    body.set_mass_data({.mass = 10, .center = {0, 1}, .inertia = 2});
    world.destroy_shape(left);
    EXPECT_EQ(body.mass_data().mass, 10) << "an override outlives the shapes";
    EXPECT_TRUE(body.has_own_mass());
    EXPECT_EQ(body.center_of_mass(), (Vec2{0, 1}));
    body.reset_mass_data();
    EXPECT_FALSE(body.has_own_mass());
    EXPECT_FLOAT_EQ(body.mass_data().mass, 6);
    EXPECT_FLOAT_EQ(body.center_of_mass().x, 2);
    world.destroy_shape(right);
    EXPECT_EQ(body.mass_data().mass, 1);
    EXPECT_EQ(body.mass_data().inertia, 0);
    EXPECT_EQ(body.center_of_mass(), Vec2{});
}

TEST_F(ViewsTest, TheVelocityGivenToABodyIsThatOfItsCentreOfMass)
{
    const Body body = world.body(world.create_body({.linear_velocity = {1, 2}, .angular_velocity = 3}, offset_box(1, 1, {4, 0})));
    EXPECT_EQ(body.linear_velocity(), (Vec2{1, 2}));
    EXPECT_EQ(body.position(), Vec2{});
    EXPECT_EQ(body.center_of_mass(), (Vec2{4, 0}));
}

TEST_F(ViewsTest, AShapeReadsBackWhatItWasMadeOfAndTakesChanges)
{
    const BodyId body = world.create_body({.position = {10, 0}});
    const Material material = {.friction = 0.1f, .restitution = 0.2f, .rolling_resistance = 0.3f, .tangent_speed = 0.4f, .id = 5};
    const Filter filter = {.category = 6, .mask = 7, .group = -8};
    const ShapeId id =
        world.create_shape(body, circle(2), {.density = 3, .material = material, .filter = filter, .is_sensor = true, .user_data = 9});
    const ShapeView view = std::as_const(world).shape(id);
    EXPECT_EQ(view.id(), id);
    EXPECT_EQ(view.body(), body);
    EXPECT_EQ(std::get<Circle>(view.geometry()).radius, 2);
    EXPECT_EQ(view.density(), 3);
    EXPECT_EQ(view.material(), material);
    EXPECT_EQ(view.filter(), filter);
    EXPECT_TRUE(view.is_sensor());
    EXPECT_TRUE(view.contact_events() && view.sensor_events());
    EXPECT_FALSE(view.persist_events());
    const ShapeView silent = std::as_const(world).shape(
        world.create_shape(body, circle(1), {.contact_events = false, .persist_events = true, .sensor_events = false}));
    EXPECT_FALSE(silent.contact_events() || silent.sensor_events());
    EXPECT_TRUE(silent.persist_events());
    world.destroy_shape(silent.id());
    EXPECT_EQ(view.bounds(), (Aabb{{8, -2}, {12, 2}}));
    EXPECT_EQ(view.user_data(), 9u);
    EXPECT_TRUE(view.contains({11, 1}));
    EXPECT_FALSE(view.contains({11.9f, 1.9f}));

    Shape shape = world.shape(id);
    shape.set_material({});
    shape.set_filter({});
    shape.set_geometry(box(2, 6));
    shape.set_density(0.5f);
    shape.set_user_data(10);
    EXPECT_EQ(view.material(), Material{});
    EXPECT_EQ(view.filter(), Filter{});
    EXPECT_TRUE(std::holds_alternative<Polygon>(view.geometry()));
    EXPECT_EQ(view.bounds(), (Aabb{{9, -3}, {11, 3}})) << "at once";
    EXPECT_EQ(view.density(), 0.5f);
    EXPECT_EQ(view.user_data(), 10u);
    EXPECT_FLOAT_EQ(world.body(body).mass_data().mass, 6);
}

TEST_F(ViewsTest, AShapeThatBecomesADiscRollsLikeOne)
{
    world.set_gravity({0, -9.81f});
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(200, 2));
    Body disc = world.body(world.create_body({.position = {-50, 0.5f}}, circle(0.5f)));
    Body former_box = world.body(world.create_body({.position = {50, 0.5f}}, box(1, 1)));
    for (int i = 0; i < 10; ++i) world.step(1 / 60.0f);
    world.shape(former_box.shapes()[0]).set_geometry(circle(0.5f));
    for (Body* body : {&disc, &former_box})
    {
        body->set_linear_velocity({20, 0});
        body->set_angular_velocity(-40);
    }
    for (int i = 0; i < 30; ++i) world.step(1 / 60.0f);
    EXPECT_NEAR(former_box.position().x - 50, disc.position().x + 50, 1e-3f);
    EXPECT_NEAR(former_box.position().y, disc.position().y, 1e-4f);
    EXPECT_NEAR(former_box.linear_velocity().x, 20, 1e-2f);
}

TEST_F(ViewsTest, ADisabledBodysShapesFollowItsTransform)
{
    Body body = world.body(world.create_body({.is_enabled = false}, circle(1)));
    Shape shape = world.shape(body.shapes()[0]);
    body.set_transform({10, 0}, 0);
    EXPECT_EQ(shape.bounds(), (Aabb{{9, -1}, {11, 1}}));
    shape.set_geometry(circle(2));
    EXPECT_EQ(body.bounds(), (Aabb{{8, -2}, {12, 2}}));
    const ShapeId second = world.create_shape(body.id(), circle(1, {5, 0}));
    EXPECT_EQ(body.bounds(), (Aabb{{8, -2}, {16, 2}}));
    world.destroy_shape(second);
    body.set_enabled(true);
    world.create_body({.type = BodyType::Static, .position = {12.9f, 0}}, circle(1));
    EXPECT_EQ(world.step(1 / 60.0f).contacts, 1);
}

TEST_F(ViewsTest, AMaterialReachesContactsThatExist)
{
    world.set_gravity({0, -10});
    const BodyId ground = world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2), {.material = {.friction = 0}});
    Body puck = world.body(world.create_body({.position = {0, 0.5f}, .linear_velocity = {3, 0}}, box(1, 1)));
    for (int i = 0; i < 30; ++i) world.step(1 / 60.0f);
    EXPECT_NEAR(puck.linear_velocity().x, 3, 1e-3);
    world.shape(world.body(ground).shapes()[0]).set_material({.friction = 0.6f});
    for (int i = 0; i < 60; ++i) world.step(1 / 60.0f);
    EXPECT_NEAR(puck.linear_velocity().x, 0, 1e-3);
}

TEST_F(ViewsTest, BadValuesAreRefusedByNameAndChangeNothing)
{
    Body body = world.body(world.create_body({.linear_velocity = {1, 1}}, box(1, 1)));
    Body ground = world.body(world.create_body({.type = BodyType::Static}, box(1, 1)));
    Shape shape = world.shape(body.shapes()[0]);
    const std::uint64_t before = world.hash();
    expect_refused("position.x", [&] { body.set_transform({nan, 0}, 0); });
    expect_refused("angle", [&] { body.set_transform({}, nan); });
    expect_refused("linear_velocity.y", [&] { body.set_linear_velocity({0, 2e6f}); });
    expect_refused("linear_velocity", [&] { ground.set_linear_velocity({1, 0}); });
    expect_refused("angular_velocity", [&] { ground.set_angular_velocity(1); });
    expect_refused("rate", [&] { body.set_linear_damping(-1); });
    expect_refused("rate", [&] { body.set_angular_damping(nan); });
    expect_refused("scale", [&] { body.set_gravity_scale(nan); });
    expect_refused("mass", [&] { body.set_mass_data({.mass = 0, .center = {}, .inertia = 1}); });
    expect_refused("inertia", [&] { body.set_mass_data({.mass = 1, .center = {}, .inertia = 0}); });
    expect_refused("type", [&] { body.set_type(static_cast<BodyType>(9)); });
    expect_refused("force.x", [&] { body.apply_force_to_center({nan, 0}); });
    expect_refused("torque", [&] { body.apply_torque(nan); });
    expect_refused("impulse.y", [&] { body.apply_impulse({0, nan}, {}); });
    expect_refused("world_point.x", [&] { body.apply_impulse({}, {nan, 0}); });
    expect_refused("density", [&] { shape.set_density(-1); });
    expect_refused("circle.radius", [&] { shape.set_geometry(Circle{{}, -1}); });
    expect_refused("material.friction", [&] { shape.set_material({.friction = -1}); });
    ground.set_mass_data({});
    expect_refused("mass", [&] { ground.set_type(BodyType::Dynamic); });
    ground.reset_mass_data();
    EXPECT_EQ(world.hash(), before);
}

TEST_F(ViewsTest, AViewOfWhatIsGoneRefusesEveryCall)
{
    Body body = world.body(world.create_body({}, box(1, 1)));
    Shape shape = world.shape(body.shapes()[0]);
    world.destroy_body(body.id());
    world.create_body({}, box(1, 1)); // takes both places
    expect_refused("body", [&] { body.position(); });
    expect_refused("body", [&] { body.shapes(); });
    expect_refused("body", [&] { body.set_enabled(false); });
    expect_refused("body", [&] { body.apply_torque(1); });
    expect_refused("shape", [&] { shape.bounds(); });
    expect_refused("shape", [&] { shape.touching(); });
    expect_refused("shape", [&] { shape.set_user_data(1); });
}

} // namespace carom
