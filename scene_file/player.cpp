// Makes bodies and joints from their descriptions, and says of which one the engine refused something.
#include "scene_file/player.hpp"

#include "scene_file/check.hpp"
#include "scene_file/fields.hpp"

#include <utility>

namespace carom::scene_file
{

namespace
{

std::string element(const std::string& list, std::size_t index) { return list + "[" + std::to_string(index) + "]"; }

BodyDef def_of(const FileBody& body)
{
    BodyDef def = body.def;
    def.name = body.name;
    return def;
}

ChainDef def_of(const FileChain& chain)
{
    ChainDef def = chain.def;
    def.points = chain.points;
    def.materials = chain.materials;
    return def;
}

/// With another speed of the motor; without one, it gets one that has no force.
template <class Spec>
    requires requires(Spec spec) { spec.motor; }
void set_motor_speed(Spec& spec, float speed)
{
    Motor motor = spec.motor.value_or(Motor{});
    motor.speed = speed;
    spec.motor = motor;
}
template <class Spec>
void set_motor_speed(Spec&, float)
{
}

} // namespace

WorldDef FilePlayback::world_def(const SceneFile& file)
{
    const FileWorld& world = file.world;
    return {.gravity = world.gravity,
            .length_unit = world.length_unit,
            .solver = world.solver,
            .sleep = world.sleep,
            .continuous = world.continuous,
            .mixing = world.mixing,
            .hit_speed = world.hit_speed,
            .max_pairs = world.max_pairs};
}

/// Does something to the world; what the engine refuses of it is reported with its place in the file.
/// @param place of the part of the file
/// @param path  makes the path of the part
template <class Path, class Action>
void FilePlayback::located(const Place& place, const Path& path, const Action& action) const
{
    try
    {
        action();
    }
    catch (const UsageError& error)
    {
        throw SceneFileError({.source = name_,
                              .line = place.line,
                              .column = place.column,
                              .field = path() + "." + error.field(),
                              .message = "is " + error.value() + "; " + error.remedy()});
    }
}

void FilePlayback::begin(World& world)
{
    add_fields(world);
    create_parts(world);
}

void FilePlayback::add_fields(World& world)
{
    for (std::size_t i = 0; i < file_.world.fields.size(); ++i)
        located(file_.place, [&] { return element("world.fields", i); },
                [&] { fields_.push_back(world.add_field(file_.world.fields[i])); });
}

void FilePlayback::create_parts(World& world)
{
    create_bodies(world, file_.bodies, "bodies");
    create_joints(world, file_.joints, "joints");
    put_to_sleep(world, file_.bodies, 0);
    hits_.resize(file_.rays.size());
}

void FilePlayback::create_bodies(World& world, const std::vector<FileBody>& bodies, const std::string& list)
{
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        const FileBody& body = bodies[i];
        BodyId id;
        located(body.place, [&] { return element(list, i); }, [&] { id = world.create_body(def_of(body)); });
        bodies_.push_back(id);
        if (!body.name.empty()) names_.bodies.add(body.name, id);
        add_shapes(world, id, body, list, i);
        if (body.mass_data)
            located(body.place, [&] { return element(list, i) + ".mass_data"; }, [&] { world.body(id).set_mass_data(*body.mass_data); });
    }
}

void FilePlayback::add_shapes(World& world, BodyId id, const FileBody& body, const std::string& list, std::size_t index)
{
    for (std::size_t i = 0; i < body.shapes.size(); ++i)
    {
        const FileShape& shape = body.shapes[i];
        ShapeId made;
        located(shape.place, [&] { return element(element(list, index) + ".shapes", i); },
                [&] { made = world.create_shape(id, shape.geometry, shape.def); });
        if (!shape.name.empty()) names_.shapes.add(shape.name, made);
    }
    for (std::size_t i = 0; i < body.chains.size(); ++i)
    {
        const FileChain& chain = body.chains[i];
        ChainId made;
        located(chain.place, [&] { return element(element(list, index) + ".chains", i); },
                [&] { made = world.create_chain(id, def_of(chain)); });
        if (!chain.name.empty()) names_.chains.add(chain.name, made);
    }
}

/// Once the joints are there: making one wakes its bodies.
void FilePlayback::put_to_sleep(World& world, const std::vector<FileBody>& bodies, std::size_t first_number) const
{
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (!bodies[i].is_awake) world.body(bodies_[first_number + i]).set_awake(false);
}

void FilePlayback::create_joints(World& world, const std::vector<FileJoint>& joints, const std::string& list)
{
    for (std::size_t i = 0; i < joints.size(); ++i)
    {
        const FileJoint& joint = joints[i];
        JointDef def = joint.def;
        if (joint.body_a) def.body_a = body(*joint.body_a);
        def.body_b = body(joint.body_b);
        located(joint.place, [&] { return element(list, i); }, [&] { joints_.push_back(world.create_joint(def, joint.spec)); });
        if (!joint.name.empty()) names_.joints.add(joint.name, joints_.back());
    }
}

void FilePlayback::before_step(World& world, int step)
{
    while (is_due(step))
    {
        const std::size_t event = next_event_++;
        play(world, file_.events[event], element("events", event));
    }
}

void FilePlayback::play(World& world, const FileEvent& event, const std::string& path)
{
    destroy(world, event);
    const std::size_t first = bodies_.size();
    create_bodies(world, event.create_bodies, path + ".create_bodies");
    create_joints(world, event.create_joints, path + ".create_joints");
    put_to_sleep(world, event.create_bodies, first);
    if (event.set_world && event.set_world->gravity)
        located(event.place, [&] { return path + ".set_world"; }, [&] { world.set_gravity(*event.set_world->gravity); });
    for (std::size_t i = 0; i < event.set_bodies.size(); ++i)
        located(event.set_bodies[i].place, [&] { return element(path + ".set_bodies", i); }, [&] { set(world, event.set_bodies[i]); });
    for (std::size_t i = 0; i < event.set_joints.size(); ++i)
        located(event.set_joints[i].place, [&] { return element(path + ".set_joints", i); }, [&] { set(world, event.set_joints[i]); });
}

void FilePlayback::destroy(World& world, const FileEvent& event)
{
    for (const int number : event.destroy_joints)
    {
        if (world.find_joint(joint(number))) world.destroy_joint(joint(number)); // else it broke
    }
    for (const int number : event.destroy_bodies)
    {
        if (world.find_body(body(number))) world.destroy_body(body(number)); // else the program destroyed it
    }
}

void FilePlayback::set(World& world, const SetBody& set) const
{
    std::optional<Body> found = world.find_body(body(set.body));
    if (!found) return; // the program destroyed it
    Body& b = *found;
    if (set.type) b.set_type(*set.type);
    if (set.position || set.angle) b.set_transform(set.position.value_or(b.position()), set.angle.value_or(b.angle()));
    if (set.linear_velocity) b.set_linear_velocity(*set.linear_velocity);
    if (set.angular_velocity) b.set_angular_velocity(*set.angular_velocity);
    if (set.linear_damping) b.set_linear_damping(*set.linear_damping);
    if (set.angular_damping) b.set_angular_damping(*set.angular_damping);
    if (set.gravity_scale) b.set_gravity_scale(*set.gravity_scale);
    if (set.locks) b.set_locks(*set.locks);
    if (set.can_sleep) b.set_can_sleep(*set.can_sleep);
    if (set.is_bullet) b.set_is_bullet(*set.is_bullet);
    if (set.is_attractor) b.set_is_attractor(*set.is_attractor);
    if (set.is_enabled) b.set_enabled(*set.is_enabled);
    if (set.is_awake) b.set_awake(*set.is_awake);
}

void FilePlayback::set(World& world, const SetJoint& set) const
{
    std::optional<Joint> found = world.find_joint(joint(set.joint));
    if (!found) return; // it broke
    JointSpec spec = set.spec.value_or(found->spec());
    if (set.motor_speed) std::visit([&](auto& s) { set_motor_speed(s, *set.motor_speed); }, spec);
    found->set_spec(spec);
}

RayResult FilePlayback::cast_rays(const World& world)
{
    world.cast_rays(file_.rays, hits_);
    RayResult result;
    for (const std::optional<RayHit>& hit : hits_)
    {
        if (!hit) continue;
        ++result.hits;
        result.sum_of_fractions += double{hit->fraction};
    }
    return result;
}

FilePlayer::FilePlayer(SceneFile file, std::string name)
    : name_(std::move(name)),
      file_(std::move(file)),
      world_(FilePlayback::world_def(file_)),
      playback_(file_, name_)
{
    check(file_, name_);
    playback_.begin(world_);
}

StepReport FilePlayer::step()
{
    playback_.before_step(world_, next_step_++);
    const StepReport report = world_.step(file_.time_step, file_.substeps);
    if (!file_.rays.empty()) rays_ = playback_.cast_rays(world_);
    return report;
}

} // namespace carom::scene_file
