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

struct Joint
{
    std::uint32_t body_a = 0xffffffff; ///< null_index: the world
    std::uint32_t body_b = 0xffffffff;
    std::array<std::uint32_t, 2> previous = {null_index, null_index}; ///< neighbours in the lists of body A and of body B: edges
    std::array<std::uint32_t, 2> next = {null_index, null_index};
    Transform frame_a; ///< seen from the body's origin
    Transform frame_b;
    JointSpec spec;
    float break_force = 0;  ///< [N]
    float break_torque = 0; ///< [N m]
    std::uint64_t user_data = 0;
    bool collide_connected = false;
    std::uint32_t place_in_active = null_index; ///< of those that the solver works on
    bool is_active() const { return place_in_active != null_index; }

    // What the solver leaves behind.
    std::array<float, max_rigid_rows> rigid = {};
    std::array<ControlImpulses, max_controls> controls = {};
    Vec2 drive;          ///< of the last substep [N s]
    float angle = 0;     ///< of frame B in frame A over full turns at the end of the last step [rad]
    float gear_slip = 0; ///< q_a + ratio q_b since the joint was made
    Vec2 force;          ///< mean of the last step [N]
    float torque = 0;    ///< [N m]
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

    SlotPool slots;
    std::pmr::vector<Joint> joints;
    std::pmr::vector<std::uint32_t> active; ///< slots, in an order that only the history of the world decides
};

/// Starts a joint cold.
void forget_impulses(Joint& joint);

/// The place of a joint's frame in the world.
Transform world_frame(const BodyStore& bodies, std::uint32_t body, const Transform& frame);

/// The angle that equals `angle` but for full turns and is nearest to `near` [rad].
float unwrapped(float angle, float near);

} // namespace carom::detail
