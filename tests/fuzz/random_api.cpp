// Which calls are made how often, with which ids, and what is compared.
#include "tests/fuzz/random_api.hpp"

#include "tests/fuzz/readable_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace carom::fuzz
{

namespace
{

constexpr int most_bodies = 150;

/// One of a list; null when it is empty.
template <class T>
T any_of(const std::vector<T>& list, Random& random)
{
    return list.empty() ? T{} : list[static_cast<std::size_t>(random.below(static_cast<int>(list.size())))];
}

/// Forgets the older half of what would crowd out the rest.
template <class T>
void trim(std::vector<T>& list, std::size_t most)
{
    if (list.size() > most) list.erase(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(most / 2));
}

} // namespace

void report_accepted(const char* function) { ADD_FAILURE() << function << " accepted a bad argument"; }
void report_refused(const UsageError& error) { ADD_FAILURE() << "a good call was refused: " << error.what(); }

RandomApi::RandomApi(std::uint64_t seed) : draw_(seed), hooks_(seed + 1000), world_({.memory = &hook_}), character_(CharacterDef{})
{
    hooks_.world = &world_;
    foreign_ = other_.create_body({});
}

Tally RandomApi::tally() const
{
    Tally tally = tally_;
    tally.hook_calls = hooks_.calls;
    return tally;
}

void RandomApi::remember_state()
{
    if (!is_state_known_)
    {
        hash_ = world_.hash();
        readable_.reset();
    }
    is_state_known_ = true;
    // To read everything takes five times as long as the call: for every third is enough.
    if (!readable_ && tally_.calls % 3 == 0) readable_ = readable_state(world_);
}

void RandomApi::expect_unchanged(const UsageError& error) const
{
    EXPECT_EQ(world_.hash(), hash_) << "a refused call changed the world: " << error.what();
    if (readable_)
    {
        EXPECT_EQ(readable_state(world_), *readable_) << "a refused call changed what can be read: " << error.what();
    }
}

// ---- ids ----

BodyId RandomApi::any_body()
{
    if (draw_.random.one_in(40)) return foreign_;
    return draw_.random.one_in(60) ? BodyId{} : any_of(bodies_, draw_.random);
}

BodyId RandomApi::body_id()
{
    const BodyId id = any_body();
    draw_.expect(world_.find_body(id).has_value());
    return id;
}

ShapeId RandomApi::shape_id()
{
    ShapeId id = draw_.random.one_in(60) ? ShapeId{} : any_of(shapes_, draw_.random);
    if (draw_.random.one_in(60)) id = {static_cast<std::uint32_t>(draw_.random.bits()), 1, world_.number()};
    draw_.expect(world_.find_shape(id).has_value());
    return id;
}

JointId RandomApi::joint_id()
{
    JointId id = draw_.random.one_in(60) ? JointId{} : any_of(joints_, draw_.random);
    if (draw_.random.one_in(60)) id = {static_cast<std::uint32_t>(draw_.random.bits()), 1, world_.number()};
    draw_.expect(world_.find_joint(id).has_value());
    return id;
}

ChainId RandomApi::chain_id()
{
    const ChainId id = draw_.random.one_in(20) ? ChainId{} : any_of(chains_, draw_.random);
    draw_.expect(world_.find_chain(id).has_value());
    return id;
}

FieldId RandomApi::field_id()
{
    FieldId id = draw_.random.one_in(20) ? FieldId{} : any_of(fields_, draw_.random);
    if (draw_.random.one_in(10)) id = any_of(gone_fields_, draw_.random);
    draw_.expect(std::ranges::count(fields_, id) > 0);
    return id;
}

BodyId RandomApi::gone_body()
{
    const BodyId id = any_of(bodies_, draw_.random);
    return world_.find_body(id) ? BodyId{} : id;
}

ShapeId RandomApi::gone_shape()
{
    const ShapeId id = any_of(shapes_, draw_.random);
    return world_.find_shape(id) ? ShapeId{} : id;
}

ChainId RandomApi::gone_chain()
{
    const ChainId id = any_of(chains_, draw_.random);
    return world_.find_chain(id) ? ChainId{} : id;
}

JointId RandomApi::gone_joint()
{
    const JointId id = any_of(joints_, draw_.random);
    return world_.find_joint(id) ? JointId{} : id;
}

// ---- calls ----

void RandomApi::call()
{
    struct Kind
    {
        int until; ///< of 100
        void (RandomApi::*make)();
    };
    constexpr Kind kinds[] = {{3, &RandomApi::make_chain},     {20, &RandomApi::create},       {25, &RandomApi::destroy},
                              {43, &RandomApi::edit_body},     {55, &RandomApi::push_body},    {62, &RandomApi::edit_shape},
                              {64, &RandomApi::edit_chain},    {66, &RandomApi::edit_rules},   {69, &RandomApi::edit_world},
                              {72, &RandomApi::create_joint},  {74, &RandomApi::edit_joint},   {75, &RandomApi::read},
                              {76, &RandomApi::walk},          {78, &RandomApi::cast},         {80, &RandomApi::query},
                              {81, &RandomApi::measure},       {83, &RandomApi::make_mistake}, {86, &RandomApi::call_stale_view},
                              {88, &RandomApi::call_stale_id}, {100, &RandomApi::step}};
    draw_.forget();
    const int kind = draw_.random.below(100);
    if (draw_.random.one_in(1000))
        edit_during_step();
    else
        (this->*std::ranges::find_if(kinds, [kind](const Kind& k) { return kind < k.until; })->make)();

    trim(bodies_, 400);
    trim(chains_, 60);
    trim(joints_, 400);
    trim(shapes_, 800);
    trim(gone_fields_, 20);
    trim(body_views_, 60);
    trim(shape_views_, 60);
    trim(chain_views_, 40);
    trim(joint_views_, 60);
    while (world_.body_count() > most_bodies)
    {
        world_.destroy_body(world_.bodies().front());
        forget_state();
    }
}

} // namespace carom::fuzz
