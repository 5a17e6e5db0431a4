// Which proxies have changed since a structure over all of them was built.
#pragma once

#include "broadphase/broad_phase.hpp"
#include "memory/make_room.hpp"

namespace carom::detail
{

/// A structure that is only ever built anew answers queries by this: what has not changed stands in it, and what has is looked at one by one.
class ChangedProxies
{
public:
    explicit ChangedProxies(std::pmr::memory_resource& memory) : list_(&memory), is_changed_(&memory) {}

    /// So that note() of this proxy never allocates. Changes nothing when memory runs out.
    void reserve(ProxyIndex proxy)
    {
        make_room(list_, proxy + std::size_t{1});
        if (proxy >= is_changed_.size()) is_changed_.resize(proxy + std::size_t{1}, false);
    }
    /// Inserted, removed, or given another box.
    void note(ProxyIndex proxy)
    {
        if (is_changed_[proxy]) return;
        is_changed_[proxy] = true;
        list_.push_back(proxy);
    }
    void clear()
    {
        for (const ProxyIndex proxy : list_) is_changed_[proxy] = false;
        list_.clear();
    }

    bool holds(ProxyIndex proxy) const { return is_changed_[proxy]; }
    std::span<const ProxyIndex> list() const { return list_; } ///< also those that are gone, each once

private:
    std::pmr::vector<ProxyIndex> list_;
    std::pmr::vector<unsigned char> is_changed_; ///< by proxy
};

} // namespace carom::detail
