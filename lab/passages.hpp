// Which bodies went through others, seen from where all of them are after each step.
#pragma once

#include <carom/world.hpp>

#include <map>
#include <optional>
#include <set>
#include <utility>

namespace carom::lab
{

/// A body went through another one when its centre of mass came to the inner side of its surface in a step: by that, half of it is gone through the
/// wall. Its way is seen from the other body, so walls may move; between two steps both go straight. What turns by more than half a radian in a step is
/// followed without its turning. Shapes that would not collide, sensors and what a centre lies in from the start do not count.
class Passages
{
public:
    /// @param world as it is after a step
    /// @param step  number of that step; ways are known from the step right before it only
    void look(const World& world, int step);

    /// Pairs of bodies of which one went through the other, each once; none when there never were two steps in a row.
    std::optional<int> count() const;

private:
    struct Place
    {
        Transform frame;
        Vec2 center; ///< of mass
    };
    using Places = std::map<BodyId, Place>;

    void follow(const World& world, BodyId id, const Place& before, const Places& now);

    Places before_;
    std::optional<int> step_before_;                   ///< of those places
    std::set<std::pair<BodyId, BodyId>> gone_through_; ///< the smaller id first
    bool has_seen_a_step_ = false;
};

} // namespace carom::lab
