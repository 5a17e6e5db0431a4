// Undoing the first half of a change when the second half fails.
#pragma once

#include <utility>

namespace carom::detail
{

/// Undoes what was done so far when a change ends before dismiss(), as by running out of memory.
template <class Undo>
class Rollback
{
public:
    explicit Rollback(Undo undo) : undo_(std::move(undo)) {}
    Rollback(const Rollback&) = delete;
    Rollback& operator=(const Rollback&) = delete;
    ~Rollback()
    {
        if (is_armed_) undo_();
    }
    void dismiss() { is_armed_ = false; }

private:
    Undo undo_;
    bool is_armed_ = true;
};

} // namespace carom::detail
