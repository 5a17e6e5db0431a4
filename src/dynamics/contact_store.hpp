// Contacts: one for every pair of shapes whose fattened bounds overlap and that may meet, sensors included.
#pragma once

#include "dynamics/collision_memory.hpp"
#include "dynamics/slot_pool.hpp"

#include <carom/math.hpp>

#include <array>
#include <cstdint>
#include <memory_resource>
#include <vector>

namespace carom::detail
{

class BodyStore;

inline constexpr std::uint8_t no_color = 255;

/// Whether anything but the two shapes may change a contact.
enum class Neighborhood : std::uint8_t
{
    Unknown,
    Empty, ///< each is the only shape of a dynamic body, and no one-sided segment
    Shared
};

/// Who meets whom, and how their surfaces mix. Shape A has the lower index.
struct Contact
{
    std::uint32_t shape_a = null_index;
    std::uint32_t shape_b = null_index;
    std::uint32_t body_a = null_index;
    std::uint32_t body_b = null_index;
    std::array<std::uint32_t, 2> previous = {null_index, null_index}; ///< neighbours in the lists of body A and of body B: edges
    std::array<std::uint32_t, 2> next = {null_index, null_index};
    float friction = 0;
    float restitution = 0;
    float rolling_resistance = 0; ///< times a radius [m]
    float tangent_speed = 0;      ///< of B past A along the right of the normal [m/s]
    std::uint32_t place_in_awake = null_index;
    std::uint8_t color = no_color; ///< the solver's colour while the contact has points
    bool is_live = false;
    bool is_sensor = false;
    bool is_touching = false;   ///< as the events have told it
    bool is_passing = false;    ///< from behind through a one-sided segment
    bool is_hitting = false;    ///< was pushed faster than the hit speed in the last step
    bool is_disabled = false;   ///< by a hook, for this step
    bool is_overridden = false; ///< a hook may have changed the surface for a step
    Neighborhood neighborhood = Neighborhood::Unknown;
    bool wants_persist = false; ///< one of its shapes asks for the events of each step
    bool wants_hits = false;    ///< one of them asks for hits
    std::uint32_t search = 0;   ///< the search for pairs that found it
    float last_normal = 0;      ///< impulse of the last step in which it touched [N s]
    float last_tangent = 0;     ///< the same along the surface [N s]
};

/// One point of a contact as the solver leaves it for the next step.
struct ContactPointState
{
    Vec2 position;             ///< in the world at the start of the step [m]
    Vec2 r_a;                  ///< from A's centre of mass to the point [m]
    Vec2 r_b;                  ///< from B's [m]
    float separation = 0;      ///< at the start of the step [m]
    float normal_impulse = 0;  ///< of the last substep: warm starts the next [N s]
    float tangent_impulse = 0; ///< of the last substep [N s]
    float total_normal = 0;    ///< over the step [N s]
    float total_tangent = 0;   ///< over the step [N s]
    float normal_velocity = 0; ///< along the normal at the start of the step; negative when approaching [m/s]
    std::uint32_t feature = 0;
};

/// The contact's points, by contact slot.
struct ContactManifold
{
    Vec2 normal;               ///< in the world, from A to B
    float rolling_impulse = 0; ///< of the last substep [N m s]
    float total_rolling = 0;   ///< over the step [N m s]
    float carried_impulse = 0; ///< what each point has been carrying for a while, per substep [N s]
    float rounding_a = 0;      ///< how far A's surface is from its core, which turns with A while the surface stays where it is [m]
    float rounding_b = 0;
    int count = 0; ///< points; a sensor's overlap counts as one
    std::array<ContactPointState, 2> points;
};

/// What a step reads first of an awake contact: most pairs of a crowd are near and do not touch, and need nothing else.
struct AwakePair
{
    std::uint32_t shape_a;
    std::uint32_t shape_b : 31;
    /// No points, no colour, nothing that events told, and no surface beyond the two shapes: while their bounds are apart, it stays so.
    std::uint32_t is_idle : 1;
};

/// All contacts of a world. Those of which no body is active leave the list of the awake ones, and with it every loop of a step. The
/// contacts of a body form a list of edges (dynamics/edge_list.hpp).
class ContactStore
{
public:
    explicit ContactStore(std::pmr::memory_resource& memory)
        : slots(memory),
          contacts(&memory),
          manifolds(&memory),
          memories(&memory),
          awake(&memory),
          awake_pairs(&memory)
    {
    }

    /// Awake, whoever its bodies are: the next update looks at it. Changes nothing when memory runs out.
    std::uint32_t create(const Contact& pair, BodyStore& bodies);
    void destroy(std::uint32_t slot, BodyStore& bodies);
    void reserve(std::size_t count);
    /// Room to wake every contact: what create() sees to, and a copy of the arrays does not bring along.
    void make_room_to_wake();
    /// Gives back the memory of what lies behind the last contact, and spare room.
    void shrink();
    /// Contacts that are made from now on are new; those from before no longer.
    void begin_search() { ++search_; }
    bool is_new(const Contact& contact) const { return contact.search == search_; }
    /// Looks at a contact again in each step, or no longer. Neither allocates, nor minds when it is so already.
    void wake(std::uint32_t slot);
    void put_to_sleep(std::uint32_t slot);

    SlotPool slots;
    std::pmr::vector<Contact> contacts;
    std::pmr::vector<ContactManifold> manifolds;
    std::pmr::vector<CollisionMemory> memories;
    std::pmr::vector<std::uint32_t> awake;   ///< slots, in an order that only the history of the world decides
    std::pmr::vector<AwakePair> awake_pairs; ///< of the awake contacts, in the same order

private:
    std::uint32_t search_ = 0; ///< the last one's number; turns over after years, when no pair of that time is left
};

} // namespace carom::detail
