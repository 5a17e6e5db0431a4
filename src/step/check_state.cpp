// Each check walks one structure and compares it with what the others say.
#include "step/check_state.hpp"

#include "dynamics/neighborhood.hpp"
#include "dynamics/walks.hpp"

#include <span>

namespace carom::detail
{

namespace
{

/// Collects the first complaint.
class Inspector
{
public:
    explicit Inspector(const WorldState& world) : world_(world), bodies_(world.bodies), contacts_(world.contacts), joints_(world.joints) {}

    std::string run()
    {
        check_motions();
        for (std::uint32_t body = 0; body < bodies_.slots.size() && fault_.empty(); ++body)
            if (bodies_.slots.is_live(body)) check_body(body);
        check_contacts();
        check_joints();
        check_islands();
        check_chains();
        return fault_;
    }

private:
    void expect(bool is_true, const char* claim, std::uint32_t index)
    {
        if (!is_true && fault_.empty()) fault_ = std::string(claim) + " (" + std::to_string(index) + ")";
    }

    void check_motions()
    {
        expect(bodies_.motions.size() == bodies_.masses.size() && bodies_.motions.size() == bodies_.drives.size() &&
                   bodies_.motions.size() == bodies_.watches.size(),
               "the dense arrays are equally long", 0);
        expect(bodies_.motions[0].v == Vec2{} && bodies_.motions[0].w == 0, "motion 0 stands still", 0);
        for (std::uint32_t i = 1; i < bodies_.motions.size(); ++i)
        {
            const std::uint32_t slot = bodies_.motions[i].slot;
            expect(bodies_.slots.is_live(slot) && bodies_.motion_index[slot] == i, "a motion's body knows it", i);
        }
    }

    void check_body(std::uint32_t body)
    {
        const BodyRecord& record = bodies_.records[body];
        const bool should_be_active = record.is_enabled && record.type != BodyType::Static && !record.is_asleep;
        expect(bodies_.is_active(body) == should_be_active, "a body is active when it is enabled, awake and not static", body);
        expect((record.island != null_index) == (record.is_enabled && record.type == BodyType::Dynamic), "dynamic bodies have islands",
               body);
        if (record.island != null_index)
        {
            expect(world_.islands.is_live(record.island), "a body's island is alive", body);
            expect(world_.islands.is_awake(record.island) != record.is_asleep, "a body sleeps with its island", body);
        }
        if (bodies_.is_active(body))
            expect(bodies_.watches[bodies_.motion_index[body]].island == record.island, "a watch knows the island", body);
        expect(record.ground_contacts == (bodies_.is_dynamic(body) ? ground_contacts(body) : 0), "a body counts what it lies on", body);
        check_shapes_of(body);
        check_edges_of(body);
    }

    void check_shapes_of(std::uint32_t body)
    {
        const BodyRecord& record = bodies_.records[body];
        std::uint32_t count = 0;
        std::uint32_t previous = null_index;
        for (std::uint32_t s = record.first_shape; s != null_index && fault_.empty(); s = world_.shapes.records[s].next_of_body)
        {
            expect(world_.shapes.slots.is_live(s) && world_.shapes.records[s].body == body, "a body's shapes are its own", body);
            expect(world_.shapes.records[s].previous_of_body == previous, "the list of shapes links both ways", body);
            expect(!record.is_enabled || contains(world_.shapes.bounds[s].fat, world_.shapes.bounds[s].tight), "fat bounds hold tight ones",
                   s);
            previous = s;
            ++count;
        }
        expect(count == record.shape_count && record.last_shape == previous, "a body's shapes are counted", body);
    }

    void check_edges_of(std::uint32_t body)
    {
        std::uint32_t previous = null_index;
        for (std::uint32_t e = bodies_.records[body].first_contact; e != null_index && fault_.empty();
             e = contacts_.contacts[e / 2].next[e % 2])
        {
            const Contact& contact = contacts_.contacts[e / 2];
            expect(contact.is_live && (e % 2 == 0 ? contact.body_a : contact.body_b) == body, "a body's contacts are its own", body);
            expect(contact.previous[e % 2] == previous, "the list of contacts links both ways", body);
            previous = e;
        }
        previous = null_index;
        for (std::uint32_t e = bodies_.records[body].first_joint; e != null_index && fault_.empty(); e = joints_.joints[e / 2].next[e % 2])
        {
            const Joint& joint = joints_.joints[e / 2];
            expect(joints_.slots.is_live(e / 2) && (e % 2 == 0 ? joint.body_a : joint.body_b) == body, "a body's joints are its own", body);
            expect(joint.previous[e % 2] == previous, "the list of joints links both ways", body);
            previous = e;
        }
    }

    /// By walking the body's contacts.
    std::uint32_t ground_contacts(std::uint32_t body) const
    {
        std::uint32_t count = 0;
        for (const Tie contact : contacts_of(bodies_, contacts_, body))
            count += !contacts_.contacts[contact.slot].is_sensor && !bodies_.is_dynamic(contact.other);
        return count;
    }

    void check_contacts()
    {
        std::size_t live = 0;
        std::size_t awake = 0;
        for (std::uint32_t slot = 0; slot < contacts_.slots.size() && fault_.empty(); ++slot)
        {
            const Contact& contact = contacts_.contacts[slot];
            expect(contact.is_live == contacts_.slots.is_live(slot), "a contact and its slot agree", slot);
            if (!contact.is_live) continue;
            ++live;
            awake += contact.place_in_awake != null_index ? 1 : 0;
            expect(world_.pairs.contains({contact.shape_a, contact.shape_b}), "a contact's pair is known", slot);
            const bool any_active = bodies_.is_active(contact.body_a) || bodies_.is_active(contact.body_b);
            expect(!any_active || contact.place_in_awake != null_index, "a contact with an active body is awake", slot);
            const bool are_dynamic = bodies_.is_dynamic(contact.body_a) && bodies_.is_dynamic(contact.body_b);
            const bool share_island = bodies_.records[contact.body_a].island == bodies_.records[contact.body_b].island;
            const bool has_points = !contact.is_sensor && contacts_.manifolds[slot].count > 0;
            expect(any_active || !are_dynamic || !has_points || share_island, "sleepers that touch share an island", slot);
            if (contact.neighborhood == Neighborhood::Empty || contact.neighborhood == Neighborhood::Ground)
                expect(contact.neighborhood == neighborhood_of(contact, bodies_, world_.shapes), "a contact's neighbourhood is as it was",
                       slot);
            if (contact.color == no_color) continue;
            expect(any_active && !contact.is_sensor, "a coloured contact has an active body", slot);
            expect(!are_dynamic || share_island, "bodies that push each other share an island", slot);
        }
        expect(live == world_.pairs.size(), "there is a contact for every pair", 0);
        expect(awake == contacts_.awake.size(), "awake contacts are listed", 0);
        check_awake_pairs();
    }

    void check_awake_pairs()
    {
        expect(contacts_.awake_pairs.size() == contacts_.awake.size(), "an awake contact has a pair", 0);
        expect(contacts_.awake_states.size() == contacts_.awake.size(), "an awake contact has a state", 0);
        for (std::size_t place = 0; place < contacts_.awake_pairs.size() && fault_.empty(); ++place)
        {
            const std::uint32_t slot = contacts_.awake[place];
            const Contact& contact = contacts_.contacts[slot];
            const AwakePair& pair = contacts_.awake_pairs[place];
            expect(pair.shape_a == contact.shape_a && pair.shape_b == contact.shape_b, "an awake pair is that of its contact", slot);
            const bool can_be_idle =
                contacts_.manifolds[slot].count == 0 && contact.color == no_color && !contact.is_touching && !contact.is_hitting;
            expect(!pair.is_idle || can_be_idle, "an idle contact has nothing to tell", slot);
            expect(contacts_.awake_states[place].bucket == bucket_of(contact.color, contacts_.manifolds[slot].count),
                   "a contact's bucket is that of its colour and its points", slot);
        }
    }

    void check_joints()
    {
        for (std::uint32_t slot = 0; slot < joints_.slots.size() && fault_.empty(); ++slot)
        {
            if (!joints_.slots.is_live(slot)) continue;
            const Joint& joint = joints_.joints[slot];
            const bool pushes = (joint.body_a != null_index && bodies_.is_pushable(joint.body_a)) || bodies_.is_pushable(joint.body_b);
            expect(!joint.is_active() || pushes, "an active joint can push", slot);
            if (!joint.is_active()) continue;
            expect(joint.place_in_active < joints_.active.size() && joints_.active[joint.place_in_active] == slot,
                   "active joints are listed", slot);
            if (joint.body_a == null_index || !bodies_.is_dynamic(joint.body_a) || !bodies_.is_dynamic(joint.body_b)) continue;
            expect(bodies_.records[joint.body_a].island == bodies_.records[joint.body_b].island, "joined bodies share an island", slot);
        }
    }

    void check_islands()
    {
        std::uint32_t in_islands = 0;
        for (std::uint32_t island = 0; island < world_.islands.size() && fault_.empty(); ++island)
        {
            if (!world_.islands.is_live(island)) continue;
            std::uint32_t count = 0;
            std::uint32_t previous = null_index;
            for (std::uint32_t b = world_.islands[island].first_body; b != null_index && fault_.empty();
                 b = bodies_.records[b].next_in_island)
            {
                expect(bodies_.slots.is_live(b) && bodies_.records[b].island == island, "an island's bodies are its own", island);
                expect(bodies_.records[b].previous_in_island == previous, "the list of an island links both ways", island);
                previous = b;
                ++count;
            }
            expect(count == world_.islands[island].body_count && count > 0, "an island's bodies are counted", island);
            in_islands += count;
        }
        std::uint32_t dynamic = 0;
        for (std::uint32_t body = 0; body < bodies_.slots.size(); ++body)
            dynamic += bodies_.slots.is_live(body) && bodies_.records[body].island != null_index ? 1 : 0;
        expect(in_islands == dynamic, "every dynamic body is in one island", 0);
    }

    void check_chains()
    {
        const ShapeStore& shapes = world_.shapes;
        std::uint32_t in_chains = 0;
        for (std::uint32_t chain = 0; chain < world_.chains.slots.size() && fault_.empty(); ++chain)
        {
            if (!world_.chains.slots.is_live(chain)) continue;
            const ChainRecord& record = world_.chains.records[chain];
            std::uint32_t segment = record.first_shape;
            for (std::uint32_t i = 0; i < record.segment_count && fault_.empty(); ++i)
            {
                const bool is_its_own = segment != null_index && shapes.slots.is_live(segment) && shapes.records[segment].chain == chain &&
                                        shapes.records[segment].body == record.body;
                expect(is_its_own, "a chain's segments are its own", chain);
                if (!is_its_own) return;
                const std::uint32_t next = shapes.records[segment].next_in_chain;
                expect(next == null_index || shapes.records[next].previous_in_chain == segment, "segments link both ways", chain);
                segment = next;
                ++in_chains;
            }
            expect(segment == (record.is_loop ? record.first_shape : null_index), "a loop ends where it starts", chain);
        }
        std::uint32_t segments = 0;
        for (std::uint32_t shape = 0; shape < shapes.slots.size(); ++shape)
            segments += shapes.slots.is_live(shape) && shapes.records[shape].chain != null_index ? 1 : 0;
        expect(in_chains == segments, "every segment is in its chain", 0);
    }

    const WorldState& world_;
    const BodyStore& bodies_;
    const ContactStore& contacts_;
    const JointStore& joints_;
    std::string fault_;
};

} // namespace

std::string first_fault(const WorldState& world) { return Inspector(world).run(); }

} // namespace carom::detail
