// Finds how far two shapes may move until they have to be searched again.
#include "dynamics/collision_memory.hpp"

#include <algorithm>
#include <limits>
#include <variant>

namespace carom::detail
{

namespace
{

/// While an edge faces a face more squarely than its neighbours by twice this, its ends are the deepest corners, whatever rounding does: the
/// next corners are higher by a fiftieth of an edge.
constexpr float least_turn_lead = 1e-4f;

float l1_norm(Vec2 v) { return std::abs(v.x) + std::abs(v.y); }

} // namespace

CollisionMemory remember(const FaceSearch& search, const Searched& a, const Searched& b, const Transform& b_in_a)
{
    CollisionMemory memory;
    if (spares_no_search(search)) return memory;

    const bool b_is_smaller = b.extent.outer <= a.extent.outer;
    const Searched& smaller = b_is_smaller ? b : a;
    const Vec2 middle_a = a.extent.middle;
    const Vec2 middle_b = b_in_a * b.extent.middle;
    memory.made_at = b_in_a;
    memory.arm = (b_is_smaller ? middle_b : middle_a) - b_in_a.p;
    float most_turn = std::numeric_limits<float>::max();
    if (search.gap > 0)
    {
        memory.result = CollisionMemory::Result::Gap;
        memory.radius = std::holds_alternative<Circle>(smaller.geometry) ? 0 : smaller.extent.outer;
        memory.allowed = search.gap;
    }
    else
    {
        memory.result = CollisionMemory::Result::Faces;
        memory.radius = distance(middle_a, middle_b) + std::max(a.extent.outer, b.extent.outer); // all corners of both
        memory.allowed = 0.5f * search.lead;
        most_turn = 0.5f * search.turn_lead - least_turn_lead;
        memory.faces_a = static_cast<std::uint8_t>(search.face_a + 16 * search.facing_a);
        memory.faces_b = static_cast<std::uint8_t>(search.face_b + 16 * search.facing_b);
    }
    // Above the rounding of everything that is compared; more than a hundred times of a float's last digit.
    constexpr float rounding_share = 1e-5f;
    memory.allowed -= rounding_share * (l1_norm(b_in_a.p) + l1_norm(memory.arm) + memory.radius);
    if (memory.allowed <= 0 || most_turn <= 0) memory.result = CollisionMemory::Result::Nothing;
    if (memory.allowed > most_turn * memory.radius) memory.radius = memory.allowed / most_turn;
    return memory;
}

} // namespace carom::detail
