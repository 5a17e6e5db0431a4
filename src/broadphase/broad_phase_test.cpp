// All broad phases find the same pairs as a plain double loop, through random histories of many kinds of worlds.
#include "broadphase/broad_phase.hpp"
#include "math/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace carom::detail
{
namespace
{

Aabb box_at(Vec2 center, float half_x, float half_y)
{
    return {{center.x - half_x, center.y - half_y}, {center.x + half_x, center.y + half_y}};
}

/// Kinds of worlds, each a way to draw a box.
struct WorldKind
{
    const char* name;
    Aabb (*draw)(Random&);
};

const WorldKind world_kinds[] = {
    {"negative", [](Random& r) { return box_at({r.between(-130, -100), r.between(-90, -60)}, r.between(0.2f, 1), r.between(0.2f, 1)); }},
    {"clustered",
     [](Random& r)
{
    const float cluster = 1000.0f * static_cast<float>(r.below(5));
    return box_at({cluster + r.between(-5, 5), -cluster + r.between(-5, 5)}, r.between(0.1f, 0.6f), r.between(0.1f, 0.6f));
}},
    {"sizes of all magnitudes",
     [](Random& r)
{
    const float size = std::pow(10.0f, r.between(-3, 3));
    return box_at({r.between(-500, 500), r.between(-500, 500)}, size, size * r.between(0.1f, 1));
}},
    {"zero size on a grid", // touching at points and edges only
     [](Random& r)
{
    const Vec2 at{static_cast<float>(r.below(12)), -static_cast<float>(r.below(12))};
    return box_at(at, static_cast<float>(r.below(2)), static_cast<float>(r.below(2)) * 0.5f);
}},
    {"identical", [](Random&) { return Aabb{{-3, 4}, {-2, 5}}; }},
    {"one point", [](Random&) { return Aabb{{7, -7}, {7, -7}}; }},
    {"one line", [](Random& r) { return box_at({r.between(-50, 50), 3}, r.between(0, 1), 0); }},
    {"huge spread",
     [](Random& r)
{
    const float scale = std::pow(10.0f, r.between(-5, 37));
    return box_at({r.between(-1, 1) * scale, r.between(-1, 1) * scale}, r.between(0, 1) * scale, r.between(0, 1) * scale);
}},
    {"largest floats among small",
     [](Random& r)
{
    const float most = std::numeric_limits<float>::max();
    if (r.chance(0.05)) return Aabb{{-most, -most}, {most, most}};
    if (r.chance(0.05)) return Aabb{{most, most}, {most, most}};
    return box_at({r.between(-20, 20), r.between(-20, 20)}, 0.5f, 0.5f);
}},
    {"tall wall",
     [](Random& r) { return box_at({0.01f * static_cast<float>(r.below(3)), static_cast<float>(r.below(100))}, 0.5f, 0.51f); }},
};

/// A world with its own list of boxes beside the broad phases under test.
class Worlds
{
public:
    Worlds(const WorldKind& kind, unsigned seed, const BroadPhaseOptions& options) : kind_(kind), random_(seed)
    {
        for (const BroadPhaseType type : all_broad_phases)
        {
            BroadPhaseOptions own = options;
            if (type == BroadPhaseType::QuadtreeNaive) own.quadtree_max_depth = std::min(own.quadtree_max_depth, 6); // or it takes seconds
            broad_phases_.push_back(make_broad_phase(type, own, *std::pmr::new_delete_resource()));
        }
    }

    void insert()
    {
        ProxyIndex proxy = random_.below(400);
        while (proxy < proxies_.size() && proxies_[proxy].is_in) ++proxy;
        if (proxy >= proxies_.size()) proxies_.resize(proxy + 1);
        const ProxyKind kind = random_.chance(0.3) ? ProxyKind::Static : ProxyKind::Moving;
        proxies_[proxy] = {kind_.draw(random_), kind, true, true};
        for (const BroadPhasePtr& b : broad_phases_) b->insert(proxy, proxies_[proxy].box, kind);
    }

    /// Removes, moves a little, or teleports some; asks for pairs with the changed ones and others as `moved`.
    void random_changes(double share)
    {
        for (ProxyIndex i = 0; i < proxies_.size(); ++i)
        {
            Proxy& proxy = proxies_[i];
            if (!proxy.is_in || !random_.chance(share)) continue;
            if (random_.chance(0.05))
            {
                proxy.is_in = false;
                for (const BroadPhasePtr& b : broad_phases_) b->remove(i);
                continue;
            }
            proxy.is_moved = true;
            const Vec2 shift{random_.between(-0.3f, 0.3f), random_.between(-0.3f, 0.3f)};
            const Aabb shifted{proxy.box.min + shift, proxy.box.max + shift};
            proxy.box = random_.chance(0.1) ? kind_.draw(random_) : shifted;
            for (const BroadPhasePtr& b : broad_phases_) b->update(i, proxy.box);
        }
    }

    void expect_same_pairs()
    {
        std::vector<ProxyIndex> moved;
        for (ProxyIndex i = 0; i < proxies_.size(); ++i)
            if (proxies_[i].is_in && proxies_[i].is_moved) moved.push_back(i);
        for (std::size_t i = moved.size(); i > 1; --i) std::swap(moved[i - 1], moved[random_.below(static_cast<unsigned>(i))]);

        const std::vector<ProxyPair> expected = reference_pairs();
        for (const BroadPhasePtr& b : broad_phases_)
        {
            std::pmr::vector<ProxyPair> pairs{{1, 2}}; // what is there already stays
            b->find_pairs(moved, pairs);
            ASSERT_EQ(pairs.front(), (ProxyPair{1, 2}));
            pairs.erase(pairs.begin());
            std::sort(pairs.begin(), pairs.end());
            ASSERT_EQ(pairs.size(), expected.size()) << name_of(b->type());
            ASSERT_TRUE(std::equal(pairs.begin(), pairs.end(), expected.begin())) << name_of(b->type());
            EXPECT_EQ(b->stats().pairs_found, expected.size());
        }
        for (Proxy& proxy : proxies_) proxy.is_moved = false;
    }

private:
    struct Proxy
    {
        Aabb box;
        ProxyKind kind = ProxyKind::Moving;
        bool is_in = false;
        bool is_moved = false;
    };

    std::vector<ProxyPair> reference_pairs() const
    {
        std::vector<ProxyPair> pairs;
        for (ProxyIndex a = 0; a < proxies_.size(); ++a)
            for (ProxyIndex b = a + 1; b < proxies_.size(); ++b)
            {
                const Proxy& p = proxies_[a];
                const Proxy& q = proxies_[b];
                if (!p.is_in || !q.is_in || !(p.is_moved || q.is_moved)) continue;
                if (p.kind == ProxyKind::Static && q.kind == ProxyKind::Static) continue;
                if (overlaps(p.box, q.box)) pairs.push_back({a, b});
            }
        return pairs;
    }

    const WorldKind& kind_;
    Random random_;
    std::vector<Proxy> proxies_;
    std::vector<BroadPhasePtr> broad_phases_;
};

class AllBroadPhases : public testing::TestWithParam<std::size_t>
{
};

TEST_P(AllBroadPhases, FindTheSamePairsOverRandomHistories)
{
    const BroadPhaseOptions all_options[] = {{}, {0, 1}, {3, 1}, {10, 2}};
    unsigned seed = 1;
    for (const BroadPhaseOptions& options : all_options)
    {
        SCOPED_TRACE("depth " + std::to_string(options.quadtree_max_depth));
        Worlds worlds(world_kinds[GetParam()], seed++, options);
        worlds.expect_same_pairs(); // nothing in
        for (int i = 0; i < 150; ++i) worlds.insert();
        for (int round = 0; round < 40; ++round)
        {
            worlds.expect_same_pairs();
            if (HasFatalFailure()) return;
            const double shares[] = {0, 0.02, 0.3, 1};
            worlds.random_changes(shares[round % 4]);
            for (int i = 0; i < round % 7; ++i) worlds.insert();
        }
        for (int round = 0; round < 100; ++round) worlds.random_changes(1); // few are left
        worlds.expect_same_pairs();
    }
}

std::string kind_name(const testing::TestParamInfo<std::size_t>& info)
{
    std::string name = world_kinds[info.param].name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Worlds, AllBroadPhases, testing::Range<std::size_t>(0, std::size(world_kinds)), kind_name);

/// Counts what is taken and given back.
class CountingResource final : public std::pmr::memory_resource
{
public:
    int allocations = 0;
    std::size_t bytes = 0;

private:
    void* do_allocate(std::size_t size, std::size_t alignment) override
    {
        ++allocations;
        bytes += size;
        return std::pmr::new_delete_resource()->allocate(size, alignment);
    }
    void do_deallocate(void* p, std::size_t size, std::size_t alignment) override
    {
        bytes -= size;
        std::pmr::new_delete_resource()->deallocate(p, size, alignment);
    }
    bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
};

class EachBroadPhase : public testing::TestWithParam<BroadPhaseType>
{
};

bool has_set(BroadPhaseType type) { return type == BroadPhaseType::QuadtreeNaive || type == BroadPhaseType::QuadtreeWithSet; }

TEST_P(EachBroadPhase, AllocatesNothingAfterWarmUpButASetsCellsAndGivesEverythingBack)
{
    CountingResource memory;
    {
        const BroadPhasePtr broad_phase = make_broad_phase(GetParam(), {}, memory);
        Random random(5);
        std::vector<ProxyIndex> everyone;
        std::pmr::vector<ProxyPair> pairs;
        for (ProxyIndex i = 0; i < 500; ++i) everyone.push_back(i);
        const auto box_in_cloud = [&random]
        { return box_at({random.between(0, 50), random.between(0, 50)}, random.between(0, 1), random.between(0, 1)); };
        const auto step = [&](bool is_churning)
        {
            for (const ProxyIndex i : everyone) broad_phase->update(i, box_in_cloud());
            if (is_churning)
                for (const ProxyIndex i : everyone)
                    if (random.chance(0.2)) broad_phase->remove(i), broad_phase->insert(i, box_in_cloud(), ProxyKind::Moving);
            pairs.clear();
            broad_phase->find_pairs(everyone, pairs);
        };
        for (const ProxyIndex i : everyone) broad_phase->insert(i, box_in_cloud(), ProxyKind::Moving);
        for (int i = 0; i < 200; ++i) step(i % 3 == 0);
        const int warm = memory.allocations;
        std::size_t found = 0;
        for (int i = 0; i < 60; ++i)
        {
            step(i % 3 == 0);
            found += pairs.size();
        }
        EXPECT_EQ(static_cast<std::size_t>(memory.allocations - warm), has_set(GetParam()) ? found : 0);
        EXPECT_GT(found, 60u);
    }
    EXPECT_EQ(memory.bytes, 0u);
}

TEST(QuadtreeWithSet, MakesTheSearchOfTheQuadtreeInTheSameOrder)
{
    const BroadPhasePtr plain = make_broad_phase(BroadPhaseType::Quadtree, {}, *std::pmr::new_delete_resource());
    const BroadPhasePtr with_set = make_broad_phase(BroadPhaseType::QuadtreeWithSet, {}, *std::pmr::new_delete_resource());
    Random random(7);
    std::vector<ProxyIndex> everyone;
    for (ProxyIndex i = 0; i < 300; ++i)
    {
        const Aabb box = box_at({random.between(0, 20), random.between(0, 20)}, 0.5f, 0.5f);
        for (const BroadPhasePtr* b : {&plain, &with_set}) (*b)->insert(i, box, ProxyKind::Moving);
        everyone.push_back(i);
    }
    std::pmr::vector<ProxyPair> expected;
    std::pmr::vector<ProxyPair> pairs;
    for (int step = 0; step < 2; ++step) // what the set held before must not hide a pair
    {
        expected.clear();
        pairs.clear();
        plain->find_pairs(everyone, expected);
        with_set->find_pairs(everyone, pairs);
        EXPECT_EQ(pairs, expected);
        EXPECT_EQ(with_set->stats(), plain->stats());
        EXPECT_GT(pairs.size(), 100u);
    }
}

TEST_P(EachBroadPhase, ListsNodesThatCoverTheShapes)
{
    const BroadPhasePtr broad_phase = make_broad_phase(GetParam(), {}, *std::pmr::new_delete_resource());
    Random random(6);
    std::vector<ProxyIndex> everyone;
    Aabb around = box_at({-20, -20}, 0, 0);
    for (ProxyIndex i = 0; i < 300; ++i)
    {
        const Aabb box = box_at({random.between(-40, -10), random.between(-40, -10)}, 0.3f, 0.3f);
        around = merge(around, box);
        broad_phase->insert(i, box, ProxyKind::Moving);
        everyone.push_back(i);
    }
    std::pmr::vector<ProxyPair> pairs;
    broad_phase->find_pairs(everyone, pairs);
    std::vector<BroadPhaseNode> nodes;
    broad_phase->list_nodes(nodes);
    if (GetParam() == BroadPhaseType::BruteForce)
    {
        EXPECT_TRUE(nodes.empty());
        return;
    }
    ASSERT_GT(nodes.size(), 10u);
    EXPECT_EQ(nodes[0].depth, 0);
    EXPECT_EQ(nodes[0].bounds, around);
    EXPECT_EQ(std::count_if(nodes.begin(), nodes.end(), [](const BroadPhaseNode& n) { return n.depth == 0; }), 1);
    for (const BroadPhaseNode& node : nodes) EXPECT_TRUE(contains(expanded(around, 1e-3f), node.bounds));
}

INSTANTIATE_TEST_SUITE_P(Types, EachBroadPhase, testing::ValuesIn(all_broad_phases),
                         [](const auto& type) { return std::string(name_of(type.param)); });

} // namespace
} // namespace carom::detail
