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
    Empty,  ///< each is the only shape of a dynamic body, and no one-sided segment
    Ground, ///< one is the only shape of a dynamic body; the other belongs to one that is not dynamic, and is no part of a chain
    Shared
};

/// Two shapes that meet, and what the stages of a step know of them. Shape A has the lower index.
struct Contact
{
    std::uint32_t shape_a = null_index;
    std::uint32_t shape_b = null_index;
    std::uint32_t body_a = null_index;
    std::uint32_t body_b = null_index;
    std::array<std::uint32_t, 2> previous = {null_index, null_index}; ///< neighbours in the lists of body A and of body B: edges
    std::array<std::uint32_t, 2> next = {null_index, null_index};
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
    bool is_watched = false;    ///< one of them asks for any of these, or for the hook before each step
    std::uint32_t search = 0;   ///< the search for pairs that found it
};

/// How the surfaces of two shapes mix.
struct ContactSurface
{
    float friction = 0;
    float restitution = 0;
    float rolling_resistance = 0; ///< times a radius [m]
    float tangent_speed = 0;      ///< of B past A along the right of the normal [m/s]
};

/// From the two centres of mass to a contact point [m].
struct ContactArms
{
    Vec2 r_a;
    Vec2 r_b;
};

/// At a contact point [N s].
struct ContactImpulse
{
    float normal = 0;
    float tangent = 0;
};

/// The contact's points, by contact slot: what rows are made of, in three groups of eight floats, each of which a transpose turns into lanes.
/// What only events and pictures read is in ContactResult.
struct alignas(64) ContactManifold
{
    std::array<ContactArms, 2> arms;

    Vec2 normal;                       ///< in the world, from A to B
    std::array<float, 2> separation{}; ///< of each point at the start of the step [m]
    float rounding_a = 0;              ///< how far A's surface is from its core, which turns with A while the surface stays where it is [m]
    float rounding_b = 0;
    float rolling_impulse = 0; ///< of the last substep [N m s]
    float carried_impulse = 0; ///< what each point has been carrying for a while, per substep [N s]

    std::array<ContactImpulse, 2> impulses; ///< of the last substep: warm start the next
    ContactSurface surface;

    std::array<std::uint32_t, 2> features{};
    int count = 0;           ///< points; a sensor's overlap counts as one
    Vec2 center_a;           ///< A's centre of mass at the start of the step [m]
    ContactImpulse last{};   ///< of all points over the last step in which it touched, once it may no longer do so
    bool has_result = false; ///< whether the solver has worked on these points: else what ContactResult holds is old
};
static_assert(sizeof(ContactManifold) == 128);

/// Where a point was at the start of the step, halfway between the surfaces [m].
inline Vec2 position_of(const ContactManifold& manifold, std::size_t point) { return manifold.center_a + manifold.arms[point].r_a; }

/// What the solver did at a contact's points in a step, by contact slot. Of one point the second is zero.
struct alignas(32) ContactResult
{
    std::array<ContactImpulse, 2> totals;   ///< over the step
    std::array<float, 2> normal_velocity{}; ///< of each point at the start of the step; negative when approaching [m/s]
    float total_rolling = 0;                ///< over the step [N m s]
};
static_assert(sizeof(ContactResult) == 32);

/// The result that goes with the points that a manifold has now.
inline ContactResult result_of(const ContactManifold& manifold, const ContactResult& result)
{
    return manifold.has_result ? result : ContactResult{};
}

/// Over all points.
inline ContactImpulse sum_of(const ContactResult& result)
{
    return {result.totals[0].normal + result.totals[1].normal, result.totals[0].tangent + result.totals[1].tangent};
}

/// What a step reads first of an awake contact: most pairs of a crowd are near and do not touch, and need nothing else.
struct AwakePair
{
    std::uint32_t shape_a;
    std::uint32_t shape_b : 31;
    /// No points, no colour, nothing that events told, and no surface beyond the two shapes: while their bounds are apart, it stays so.
    std::uint32_t is_idle : 1;
};

/// Contacts of one colour and one number of points are solved together: their bucket is 2 color + points - 1.
inline constexpr std::uint8_t bucket_count = 64;
inline constexpr std::uint8_t no_bucket = bucket_count;

inline std::uint8_t bucket_of(std::uint8_t color, int points)
{
    return color == no_color || points == 0 ? no_bucket : static_cast<std::uint8_t>(2 * color + points - 1);
}

/// What the later stages of a step read first of an awake contact.
struct AwakeState
{
    std::uint8_t bucket = no_bucket; ///< that of its colour and its points; no_bucket where the solver has nothing to do
    bool is_quiet = false;           ///< events have nothing to tell of it in this step
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
          results(&memory),
          memories(&memory),
          face_pairs(&memory),
          awake(&memory),
          awake_pairs(&memory),
          awake_states(&memory)
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
    /// Makes the bucket of a contact follow its colour and its points; nothing to do where it is asleep.
    void refresh_bucket(std::uint32_t slot);

    SlotPool slots;
    std::pmr::vector<Contact> contacts;
    std::pmr::vector<ContactManifold> manifolds;
    std::pmr::vector<ContactResult> results;
    std::pmr::vector<CollisionMemory> memories;
    std::pmr::vector<FacePair<float>> face_pairs; ///< where the memory has one
    std::pmr::vector<std::uint32_t> awake;        ///< slots, in an order that only the history of the world decides
    std::pmr::vector<AwakePair> awake_pairs;      ///< of the awake contacts, in the same order
    std::pmr::vector<AwakeState> awake_states;

private:
    std::uint32_t search_ = 0; ///< the last one's number; turns over after years, when no pair of that time is left
};

} // namespace carom::detail
