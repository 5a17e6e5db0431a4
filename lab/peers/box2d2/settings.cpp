// What Box2D 2.4 lacks, and what it does in its own way.
#include "lab/peers/box2d2/joints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace carom::lab::box2d2
{

namespace
{

constexpr std::array<std::string_view, 5> lacking_words = {"capsules", "rounded_polygons", "rolling_resistance", "point_fields",
                                                           "n_body_fields"};

/// Calls visit for all that the file makes or changes: bodies, filters and joints' specs.
template <class Bodies, class Filters, class Specs>
void walk(const SceneFile& file, const Bodies& on_body, const Filters& on_filter, const Specs& on_spec)
{
    const auto walk_lists = [&](const std::vector<FileBody>& bodies, const std::vector<FileJoint>& joints)
    {
        for (const FileBody& body : bodies)
        {
            on_body(body);
            for (const FileShape& shape : body.shapes) on_filter(shape.def.filter);
            for (const FileChain& chain : body.chains) on_filter(chain.def.filter);
        }
        for (const FileJoint& joint : joints) on_spec(joint.spec);
    };
    walk_lists(file.bodies, file.joints);
    for (const FileEvent& event : file.events)
    {
        walk_lists(event.create_bodies, event.create_joints);
        for (const SetJoint& set : event.set_joints)
            if (set.spec) on_spec(*set.spec);
    }
}

void add_once(std::vector<std::string>& list, const std::string& what)
{
    if (!what.empty() && std::find(list.begin(), list.end(), what) == list.end()) list.push_back(what);
}

std::string lacks(const MotionLocks& locks) { return locks.x || locks.y ? "locks of x and y" : ""; }

std::string lacks(const Filter& filter)
{
    if (filter.category > 0xffff) return "filters of more than 16 bits";
    return std::abs(filter.group) > 0x7fff ? "groups of more than 16 bits" : "";
}

bool needs(const SceneFile& file, std::string_view word)
{
    return std::find(file.needs.begin(), file.needs.end(), word) != file.needs.end();
}

} // namespace

void require_features(const SceneFile& file)
{
    std::vector<std::string> list;
    for (const std::string_view word : lacking_words)
        if (needs(file, word)) list.emplace_back(word);
    walk(file, [&](const FileBody& body) { add_once(list, lacks(body.def.locks)); },
         [&](const Filter& filter) { add_once(list, lacks(filter)); }, [&](const JointSpec& spec) { add_once(list, lacks(spec)); });
    for (const FileEvent& event : file.events)
        for (const SetBody& set : event.set_bodies)
            if (set.locks) add_once(list, lacks(*set.locks));
    if (list.empty()) return;
    std::string all = list.front();
    for (std::size_t i = 1; i < list.size(); ++i) all += ", " + list[i];
    throw Lacking(all);
}

std::vector<std::string> differences(const SceneFile& file, int threads)
{
    std::vector<std::string> list = {"a step is not divided: " + std::to_string(velocity_iterations) + " velocity and " +
                                         std::to_string(position_iterations) + " position iterations",
                                     "the library of the distribution, with its assertions, and without AVX2",
                                     "polygons and edges have a skin of 1 cm around them"};
    const auto add_if = [&](bool is_so, const char* what)
    {
        if (is_so) list.emplace_back(what);
    };
    add_if(threads > 1, "it runs on one thread");
    add_if(file.world.sleep.is_enabled, "bodies sleep after 0.5 s below 0.01 m/s and 2 degrees a second, which is fixed");
    add_if(needs(file, "chains"), "two-sided chains are made of edges that know nothing of each other, since its chains have one side");
    add_if(needs(file, "breakable_joints"), "joints are broken from outside, by the force that the engine tells after the step");
    add_if(file.world.length_unit != 1, "tolerances are fixed, for bodies of 0.1 m to 10 m");
    const bool has_own_tuning =
        file.world.solver.contact_hertz != 30 || file.world.solver.contact_damping_ratio != 10 || file.world.solver.push_out_speed != 3;
    add_if(has_own_tuning, "contacts have the engine's own stiffness");
    std::vector<std::string> of_joints;
    walk(file, [](const FileBody&) {}, [](const Filter&) {}, [&](const JointSpec& spec) { add_differences(of_joints, spec); });
    for (const std::string& what : of_joints) add_once(list, what);
    return list;
}

} // namespace carom::lab::box2d2
