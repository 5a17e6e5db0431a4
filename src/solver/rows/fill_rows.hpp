// Between contacts and rows: what rows are filled from, where they lie, and where their results go.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "memory/floats_of.hpp"
#include "solver/isa/contact_passes.hpp"
#include "solver/rows/body_lanes.hpp"
#include "solver/rows/softness.hpp"

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>

namespace carom::detail
{

static_assert(sizeof(ContactManifold) == ManifoldFloats::all * sizeof(float));
static_assert(offsetof(ContactManifold, arms) == ManifoldFloats::arms * sizeof(float) &&
              offsetof(ContactManifold, normal) == ManifoldFloats::normal * sizeof(float) &&
              offsetof(ContactManifold, impulses) == ManifoldFloats::impulses * sizeof(float));
static_assert(offsetof(ContactManifold, carried_impulse) == (ManifoldFloats::normal + 7) * sizeof(float));
static_assert(offsetof(ContactManifold, surface) == (ManifoldFloats::impulses + 4) * sizeof(float));
static_assert(offsetof(Contact, body_b) == offsetof(Contact, body_a) + sizeof(std::uint32_t));
static_assert(sizeof(BodyMass) == mass_floats * sizeof(float) && offsetof(BodyMass, inv_inertia) == 2 * sizeof(float));
static_assert(offsetof(ContactManifold, rolling_impulse) == ManifoldFloats::rolling * sizeof(float));
static_assert(sizeof(ContactResult) == result_floats * sizeof(float) && offsetof(ContactResult, normal_velocity) == 4 * sizeof(float) &&
              offsetof(ContactResult, total_rolling) == 6 * sizeof(float));
static_assert(null_index == no_contact && offsetof(ContactManifold, has_result) == ManifoldFloats::has_result && sizeof(bool) == 1);

/// A body that turns by more than this in a substep meets others as a disc would [rad]: see round_off().
inline constexpr float whirl = 1;

inline SoftnessLanes<float> lanes_of(const Softness& softness) { return {softness.bias_rate, softness.mass_scale, softness.impulse_scale}; }

inline RowSource source_of(const BodyStore& bodies, const ContactStore& contacts, const ContactConstants& constants,
                           const PassConstants<float>& pass)
{
    return {.manifolds = floats_of(contacts.manifolds),
            .bodies = contacts.contacts.empty() ? nullptr : &contacts.contacts.front().body_a,
            .words_per_contact = sizeof(Contact) / sizeof(std::uint32_t),
            .motion_index = bodies.motion_index.data(),
            .masses = floats_of(bodies.masses),
            .motions = floats_of(std::span(bodies.motions)),
            .fill = {constants.warm_scale, whirl * constants.inv_h, lanes_of(constants.between_dynamic), lanes_of(constants.with_static)},
            .pass = pass};
}

inline ResultTarget target_of(ContactStore& contacts, std::span<BodyWatch> watches, std::span<const float> is_calm,
                              const StoreConstants<float>& constants)
{
    return {.manifolds = floats_of(contacts.manifolds),
            .results = floats_of(contacts.results),
            .is_calm = is_calm.data(),
            .is_settling = &watches.front().is_settling,
            .watch_bytes = sizeof(BodyWatch),
            .store = constants};
}

/// Rows that a pass fills: nothing is written to them before.
template <class Row>
class RowList
{
public:
    explicit RowList(std::pmr::memory_resource& memory) : memory_(memory) {}
    RowList(const RowList&) = delete;
    RowList& operator=(const RowList&) = delete;
    ~RowList() { give_back(); }

    /// Forgets all rows, and makes room for others.
    void renew(std::size_t room)
    {
        give_back();
        rows_ = room == 0 ? nullptr : static_cast<Row*>(memory_.allocate(room * sizeof(Row), alignof(Row)));
        room_ = room;
        size_ = 0;
    }
    /// @return the first of `count` more rows
    Row* add(std::size_t count)
    {
        Row* const first = rows_ + size_;
        size_ += count;
        return first;
    }
    Row* data() { return rows_; }
    Row* end() { return rows_ + size_; }
    std::size_t size() const { return size_; }
    const Row* begin() const { return rows_; }
    const Row* end() const { return rows_ + size_; }

private:
    void give_back()
    {
        if (room_ > 0) memory_.deallocate(rows_, room_ * sizeof(Row), alignof(Row));
        room_ = 0;
    }

    std::pmr::memory_resource& memory_;
    Row* rows_ = nullptr;
    std::size_t size_ = 0;
    std::size_t room_ = 0;
};

} // namespace carom::detail
