// Follows centres of mass from step to step.
#include "lab/passages.hpp"

#include <algorithm>

namespace carom::lab
{

namespace
{

/// Lets a ray see one body.
class OnlyBody : public QueryPredicate
{
public:
    explicit OnlyBody(BodyId body) : body_(body) {}
    bool accepts(ShapeId, BodyId body) const override { return body == body_; }

private:
    BodyId body_;
};

/// Where a point was before, had the other body been all the time where it is now.
Vec2 seen_from(const Transform& before, const Transform& now, Vec2 point)
{
    constexpr float most_cosine = 0.87758256f; // of half a radian
    const bool turns_far = relative(before.q, now.q).c < most_cosine;
    return turns_far ? point + (now.p - before.p) : now * inverse_transform(before, point);
}

bool can_pass(const BodyView& body) { return body.type() == BodyType::Dynamic && body.is_enabled() && body.shape_count() > 0; }

} // namespace

void Passages::look(const World& world, int step)
{
    Places now;
    for (const BodyId id : world.bodies())
    {
        const BodyView body = world.body(id);
        if (body.is_enabled() && body.shape_count() > 0) now[id] = {body.transform(), body.center_of_mass()};
    }
    if (step_before_ && step == *step_before_ + 1)
    {
        has_seen_a_step_ = true;
        for (const auto& [id, before] : before_)
            if (now.contains(id) && can_pass(world.body(id))) follow(world, id, before, now);
    }
    before_ = std::move(now);
    step_before_ = step;
}

void Passages::follow(const World& world, BodyId id, const Place& before, const Places& now)
{
    const Vec2 end = now.at(id).center;
    const ShapeId shape = world.body(id).shapes().front();
    for (const auto& [other, place] : now)
    {
        const auto other_before = before_.find(other);
        if (other == id || other_before == before_.end()) continue;
        const Vec2 start = seen_from(other_before->second.frame, place.frame, before.center);
        if (!overlaps(world.body(other).bounds(), Aabb{min(start, end), max(start, end)})) continue;
        const OnlyBody only(other);
        const auto hit = world.cast_ray(start, end - start, {.filter = world.shape(shape).filter(), .predicate = &only});
        if (hit && !hit->starts_inside) gone_through_.insert(std::minmax(id, other));
    }
}

std::optional<int> Passages::count() const
{
    if (!has_seen_a_step_) return std::nullopt;
    return static_cast<int>(gone_through_.size());
}

} // namespace carom::lab
