// Where a search for pairs puts what it finds: a list that stays small when most of it is dropped, and that ends the search when too much is kept.
//
// n shapes in one place are n (n - 1) / 2 pairs: 20,000 are 200 million, or 1.6 GB before the first contact is made. So the list is looked through whenever
// it has grown by a block, and a search stops adding once more is kept than may be.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory_resource>
#include <vector>

namespace carom::detail
{

/// The index of a shape in the shape store. Small and dense, so arrays can be addressed by it.
using ProxyIndex = std::uint32_t;

/// Two shapes with overlapping boxes; a < b.
struct ProxyPair
{
    ProxyIndex a;
    ProxyIndex b;

    friend constexpr auto operator<=>(const ProxyPair&, const ProxyPair&) = default;
};

/// Drops pairs that are of no use.
class PairFilter
{
public:
    /// Removes them from the list, beginning at `first`; the others keep their order.
    virtual void filter(std::pmr::vector<ProxyPair>& pairs, std::size_t first) = 0;

protected:
    ~PairFilter() = default;
};

class PairList
{
public:
    /// Keeps all, however many.
    explicit PairList(std::pmr::vector<ProxyPair>& pairs) : pairs_(pairs), next_look_(no_limit) {}
    /// @param most kept pairs; with one more the list is full
    PairList(std::pmr::vector<ProxyPair>& pairs, PairFilter& filter, std::size_t most)
        : pairs_(pairs),
          filter_(&filter),
          most_(most),
          next_look_(block)
    {
    }

    void add(ProxyPair pair)
    {
        if (pairs_.size() >= next_look_) [[unlikely]]
            if (!make_room()) return;
        pairs_.push_back(pair);
    }
    /// Nothing that is added any more counts: a search may end.
    bool is_full() const { return is_full_; }
    /// Pairs added so far, those that were dropped included.
    std::size_t found() const { return dropped_ + pairs_.size(); }
    /// Drops what has not been looked at yet. To be called once, after the search.
    void finish()
    {
        if (filter_ && !is_full_) look();
    }

private:
    static constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
    static constexpr std::size_t block = 1 << 16; ///< pairs between two looks: 512 KB

    bool make_room()
    {
        if (!is_full_) look();
        return !is_full_;
    }
    void look()
    {
        const std::size_t before = pairs_.size();
        filter_->filter(pairs_, kept_);
        dropped_ += before - pairs_.size();
        kept_ = pairs_.size();
        is_full_ = kept_ > most_;
        next_look_ = is_full_ ? 0 : kept_ + block;
    }

    std::pmr::vector<ProxyPair>& pairs_;
    PairFilter* filter_ = nullptr;
    std::size_t most_ = no_limit;
    std::size_t next_look_;
    std::size_t kept_ = 0; ///< the first of the list, that the filter has seen
    std::size_t dropped_ = 0;
    bool is_full_ = false;
};

} // namespace carom::detail
