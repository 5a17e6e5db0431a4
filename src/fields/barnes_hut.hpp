// The pull of many bodies on many, far groups counted as one mass each.
#pragma once

#include "fields/interaction_list.hpp"
#include "fields/local_series.hpp"
#include "fields/point_tree.hpp"

namespace carom::detail
{

/// Barnes and Hut's method, for all targets at once: a tree of sources and one of targets are walked together from their roots. Where a node of
/// sources is far from a node of targets, for the sizes of both, its pull is found once, as a series about the middle of the targets, which their
/// children inherit. What is near goes on to the children. A bucket of targets is left with its own neighbourhood: groups that are far for
/// their own size, and bodies, in a list that is summed for each target. Sums run over the lanes of the instruction set.
///
/// A node counts as one mass (with its second moments) for each target when its side w is less than opening_angle times the distance from its
/// centre of mass to the box around the bucket's targets, and it does not touch that box: at least as strict as asking for each target
/// alone. For a series, w is the larger of both sides and the distance that of both centres: see series_share. A side is the longer one of the box around a node's points, which is no larger than its cell.
/// @source J. Barnes, P. Hut, "A hierarchical O(N log N) force-calculation algorithm", 1986; J. Barnes, "A modified tree code: don't
///         laugh; it runs", 1990 (lists for groups of targets); W. Dehnen, "A Very Fast and Momentum-conserving Tree Code", 2000 (series)
class BarnesHut
{
public:
    explicit BarnesHut(std::pmr::memory_resource& memory)
        : source_tree_(memory),
          target_tree_(memory),
          near_(memory),
          open_(&memory),
          queue_(&memory),
          rest_(&memory),
          far_(&memory),
          targets_(&memory),
          pulls_(&memory),
          sources_(memory),
          masses_(&memory),
          extents_(&memory),
          moments_(&memory)
    {
    }

    /// Adds the pull of the sources at each target.
    /// @param pull gravitational constant times mass of each source [m^3/s^2], all of one sign, none zero
    /// @param are_as_before the sources and targets are those of the last call, and have hardly moved: the trees are kept, with new bounds
    void add(std::span<const Vec2> positions, std::span<const float> pull, float softening, float opening_angle,
             std::span<const Vec2> targets, std::span<Vec2> acceleration, const PullPasses& passes, bool are_as_before);

private:
    /// What tells how near a node of sources is.
    struct Extent
    {
        Vec2 center; ///< of mass [m]
        float side;  ///< the longer one of the box around its sources [m]
    };
    /// The mass of a node, while it is summed.
    struct Moments
    {
        double pull = 0;
        double x = 0; ///< centre
        double y = 0;
        double xx = 0; ///< pull times spread
        double xy = 0;
        double yy = 0;
        double xxx = 0;
        double xxy = 0;
        double xyy = 0;
        double yyy = 0;
    };

    /// What stays the same during a walk.
    struct Walk
    {
        float angle_squared;        ///< of groups at single targets
        float series_angle_squared; ///< of groups at a node of targets
        PullLimits limits;
        const PullPasses& passes;
    };

    template <class ForEachPart>
    static Moments moments_of(ForEachPart for_each_part);
    static GroupMass mass_of(const Moments& moments);
    static void update(PointTree& tree, std::span<const Vec2> points, std::uint32_t bucket_size, bool is_kept);
    void sum_groups(std::span<const Vec2> positions, std::span<const float> pull);
    void visit(const Walk& walk, std::uint32_t target, std::size_t begin, std::size_t end, const LocalPull& inherited);
    void take_far(const Walk& walk, const LocalPull& around, float side);
    void take_near(const Walk& walk, const Aabb& targets);
    void leave_small(float side);
    void add_children(std::uint32_t source);
    void sum_bucket(const Walk& walk, const PointTree::Node& bucket, const LocalPull& around);

    PointTree source_tree_;
    PointTree target_tree_;
    InteractionList near_; ///< what is summed for each target of a bucket
    std::pmr::vector<std::uint32_t>
        open_; ///< sources that each node of targets on the way down leaves to its children, one after the other
    std::pmr::vector<std::uint32_t> queue_; ///< sources that are to be sorted for a node of targets
    std::pmr::vector<std::uint32_t> rest_;  ///< those of them that are not far
    std::pmr::vector<std::uint32_t> far_;   ///< those that are
    std::pmr::vector<Vec2> targets_;        ///< in their tree's order
    std::pmr::vector<Vec2> pulls_;          ///< of the targets, in the same order
    BodyArrays sources_;                    ///< in the tree's order
    std::pmr::vector<GroupMass> masses_;    ///< by node
    std::pmr::vector<Extent> extents_;      ///< by node
    std::pmr::vector<Moments> moments_;     ///< by node
};

} // namespace carom::detail
