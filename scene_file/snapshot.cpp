// Asks a world for all that a scene file holds, and plays the file to see whether it holds all.
#include "scene_file/snapshot.hpp"

#include "scene_file/check.hpp"
#include "scene_file/player.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace carom::scene_file
{

namespace
{

bool are_same_bits(Rot a, Rot b)
{
    return std::bit_cast<std::uint32_t>(a.c) == std::bit_cast<std::uint32_t>(b.c) &&
           std::bit_cast<std::uint32_t>(a.s) == std::bit_cast<std::uint32_t>(b.s);
}

/// An angle whose rotation is q, to the last bit when there is one: the angle from which q was made, or another that gives the same.
float exact_angle(Rot q)
{
    const double principal = std::atan2(double{q.s}, double{q.c});
    constexpr int most_turns = 3;
    constexpr int most_neighbors = 64; // the engine's sine is right to a few units in the last place
    for (int turns = 0; turns <= 2 * most_turns; ++turns)
    {
        const int turn = turns % 2 == 0 ? turns / 2 : -(turns + 1) / 2;
        float up = static_cast<float>(principal + turn * 2 * 3.14159265358979323846);
        float down = up;
        for (int i = 0; i < most_neighbors; ++i)
        {
            if (are_same_bits(rotation(up), q)) return up;
            if (are_same_bits(rotation(down), q)) return down;
            up = std::nextafter(up, 1e6f);
            down = std::nextafter(down, -1e6f);
        }
    }
    return static_cast<float>(principal);
}

/// A name as long as a file can hold.
std::string fitting(std::string_view name)
{
    std::size_t end = std::min(name.size(), most_text_bytes);
    while (end < name.size() && end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end; // not within a character
    return std::string(name.substr(0, end));
}

/// A speed that can be given to a body; a step can lead to a larger one.
float within_limit(float speed) { return std::clamp(speed, -max_speed, max_speed); }

/// Names by id.
struct Names
{
    explicit Names(const SceneNames* given)
    {
        if (!given) return;
        turn_round(given->shapes, shapes);
        turn_round(given->chains, chains);
        turn_round(given->joints, joints);
    }

    std::map<ShapeId, std::string> shapes;
    std::map<ChainId, std::string> chains;
    std::map<JointId, std::string> joints;

private:
    template <class Id>
    static void turn_round(const NamedIds<Id>& given, std::map<Id, std::string>& names)
    {
        for (const auto& [name, id] : given) names.emplace(id, fitting(name));
    }
};

template <class Id>
std::string name_of(Id id, const std::map<Id, std::string>& names)
{
    const auto found = names.find(id);
    return found == names.end() ? std::string() : found->second;
}

FileShape shape_from(const ShapeView& shape, const Names& names)
{
    return {.geometry = shape.geometry(),
            .def = {.density = shape.density(),
                    .material = shape.material(),
                    .filter = shape.filter(),
                    .is_sensor = shape.is_sensor(),
                    .contact_events = shape.contact_events(),
                    .persist_events = shape.persist_events(),
                    .sensor_events = shape.sensor_events(),
                    .hit_events = shape.hit_events(),
                    .pre_solve = shape.pre_solve(),
                    .user_data = shape.user_data()},
            .name = name_of(shape.id(), names.shapes)};
}

FileChain chain_from(const World& world, const ChainView& chain, const Names& names)
{
    const std::vector<ShapeId> segments = chain.segments();
    const ShapeView first = world.shape(segments.front());
    FileChain file;
    file.name = name_of(chain.id(), names.chains);
    file.def.is_loop = chain.is_loop();
    file.def.sides = chain.sides();
    file.def.filter = first.filter();
    file.def.contact_events = first.contact_events();
    file.def.persist_events = first.persist_events();
    file.def.sensor_events = first.sensor_events();
    file.def.hit_events = first.hit_events();
    file.def.pre_solve = first.pre_solve();
    file.def.user_data = chain.user_data();
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
        const Segment segment = std::get<Segment>(world.shape(segments[i]).geometry());
        file.points.push_back(segment.p1);
        if (i + 1 == segments.size() && !chain.is_loop()) file.points.push_back(segment.p2);
        file.materials.push_back(chain.material(static_cast<int>(i)));
    }
    const auto is_first = [&](const Material& material) { return material == file.materials.front(); };
    if (std::all_of(file.materials.begin(), file.materials.end(), is_first))
        file.materials.resize(file.materials.front() == Material{} ? 0 : 1);
    return file;
}

FileBody body_from(const World& world, const BodyView& body, const Names& names)
{
    FileBody file{.def = {.type = body.type(),
                          .position = body.position(),
                          .angle = exact_angle(body.transform().q),
                          .linear_velocity = {within_limit(body.linear_velocity().x), within_limit(body.linear_velocity().y)},
                          .angular_velocity = within_limit(body.angular_velocity()),
                          .linear_damping = body.linear_damping(),
                          .angular_damping = body.angular_damping(),
                          .gravity_scale = body.gravity_scale(),
                          .locks = body.locks(),
                          .can_sleep = body.can_sleep(),
                          .is_bullet = body.is_bullet(),
                          .is_attractor = body.is_attractor(),
                          .is_enabled = body.is_enabled(),
                          .user_data = body.user_data()},
                  .name = fitting(body.name()),
                  .is_awake = body.type() == BodyType::Static || !body.is_enabled() || body.is_awake()};
    if (body.has_own_mass()) file.mass_data = body.mass_data();
    ChainId last;
    for (const ShapeId id : body.shapes())
    {
        const ShapeView shape = world.shape(id);
        if (!shape.chain())
            file.shapes.push_back(shape_from(shape, names));
        else if (shape.chain() != last)
            file.chains.push_back(chain_from(world, world.chain(last = shape.chain()), names));
    }
    return file;
}

std::vector<FileJoint> joints_from(const World& world, const std::map<BodyId, int>& numbers, const Names& names)
{
    std::vector<FileJoint> joints;
    for (const JointId id : world.joints())
    {
        const JointView joint = world.joint(id);
        FileJoint file{.body_b = numbers.at(joint.body_b()),
                       .def = {.frame_a = joint.frame_a(),
                               .frame_b = joint.frame_b(),
                               .collide_connected = joint.collide_connected(),
                               .break_force = joint.break_force(),
                               .break_torque = joint.break_torque(),
                               .user_data = joint.user_data()},
                       .spec = joint.spec(),
                       .name = name_of(id, names.joints)};
        if (joint.body_a()) file.body_a = numbers.at(joint.body_a());
        joints.push_back(file);
    }
    return joints;
}

/// What can be known to be missing from a file of this world.
std::vector<std::string> losses_of(const World& world)
{
    std::vector<std::string> notes;
    if (world.hooks()) notes.emplace_back("The world's hooks, which decide on contacts, are not in the file.");
    if (world.step_count() > 0)
        notes.emplace_back(
            "The world had been stepped: its contacts with their impulses, and how long bodies have rested, are not in the file.");
    const auto has_force = [&](BodyId id) { return world.body(id).force() != Vec2{} || world.body(id).torque() != 0; };
    const std::vector<BodyId> bodies = world.bodies();
    const auto is_too_fast = [&](BodyId id)
    {
        const Vec2 v = world.body(id).linear_velocity();
        return std::max({std::abs(v.x), std::abs(v.y), std::abs(world.body(id).angular_velocity())}) > max_speed;
    };
    if (std::any_of(bodies.begin(), bodies.end(), is_too_fast)) notes.emplace_back("Speeds above 1,000,000 m/s or rad/s were cut.");
    const auto is_cut = [&](BodyId id) { return world.body(id).name().size() > most_text_bytes; };
    if (std::any_of(bodies.begin(), bodies.end(), is_cut)) notes.emplace_back("Names longer than 64 KiB were cut.");
    if (std::any_of(bodies.begin(), bodies.end(), has_force)) notes.emplace_back("Forces that wait for the next step are not in the file.");
    return notes;
}

/// Plays the file for no step and compares: it says whether anything is missing that losses_of() does not know.
void compare(SceneFile& file, const World& world)
{
    check(file, "the scene");
    World again(FilePlayback::world_def(file));
    const std::string name = "the scene";
    FilePlayback(file, name).begin(again);
    if (again.hash() == world.hash() || !file.notes.empty()) return;
    file.notes.emplace_back(
        "The scene goes on to slightly other numbers than the world that was written: there, things were made in another order "
        "than that of the file, or some were destroyed before.");
}

SceneFile parts_of(const World& world, const Names& names)
{
    SceneFile file;
    file.world = settings_of(world);
    for (const FieldId field : world.fields()) file.world.fields.push_back(world.field(field));
    std::map<BodyId, int> numbers;
    for (const BodyId id : world.bodies())
    {
        numbers.emplace(id, static_cast<int>(numbers.size()));
        file.bodies.push_back(body_from(world, world.body(id), names));
    }
    file.joints = joints_from(world, numbers, names);
    file.notes = losses_of(world);
    return file;
}

} // namespace

FileWorld settings_of(const World& world)
{
    return {.gravity = world.gravity(),
            .continuous = world.is_continuous(),
            .sleep = world.sleep_tuning(),
            .solver = world.solver_tuning(),
            .mixing = world.mixing(),
            .hit_speed = world.hit_speed(),
            .length_unit = world.length_unit(),
            .max_pairs = world.max_pairs()};
}

SceneFile snapshot_of(const World& world, const SceneNames* names)
{
    SceneFile file = parts_of(world, Names(names));
    compare(file, world);
    return file;
}

} // namespace carom::scene_file
