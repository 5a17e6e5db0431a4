// The blocks of memory that are in use, by address: a hash table with open addressing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>

namespace carom::profile
{

/// Its own memory comes from malloc, not from operator new: the recorder does not show in the counts of who watches the heap, and a lack
/// of memory costs an entry, not the program.
class BlockTable
{
public:
    struct Block
    {
        const void* pointer; ///< null marks a free place
        std::size_t bytes;
        std::size_t pool;
    };

    std::size_t size() const { return size_; }

    /// @param block its pointer is not null and not in the table
    /// @return false when there was no memory to note it
    bool insert(const Block& block);
    /// Takes a block out; empty when there is none at this address.
    std::optional<Block> remove(const void* pointer);

private:
    struct Free
    {
        void operator()(Block* blocks) const { std::free(blocks); }
    };
    using Places = std::unique_ptr<Block, Free>;

    bool grow();
    std::size_t home_of(const void* pointer) const;
    std::size_t after(std::size_t place) const { return (place + 1) & (capacity_ - 1); }
    Block& at(std::size_t place) const { return places_.get()[place]; }
    void put(const Block& block);

    Places places_;
    std::size_t capacity_ = 0; ///< 0 or a power of two; at least a quarter is free
    std::size_t size_ = 0;
};

} // namespace carom::profile
