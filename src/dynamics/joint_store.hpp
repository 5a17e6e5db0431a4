// Joints: what a user asked for, and what the solver leaves for the next step.
#pragma once

#include "dynamics/slot_pool.hpp"

#include <carom/joint.hpp>
#include <carom/math.hpp>

#include <array>
#include <cstdint>
#include <memory_resource>
#include <vector>

namespace carom::detail
{

class BodyStore;

/// Most rows that one joint holds rigidly: x, y and the angle of a weld.
inline constexpr std::size_t max_rigid_rows = 3;
/// Most coordinates that one joint limits, drives or springs: the way and the angle of a wheel.
inline constexpr std::size_t max_controls = 2;

/// Impulses of the last substep, which warm start the next.
struct ControlImpulses
{
    float spring = 0;
    float motor = 0;
    float lower = 0;
    float upper = 0;
};

/// What the solver reads of every joint in each step, and what it leaves behind, comes first.
struct alignas(64) Joint
{
    std::uint32_t body_a = 0xffffffff; ///< null_index: the world
    std::uint32_t body_b = 0xffffffff;
    Transform frame_a; ///< seen from the body's origin
    Transform frame_b;
    Vec2 force;                                   ///< mean of the last step [N]
    std::array<float, max_rigid_rows> rigid = {}; ///< impulses of the last substep
    float torque = 0;                             ///< mean of the last step [N m]

    float angle = 0;     ///< of frame B in frame A over full turns at the end of the last step [rad]
    float gear_slip = 0; ///< q_a + ratio q_b since the joint was made
    Vec2 drive;          ///< of the last substep [N s]
    std::array<ControlImpulses, max_controls> controls = {};
    std::uint32_t place_in_active = null_index; ///< of those that the solver works on
    bool is_active() const { return place_in_active != null_index; }

    JointSpec spec;
    float break_force = 0;  ///< [N]
    float break_torque = 0; ///< [N m]
    bool collide_connected = false;
    std::uint64_t user_data = 0;
    std::array<std::uint32_t, 2> previous = {null_index, null_index}; ///< neighbours in the lists of body A and of body B: edges
    std::array<std::uint32_t, 2> next = {null_index, null_index};
};

/// All joints of a world. The joints of a body form a list of edges (dynamics/edge_list.hpp).
class JointStore
{
public:
    explicit JointStore(std::pmr::memory_resource& memory) : slots(memory), joints(&memory), active(&memory) {}

    /// Changes nothing when memory runs out.
    std::uint32_t create(const Joint& joint, BodyStore& bodies);
    void destroy(std::uint32_t slot, BodyStore& bodies);

    /// Gives back the memory of what lies behind the last joint, and spare room.
    void shrink();

    /// The solver works on a joint, or no longer. Neither allocates.
    void activate(std::uint32_t slot);
    void deactivate(std::uint32_t slot);

    /// What the joint holds and drives is another from now on.
    void set_spec(std::uint32_t slot, const JointSpec& spec);

    SlotPool slots;
    std::pmr::vector<Joint> joints;
    std::pmr::vector<std::uint32_t> active; ///< slots, in an order that only the history of the world decides
    std::uint64_t revision = 0;             ///< another after each change to what is active and to what it holds
};

/// Starts a joint cold.
void forget_impulses(Joint& joint);

/// The place of a joint's frame in the world.
Transform world_frame(const BodyStore& bodies, std::uint32_t body, const Transform& frame);

/// The angle that equals `angle` but for full turns and is nearest to `near` [rad].
float unwrapped(float angle, float near);

} // namespace carom::detail
