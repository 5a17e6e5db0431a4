// Makes a broad phase of the chosen type.
#include "broadphase/broad_phase.hpp"

#include "broadphase/brute_force.hpp"
#include "broadphase/quadtree.hpp"
#include "broadphase/quadtree_naive.hpp"
#include "broadphase/quadtree_with_set.hpp"
#include "broadphase/tree.hpp"

#include <new>

namespace carom
{

std::string_view name_of(BroadPhaseType type)
{
    switch (type)
    {
    case BroadPhaseType::BruteForce: return "BruteForce";
    case BroadPhaseType::QuadtreeNaive: return "QuadtreeNaive";
    case BroadPhaseType::QuadtreeWithSet: return "QuadtreeWithSet";
    case BroadPhaseType::Quadtree: return "Quadtree";
    case BroadPhaseType::Tree: return "Tree";
    }
    return "";
}

std::optional<BroadPhaseType> broad_phase_named(std::string_view name)
{
    for (const BroadPhaseType type : all_broad_phases)
        if (name_of(type) == name) return type;
    return std::nullopt;
}

} // namespace carom

namespace carom::detail
{
namespace
{

// The constructors allocate nothing, so nothing can throw between the two lines.
template <class T>
BroadPhasePtr make(const BroadPhaseOptions& options, std::pmr::memory_resource& memory)
{
    void* const storage = memory.allocate(sizeof(T), alignof(T));
    return BroadPhasePtr(new (storage) T(options, memory), {&memory, sizeof(T), alignof(T)});
}

} // namespace

void BroadPhaseDelete::operator()(BroadPhase* broad_phase) const
{
    broad_phase->~BroadPhase();
    memory->deallocate(broad_phase, size, alignment);
}

BroadPhasePtr make_broad_phase(BroadPhaseType type, const BroadPhaseOptions& options, std::pmr::memory_resource& memory)
{
    switch (type)
    {
    case BroadPhaseType::BruteForce: return make<BruteForce>(options, memory);
    case BroadPhaseType::QuadtreeNaive: return make<QuadtreeNaive>(options, memory);
    case BroadPhaseType::QuadtreeWithSet: return make<QuadtreeWithSet>(options, memory);
    case BroadPhaseType::Quadtree: return make<Quadtree>(options, memory);
    case BroadPhaseType::Tree: break;
    }
    return make<Tree>(options, memory);
}

} // namespace carom::detail
