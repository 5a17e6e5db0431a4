// What every memory resource keeps: blocks do not overlap, are aligned, and come back to the last byte.
#include <carom/error.hpp>
#include <carom/memory.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <random>
#include <vector>

namespace carom
{

namespace
{

/// Upstream of a resource under test: nothing may be left over in the end.
class Upstream final : public std::pmr::memory_resource
{
public:
    ~Upstream() override { EXPECT_EQ(bytes, 0u); }
    std::size_t bytes = 0;

private:
    void* do_allocate(std::size_t n, std::size_t alignment) override
    {
        if (n > std::size_t{1} << 40) throw std::bad_alloc(); // the address sanitizer would end the program
        bytes += n;
        return ::operator new(n, std::align_val_t(alignment));
    }
    void do_deallocate(void* block, std::size_t n, std::size_t alignment) override
    {
        bytes -= n;
        ::operator delete(block, n, std::align_val_t(alignment));
    }
    bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
};

struct Kind
{
    const char* name;
    std::function<std::unique_ptr<std::pmr::memory_resource>(Upstream&, std::span<std::byte>)> make;
    std::function<MemoryStats(const std::pmr::memory_resource&)> stats;
};

template <class Resource>
MemoryStats stats_of(const std::pmr::memory_resource& resource)
{
    return static_cast<const Resource&>(resource).stats();
}

const Kind kinds[] = {
    {"heap", [](auto&, auto) { return std::make_unique<HeapResource>(); }, stats_of<HeapResource>},
    {"linear", [](auto& up, auto) { return std::make_unique<LinearResource>(1000, &up); }, stats_of<LinearResource>},
    {"linear_in_a_buffer", [](auto&, auto buffer) { return std::make_unique<LinearResource>(buffer); }, stats_of<LinearResource>},
    {"free_list_first_fit", [](auto& up, auto)
{ return std::make_unique<FreeListResource>(FreeListOptions{.chunk_bytes = 3000, .checks = true}, &up); }, stats_of<FreeListResource>},
    {"free_list_best_fit", [](auto& up, auto)
{ return std::make_unique<FreeListResource>(FreeListOptions{.fit = FreeListFit::Best, .chunk_bytes = 3000, .checks = true}, &up); },
     stats_of<FreeListResource>},
    {"free_list_in_a_buffer", [](auto&, auto buffer)
{ return std::make_unique<FreeListResource>(buffer, FreeListOptions{.checks = true}); }, stats_of<FreeListResource>},
    {"tracking", [](auto& up, auto) { return std::make_unique<TrackingResource>(std::initializer_list<const char*>{"a", "b"}, &up); },
     stats_of<TrackingResource>},
    {"limit", [](auto& up, auto) { return std::make_unique<LimitResource>(std::size_t{1} << 30, &up); }, stats_of<LimitResource>},
};

class EveryResource : public testing::TestWithParam<Kind>
{
};

INSTANTIATE_TEST_SUITE_P(Kinds, EveryResource, testing::ValuesIn(kinds), [](const auto& kind) { return kind.param.name; });

/// All but the heap: what that refuses is up to operator new.
class OverOtherMemory : public EveryResource
{
};

INSTANTIATE_TEST_SUITE_P(Kinds, OverOtherMemory, testing::ValuesIn(std::begin(kinds) + 1, std::end(kinds)),
                         [](const auto& kind) { return kind.param.name; });

struct Block
{
    unsigned char* begin;
    std::size_t bytes;
    std::size_t alignment;
    unsigned char mark;
};

void expect_untouched(const Block& block)
{
    for (std::size_t i = 0; i < block.bytes; ++i) ASSERT_EQ(block.begin[i], block.mark) << "byte " << i << " of " << block.bytes;
}

} // namespace

/// Random sizes, alignments and orders; each block is filled, and must be as it was filled when it goes.
TEST_P(EveryResource, GivesOutBlocksThatDoNotOverlap)
{
    for (unsigned seed = 0; seed < 20; ++seed)
    {
        Upstream upstream;
        std::vector<std::byte> buffer(3'000'000);
        const auto resource = GetParam().make(upstream, std::span(buffer).subspan(seed)); // its start is not aligned
        std::mt19937 engine(seed);
        std::vector<Block> blocks;
        std::size_t bytes = 0;
        std::size_t peak = 0;
        std::size_t total = 0;
        std::size_t allocations = 0;
        for (int i = 0; i < 2000; ++i)
        {
            const bool grows = engine() % 100 < (i % 400 < 200 ? 70u : 35u);
            if (grows || blocks.empty())
            {
                const std::size_t size = engine() % 8 == 0 ? engine() % 5000 : engine() % 200;
                const std::size_t alignment = std::size_t{1} << engine() % 8;
                auto* begin = static_cast<unsigned char*>(resource->allocate(size, alignment));
                ASSERT_NE(begin, nullptr);
                ASSERT_EQ(reinterpret_cast<std::uintptr_t>(begin) % alignment, 0u);
                const Block block = {begin, size, alignment, static_cast<unsigned char>(engine() % 256)};
                std::memset(begin, block.mark, size);
                blocks.push_back(block);
                bytes += size;
                total += size;
                ++allocations;
                peak = std::max(peak, bytes);
            }
            else
            {
                std::swap(blocks[engine() % blocks.size()], blocks.back());
                const Block block = blocks.back();
                blocks.pop_back();
                expect_untouched(block);
                resource->deallocate(block.begin, block.bytes, block.alignment);
                bytes -= block.bytes;
            }
            const MemoryStats expected = {bytes, blocks.size(), peak, allocations, total};
            ASSERT_EQ(GetParam().stats(*resource), expected) << i;
        }
        for (const Block& block : blocks)
        {
            expect_untouched(block);
            resource->deallocate(block.begin, block.bytes, block.alignment);
        }
        EXPECT_EQ(GetParam().stats(*resource).bytes, 0u);
        EXPECT_EQ(GetParam().stats(*resource).blocks, 0u);
    }
}

TEST_P(OverOtherMemory, RefusesMoreThanThereIs)
{
    Upstream upstream;
    std::vector<std::byte> buffer(10'000);
    const auto resource = GetParam().make(upstream, buffer);
    EXPECT_THROW((void)resource->allocate(std::size_t{1} << 62, 8), std::bad_alloc);
    EXPECT_EQ(GetParam().stats(*resource), MemoryStats{});
    void* block = resource->allocate(100, 8); // and goes on
    resource->deallocate(block, 100, 8);
}

TEST_P(EveryResource, HoldsContainers)
{
    Upstream upstream;
    std::vector<std::byte> buffer(1'000'000);
    const auto resource = GetParam().make(upstream, buffer);
    {
        std::pmr::vector<std::pmr::vector<int>> lists(resource.get());
        for (int i = 0; i < 100; ++i) lists.emplace_back(static_cast<std::size_t>(i), i);
        for (int i = 0; i < 100; i += 2) lists[static_cast<std::size_t>(i)].resize(200, i);
        EXPECT_EQ(lists[99][98], 99);
        EXPECT_EQ(lists[98][199], 98);
    }
    EXPECT_EQ(GetParam().stats(*resource).bytes, 0u);
}

// ---- the bump allocator ----

TEST(LinearResource, GivesTheSameMemoryAgainAfterAReset)
{
    Upstream upstream;
    LinearResource linear(1000, &upstream);
    void* first = linear.allocate(100, 8);
    (void)linear.allocate(200, 8);
    linear.reset();
    EXPECT_EQ(linear.stats().blocks, 0u);
    EXPECT_EQ(linear.allocate(100, 8), first);
}

TEST(LinearResource, IsServedByOneChunkOnceItKnowsHowMuchIsNeeded)
{
    Upstream upstream;
    LinearResource linear(1000, &upstream);
    const auto round = [&]
    {
        for (int i = 0; i < 100; ++i) (void)linear.allocate(100, 8);
        linear.reset();
    };
    round();
    round();
    const std::size_t bytes = upstream.bytes;
    EXPECT_GE(linear.capacity(), 10'000u);
    EXPECT_LT(linear.capacity(), 17'000u);
    for (int i = 0; i < 10; ++i) round();
    EXPECT_EQ(upstream.bytes, bytes);
}

TEST(LinearResource, ReservesAhead)
{
    Upstream upstream;
    LinearResource linear(256, &upstream);
    linear.reserve(5000);
    const std::size_t bytes = upstream.bytes;
    EXPECT_GE(bytes, 5000u);
    (void)linear.allocate(5000, 1);
    EXPECT_EQ(upstream.bytes, bytes);
    std::array<std::byte, 100> buffer;
    LinearResource fixed(buffer);
    fixed.reserve(100);
    EXPECT_THROW(fixed.reserve(101), std::bad_alloc);
}

TEST(LinearResource, TakesBackTheLastBlock)
{
    std::array<std::byte, 256> buffer;
    LinearResource linear(buffer);
    for (int i = 0; i < 100; ++i) linear.deallocate(linear.allocate(200, 1), 200, 1);
    EXPECT_EQ(linear.used(), 0u);
    EXPECT_EQ(linear.high_water(), 200u);
    EXPECT_THROW((void)linear.allocate(257, 1), std::bad_alloc);
}

// ---- the free list ----

TEST(FreeListResource, UnitesNeighboursInAnyOrder)
{
    std::array<int, 4> order = {0, 1, 2, 3};
    do
    {
        std::vector<std::byte> buffer(4096);
        FreeListResource list{buffer, {}};
        const std::size_t whole = list.largest_free_block();
        std::array<void*, 4> blocks;
        for (void*& block : blocks) block = list.allocate(500, 8);
        for (const int i : order) list.deallocate(blocks[static_cast<std::size_t>(i)], 500, 8);
        EXPECT_EQ(list.free_blocks(), 1u);
        EXPECT_EQ(list.largest_free_block(), whole);
        EXPECT_EQ(list.free_bytes(), whole);
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(FreeListResource, BestFitTakesTheSmallestHole)
{
    for (const FreeListFit fit : {FreeListFit::First, FreeListFit::Best})
    {
        std::vector<std::byte> buffer(8192);
        FreeListResource list(buffer, {.fit = fit});
        void* small = list.allocate(100, 8);
        (void)list.allocate(16, 8);
        void* large = list.allocate(1000, 8);
        (void)list.allocate(16, 8);
        list.deallocate(small, 100, 8);
        list.deallocate(large, 1000, 8); // the last that was freed
        EXPECT_EQ(list.allocate(90, 8), fit == FreeListFit::Best ? small : large);
    }
}

TEST(FreeListResource, WastesNoMoreThanAHeaderAndRounding)
{
    std::vector<std::byte> buffer(64 * 1024);
    FreeListResource list{buffer, {}};
    std::size_t count = 0;
    try
    {
        for (;; ++count) (void)list.allocate(112, 16);
    }
    catch (const std::bad_alloc&)
    {
    }
    EXPECT_GE(count, buffer.size() / 128 - 1);
}

/// An hour of a game whose constant number of things live for a while: what is free stays usable.
TEST(FreeListResource, StaysWholeOverALongTime)
{
    for (const FreeListFit fit : {FreeListFit::First, FreeListFit::Best})
    {
        FreeListResource list({.fit = fit});
        std::mt19937 engine(3);
        struct Thing
        {
            void* begin = nullptr;
            std::size_t bytes = 0;
        };
        std::vector<Thing> things(500);
        std::size_t capacity_early = 0;
        for (int i = 0; i < 300'000; ++i)
        {
            Thing& thing = things[engine() % things.size()];
            if (thing.begin) list.deallocate(thing.begin, thing.bytes, 16);
            thing.bytes = 16 + engine() % 1000;
            thing.begin = list.allocate(thing.bytes, 16);
            if (i == 10'000) capacity_early = list.capacity();
        }
        EXPECT_LE(list.capacity(), 2 * capacity_early);
        EXPECT_LE(list.capacity(), 2 * list.stats().peak_bytes);
        for (const Thing& thing : things)
            if (thing.begin) list.deallocate(thing.begin, thing.bytes, 16);
    }
}

using FreeListDeathTest = testing::Test;

TEST(FreeListDeathTest, FindsBlocksThatAreFreedTwice)
{
    FreeListResource list({.checks = true});
    void* a = list.allocate(100, 8);
    void* b = list.allocate(100, 8);
    void* c = list.allocate(100, 8);
    list.deallocate(a, 100, 8);
    EXPECT_DEATH(list.deallocate(a, 100, 8), "FreeListResource: .* is free already");
    list.deallocate(b, 100, 8); // united with A
    EXPECT_DEATH(list.deallocate(b, 100, 8), "FreeListResource: .* is free already");
    EXPECT_DEATH(list.deallocate(a, 100, 8), "FreeListResource: .* is free already");
    list.deallocate(c, 100, 8);
}

TEST(FreeListDeathTest, FindsPointersFromElsewhere)
{
    FreeListResource list({.checks = true});
    void* block = list.allocate(100, 8);
    alignas(16) std::array<std::byte, 64> elsewhere = {};
    EXPECT_DEATH(list.deallocate(elsewhere.data() + 16, 16, 8), "was not allocated here");
    EXPECT_DEATH(list.deallocate(static_cast<std::byte*>(block) + 16, 16, 8), "FreeListResource: .*not allocated here");
    EXPECT_DEATH(list.deallocate(block, 300, 8), "with another size");
    list.deallocate(block, 100, 8);
}

// ---- tracking and limits ----

TEST(TrackingResource, CountsByCategoryAndTogether)
{
    Upstream upstream;
    TrackingResource tracking({"ships", "shots"}, &upstream);
    std::pmr::vector<int> ships(10, 0, &tracking.category(0));
    {
        std::pmr::vector<char> shots(1000, 'x', &tracking.category(1));
        EXPECT_EQ(tracking.stats(1).bytes, 1000u);
        EXPECT_EQ(tracking.stats().bytes, 1040u);
    }
    EXPECT_EQ(tracking.stats(0), (MemoryStats{40, 1, 40, 1, 40}));
    EXPECT_EQ(tracking.stats(1), (MemoryStats{0, 0, 1000, 1, 1000}));
    EXPECT_EQ(tracking.stats(), (MemoryStats{40, 1, 1040, 2, 1040}));
    EXPECT_STREQ(tracking.name(1), "shots");
    EXPECT_THROW(TrackingResource(std::span<const char* const>{}), UsageError);
}

TEST(LimitResource, StopsAtItsBudgetAndSaysSo)
{
    Upstream upstream;
    LimitResource limit(1000, &upstream);
    void* block = limit.allocate(900, 8);
    try
    {
        (void)limit.allocate(101, 8);
        FAIL();
    }
    catch (const MemoryLimitError& error)
    {
        EXPECT_STREQ(
            error.what(),
            "LimitResource: 101 bytes more do not fit into the budget of 1000 bytes, of which 900 are in use; raise it or hold less");
        EXPECT_EQ(error.asked(), 101u);
    }
    EXPECT_EQ(limit.stats().bytes, 900u);
    limit.set_budget(10);
    EXPECT_THROW((void)limit.allocate(1, 1), MemoryLimitError);
    limit.deallocate(block, 900, 8);
    limit.deallocate(limit.allocate(10, 1), 10, 1);
}

} // namespace carom
