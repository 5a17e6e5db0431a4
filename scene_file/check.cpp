// Walks a scene from its first step to its last with no more than the numbers of what is there.
#include "scene_file/check.hpp"

#include "scene_file/fields.hpp"
#include "scene_file/reading.hpp"
#include "support/text.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace carom::scene_file
{

namespace
{

// The joints come last, in the order of JointSpec's alternatives.
enum Feature : std::size_t
{
    Capsules,
    Segments,
    RoundedPolygons,
    Chains,
    OneSidedChains,
    Sensors,
    RollingResistance,
    TangentSpeed,
    MotionLocking,
    MassOverride,
    SleepingBodies,
    MixingRules,
    UniformFields,
    PointFields,
    NBodyFields,
    Events,
    RayCasts,
    BreakableJoints,
    FirstJoint,
    FeatureCount = FirstJoint + std::variant_size_v<JointSpec>
};

constexpr std::array<std::string_view, FeatureCount> words = {"capsules",
                                                              "segments",
                                                              "rounded_polygons",
                                                              "chains",
                                                              "one_sided_chains",
                                                              "sensors",
                                                              "rolling_resistance",
                                                              "tangent_speed",
                                                              "locks",
                                                              "mass_data",
                                                              "sleeping_bodies",
                                                              "mixing",
                                                              "uniform_fields",
                                                              "point_fields",
                                                              "n_body_fields",
                                                              "events",
                                                              "rays",
                                                              "breakable_joints",
                                                              "revolute_joints",
                                                              "prismatic_joints",
                                                              "distance_joints",
                                                              "weld_joints",
                                                              "wheel_joints",
                                                              "motor_joints",
                                                              "mouse_joints",
                                                              "gear_joints",
                                                              "pulley_joints"};

class Features
{
public:
    void add(const SceneFile& file)
    {
        add_if(MixingRules, !(file.world.mixing == MaterialMixing{}));
        add_if(Events, !file.events.empty());
        add_if(RayCasts, !file.rays.empty());
        for (const Field& field : file.world.fields) has_[UniformFields + field.index()] = true;
        add(file.bodies, file.joints);
        for (const FileEvent& event : file.events)
        {
            add(event.create_bodies, event.create_joints);
            for (const SetBody& set : event.set_bodies)
            {
                add_if(SleepingBodies, set.is_awake == false);
                add_if(MotionLocking, set.locks && !(*set.locks == MotionLocks{}));
            }
        }
    }

    std::vector<std::string> list() const
    {
        std::vector<std::string> list;
        for (std::size_t i = 0; i < FeatureCount; ++i)
            if (has_[i]) list.emplace_back(words[i]);
        return list;
    }

private:
    void add_if(Feature feature, bool has) { has_[feature] = has_[feature] || has; }

    void add(const std::vector<FileBody>& bodies, const std::vector<FileJoint>& joints)
    {
        for (const FileBody& body : bodies) add(body);
        for (const FileJoint& joint : joints)
        {
            has_[FirstJoint + joint.spec.index()] = true;
            constexpr float never = std::numeric_limits<float>::infinity();
            add_if(BreakableJoints, joint.def.break_force < never || joint.def.break_torque < never);
        }
    }

    void add(const FileBody& body)
    {
        add_if(MotionLocking, !(body.def.locks == MotionLocks{}));
        add_if(MassOverride, body.mass_data.has_value());
        add_if(SleepingBodies, !body.is_awake);
        for (const FileShape& shape : body.shapes)
        {
            add_if(Capsules, std::holds_alternative<Capsule>(shape.geometry));
            add_if(Segments, std::holds_alternative<Segment>(shape.geometry));
            if (const auto* polygon = std::get_if<Polygon>(&shape.geometry)) add_if(RoundedPolygons, polygon->radius > 0);
            add_if(Sensors, shape.def.is_sensor);
            add(shape.def.material);
        }
        for (const FileChain& chain : body.chains)
        {
            add_if(chain.def.sides == ChainSides::OneSided ? OneSidedChains : Chains, true);
            for (const Material& material : chain.materials) add(material);
        }
    }

    void add(const Material& material)
    {
        add_if(RollingResistance, material.rolling_resistance != 0);
        add_if(TangentSpeed, material.tangent_speed != 0);
    }

    std::array<bool, FeatureCount> has_ = {};
};

std::string element(const char* list, std::size_t index) { return std::string(list) + "[" + std::to_string(index) + "]"; }

bool has_motor(std::size_t joint_type)
{
    const auto type = static_cast<JointType>(joint_type);
    return type == JointType::Revolute || type == JointType::Prismatic || type == JointType::Wheel;
}

/// Thrown when enough problems are known.
struct Enough
{
};

class Checker
{
public:
    /// @param problems grows by those that are found, to at most `most`
    Checker(const SceneFile& file, const std::string& name, std::vector<SceneProblem>& problems, std::size_t most)
        : file_(file),
          name_(name),
          problems_(problems),
          most_(most)
    {
    }

    void check_all()
    {
        add_bodies(file_.bodies, "bodies");
        add_joints(file_.joints, "joints");
        int step = 0;
        for (std::size_t i = 0; i < file_.events.size(); ++i)
        {
            const std::string path = element("events", i);
            attempt([&] { check_order(file_.events[i], step, path); });
            step = file_.events[i].step;
            check_event(file_.events[i], path + ".");
        }
    }

private:
    struct JointState
    {
        std::size_t type;
        bool is_there = true;
        int body_a = -1;
        int body_b = -1;
    };

    /// Keeps a problem and goes on, unless it is the last one that is asked for.
    template <class Action>
    void attempt(const Action& action)
    {
        try
        {
            action();
        }
        catch (const SceneFileError& error)
        {
            problems_.push_back(error.problem());
            if (problems_.size() >= most_) throw Enough();
        }
    }

    void check_order(const FileEvent& event, int step_before, const std::string& path) const
    {
        if (event.step < step_before)
            fail(event.place, path + ".step", "is " + std::to_string(event.step),
                 "give events by step: the one before is at " + std::to_string(step_before));
    }

    void add_bodies(const std::vector<FileBody>& bodies, const std::string& list)
    {
        for (std::size_t i = 0; i < bodies.size(); ++i)
        {
            bodies_.push_back(true);
            attempt([&] { check_body(bodies[i], list + "[" + std::to_string(i) + "]"); });
        }
        if (bodies_.size() > static_cast<std::size_t>(most_file_bodies)) too_many("bodies", most_file_bodies);
        if (shapes_ > static_cast<std::size_t>(most_file_shapes)) too_many("shapes", most_file_shapes);
    }

    void check_body(const FileBody& body, const std::string& path)
    {
        const bool is_static = body.def.type == BodyType::Static;
        if (is_static && body.def.linear_velocity != Vec2{})
            fail(body.place, path + ".linear_velocity", "is not 0", "a static body does not move; make it kinematic, or leave it out");
        if (is_static && body.def.angular_velocity != 0)
            fail(body.place, path + ".angular_velocity", "is not 0", "a static body does not move; make it kinematic, or leave it out");
        if (is_static && !body.is_awake)
            fail(body.place, path + ".is_awake", "is false", "a static body neither wakes nor sleeps; leave it out");
        for (std::size_t i = 0; i < body.shapes.size(); ++i) check_shape(body.shapes[i], path + "." + element("shapes", i));
        for (std::size_t i = 0; i < body.chains.size(); ++i) add_chain(body.chains[i], path + "." + element("chains", i));
        shapes_ += body.shapes.size();
    }

    void check_shape(const FileShape& shape, const std::string& path) const
    {
        try
        {
            static_cast<void>(transformed(shape.geometry, {}, file_.world.length_unit));
        }
        catch (const UsageError& error)
        {
            fail(shape.place, path + "." + error.field(), "is " + error.value(), error.remedy());
        }
    }

    void add_chain(const FileChain& chain, const std::string& path)
    {
        const std::size_t least = chain.def.is_loop ? 3 : 2;
        if (chain.points.size() < least)
            fail(chain.place, path + ".points", "are fewer than " + std::to_string(least), "a loop has 3 or more");
        const std::size_t segments = chain.def.is_loop ? chain.points.size() : chain.points.size() - 1;
        if (chain.materials.size() > 1 && chain.materials.size() != segments)
            fail(chain.place, path + ".materials", "are " + std::to_string(chain.materials.size()),
                 "give none, one, or one for each of the " + std::to_string(segments) + " segments");
        shapes_ += segments;
    }

    void add_joints(const std::vector<FileJoint>& joints, const std::string& list)
    {
        for (std::size_t i = 0; i < joints.size(); ++i)
        {
            const FileJoint& joint = joints[i];
            const std::string path = list + "[" + std::to_string(i) + "]";
            attempt([&] { check_joint(joint, path); });
            joints_.push_back({joint.spec.index(), true, joint.body_a.value_or(-1), joint.body_b});
        }
        if (joints_.size() > static_cast<std::size_t>(most_file_joints)) too_many("joints", most_file_joints);
    }

    void check_joint(const FileJoint& joint, const std::string& path) const
    {
        if (joint.body_a) require_body(*joint.body_a, joint.place, path + ".body_a");
        require_body(joint.body_b, joint.place, path + ".body_b");
        if (joint.body_a == joint.body_b)
            fail(joint.place, path + ".body_b", "is the same as body_a", "give two bodies, or leave out body_a for the world");
    }

    void check_event(const FileEvent& event, const std::string& path)
    {
        for (std::size_t i = 0; i < event.destroy_joints.size(); ++i)
        {
            const std::string place = path + element("destroy_joints", i);
            attempt([&] { joints_[require_joint(event.destroy_joints[i], event.place, place)].is_there = false; });
        }
        for (std::size_t i = 0; i < event.destroy_bodies.size(); ++i)
        {
            const std::string place = path + element("destroy_bodies", i);
            attempt([&] { bodies_[require_body(event.destroy_bodies[i], event.place, place)] = false; });
        }
        add_bodies(event.create_bodies, path + "create_bodies");
        add_joints(event.create_joints, path + "create_joints");
        for (std::size_t i = 0; i < event.set_bodies.size(); ++i)
            attempt([&] { require_body(event.set_bodies[i].body, event.set_bodies[i].place, path + element("set_bodies", i) + ".body"); });
        for (std::size_t i = 0; i < event.set_joints.size(); ++i)
            attempt([&] { check_set(event.set_joints[i], path + element("set_joints", i)); });
    }

    void check_set(const SetJoint& set, const std::string& path)
    {
        const std::size_t type = joints_[require_joint(set.joint, set.place, path + ".joint")].type;
        const std::string what = "joint " + std::to_string(set.joint) + " is a " + std::string(Keys<JointSpec>::all[type]) + " joint";
        if (set.motor_speed.has_value() == set.spec.has_value())
            fail(set.place, path, "needs motor_speed or the joint's type", "give one of them");
        if (set.motor_speed && !has_motor(type)) fail(set.place, path + ".motor_speed", "does not fit", what + ", which has no motor");
        if (set.spec && set.spec->index() != type)
            fail(set.place, path + "." + std::string(Keys<JointSpec>::all[set.spec->index()]), "does not fit", what);
    }

    std::size_t require_body(int number, const Place& place, const std::string& path) const
    {
        const auto index = static_cast<std::size_t>(number);
        if (number < 0 || index >= bodies_.size())
            fail(place, path, "is " + std::to_string(number),
                 "there are " + std::to_string(bodies_.size()) + " bodies at that point, numbered from 0");
        if (!bodies_[index]) fail(place, path, "is " + std::to_string(number), "that body was destroyed before");
        return index;
    }

    std::size_t require_joint(int number, const Place& place, const std::string& path) const
    {
        const auto index = static_cast<std::size_t>(number);
        if (number < 0 || index >= joints_.size())
            fail(place, path, "is " + std::to_string(number),
                 "there are " + std::to_string(joints_.size()) + " joints at that point, numbered from 0");
        const JointState& joint = joints_[index];
        const auto is_gone = [&](int body)
        {
            const auto at = static_cast<std::size_t>(body);
            return body >= 0 && (at >= bodies_.size() || !bodies_[at]);
        };
        if (!joint.is_there || is_gone(joint.body_a) || is_gone(joint.body_b))
            fail(place, path, "is " + std::to_string(number), "that joint was destroyed before");
        return index;
    }

    [[noreturn]] void too_many(const std::string& things, int most) const
    {
        fail(file_.place, "", "the file holds more than " + std::to_string(most) + " " + things, "make the scene smaller");
    }
    /// @param place of the part in which the field lies
    [[noreturn]] void fail(const Place& place, std::string field, const std::string& problem, const std::string& remedy) const
    {
        throw SceneFileError(
            {.source = name_, .line = place.line, .column = place.column, .field = std::move(field), .message = problem + "; " + remedy});
    }

    const SceneFile& file_;
    const std::string& name_;
    std::vector<SceneProblem>& problems_;
    std::size_t most_;
    std::vector<bool> bodies_; ///< by number, whether it is there
    std::vector<JointState> joints_;
    std::size_t shapes_ = 0;
};

void check_needs(const SceneFile& file, const std::string& name)
{
    const auto fail = [&](std::string message)
    {
        throw SceneFileError(
            {.source = name, .line = file.place.line, .column = file.place.column, .field = "needs", .message = std::move(message)});
    };
    const std::vector<std::string> known(words.begin(), words.end());
    for (const std::string& need : file.needs)
    {
        if (std::find(known.begin(), known.end(), need) == known.end())
            fail("names \"" + shortened(need) + "\", which is no feature; " + support::suggestion(need, known));
    }
    for (const std::string& need : needs_of(file))
    {
        if (std::find(file.needs.begin(), file.needs.end(), need) == file.needs.end())
            fail("leaves out \"" + need + "\"; add it, or leave out needs as a whole");
    }
}

} // namespace

std::vector<SceneProblem> problems_of(const SceneFile& file, const std::string& name, int most)
{
    std::vector<SceneProblem> problems;
    try
    {
        Checker(file, name, problems, static_cast<std::size_t>(most)).check_all();
        if (!file.needs.empty()) check_needs(file, name);
    }
    catch (const Enough&)
    {
    }
    catch (const SceneFileError& error) // of what concerns the whole file
    {
        problems.push_back(error.problem());
    }
    return problems;
}

void check(SceneFile& file, const std::string& name)
{
    const std::vector<SceneProblem> problems = problems_of(file, name, 1);
    if (!problems.empty()) throw SceneFileError(problems.front());
    if (file.needs.empty()) file.needs = needs_of(file);
}

std::vector<std::string> needs_of(const SceneFile& file)
{
    Features features;
    features.add(file);
    return features.list();
}

std::span<const std::string_view> feature_words() { return words; }

} // namespace carom::scene_file
