// From contacts to rows: each contact becomes a lane of a row for its number of points.
#pragma once

#include "memory/fetch_lines.hpp"
#include "solver/kernels/contact_row.hpp"
#include "solver/rows/body_lanes.hpp"
#include "solver/rows/graph_colors.hpp"
#include "solver/rows/softness.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// A body that turns by more than this in a substep is everywhere around its centre at once, and meets others as a disc would [rad]. At its corner as it
/// happens to be, its spin may seem to take it away from what it runs into. Test: bullets_test.
inline constexpr float whirl = 1;

/// The arm of a point on a disc: straight towards what it touches.
inline Vec2 arm_of_disc(Vec2 r, Vec2 n) { return dot(r, n) * n; }

/// Writes a contact into lane `i` of a row; the rest follows from that in prepare().
template <class F, int N>
void fill_row(ContactRow<F, N>& row, int i, std::uint32_t slot, const BodyStore& bodies, const ContactStore& contacts,
              const ContactConstants& constants)
{
    const Contact& contact = contacts.contacts[slot];
    const ContactManifold& manifold = contacts.manifolds[slot];
    const std::uint32_t index_a = bodies.motion_index[contact.body_a];
    const std::uint32_t index_b = bodies.motion_index[contact.body_b];
    const BodyMass mass_a = bodies.masses[index_a];
    const BodyMass mass_b = bodies.masses[index_b];
    const bool with_static = mass_a.inv_mass == Vec2{} || mass_b.inv_mass == Vec2{};
    const Softness& softness = with_static ? constants.with_static : constants.between_dynamic;
    const float whirl_speed = whirl * constants.inv_h;
    const float w_a = bodies.motions[index_a].w;
    const float w_b = bodies.motions[index_b].w;
    const bool a_whirls = w_a * w_a > whirl_speed * whirl_speed;
    const bool b_whirls = w_b * w_b > whirl_speed * whirl_speed;
    const Vec2 n = manifold.normal;
    const float gap = 0.5f * manifold.separation[0]; // points are halfway between the surfaces

    row.contact[static_cast<std::size_t>(i)] = slot;
    fill_bodies(row, i, index_a, index_b, mass_a, mass_b);
    set_lane(row.n, i, n);
    lane(row.core_a, i) = a_whirls ? dot(manifold.arms[0].r_a, n) : manifold.rounding_a + gap;
    lane(row.core_b, i) = b_whirls ? -dot(manifold.arms[0].r_b, n) : manifold.rounding_b + gap;
    lane(row.friction, i) = manifold.surface.friction;
    lane(row.restitution, i) = manifold.surface.restitution;
    lane(row.tangent_speed, i) = manifold.surface.tangent_speed;
    lane(row.rolling_resistance, i) = manifold.surface.rolling_resistance;
    lane(row.rolling_lambda, i) = constants.warm_scale * manifold.rolling_impulse;
    lane(row.bias_rate, i) = softness.bias_rate;
    lane(row.mass_scale, i) = softness.mass_scale;
    lane(row.impulse_scale, i) = softness.impulse_scale;
    lane(row.carried, i) = constants.warm_scale * manifold.carried_impulse;
    for (std::size_t p = 0; p < N; ++p)
    {
        const ContactArms& arms = manifold.arms[p];
        PointRow<F>& to = row.points[p];
        set_lane(to.r_a, i, a_whirls ? arm_of_disc(arms.r_a, n) : arms.r_a);
        set_lane(to.r_b, i, b_whirls ? arm_of_disc(arms.r_b, n) : arms.r_b);
        lane(to.adjusted_separation, i) = manifold.separation[p]; // prepare() adjusts it
        lane(to.lambda_n, i) = constants.warm_scale * manifold.impulses[p].normal;
        lane(to.lambda_t, i) = constants.warm_scale * manifold.impulses[p].tangent;
    }
}

/// The contacts of each colour by their number of points, both parts in the colour's order. Split without a branch, which random numbers of points
/// would mislead.
class ContactsByPoints
{
public:
    ContactsByPoints(const ColorLists& colors, const ContactStore& contacts, std::pmr::memory_resource& memory)
        : singles_(colors.size() + 1, &memory),
          doubles_(colors.size() + 1, &memory)
    {
        for (int color = 0; color < color_count; ++color)
        {
            std::size_t& single = ends_[static_cast<std::size_t>(color) + 1].single;
            std::size_t& pair = ends_[static_cast<std::size_t>(color) + 1].pair;
            single = ends_[static_cast<std::size_t>(color)].single;
            pair = ends_[static_cast<std::size_t>(color)].pair;
            for (const std::uint32_t slot : colors.list(color))
            {
                const std::size_t has_one = contacts.manifolds[slot].count == 1 ? 1 : 0;
                singles_[single] = doubles_[pair] = slot;
                single += has_one;
                pair += 1 - has_one;
            }
        }
    }

    std::span<const std::uint32_t> singles(int color) const { return part(singles_, &Ends::single, color); }
    std::span<const std::uint32_t> doubles(int color) const { return part(doubles_, &Ends::pair, color); }

private:
    struct Ends
    {
        std::size_t single = 0;
        std::size_t pair = 0;
    };

    std::span<const std::uint32_t> part(const std::pmr::vector<std::uint32_t>& slots, std::size_t Ends::* end, int color) const
    {
        const std::size_t begin = ends_[static_cast<std::size_t>(color)].*end;
        return std::span(slots).subspan(begin, ends_[static_cast<std::size_t>(color) + 1].*end - begin);
    }

    std::pmr::vector<std::uint32_t> singles_;
    std::pmr::vector<std::uint32_t> doubles_;
    std::array<Ends, color_count + 1> ends_ = {};
};

/// How many contacts ahead their lines are fetched: those of one colour lie anywhere.
inline constexpr std::size_t fetched_ahead = 6;

/// Puts contacts one after the other into the lanes of rows; a last row's free lanes stay zero and push nothing.
/// @param lanes how many lanes of a row to use: all, or one where contacts depend on each other
/// @return whether a surface has a tangent speed
template <class F, int N>
bool write_rows(std::pmr::vector<ContactRow<F, N>>& rows, std::span<const std::uint32_t> slots, std::size_t lanes, const BodyStore& bodies,
                const ContactStore& contacts, const ContactConstants& constants)
{
    bool any_belts = false;
    for (std::size_t begin = 0; begin < slots.size(); begin += lanes)
    {
        ContactRow<F, N>& row = rows.emplace_back();
        row.contact.fill(null_index);
        const std::size_t end = std::min(begin + lanes, slots.size());
        for (std::size_t i = begin; i < end; ++i)
        {
            if (i + fetched_ahead < slots.size())
            {
                fetch_lines(contacts.contacts[slots[i + fetched_ahead]]);
                fetch_lines(contacts.manifolds[slots[i + fetched_ahead]]);
            }
            fill_row(row, static_cast<int>(i - begin), slots[i], bodies, contacts, constants);
            any_belts |= contacts.manifolds[slots[i]].surface.tangent_speed != 0;
        }
    }
    return any_belts;
}

} // namespace carom::detail
