// Keeping a tree of boxes up to date, and building it anew.
#include "broadphase/box_tree.hpp"

#include "memory/make_room.hpp"
#include "memory/rollback.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

namespace carom::detail
{
namespace
{

/// Marks a place that is an index into the waiting list.
constexpr std::uint32_t waiting_bit = std::uint32_t{1} << 31;

/// The young part may hold this share of the old one: rebuilding it every step must stay cheap beside finding pairs.
constexpr std::uint32_t young_share = 16;
constexpr std::uint32_t young_least = 32;
/// Rebuilt when this share of the proxies is gone: the gaps cost as much as full lanes.
constexpr std::uint32_t removed_share = 4;
/// A node is degraded when its perimeter has grown by this factor, and the tree when this share of the nodes is.
constexpr float degraded_growth = 1.5f;
constexpr std::size_t degraded_share = 4;

} // namespace

BoxTree::BoxTree(std::pmr::memory_resource& memory)
    : boxes_(&memory),
      nodes_(&memory),
      touched_(&memory),
      moved_nodes_(&memory),
      place_of_(&memory),
      waiting_(&memory),
      items_(&memory)
{
}

void BoxTree::reserve(std::size_t proxies)
{
    const std::size_t nodes = proxies / 2 + 8; // all levels but the topmost are full: a third is usual
    boxes_.reserve(nodes);
    nodes_.reserve(nodes);
    touched_.reserve(nodes / 64 + 1);
    moved_nodes_.reserve(nodes);
    place_of_.reserve(proxies);
    waiting_.reserve(proxies);
    items_.reserve(proxies);
}

void BoxTree::insert(ProxyIndex proxy, const Aabb& box)
{
    if (proxy >= place_of_.size()) place_of_.resize(proxy + std::size_t{1}, none);
    // A rebuild puts all that there is among the waiting ones: it may come long after the last insertion, and shall not allocate then.
    make_room(waiting_, place_of_.size());
    make_room(items_, place_of_.size());
    assert(place_of_[proxy] == none);
    const std::uint32_t place = static_cast<std::uint32_t>(waiting_.size());
    waiting_.push_back({box, proxy}); // may throw: nothing points to it yet
    place_of_[proxy] = waiting_bit | place;
    ++proxy_count_;
}

void BoxTree::remove(ProxyIndex proxy)
{
    const std::uint32_t place = place_of_[proxy];
    assert(place != none);
    if (place & waiting_bit)
    {
        const Entry last = waiting_.back();
        waiting_[place & ~waiting_bit] = last;
        waiting_.pop_back();
        place_of_[last.proxy] = place;
    }
    else
    {
        const std::uint32_t node = place / 4;
        set_box(boxes_[node], place % 4, empty_box);
        nodes_[node].child[place % 4] = none;
        touch(node);
    }
    place_of_[proxy] = none;
    --proxy_count_;
}

void BoxTree::update(ProxyIndex proxy, const Aabb& box)
{
    const std::uint32_t place = place_of_[proxy];
    assert(place != none);
    if (place & waiting_bit)
    {
        waiting_[place & ~waiting_bit].box = box;
        return;
    }
    set_box(boxes_[place / 4], place % 4, box);
    touch(place / 4);
}

void BoxTree::settle()
{
    const auto waiting = static_cast<std::uint32_t>(waiting_.size());
    if (waiting > 0 && young_count_ + waiting > std::max(young_least, old_count_ / young_share))
        rebuild();
    else if (gap_count() > 0 && gap_count() >= (old_count_ + young_count_) / removed_share)
        rebuild();
    else if (waiting > 0)
        rebuild_young();
}

void BoxTree::mark_moved(ProxyIndex proxy)
{
    const std::uint32_t place = place_of_[proxy];
    assert(place < waiting_bit);
    nodes_[place / 4].moved |= static_cast<std::uint8_t>(1u << place % 4);
    touch(place / 4);
}

bool BoxTree::is_degraded() const { return degraded_count_ * degraded_share > nodes_.size(); }

void BoxTree::refit()
{
    for (std::size_t word = touched_.size(); word-- > 0;)
    {
        // Refitting a node touches its parent, which has a lower index: in an earlier word, or in this one below the current bit.
        while (touched_[word] != 0)
        {
            const int bit = 63 - std::countl_zero(touched_[word]);
            touched_[word] ^= std::uint64_t{1} << bit;
            refit_node(static_cast<std::uint32_t>(word * 64) + static_cast<std::uint32_t>(bit));
        }
    }
}

void BoxTree::refit_node(std::uint32_t index)
{
    TreeNode& node = nodes_[index];
    if (node.moved) moved_nodes_.push_back(index);
    if (node.parent == none) return;
    const Aabb box = merge4(boxes_[index]);
    const std::uint32_t parent = node.parent / 4;
    set_box(boxes_[parent], node.parent % 4, box);
    if (node.moved) nodes_[parent].moved |= static_cast<std::uint8_t>(1u << node.parent % 4);
    touch(parent);

    const bool is_grown = box.perimeter() > degraded_growth * node.built_perimeter;
    degraded_count_ += std::uint32_t{is_grown} - std::uint32_t{node.is_degraded};
    node.is_degraded = is_grown;
}

void BoxTree::clear_moved()
{
    for (const std::uint32_t index : moved_nodes_) nodes_[index].moved = 0;
    moved_nodes_.clear();
}

// ---- building ----

void BoxTree::rebuild()
{
    collect(0);
    nodes_.clear();
    boxes_.clear();
    moved_nodes_.clear();
    old_count_ = static_cast<std::uint32_t>(waiting_.size());
    young_count_ = 0;
    degraded_count_ = 0;
    std::fill(touched_.begin(), touched_.end(), std::uint64_t{0}); // what they name is gone, also when nothing follows
    if (waiting_.empty()) return;
    Rollback all_wait([this] { abandon(0); });
    add_node(none, false);
    all_wait.dismiss();
    build_part(0);
    young_begin_ = static_cast<std::uint32_t>(nodes_.size());
}

void BoxTree::rebuild_young()
{
    if (nodes_.empty()) return rebuild();
    collect(young_begin_);
    for (std::size_t i = young_begin_; i < nodes_.size(); ++i) degraded_count_ -= nodes_[i].is_degraded;
    nodes_.resize(young_begin_);
    boxes_.resize(young_begin_);
    forget_touched(young_begin_); // what they name is gone, also when memory runs out below
    young_count_ = static_cast<std::uint32_t>(waiting_.size());
    build_part(1);
}

/// Puts the proxies of the nodes from `first_node` on to the waiting ones. Changes nothing when memory runs out.
void BoxTree::collect(std::uint32_t first_node)
{
    make_room(waiting_, std::min(waiting_.size() + 4 * (nodes_.size() - first_node), place_of_.size()));
    for (std::uint32_t i = first_node; i < nodes_.size(); ++i)
    {
        if (!nodes_[i].is_leaf) continue;
        for (unsigned lane = 0; lane < 4; ++lane)
            if (nodes_[i].child[lane] != none) waiting_.push_back({get_box(boxes_[i], lane), nodes_[i].child[lane]});
    }
}

/// Builds the waiting proxies into a part of the tree below the root.
void BoxTree::build_part(unsigned root_lane)
{
    const auto begin = static_cast<std::uint32_t>(nodes_.size());
    Rollback all_wait([&] { abandon(root_lane == 0 ? 0 : begin); });
    items_.clear();
    for (std::uint32_t i = 0; i < waiting_.size(); ++i) items_.push_back(build_item(waiting_[i].box, i));
    build_node(root_lane, items_);
    if (touched_.size() < nodes_.size() / 64 + 1) touched_.resize(nodes_.size() / 64 + 1);
    all_wait.dismiss();
    waiting_.clear();

    for (auto i = static_cast<std::uint32_t>(nodes_.size()); i-- > begin;)
    {
        nodes_[i].built_perimeter = merge4(boxes_[i]).perimeter();
        refit_node(i);
    }
    forget_touched(begin);
}

/// Takes back a build that memory did not suffice for: what was to be built waits.
void BoxTree::abandon(std::uint32_t first_node)
{
    nodes_.resize(first_node);
    boxes_.resize(first_node);
    young_count_ = 0;
    if (first_node == 0)
    {
        old_count_ = 0;
    }
    else
    {
        nodes_[0].child[1] = none;
        set_box(boxes_[0], 1, empty_box);
    }
    for (std::uint32_t i = 0; i < waiting_.size(); ++i) place_of_[waiting_[i].proxy] = waiting_bit | i;
}

/// The bits of nodes that were just built, or that are gone.
void BoxTree::forget_touched(std::uint32_t first_node)
{
    const std::size_t word = first_node / 64;
    touched_[word] &= (std::uint64_t{1} << first_node % 64) - 1;
    std::fill(touched_.begin() + static_cast<std::ptrdiff_t>(word) + 1, touched_.end(), std::uint64_t{0});
}

std::uint32_t BoxTree::add_node(std::uint32_t parent, bool is_leaf)
{
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    if (parent != none) nodes_[parent / 4].child[parent % 4] = index;
    nodes_.push_back({{none, none, none, none}, parent, 0, 0, is_leaf, false});
    boxes_.push_back(empty_box4);
    return index;
}

void BoxTree::build_node(std::uint32_t parent, std::span<BuildItem> items)
{
    const bool is_leaf = items.size() <= 4;
    const std::uint32_t index = add_node(parent, is_leaf);
    if (is_leaf)
    {
        for (std::uint32_t lane = 0; lane < items.size(); ++lane)
        {
            const Entry& entry = waiting_[items[lane].source];
            set_box(boxes_[index], lane, entry.box);
            nodes_[index].child[lane] = entry.proxy;
            place_of_[entry.proxy] = 4 * index + lane;
        }
        return;
    }
    const BuildGroups groups = divide(items);
    for (std::uint32_t lane = 0; lane < groups.count; ++lane) build_node(4 * index + lane, groups.group[lane]);
}

} // namespace carom::detail
