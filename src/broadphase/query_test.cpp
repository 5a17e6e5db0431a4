// Queries of all broad phases against a plain loop, through random histories, with and without a search for pairs in between.
#include "broadphase/broad_phase.hpp"
#include "math/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <new>
#include <string>
#include <thread>
#include <vector>

namespace carom::detail
{
namespace
{

/// Small boxes, seldom one as large as the world, seldom at places and of sizes where floats end.
Aabb random_box(Random& random)
{
    const unsigned kind = random.below(60);
    if (kind == 0) return {{-1e30f, -1e30f}, {1e30f, 1e30f}};
    const Vec2 center = random.point(kind == 1 ? 1e6f : 50);
    const float size = kind == 2 ? 40.0f : random.between(0, 2);
    const Vec2 half = {size, size * random.between(0, 1)};
    return {center - half, center + half};
}

struct AllBoxes final : BoxVisitor
{
    std::vector<ProxyIndex> found;
    bool visit(ProxyIndex proxy) override
    {
        found.push_back(proxy);
        return true;
    }
};

struct AllMet final : SweepVisitor
{
    std::vector<ProxyIndex> found;
    float visit(ProxyIndex proxy) override
    {
        found.push_back(proxy);
        return 1;
    }
};

/// A list of boxes beside the broad phase under test.
class Histories
{
public:
    Histories(BroadPhaseType type, unsigned seed, std::pmr::memory_resource& memory)
        : random(seed),
          broad_phase(make_broad_phase(type, {.quadtree_max_depth = static_cast<int>(seed % 11)}, memory))
    {
    }

    void change()
    {
        const ProxyIndex proxy = random.below(500);
        if (proxy >= boxes.size()) boxes.resize(proxy + 1, nowhere);
        if (boxes[proxy] == nowhere)
        {
            const Aabb box = random_box(random);
            broad_phase->insert(proxy, box, random.below(3) == 0 ? ProxyKind::Static : ProxyKind::Moving);
            boxes[proxy] = box;
        }
        else if (random.below(4) == 0)
        {
            broad_phase->remove(proxy);
            boxes[proxy] = nowhere;
        }
        else
        {
            const Vec2 shift = random.point(0.5f);
            boxes[proxy] = random.below(3) == 0 ? random_box(random) : Aabb{boxes[proxy].min + shift, boxes[proxy].max + shift};
            broad_phase->update(proxy, boxes[proxy]);
        }
    }

    void find_pairs()
    {
        std::vector<ProxyIndex> moved;
        for (ProxyIndex i = 0; i < boxes.size(); ++i)
            if (boxes[i] != nowhere && random.below(2) == 0) moved.push_back(i);
        std::pmr::vector<ProxyPair> pairs;
        broad_phase->find_pairs(moved, pairs);
    }

    void expect_box_query()
    {
        const Aabb box = random_box(random);
        std::vector<ProxyIndex> expected;
        for (ProxyIndex i = 0; i < boxes.size(); ++i)
            if (boxes[i] != nowhere && overlaps(boxes[i], box)) expected.push_back(i);
        AllBoxes all;
        broad_phase->query(box, all);
        std::sort(all.found.begin(), all.found.end());
        ASSERT_EQ(all.found, expected);
    }

    void expect_sweep_query()
    {
        const Vec2 start = random.point(60);
        const Vec2 half = random.below(2) == 0 ? Vec2{} : Vec2{random.between(0, 3), random.between(0, 3)};
        Vec2 way = random.point(random.below(4) == 0 ? 1e5f : 60);
        if (random.below(6) == 0) way.x = 0;
        if (random.below(6) == 0) way.y = 0;
        const BoxSweep sweep({start - half, start + half}, way);
        std::vector<ProxyIndex> expected;
        for (ProxyIndex i = 0; i < boxes.size(); ++i)
            if (boxes[i] != nowhere && sweep.meets(boxes[i], 1).is_met) expected.push_back(i);
        AllMet all;
        broad_phase->query(sweep, all);
        std::sort(all.found.begin(), all.found.end());
        ASSERT_EQ(all.found, expected);
    }

    static constexpr Aabb nowhere = {{1, 1}, {-1, -1}};

    Random random;
    BroadPhasePtr broad_phase;
    std::vector<Aabb> boxes;
};

class BroadPhaseQueries : public testing::TestWithParam<BroadPhaseType>
{
};

TEST_P(BroadPhaseQueries, SeeEveryBoxAsItIs)
{
    for (unsigned seed = 1; seed <= 12; ++seed)
    {
        SCOPED_TRACE(seed);
        Histories history(GetParam(), seed, *std::pmr::new_delete_resource());
        history.expect_box_query(); // nothing in
        history.expect_sweep_query();
        for (int round = 0; round < 400; ++round)
        {
            const unsigned changes[] = {0, 1, 3, 200};
            for (unsigned i = changes[history.random.below(4)]; i > 0; --i) history.change();
            if (history.random.below(5) == 0) history.find_pairs();
            history.expect_box_query();
            history.expect_sweep_query();
            if (HasFatalFailure()) return;
        }
    }
}

TEST_P(BroadPhaseQueries, EndWhenTheVisitorSaysSo)
{
    struct FirstBox final : BoxVisitor
    {
        int visits = 0;
        bool visit(ProxyIndex) override { return ++visits < 3; }
    };
    struct FirstMet final : SweepVisitor
    {
        int visits = 0;
        float visit(ProxyIndex) override { return ++visits < 3 ? 1.0f : -1.0f; }
    };
    Histories history(GetParam(), 5, *std::pmr::new_delete_resource());
    for (int round = 0; round < 2; ++round) // new ones wait in the first round, and are built in in the second
    {
        for (ProxyIndex i = 0; i < 40; ++i)
            history.broad_phase->insert(100 * static_cast<unsigned>(round) + i, {{0, 0}, {1, 1}},
                                        i % 2 ? ProxyKind::Static : ProxyKind::Moving);
        FirstBox box;
        history.broad_phase->query(Aabb{{0, 0}, {1, 1}}, box);
        EXPECT_EQ(box.visits, 3);
        FirstMet met;
        history.broad_phase->query(BoxSweep({{-2, 0.5f}, {-2, 0.5f}}, {5, 0}), met);
        EXPECT_EQ(met.visits, 3);
        std::vector<ProxyIndex> moved;
        std::pmr::vector<ProxyPair> pairs;
        history.broad_phase->find_pairs(moved, pairs);
    }
}

/// Clipping to the nearest so far loses nothing that is as near, and spares most of the rest.
TEST_P(BroadPhaseQueries, ClippedSweepFindsTheNearest)
{
    struct Nearest final : SweepVisitor
    {
        explicit Nearest(const std::vector<Aabb>& all, const BoxSweep& way) : boxes(all), sweep(way) {}
        float visit(ProxyIndex proxy) override
        {
            ++visits;
            return best = std::min(best, sweep.meets(boxes[proxy], 1).fraction);
        }
        const std::vector<Aabb>& boxes;
        const BoxSweep& sweep;
        float best = 1;
        int visits = 0;
    };
    Histories history(GetParam(), 6, *std::pmr::new_delete_resource());
    for (ProxyIndex i = 0; i < 3000; ++i)
    {
        const Vec2 at = history.random.point(50);
        history.boxes.push_back({at, at + Vec2{0.5f, 0.5f}});
        history.broad_phase->insert(i, history.boxes.back(), ProxyKind::Moving);
    }
    int visits = 0;
    for (int i = 0; i < 300; ++i)
    {
        const Vec2 at = history.random.point(60);
        const BoxSweep sweep({at, at}, history.random.point(100));
        float expected = 1;
        for (const Aabb& box : history.boxes)
            if (const SweepEntry entry = sweep.meets(box, 1); entry.is_met) expected = std::min(expected, entry.fraction);
        Nearest nearest(history.boxes, sweep);
        history.broad_phase->query(sweep, nearest);
        ASSERT_EQ(nearest.best, expected);
        visits += nearest.visits;
    }
    const bool sorts_by_distance = GetParam() == BroadPhaseType::Tree;
    EXPECT_LT(visits, sorts_by_distance ? 300 * 4 : 300 * 300);
}

/// Gives nothing once it is told to.
class DryingResource final : public std::pmr::memory_resource
{
public:
    int allowance = 1 << 30;

private:
    void* do_allocate(std::size_t size, std::size_t alignment) override
    {
        if (allowance <= 0) throw std::bad_alloc();
        --allowance;
        return std::pmr::new_delete_resource()->allocate(size, alignment);
    }
    void do_deallocate(void* memory, std::size_t size, std::size_t alignment) override
    {
        std::pmr::new_delete_resource()->deallocate(memory, size, alignment);
    }
    bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
};

TEST_P(BroadPhaseQueries, AreRightAfterOneThatMemoryDidNotSufficeFor)
{
    int failures = 0;
    for (int allowance = 0; allowance < 40; ++allowance)
    {
        DryingResource memory;
        Histories history(GetParam(), 7, memory);
        for (int i = 0; i < 30 * allowance; ++i) history.change();
        if (allowance % 3 == 0) history.find_pairs();
        for (int i = 0; i < 300; ++i) history.change();
        memory.allowance = allowance % 10;
        AllBoxes all;
        try
        {
            history.broad_phase->query(Aabb{{0, 0}, {1, 1}}, all);
        }
        catch (const std::bad_alloc&)
        {
            ++failures;
        }
        memory.allowance = 1 << 30;
        for (int round = 0; round < 20; ++round)
        {
            history.expect_box_query();
            history.expect_sweep_query();
            history.change();
            if (round == 10) history.find_pairs();
            if (HasFatalFailure()) return;
        }
    }
    const bool can_fail = GetParam() != BroadPhaseType::BruteForce && GetParam() != BroadPhaseType::QuadtreeNaive;
    EXPECT_EQ(failures > 0, can_fail);
}

TEST_P(BroadPhaseQueries, ComeFromManyThreadsAtOnce)
{
    Histories history(GetParam(), 8, *std::pmr::new_delete_resource());
    for (int round = 0; round < 20; ++round)
    {
        for (int i = 0; i < 200; ++i) history.change();
        AllBoxes expected;
        const auto ask = [&history](AllBoxes& all) { history.broad_phase->query(Aabb{{-20, -20}, {20, 20}}, all); };
        std::array<AllBoxes, 4> found;
        std::vector<std::thread> threads;
        for (AllBoxes& all : found) threads.emplace_back([&] { ask(all); });
        for (std::thread& thread : threads) thread.join();
        ask(expected);
        for (const AllBoxes& all : found) ASSERT_EQ(all.found, expected.found);
    }
}

INSTANTIATE_TEST_SUITE_P(Types, BroadPhaseQueries, testing::ValuesIn(all_broad_phases),
                         [](const auto& type) { return std::string(name_of(type.param)); });

} // namespace
} // namespace carom::detail
