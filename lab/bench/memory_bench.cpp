// The memory resources against malloc and the standard library's pools.
#include <carom/memory.hpp>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <memory_resource>
#include <random>
#include <vector>

namespace
{

/// malloc as a resource, so that all go through the same calls.
class MallocResource final : public std::pmr::memory_resource
{
    void* do_allocate(std::size_t bytes, std::size_t) override { return std::malloc(bytes); }
    void do_deallocate(void* block, std::size_t, std::size_t) override { std::free(block); }
    bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
};

/// What a piece of work asks for: blocks that live for a while, and sizes from 16 bytes to 1 KiB.
struct Request
{
    std::size_t place;
    std::size_t bytes;
};

std::vector<Request> requests(std::size_t living)
{
    std::mt19937 engine(1);
    std::vector<Request> all(4096);
    for (Request& request : all) request = {engine() % living, 16 + engine() % 1008};
    return all;
}

/// Replaces one living block by another, again and again.
void churn(benchmark::State& state, std::pmr::memory_resource& memory)
{
    const auto living = static_cast<std::size_t>(state.range(0));
    const std::vector<Request> work = requests(living);
    struct Block
    {
        void* begin = nullptr;
        std::size_t bytes = 0;
    };
    std::vector<Block> blocks(living);
    for (auto _ : state)
        for (const Request& request : work)
        {
            Block& block = blocks[request.place];
            if (block.begin) memory.deallocate(block.begin, block.bytes, 16);
            block = {memory.allocate(request.bytes, 16), request.bytes};
            benchmark::DoNotOptimize(block.begin);
        }
    for (const Block& block : blocks)
        if (block.begin) memory.deallocate(block.begin, block.bytes, 16);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(work.size()));
}

/// Takes many and gives all back at once: what a bump allocator is for.
template <class Reset>
void frame(benchmark::State& state, std::pmr::memory_resource& memory, Reset&& reset)
{
    const std::vector<Request> work = requests(1);
    std::vector<void*> blocks(work.size());
    for (auto _ : state)
    {
        for (std::size_t i = 0; i < work.size(); ++i) benchmark::DoNotOptimize(blocks[i] = memory.allocate(work[i].bytes, 16));
        for (std::size_t i = 0; i < work.size(); ++i) memory.deallocate(blocks[i], work[i].bytes, 16);
        reset();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(work.size()));
}

template <class Resource>
void churn_with(benchmark::State& state)
{
    Resource memory;
    churn(state, memory);
}

void churn_free_list(benchmark::State& state, carom::FreeListFit fit)
{
    carom::FreeListResource memory({.fit = fit, .chunk_bytes = 1 << 20});
    churn(state, memory);
}

template <class Resource>
void frame_with(benchmark::State& state)
{
    Resource memory;
    frame(state, memory, [] {});
}

void frame_linear(benchmark::State& state)
{
    carom::LinearResource memory(1 << 20);
    frame(state, memory, [&] { memory.reset(); });
}

void frame_monotonic(benchmark::State& state)
{
    std::pmr::monotonic_buffer_resource memory(1 << 20);
    frame(state, memory, [&] { memory.release(); });
}

} // namespace

BENCHMARK(churn_with<MallocResource>)->Name("churn/malloc")->Arg(64)->Arg(4096);
BENCHMARK(churn_with<carom::HeapResource>)->Name("churn/HeapResource")->Arg(64)->Arg(4096);
BENCHMARK_CAPTURE(churn_free_list, first, carom::FreeListFit::First)->Name("churn/FreeListResource first fit")->Arg(64)->Arg(4096);
BENCHMARK_CAPTURE(churn_free_list, best, carom::FreeListFit::Best)->Name("churn/FreeListResource best fit")->Arg(64)->Arg(4096);
BENCHMARK(churn_with<std::pmr::unsynchronized_pool_resource>)->Name("churn/std::pmr::unsynchronized_pool")->Arg(64)->Arg(4096);
BENCHMARK(frame_with<MallocResource>)->Name("frame/malloc");
BENCHMARK(frame_with<carom::HeapResource>)->Name("frame/HeapResource");
BENCHMARK(frame_linear)->Name("frame/LinearResource");
BENCHMARK(frame_monotonic)->Name("frame/std::pmr::monotonic_buffer");
BENCHMARK_MAIN();
