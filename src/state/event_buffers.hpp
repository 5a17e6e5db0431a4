// The lists of events of a step, and the ends that edits between steps caused.
#pragma once

#include "dynamics/contact_rules.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/shape_store.hpp"
#include "memory/make_room.hpp"
#include "solver/continuous/continuous.hpp"

#include <carom/events.hpp>
#include <carom/memory.hpp>

#include <memory_resource>
#include <type_traits>
#include <vector>

namespace carom::detail
{

/// Lists that World::events() shows, and ends that wait for the next step.
struct EventBuffers
{
    explicit EventBuffers(std::pmr::memory_resource& memory)
        : arena(first_arena, &memory),
          contact_begin(&arena),
          contact_persist(&arena),
          contact_end(&arena),
          contact_hit(&arena),
          sensor_begin(&arena),
          sensor_persist(&arena),
          sensor_end(&arena),
          pending_contact_end(&memory),
          pending_sensor_end(&memory),
          joint_break(&memory),
          fell_asleep(&memory),
          woke(&memory)
    {
    }

    /// Forgets the last step.
    void clear()
    {
        const auto renew = [this](auto& list) { list = std::remove_reference_t<decltype(list)>(&arena); };
        renew(contact_begin), renew(contact_persist), renew(contact_end), renew(contact_hit);
        renew(sensor_begin), renew(sensor_persist), renew(sensor_end);
        arena.reset();
        joint_break.clear();
        fell_asleep.clear();
        woke.clear();
    }

    /// Forgets the last step, and gives back all memory but what holds the ends that wait to be told.
    void shrink()
    {
        clear();
        arena.release();
        cut(pending_contact_end, pending_contact_end.size());
        cut(pending_sensor_end, pending_sensor_end.size());
        cut(joint_break, 0);
        cut(fell_asleep, 0);
        cut(woke, 0);
    }

    static constexpr std::size_t first_arena = 4096; // [bytes]; it learns how much a step tells
    LinearResource arena;                            ///< of the lists that a step fills
    std::pmr::vector<ContactBegin> contact_begin;
    std::pmr::vector<ContactPersist> contact_persist;
    std::pmr::vector<ContactEnd> contact_end;
    std::pmr::vector<ContactHit> contact_hit;
    std::pmr::vector<SensorEvent> sensor_begin;
    std::pmr::vector<SensorEvent> sensor_persist;
    std::pmr::vector<SensorEvent> sensor_end;
    std::pmr::vector<ContactEnd> pending_contact_end;
    std::pmr::vector<SensorEvent> pending_sensor_end;
    std::pmr::vector<JointBreak> joint_break;
    std::pmr::vector<BodyId> fell_asleep;
    std::pmr::vector<BodyId> woke;
    int touching = 0; ///< contacts that touch, as the events have told it; sleeping ones too
};

ShapeId shape_id(const ShapeStore& shapes, std::uint32_t slot, std::uint32_t world);

/// A contact as the public API shows it.
/// @param stored what the store holds for it
Manifold public_manifold(const ContactManifold& manifold, const ContactResult& stored);

/// Notes that a contact which the events have told as touching ends, whatever the reason. Call before its shapes are gone.
/// @param result of the last step in which it was solved
void note_end(const Contact& contact, const ContactResult& result, const ShapeStore& shapes, std::uint32_t world, EventBuffers& events);

/// Compares what touches now with what the events have told, and fills the lists, each ordered by the shapes' indices.
/// @return number of contacts that touch
/// @param crossings overlaps that began and ended within the step: they are told now as begun, and in the next step as ended
int emit_events(ContactStore& contacts, std::span<const Crossing> crossings, const ShapeStore& shapes, const ContactRules& rules,
                EventBuffers& events);

} // namespace carom::detail
