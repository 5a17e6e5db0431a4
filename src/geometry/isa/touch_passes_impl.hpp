// Definitions of the passes, for the one file of each instruction set. Every function here is a template over the lane type, as in
// solver/isa/contact_passes_impl.hpp. tests: isa_symbols
#pragma once

#include "geometry/isa/touch_passes.hpp"
#include "geometry/kernels/bounds_lanes.hpp"
#include "math/lane_records.hpp"

namespace carom::detail
{

template <class F>
LaneRecords<F, const float> records_at(const float* records, std::size_t stride, const std::uint32_t* indices)
{
    LaneRecords<F, const float> lanes;
    for (std::size_t i = 0; i < static_cast<std::size_t>(lane_width<F>); ++i) lanes.at[i] = records + stride * indices[i];
    return lanes;
}

template <class F>
LanePose<F> gather_poses(const float* poses, const std::uint32_t* bodies)
{
    const EightLanes<F> c = gather_eight(records_at<F>(poses, pose_floats, bodies), 0);
    return {{{c.f0, c.f1}, {c.f2, c.f3}}, {c.f4, c.f5}, {c.f6, c.f7}};
}

template <class F>
SearchedAt<F> gather_searches(const TouchBatch& batch, const std::uint32_t* contacts)
{
    const EightLanes<F> c = gather_eight(records_at<F>(batch.searches, batch.search_stride, contacts), 0);
    return {{{c.f0, c.f1}, {c.f2, c.f3}}, {c.f4, c.f5}, c.f6, c.f7};
}

template <class F>
FacePair<F> gather_face_pairs(const float* face_pairs, const std::uint32_t* contacts)
{
    const LaneRecords<F, const float> records = records_at<F>(face_pairs, face_pair_floats, contacts);
    const EightLanes<F> a = gather_eight(records, 0);
    const EightLanes<F> b = gather_eight(records, 8);
    return {{a.f0, a.f1}, {a.f2, a.f3}, {a.f4, a.f5}, {a.f6, a.f7}, {b.f0, b.f1}, {b.f2, b.f3}, {b.f4, b.f5}, b.f6, b.f7};
}

template <class F>
void store_rows(TouchRow* rows, const FaceTouch<F>& touch)
{
    LaneRecords<F, float> records;
    for (std::size_t i = 0; i < static_cast<std::size_t>(lane_width<F>); ++i) records.at[i] = rows[i].arms;
    scatter_eight(
        records, 0,
        {touch.r_a[0].x, touch.r_a[0].y, touch.r_b[0].x, touch.r_b[0].y, touch.r_a[1].x, touch.r_a[1].y, touch.r_b[1].x, touch.r_b[1].y});
    scatter_four(records, 8, {touch.normal.x, touch.normal.y, touch.separation[0], touch.separation[1]});
}

/// Rounds a list up to a whole number of lanes with copies of its last element.
template <class F>
void fill_up(std::uint32_t* list, std::size_t count)
{
    for (std::size_t i = count; i % static_cast<std::size_t>(lane_width<F>) != 0; ++i) list[i] = list[i - 1];
}

/// Of a shape in each lane.
template <class F>
struct BoundsLanes
{
    LaneBox<F> tight;
    LaneBox<F> fat;
};

template <class F>
BoundsLanes<F> gather_bounds(const float* bounds, const std::uint32_t* shapes)
{
    const EightLanes<F> c = gather_eight(records_at<F>(bounds, bounds_floats, shapes), 0);
    return {{{c.f0, c.f1}, {c.f2, c.f3}}, {{c.f4, c.f5}, {c.f6, c.f7}}};
}

template <class F>
[[gnu::flatten]] BoundsResults compare_all_bounds(BoundsBatch& batch)
{
    fill_up<F>(batch.shapes_a, batch.count);
    fill_up<F>(batch.shapes_b, batch.count);
    std::uint64_t are_separated_bits = 0;
    std::uint64_t are_apart_bits = 0;
    for (std::size_t i = 0; i < batch.count; i += static_cast<std::size_t>(lane_width<F>))
    {
        const BoundsLanes<F> a = gather_bounds<F>(batch.bounds, batch.shapes_a + i);
        const BoundsLanes<F> b = gather_bounds<F>(batch.bounds, batch.shapes_b + i);
        are_separated_bits |= static_cast<std::uint64_t>(mask_bits(are_apart(a.fat, b.fat, F(0)))) << i;
        are_apart_bits |= static_cast<std::uint64_t>(mask_bits(are_apart(a.tight, b.tight, F(batch.margin)))) << i;
    }
    return {are_separated_bits, are_apart_bits};
}

template <class F>
[[gnu::flatten]] void touch_all(TouchBatch& batch, TouchResults& results)
{
    fill_up<F>(batch.contacts, batch.count);
    fill_up<F>(batch.bodies_a, batch.count);
    fill_up<F>(batch.bodies_b, batch.count);
    std::uint64_t are_known = 0;
    std::uint64_t have_lower = 0;
    std::uint64_t have_upper = 0;
    std::uint64_t references_are_b = 0;
    for (std::size_t i = 0; i < batch.count; i += static_cast<std::size_t>(lane_width<F>))
    {
        const FaceTouch<F> touch = touch_faces(
            gather_poses<F>(batch.poses, batch.bodies_a + i), gather_poses<F>(batch.poses, batch.bodies_b + i),
            gather_searches<F>(batch, batch.contacts + i), gather_face_pairs<F>(batch.face_pairs, batch.contacts + i), batch.limits);
        store_rows(results.rows + i, touch);
        are_known |= static_cast<std::uint64_t>(mask_bits(touch.is_known)) << i;
        have_lower |= static_cast<std::uint64_t>(mask_bits(touch.has_lower)) << i;
        have_upper |= static_cast<std::uint64_t>(mask_bits(touch.has_upper)) << i;
        references_are_b |= static_cast<std::uint64_t>(mask_bits(touch.reference_is_b)) << i;
    }
    results.are_known = are_known;
    results.have_lower = have_lower;
    results.have_upper = have_upper;
    results.references_are_b = references_are_b;
}

template <class F>
inline constexpr TouchPasses touch_passes = {&compare_all_bounds<F>, &touch_all<F>};

} // namespace carom::detail
