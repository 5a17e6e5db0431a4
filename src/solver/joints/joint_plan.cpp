// Finds mechanisms, sorts them by kind, and lays out their rows.
#include "solver/joints/joint_plan.hpp"

#include "solver/joints/joint_setup.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace carom::detail
{

namespace
{

/// A body with more joints than colours: what is left is solved one by one, after all colours.
constexpr std::uint32_t last_color = 64;

constexpr std::uint32_t shape_bits = 16;

std::uint32_t shape_number(const JointSpec& spec) { return shape_of(spec).key() << 4 | static_cast<std::uint32_t>(spec.index()); }

/// What JointShape::key() puts together.
JointShape shape_with_key(std::uint32_t key)
{
    JointShape shape;
    std::uint32_t rest = key - 1;
    shape.has_ends = rest >= 24;
    rest %= 24;
    shape.has_drive = rest >= 12;
    rest %= 12;
    shape.controls = rest / 4;
    shape.rigid = rest % 4;
    return shape;
}

JointShape shape_with_number(std::uint32_t number) { return shape_with_key(number >> 4); }

std::size_t row_size(const JointShape& shape, std::uint32_t lanes)
{
    switch (lanes)
    {
    case 4: return row_bytes<LaneArray<4>>(shape.controls, shape.has_drive);
    case 8: return row_bytes<LaneArray<8>>(shape.controls, shape.has_drive);
    case 16: return row_bytes<LaneArray<16>>(shape.controls, shape.has_drive);
    default: return row_bytes<float>(shape.controls, shape.has_drive);
    }
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) { return (hash ^ value) * 0x9e3779b97f4a7c15u ^ (hash >> 29); }

} // namespace

JointPlan::JointPlan(std::pmr::memory_resource& memory)
    : rows(&memory),
      offsets(&memory),
      slots(&memory),
      bodies(&memory),
      groups(&memory),
      memory_(&memory),
      eliminator_(memory),
      signature_(&memory),
      members_(&memory),
      kinds_(&memory),
      kind_by_hash_(&memory),
      now_(&memory),
      parent_(&memory),
      number_(&memory),
      colors_(&memory),
      order_(&memory),
      body_list_(&memory),
      components_(&memory),
      joints_(&memory),
      can_move_(&memory),
      same_kind_(&memory),
      used_kinds_(&memory),
      single_(&memory)
{
}

JointPlan::Member JointPlan::member_of(std::uint32_t slot, const BodyStore& bodies, const JointStore& joints)
{
    const Joint& joint = joints.joints[slot];
    const auto moves = [&](std::uint32_t body) { return body != null_index && can_be_pushed(bodies.masses[bodies.motion_index[body]]); };
    return {slot, joint.body_a, joint.body_b, shape_number(joint.spec), moves(joint.body_a), moves(joint.body_b)};
}

bool JointPlan::update(const BodyStore& body_store, const JointStore& joints, int lanes)
{
    const bool is_untouched = joints.revision == joint_revision_ && body_store.revision == body_revision_;
    if (is_untouched && lanes == lanes_) return false;
    joint_revision_ = joints.revision;
    body_revision_ = body_store.revision;
    now_.clear();
    for (const std::uint32_t slot : joints.active) now_.push_back(member_of(slot, body_store, joints));
    if (now_ == signature_ && lanes == lanes_) return false;
    signature_ = now_;
    lanes_ = lanes;
    members_ = now_;
    std::sort(members_.begin(), members_.end(), [](const Member& l, const Member& r) { return l.slot < r.slot; });

    rows.clear();
    offsets.clear();
    slots.clear();
    bodies.clear();
    groups.clear();
    bytes = single_rows = 0;
    if (members_.empty()) return true;
    for (Kind& kind : kinds_) kind.count = 0;
    const std::size_t body_count = body_store.motion_index.size();
    find_components(body_count);
    for (Component& component : components_)
    {
        name_bodies(component);
        component.kind = kind_in_hand();
        ++kinds_[component.kind].count;
    }
    place_single_rows(body_count, static_cast<std::uint32_t>(lanes));
    place_groups(static_cast<std::uint32_t>(lanes));
    drop_unused_kinds();
    return true;
}

/// Whether a joint takes part in a mechanism. Bodies that are locked in every way can't be held.
bool JointPlan::holds_rigidly(const Member& member)
{
    return shape_with_number(member.shape).rigid > 0 && (member.moves_a || member.moves_b);
}

std::uint32_t JointPlan::root_of(std::uint32_t body)
{
    while (parent_[body] != body) body = parent_[body] = parent_[parent_[body]];
    return body;
}

/// Joints that hold something rigidly, component by component in the order of their first joints.
void JointPlan::find_components(std::size_t body_count)
{
    parent_.resize(body_count);
    for (std::uint32_t body = 0; body < body_count; ++body) parent_[body] = body;
    for (const Member& m : members_)
        if (holds_rigidly(m) && m.moves_a && m.moves_b) parent_[root_of(m.body_b)] = root_of(m.body_a);

    components_.clear();
    number_.assign(body_count + 1, null_index);
    const auto component_of = [&](const Member& m) -> std::uint32_t& { return number_[root_of(m.moves_a ? m.body_a : m.body_b)]; };
    for (const Member& m : members_)
    {
        if (!holds_rigidly(m)) continue;
        std::uint32_t& component = component_of(m);
        if (component == null_index)
        {
            component = static_cast<std::uint32_t>(components_.size());
            components_.push_back({});
        }
        ++components_[component].count;
    }
    std::uint32_t next = 0;
    for (Component& component : components_)
    {
        component.begin = next;
        next += component.count;
        component.count = 0;
    }
    order_.resize(next);
    for (std::uint32_t i = 0; i < members_.size(); ++i)
    {
        if (!holds_rigidly(members_[i])) continue;
        Component& component = components_[component_of(members_[i])];
        order_[component.begin + component.count++] = i;
    }
    body_list_.clear();
    number_.assign(body_count + 1, null_index); // from here on places in a component
}

/// Numbers a component's bodies in the order in which its joints name them, and describes its joints by these numbers.
void JointPlan::name_bodies(Component& component)
{
    joints_.clear();
    can_move_.clear();
    component.bodies_begin = static_cast<std::uint32_t>(body_list_.size());
    const auto place_of = [&](std::uint32_t body, bool moves)
    {
        std::uint32_t& place = number_[body == null_index ? number_.size() - 1 : body];
        if (place == null_index)
        {
            place = static_cast<std::uint32_t>(can_move_.size());
            can_move_.push_back(moves ? 1 : 0);
            body_list_.push_back(body);
        }
        return place;
    };
    for (std::uint32_t i = component.begin; i < component.begin + component.count; ++i)
    {
        const Member& m = members_[order_[i]];
        const std::uint32_t a = place_of(m.body_a, m.moves_a);
        const std::uint32_t b = place_of(m.body_b, m.moves_b);
        joints_.push_back({{a, b}, shape_with_number(m.shape).rigid, m.shape});
    }
    component.bodies_end = static_cast<std::uint32_t>(body_list_.size());
    for (std::uint32_t i = component.bodies_begin; i < component.bodies_end; ++i)
        number_[body_list_[i] == null_index ? number_.size() - 1 : body_list_[i]] = null_index;
}

/// The kind of the component in hand, planned when it is the first.
std::uint32_t JointPlan::kind_in_hand()
{
    std::uint64_t hash = can_move_.size();
    for (const PlannedJoint& j : joints_) hash = mixed(mixed(hash, std::uint64_t{j.ends.a} << 32 | j.ends.b), j.shape);
    auto known = std::lower_bound(kind_by_hash_.begin(), kind_by_hash_.end(), std::pair(hash, std::uint32_t{0}));
    for (; known != kind_by_hash_.end() && known->first == hash; ++known)
        if (kinds_[known->second].joints == joints_ && kinds_[known->second].can_move == can_move_) return known->second;
    const auto index = static_cast<std::uint32_t>(kinds_.size());
    kind_by_hash_.insert(known, {hash, index});
    Kind& kind = kinds_.emplace_back(*memory_);
    kind.hash = hash;
    kind.joints = joints_;
    kind.can_move = can_move_;
    kind.plan = eliminator_.plan(joints_, can_move_, *memory_);
    return index;
}

void JointPlan::index_kinds()
{
    kind_by_hash_.clear();
    for (std::uint32_t k = 0; k < kinds_.size(); ++k) kind_by_hash_.emplace_back(kinds_[k].hash, k);
    std::sort(kind_by_hash_.begin(), kind_by_hash_.end());
}

/// @return its lanes, all free
std::uint32_t* JointPlan::place_row(std::uint32_t shape, std::uint32_t lanes)
{
    constexpr std::size_t alignment = 64;
    rows.push_back({static_cast<std::uint32_t>(slots.size()), lanes});
    offsets.push_back(static_cast<std::uint32_t>(bytes));
    bytes += (row_size(shape_with_number(shape), lanes) + alignment - 1) / alignment * alignment;
    slots.resize(slots.size() + lanes, null_index);
    return &slots[slots.size() - lanes];
}

/// Joints of nets and those that hold nothing rigidly, colour by colour; those of one colour and shape fill rows.
void JointPlan::place_single_rows(std::size_t body_count, std::uint32_t lanes)
{
    single_.clear();
    for (std::uint32_t i = 0; i < members_.size(); ++i)
        if (!holds_rigidly(members_[i])) single_.push_back(i);
    for (const Component& component : components_)
        if (kinds_[component.kind].plan.is_net)
            single_.insert(single_.end(), order_.begin() + component.begin, order_.begin() + component.begin + component.count);
    std::sort(single_.begin(), single_.end());

    colors_.assign(body_count, 0);
    for (std::uint64_t& key : single_)
    {
        const Member& m = members_[key];
        const std::uint64_t used = (m.moves_a ? colors_[m.body_a] : 0) | (m.moves_b ? colors_[m.body_b] : 0);
        const auto color = static_cast<std::uint32_t>(std::countr_one(used));
        if (color < last_color && m.moves_a) colors_[m.body_a] |= std::uint64_t{1} << color;
        if (color < last_color && m.moves_b) colors_[m.body_b] |= std::uint64_t{1} << color;
        key |= (std::uint64_t{color} << shape_bits | m.shape) << 32;
    }
    std::sort(single_.begin(), single_.end());
    std::uint32_t* lane = nullptr;
    std::uint32_t next = lanes;
    std::uint64_t before = ~std::uint64_t{0};
    for (const std::uint64_t key : single_)
    {
        const std::uint64_t bucket = key >> 32;
        if (next == lanes || bucket != before || bucket >> shape_bits == last_color)
        {
            lane = place_row(static_cast<std::uint32_t>(bucket & ((1u << shape_bits) - 1)), lanes);
            next = 0;
        }
        before = bucket;
        lane[next++] = members_[static_cast<std::uint32_t>(key)].slot;
    }
    single_rows = rows.size();
}

/// Kinds in the order of their first mechanisms.
void JointPlan::place_groups(std::uint32_t lanes)
{
    used_kinds_.clear();
    same_kind_.resize(components_.size());
    std::uint32_t next = 0;
    for (const Component& component : components_)
    {
        Kind& kind = kinds_[component.kind];
        if (kind.count == 0 || kind.plan.is_net) continue; // it has its place already, or is solved joint by joint
        used_kinds_.push_back(component.kind);
        kind.first = next;
        next += kind.count;
        kind.count = 0;
    }
    for (std::uint32_t c = 0; c < components_.size(); ++c)
    {
        Kind& kind = kinds_[components_[c].kind];
        if (!kind.plan.is_net) same_kind_[kind.first + kind.count++] = c;
    }
    for (const std::uint32_t kind : used_kinds_)
    {
        for (auto left = std::span(std::as_const(same_kind_)).subspan(kinds_[kind].first, kinds_[kind].count); !left.empty();)
        {
            const std::size_t count = std::min<std::size_t>(left.size(), lanes);
            place_group(kind, left.first(count), count == 1 ? 1 : lanes); // one alone would waste the other lanes
            left = left.subspan(count);
        }
    }
}

void JointPlan::place_group(std::uint32_t kind, std::span<const std::uint32_t> components, std::uint32_t lanes)
{
    const EliminationPlan& plan = kinds_[kind].plan;
    groups.push_back({kind, lanes, static_cast<std::uint32_t>(rows.size()), static_cast<std::uint32_t>(bodies.size())});
    for (std::uint32_t joint = 0; joint < plan.ends.size(); ++joint)
    {
        std::uint32_t* const row = place_row(kinds_[kind].joints[joint].shape, lanes);
        for (std::size_t i = 0; i < components.size(); ++i) row[i] = members_[order_[components_[components[i]].begin + joint]].slot;
    }
    for (std::uint32_t body = 0; body < plan.body_count; ++body)
        for (std::uint32_t i = 0; i < lanes; ++i)
            bodies.push_back(i < components.size() ? body_list_[components_[components[i]].bodies_begin + body] : null_index);
}

/// Once they are many. Groups name kinds by their places.
void JointPlan::drop_unused_kinds()
{
    constexpr std::size_t spare = 32;
    if (kinds_.size() <= 2 * used_kinds_.size() + spare) return;
    same_kind_.assign(kinds_.size(), null_index); // where each goes
    for (const std::uint32_t kind : used_kinds_) same_kind_[kind] = 0;
    std::uint32_t kept = 0;
    for (std::uint32_t k = 0; k < kinds_.size(); ++k)
    {
        if (same_kind_[k] == null_index) continue;
        same_kind_[k] = kept;
        if (k != kept) kinds_[kept] = std::move(kinds_[k]);
        ++kept;
    }
    kinds_.erase(kinds_.begin() + kept, kinds_.end());
    for (PlannedGroup& group : groups) group.kind = same_kind_[group.kind];
    index_kinds();
}

} // namespace carom::detail
