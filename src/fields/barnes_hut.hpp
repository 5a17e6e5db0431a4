// The pull of many bodies on many, far groups counted as one mass each.
#pragma once

#include "fields/interaction_list.hpp"
#include "fields/point_tree.hpp"

namespace carom::detail
{

/// Barnes and Hut's method, with one walk for a whole bucket of targets that are near each other: the walk collects the masses that act on
/// them into a list, and the list is then summed for each. Walking costs a bucket's share, and the sum runs four lanes wide.
///
/// A node counts as one mass (with its second moments) when its side w is less than opening_angle times the distance from its centre
/// of mass to the box around the bucket's targets, and it does not touch that box: at least as strict as asking for each target alone.
/// Its side is the longer one of the box around its sources, which is no larger than its cell.
/// @source J. Barnes, P. Hut, "A hierarchical O(N log N) force-calculation algorithm", 1986; J. Barnes, "A modified tree code: don't
///         laugh; it runs", 1990 (lists for groups of targets)
class BarnesHut
{
public:
    explicit BarnesHut(std::pmr::memory_resource& memory)
        : source_tree_(memory),
          target_tree_(memory),
          list_(memory),
          sources_(&memory),
          groups_(&memory),
          moments_(&memory)
    {
    }

    /// Adds the pull of the sources at each target.
    /// @param pull gravitational constant times mass of each source [m^3/s^2], all of one sign, none zero
    void add(std::span<const Vec2> positions, std::span<const float> pull, float softening, float opening_angle,
             std::span<const Vec2> targets, std::span<Vec2> acceleration);

private:
    /// A node of the source tree seen from afar.
    struct Group
    {
        GroupMass mass;
        float side; ///< the longer one of the box around its sources [m]
    };
    /// The same, while it is summed.
    struct Moments
    {
        double pull = 0;
        double x = 0; ///< centre
        double y = 0;
        double xx = 0; ///< pull times spread
        double xy = 0;
        double yy = 0;
    };

    template <class ForEachPart>
    static Moments moments_of(ForEachPart for_each_part);
    static GroupMass mass_of(const Moments& moments);
    void sum_groups(std::span<const Vec2> positions, std::span<const float> pull);
    void list_masses(const Aabb& targets, float opening_angle);

    PointTree source_tree_;
    PointTree target_tree_;
    InteractionList list_;
    std::pmr::vector<PointPull> sources_; ///< in the tree's order
    std::pmr::vector<Group> groups_;      ///< by node
    std::pmr::vector<Moments> moments_;   ///< by node
};

} // namespace carom::detail
