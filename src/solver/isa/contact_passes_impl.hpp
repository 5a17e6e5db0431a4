// Definitions of the passes, for the one file of each instruction set. Every function here is a template over the lane type: the linker keeps one copy
// of an inline function, and must never take that of one instruction set for another. tests: isa_symbols
#pragma once

#include "solver/isa/contact_passes.hpp"
#include "solver/kernels/bounce.hpp"

namespace carom::detail
{

template <class F>
PassConstants<F> widened(const PassConstants<float>& k)
{
    return {F(k.inv_h), F(k.push_out_speed), F(k.restitution_threshold), F(k.reach), F(k.h)};
}

template <class F, int N, class Kernel>
void for_rows(void* rows, std::size_t begin, std::size_t end, float* motions, const Kernel& kernel)
{
    for (std::size_t i = begin; i < end; ++i)
    {
        ContactRow<F, N>& row = static_cast<ContactRow<F, N>*>(rows)[i];
        BodyLanes<F> a = gather(motions, row.body_a);
        BodyLanes<F> b = gather(motions, row.body_b);
        kernel(row, a, b);
        scatter(motions, row.pushed_a, a);
        scatter(motions, row.pushed_b, b);
    }
}

template <class F>
FillConstants<F> widened(const FillConstants<float>& k)
{
    const auto wide = [](const SoftnessLanes<float>& s) { return SoftnessLanes<F>{F(s.bias_rate), F(s.mass_scale), F(s.impulse_scale)}; };
    return {F(k.warm_scale), F(k.whirl_speed), wide(k.between_dynamic), wide(k.with_static)};
}

/// How many contacts ahead their lines are fetched: those of one colour lie anywhere.
inline constexpr std::size_t fetched_ahead = 6;

/// Begins to bring a contact's lines into the cache.
template <class F>
void fetch_contact(const RowSource& source, std::uint32_t slot)
{
    const float* const manifold = source.manifolds + ManifoldFloats::all * slot;
    __builtin_prefetch(manifold);
    __builtin_prefetch(manifold + ManifoldFloats::impulses);
    __builtin_prefetch(source.bodies + source.words_per_contact * slot);
}

/// Notes in the lanes of a row which contacts and bodies they hold.
/// @param nothing the record of free lanes
/// @return the manifolds
template <class F, int N>
LaneRecords<F, const float> place_contacts(ContactRow<F, N>& row, const std::uint32_t* slots, std::size_t count, const RowSource& source,
                                           const float* nothing)
{
    LaneRecords<F, const float> manifolds;
    for (std::size_t i = 0; i < count; ++i)
    {
        const std::uint32_t* const bodies = source.bodies + source.words_per_contact * slots[i];
        row.contact[i] = slots[i];
        row.body_a[i] = source.motion_index[bodies[0]];
        row.body_b[i] = source.motion_index[bodies[1]];
        manifolds.at[i] = source.manifolds + ManifoldFloats::all * slots[i];
    }
    for (std::size_t i = count; i < static_cast<std::size_t>(lane_width<F>); ++i)
    {
        row.contact[i] = no_contact;
        row.body_a[i] = row.body_b[i] = 0;
        manifolds.at[i] = nothing;
    }
    return manifolds;
}

template <class F>
LaneRecords<F, const float> records_of(const float* records, std::size_t floats, const LaneIndices<F>& indices)
{
    LaneRecords<F, const float> lanes;
    for (std::size_t i = 0; i < static_cast<std::size_t>(lane_width<F>); ++i) lanes.at[i] = records + floats * indices[i];
    return lanes;
}

template <class F, int N>
[[gnu::flatten]] RowNeeds fill_rows(void* rows, const RowContacts& contacts, const RowSource& source)
{
    const PassConstants<F> k = widened<F>(source.pass);
    const FillConstants<F> fill_k = widened<F>(source.fill);
    const float nothing[ManifoldFloats::all] = {};
    RowNeeds needs = {};
    for (std::size_t begin = 0, r = 0; begin < contacts.count; begin += contacts.lanes, ++r)
    {
        ContactRow<F, N>& row = static_cast<ContactRow<F, N>*>(rows)[r];
        const std::size_t left = contacts.count - begin;
        const std::size_t count = left < contacts.lanes ? left : contacts.lanes;
        const std::size_t ahead = begin + fetched_ahead;
        for (std::size_t i = ahead; i < ahead + contacts.lanes && i < contacts.count; ++i) fetch_contact<F>(source, contacts.slots[i]);
        const LaneRecords<F, const float> manifolds = place_contacts(row, contacts.slots + begin, count, source, nothing);
        const RowBodies<F> bodies = {gather_velocities(source.motions, row.body_a), gather_velocities(source.motions, row.body_b),
                                     gather_four(records_of<F>(source.masses, mass_floats, row.body_a), 0),
                                     gather_four(records_of<F>(source.masses, mass_floats, row.body_b), 0)};
        fill(row, manifolds, bodies, fill_k, k);
        needs.any_bounces = needs.any_bounces || row.may_bounce;
        needs.any_belts = needs.any_belts || any(row.tangent_speed > F(0)) || any(row.tangent_speed < F(0));
    }
    return needs;
}

template <class F, int N>
[[gnu::flatten]] void warm_start_rows(void* rows, std::size_t begin, std::size_t end, float* motions, const PassConstants<float>&)
{
    for (std::size_t i = begin; i < end; ++i)
    {
        const ContactRow<F, N>& row = static_cast<const ContactRow<F, N>*>(rows)[i];
        BodyLanes<F> a = gather_velocities(motions, row.body_a);
        BodyLanes<F> b = gather_velocities(motions, row.body_b);
        warm_start(row, a, b);
        scatter(motions, row.pushed_a, a);
        scatter(motions, row.pushed_b, b);
    }
}

template <class F, int N>
[[gnu::flatten]] void solve_rows(void* rows, std::size_t begin, std::size_t end, float* motions, const PassConstants<float>& constants)
{
    const PassConstants<F> k = widened<F>(constants);
    for_rows<F, N>(rows, begin, end, motions, [&](auto& row, auto& a, auto& b) { solve(row, k, a, b); });
}

template <class F, int N>
[[gnu::flatten]] void relax_rows(void* rows, std::size_t begin, std::size_t end, float* motions, const PassConstants<float>& constants)
{
    const PassConstants<F> k = widened<F>(constants);
    for_rows<F, N>(rows, begin, end, motions, [&](auto& row, auto& a, auto& b) { relax(row, k, a, b); });
}

/// How the bodies of a row fall along its normals.
template <class F, int N>
FreeFall<F> free_fall_of(const ContactRow<F, N>& row, const float* falls)
{
    const FourLanes<F> a = gather_four(records_of<F>(falls, fall_floats, row.body_a), 0);
    const FourLanes<F> b = gather_four(records_of<F>(falls, fall_floats, row.body_b), 0);
    return {dot(LaneVec<F>{b.f0 - a.f0, b.f1 - a.f1}, row.n), dot(LaneVec<F>{b.f2 - a.f2, b.f3 - a.f3}, row.n)};
}

template <class F, int N>
[[gnu::flatten]] std::size_t list_bouncy_rows(const void* rows, std::size_t begin, std::size_t end, void* list)
{
    std::size_t count = 0;
    for (std::size_t r = begin; r < end; ++r)
    {
        const ContactRow<F, N>& row = static_cast<const ContactRow<F, N>*>(rows)[r];
        const auto has_restitution = row.restitution > F(0);
        if (!any(has_restitution)) continue;
        BouncyRow<F>& bouncy = static_cast<BouncyRow<F>*>(list)[count++];
        bouncy.pushed_a = indices_where(has_restitution, row.pushed_a);
        bouncy.pushed_b = indices_where(has_restitution, row.pushed_b);
        bouncy.row = static_cast<std::uint32_t>(r);
        bouncy.may_bounce = row.may_bounce;
    }
    return count;
}

/// After the first round only rows whose bodies have been struck since their last visit can bounce.
template <class F>
bool may_bounce_now(const BouncyRow<F>& bouncy, const BounceRound& now)
{
    if (now.round == 1 && bouncy.may_bounce) return true;
    const F before(now.round > 1 ? now.round - 1.5f : 0.5f);
    return any(gather_floats(now.struck, bouncy.pushed_a) > before) || any(gather_floats(now.struck, bouncy.pushed_b) > before);
}

template <class F, int N>
[[gnu::flatten]] bool bounce_rows(void* rows, const void* list, std::size_t count, float* motions, const PassConstants<float>& constants,
                                  const BounceRound& now)
{
    const PassConstants<F> k = widened<F>(constants);
    bool any = false;
    for (std::size_t c = 0; c < count; ++c)
    {
        const BouncyRow<F>& bouncy = static_cast<const BouncyRow<F>*>(list)[c];
        if (!may_bounce_now(bouncy, now)) continue;
        ContactRow<F, N>& row = static_cast<ContactRow<F, N>*>(rows)[bouncy.row];
        BodyLanes<F> a = gather(motions, row.body_a);
        BodyLanes<F> b = gather(motions, row.body_b);
        if (!any_bounces(row, k, a, b)) continue;
        const F bounced = bounce(row, k, a, b, free_fall_of(row, now.falls));
        BodyIndices<F> to_a = {};
        BodyIndices<F> to_b = {};
        for (int i = 0; i < lane_width<F>; ++i)
        {
            const auto at = static_cast<std::size_t>(i);
            if (!(lane(bounced, i) > 0)) continue;
            to_a[at] = row.pushed_a[at];
            to_b[at] = row.pushed_b[at];
            if (to_a[at] != 0) now.struck[to_a[at]] = now.round;
            if (to_b[at] != 0) now.struck[to_b[at]] = now.round;
            any = true;
        }
        scatter(motions, to_a, a);
        scatter(motions, to_b, b);
    }
    return any;
}

/// Where the lanes of a row are written to.
template <class F>
struct TargetRecords
{
    LaneRecords<F, float> manifolds;
    LaneRecords<F, float> results;
};

/// Marks manifolds that they have a result.
/// @param nowhere the record of free lanes
template <class F, int N>
TargetRecords<F> targets_of(const ContactRow<F, N>& row, const ResultTarget& target, float* nowhere)
{
    TargetRecords<F> records;
    for (std::size_t i = 0; i < static_cast<std::size_t>(lane_width<F>); ++i)
    {
        const std::uint32_t slot = row.contact[i];
        float* const manifold = slot == no_contact ? nowhere : target.manifolds + ManifoldFloats::all * slot;
        records.manifolds.at[i] = manifold;
        records.results.at[i] = slot == no_contact ? nowhere : target.results + result_floats * slot;
        reinterpret_cast<unsigned char*>(manifold)[ManifoldFloats::has_result] = 1;
    }
    return records;
}

template <class F, int N>
[[gnu::flatten]] void store_rows(const void* rows, std::size_t count, const ResultTarget& target)
{
    const StoreConstants<F> k = {F(target.store.carried_part), F(target.store.carry_share), F(target.store.calm_share),
                                 F(target.store.settled_within)};
    float nowhere[ManifoldFloats::all];
    for (std::size_t r = 0; r < count; ++r)
    {
        const ContactRow<F, N>& row = static_cast<const ContactRow<F, N>*>(rows)[r];
        const TargetRecords<F> records = targets_of(row, target, nowhere);
        store_points(row, records.manifolds, records.results);
        const F are_calm = gather_floats(target.is_calm, row.pushed_a) * gather_floats(target.is_calm, row.pushed_b);
        const F settles = store_load(row, records.manifolds, are_calm, k);
        if (!any(settles > F(0))) continue;
        for (int i = 0; i < lane_width<F>; ++i)
        {
            if (!(lane(settles, i) > 0)) continue;
            const std::uint32_t a = row.pushed_a[static_cast<std::size_t>(i)];
            const std::uint32_t b = row.pushed_b[static_cast<std::size_t>(i)];
            if (a != 0) target.is_settling[target.watch_bytes * a] = true;
            if (b != 0) target.is_settling[target.watch_bytes * b] = true;
        }
    }
}

template <class F, int N>
inline constexpr ContactPasses contact_passes = {&fill_rows<F, N>,        &warm_start_rows<F, N>, &solve_rows<F, N>, &relax_rows<F, N>,
                                                 &list_bouncy_rows<F, N>, &bounce_rows<F, N>,     &store_rows<F, N>};

} // namespace carom::detail
