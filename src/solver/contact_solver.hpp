// Solves all contacts of a step: builds their rows colour by colour, runs the passes, and stores the impulses.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "solver/contact_row.hpp"
#include "solver/graph_colors.hpp"
#include "solver/softness.hpp"

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// The rows of a step in lanes of type F. Contacts of one point and of two have rows of their own, so that neither carries what it
/// does not use. Definitions are in contact_solver_impl.hpp; one source file a lane type instantiates them.
template <class F>
class ContactSolver
{
public:
    explicit ContactSolver(std::pmr::memory_resource& memory) : single_(&memory), double_(&memory), ranges_(&memory), struck_(&memory) {}

    /// Makes a row of every contact that has a colour.
    void build(const ColorLists& colors, const BodyStore& bodies, const ContactStore& contacts, const ContactConstants& constants);

    /// Whether bounce() may have anything to do.
    bool any_bounces() const { return any_bounces_; }
    /// Collisions that bounce, before the substeps.
    /// @param accelerations of each body by gravity and forces [m/s^2], by motion index
    void bounce(std::span<BodyMotion> motions, std::span<const BodyWatch> watches, std::span<const Vec2> accelerations);
    void warm_start(std::span<BodyMotion> motions);
    void solve(std::span<BodyMotion> motions);
    void relax(std::span<BodyMotion> motions);

    /// @param watches bodies of contacts that are still coming up begin their rest anew
    void store_impulses(ContactStore& contacts, std::span<BodyWatch> watches) const;
    /// Notes the bodies that a surface with a tangent speed carries, or that carry it.
    void mark_driven(std::span<const BodyMotion> motions, std::span<BodyWatch> watches) const;

    /// Writes what the rows hold into copies of the manifolds, as of this moment: what the step has applied so far, and where the points have come to.
    /// @param is_within_substep whether the impulses of the substep in hand act on the bodies already, and are not yet in the sums
    void show(std::span<const BodyMotion> motions, std::span<ContactManifold> manifolds, bool is_within_substep) const;

    int row_count() const { return row_count_; }

private:
    /// The rows of one colour.
    struct ColorRange
    {
        std::size_t first_single;
        std::size_t end_single;
        std::size_t first_double;
        std::size_t end_double;
    };

    template <class Kernel>
    void for_each_row(std::span<BodyMotion> motions, Kernel&& kernel);
    template <class Action>
    void for_each_contact(Action&& action) const;
    void make_room_for_rows(const ColorLists& colors, const ContactStore& contacts);
    void build_color(std::span<const std::uint32_t> color, int lanes, const BodyStore& bodies, const ContactStore& contacts,
                     const ContactConstants& constants);

    std::pmr::vector<ContactRow<F, 1>> single_;
    std::pmr::vector<ContactRow<F, 2>> double_;
    std::pmr::vector<ColorRange> ranges_;
    std::pmr::vector<std::uint32_t> struck_; ///< by motion index, scratch of bounce()
    PassConstants<F> pass_ = {};
    int row_count_ = 0;
    float carry_share_ = 0;
    float settled_within_ = 0; ///< Tolerances::settled_within [m]
    bool any_bounces_ = false;
    bool any_belts_ = false; ///< whether a surface has a tangent speed
};

extern template class ContactSolver<float>;

} // namespace carom::detail
