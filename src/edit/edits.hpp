// Changes to a world between steps. The arguments are checked already; see validate.hpp.
#pragma once

#include "dynamics/walks.hpp"
#include "memory/rollback.hpp"
#include "state/world_state.hpp"

namespace carom::detail
{

/// After the stores were copied: the room that edits count on, which a copy of an array does not have.
void reserve_for_edits(WorldState& world);

/// Gives back all memory that what exists does not need. See World::shrink.
void shrink(WorldState& world);

std::uint32_t create_body(WorldState& world, const BodyDef& def);
std::uint32_t create_shape(WorldState& world, std::uint32_t body, const Geometry& geometry, const ShapeDef& def);
void destroy_body(WorldState& world, std::uint32_t body);
void destroy_shape(WorldState& world, std::uint32_t shape);
/// The same, but the body's mass stays as it is.
void remove_shape(WorldState& world, std::uint32_t shape);

/// Ends a contact: its event, its colour, its pair, its place.
/// @param world the number that ids carry
void end_contact(const WakeGraph& graph, ShapeStore& shapes, PairSet& pairs, EventBuffers& events, std::uint32_t world,
                 std::uint32_t contact);
void destroy_contact(WorldState& world, std::uint32_t contact);
void destroy_contacts_of_body(WorldState& world, std::uint32_t body);
void destroy_contacts_of_shape(WorldState& world, std::uint32_t shape);

std::uint32_t create_joint(WorldState& world, const JointDef& def, const JointSpec& spec);
void destroy_joint(WorldState& world, std::uint32_t joint);
/// Tells that a joint is about to go because it pulled too hard.
void note_break(WorldState& world, std::uint32_t joint);
void set_collide_connected(WorldState& world, std::uint32_t joint, bool collide_connected);
/// Wakes what a joint holds together.
void wake_ends(const WakeGraph& graph, const Joint& joint);
/// Takes joints in or out of the solver, as their bodies ask.
void refresh_joints_of_body(const WakeGraph& graph, std::uint32_t body);
void retire_joints_of_body(const BodyStore& bodies, JointStore& joints, std::uint32_t body);

/// Every contact of a shape: action(contact slot), which may destroy it.
template <class Action>
void for_each_contact_of_shape(const WorldState& world, std::uint32_t shape, Action&& action)
{
    for (const Tie tie : contacts_of(world.bodies, world.contacts, world.shapes.records[shape].body))
    {
        const Contact& contact = world.contacts.contacts[tie.slot];
        if (contact.shape_a == shape || contact.shape_b == shape) action(tie.slot);
    }
}

/// Calls the user's hooks from an edit: for as long as it lives, the world refuses other edits.
class HooksGuard
{
public:
    explicit HooksGuard(WorldState& world) : is_stepping_(world.is_stepping) { is_stepping_.store(true, std::memory_order_relaxed); }
    HooksGuard(const HooksGuard&) = delete;
    HooksGuard& operator=(const HooksGuard&) = delete;
    ~HooksGuard() { is_stepping_.store(false, std::memory_order_relaxed); }

private:
    std::atomic<bool>& is_stepping_;
};

/// Mixes the surfaces of a contact, or of all, anew.
void mix_again(WorldState& world, std::uint32_t contact);
void mix_all_again(WorldState& world);
/// For the contacts that exist too.
void set_material(WorldState& world, std::uint32_t shape, const Material& material);
/// Ends the contacts that the filter no longer allows, and looks for those that it now does.
void set_filter(WorldState& world, std::uint32_t shape, const Filter& filter);

void set_body_type(WorldState& world, std::uint32_t body, BodyType type);
void set_body_enabled(WorldState& world, std::uint32_t body, bool is_enabled);
void set_body_transform(WorldState& world, std::uint32_t body, const Transform& transform);
/// Measures the shapes anew.
void refresh_extent(WorldState& world, std::uint32_t body);
/// Sums the shapes' masses anew.
void refresh_mass(WorldState& world, std::uint32_t body);

/// Takes a shape out of the broad phase and puts it back with its present bounds, so that its pairs are judged anew.
void renew_proxy(WorldState& world, std::uint32_t shape);
void set_broad_phase(WorldState& world, BroadPhaseType type, const BroadPhaseOptions& options);

} // namespace carom::detail
