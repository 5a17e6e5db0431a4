// Definitions of ContactSolver, for the source files that instantiate it.
#pragma once

#include "solver/contact_solver.hpp"

namespace carom::detail
{

/// A body that turns by more than this in a substep is everywhere around its centre at once, and meets others as a disc would [rad]. At its corner as it
/// happens to be, its spin may seem to take it away from what it runs into. Test: bullets_test.
inline constexpr float whirl = 1;

/// The arm of a point on a disc: straight towards what it touches.
inline Vec2 arm_of_disc(Vec2 r, Vec2 n) { return dot(r, n) * n; }

/// Writes point `point` of a contact into lane `i` of its row, whose bodies and normal are there already.
template <class F, int N>
void fill_point(ContactRow<F, N>& row, int i, std::size_t index, const ContactPointState& point, Vec2 n, const BodyMotion& a,
                const BodyMotion& b, const BodyMass& mass_a, const BodyMass& mass_b, float warm_scale)
{
    // 1 / m along a direction u.
    const auto effective_mass = [&](Vec2 u)
    {
        const Vec2 inv_mass = mass_a.inv_mass + mass_b.inv_mass;
        const float arm_a = cross(point.r_a, u);
        const float arm_b = cross(point.r_b, u);
        const float k =
            inv_mass.x * u.x * u.x + inv_mass.y * u.y * u.y + mass_a.inv_inertia * arm_a * arm_a + mass_b.inv_inertia * arm_b * arm_b;
        return k > 0 ? 1 / k : 0.0f;
    };
    const Vec2 dv = (b.v + cross(b.w, point.r_b)) - (a.v + cross(a.w, point.r_a));

    PointRow<F>& out = row.points[index];
    set_lane(out.r_a, i, point.r_a);
    set_lane(out.r_b, i, point.r_b);
    lane(out.adjusted_separation, i) = point.separation - dot(point.r_b - point.r_a, n);
    lane(out.normal_velocity, i) = dot(dv, n);
    lane(out.normal_mass, i) = effective_mass(n);
    lane(out.tangent_mass, i) = effective_mass(carom::right_perp(n));
    lane(out.lambda_n, i) = warm_scale * point.normal_impulse;
    lane(out.lambda_t, i) = warm_scale * point.tangent_impulse;
}

/// Writes a contact into lane `i` of a row.
/// @return whether it approaches fast enough to bounce, or nearly so: the kernel decides
template <class F, int N>
bool fill_row(ContactRow<F, N>& row, int i, std::uint32_t slot, const BodyStore& bodies, const ContactStore& contacts,
              const ContactConstants& constants)
{
    const Contact& contact = contacts.contacts[slot];
    const ContactManifold& manifold = contacts.manifolds[slot];
    const std::uint32_t index_a = bodies.motion_index[contact.body_a];
    const std::uint32_t index_b = bodies.motion_index[contact.body_b];
    const BodyMass& mass_a = bodies.masses[index_a];
    const BodyMass& mass_b = bodies.masses[index_b];
    const float spin_resistance = mass_a.inv_inertia + mass_b.inv_inertia;
    const bool with_static = mass_a.inv_mass == Vec2{} || mass_b.inv_mass == Vec2{};
    const Softness& softness = with_static ? constants.with_static : constants.between_dynamic;

    const std::size_t at = static_cast<std::size_t>(i);
    row.contact[at] = slot;
    row.body_a[at] = index_a;
    row.body_b[at] = index_b;
    row.pushed_a[at] = can_be_pushed(mass_a) ? index_a : 0;
    row.pushed_b[at] = can_be_pushed(mass_b) ? index_b : 0;
    set_lane(row.inv_mass_a, i, mass_a.inv_mass);
    set_lane(row.inv_mass_b, i, mass_b.inv_mass);
    lane(row.inv_inertia_a, i) = mass_a.inv_inertia;
    lane(row.inv_inertia_b, i) = mass_b.inv_inertia;
    set_lane(row.n, i, manifold.normal);
    const float gap = 0.5f * manifold.points[0].separation; // points are halfway between the surfaces
    const float whirl_speed = whirl * constants.inv_h;
    const auto whirls = [&](const BodyMotion& motion) { return motion.w * motion.w > whirl_speed * whirl_speed; };
    const bool a_whirls = whirls(bodies.motions[index_a]);
    const bool b_whirls = whirls(bodies.motions[index_b]);
    lane(row.core_a, i) = a_whirls ? dot(manifold.points[0].r_a, manifold.normal) : manifold.rounding_a + gap;
    lane(row.core_b, i) = b_whirls ? -dot(manifold.points[0].r_b, manifold.normal) : manifold.rounding_b + gap;
    lane(row.friction, i) = contact.friction;
    lane(row.restitution, i) = contact.restitution;
    lane(row.tangent_speed, i) = contact.tangent_speed;
    lane(row.rolling_resistance, i) = contact.rolling_resistance;
    lane(row.rolling_mass, i) = spin_resistance > 0 ? 1 / spin_resistance : 0.0f;
    lane(row.rolling_lambda, i) = constants.warm_scale * manifold.rolling_impulse;
    lane(row.bias_rate, i) = softness.bias_rate;
    lane(row.mass_scale, i) = softness.mass_scale;
    lane(row.impulse_scale, i) = softness.impulse_scale;
    lane(row.carried, i) = constants.warm_scale * manifold.carried_impulse;
    bool is_fast = false;
    for (std::size_t p = 0; p < N; ++p)
    {
        ContactPointState point = manifold.points[p];
        if (a_whirls) point.r_a = arm_of_disc(point.r_a, manifold.normal);
        if (b_whirls) point.r_b = arm_of_disc(point.r_b, manifold.normal);
        fill_point(row, i, p, point, manifold.normal, bodies.motions[index_a], bodies.motions[index_b], mass_a, mass_b,
                   constants.warm_scale);
        is_fast = is_fast || lane(row.points[p].normal_velocity, i) < -0.99f * constants.restitution_threshold;
    }
    return is_fast && contact.restitution > 0;
}

/// Puts contacts one after the other into the lanes of rows; a last row's free lanes stay zero and push nothing.
template <class F, int N>
class RowWriter
{
public:
    /// @param lanes how many lanes of a row to use: all, or one where contacts depend on each other
    RowWriter(std::pmr::vector<ContactRow<F, N>>& rows, int lanes) : rows_(&rows), lanes_(lanes), next_(lanes) {}

    void write(std::uint32_t slot, const BodyStore& bodies, const ContactStore& contacts, const ContactConstants& constants)
    {
        if (next_ == lanes_)
        {
            rows_->emplace_back(ContactRow<F, N>{}).contact.fill(null_index);
            next_ = 0;
        }
        const bool may_bounce = fill_row(rows_->back(), next_++, slot, bodies, contacts, constants);
        rows_->back().may_bounce = rows_->back().may_bounce || may_bounce;
        any_bounces_ = any_bounces_ || may_bounce;
        any_belts_ = any_belts_ || contacts.contacts[slot].tangent_speed != 0;
    }
    bool any_bounces() const { return any_bounces_; }
    bool any_belts() const { return any_belts_; }

private:
    std::pmr::vector<ContactRow<F, N>>* rows_;
    int lanes_;
    int next_;
    bool any_bounces_ = false;
    bool any_belts_ = false;
};

template <class F>
void ContactSolver<F>::build_color(std::span<const std::uint32_t> color, int lanes, const BodyStore& bodies, const ContactStore& contacts,
                                   const ContactConstants& constants)
{
    if (color.empty()) return;
    ColorRange range = {single_.size(), 0, double_.size(), 0};
    RowWriter<F, 1> single(single_, lanes);
    RowWriter<F, 2> pairs(double_, lanes);
    for (const std::uint32_t slot : color)
    {
        if (contacts.manifolds[slot].count == 1)
            single.write(slot, bodies, contacts, constants);
        else
            pairs.write(slot, bodies, contacts, constants);
    }
    any_bounces_ = any_bounces_ || single.any_bounces() || pairs.any_bounces();
    any_belts_ = any_belts_ || single.any_belts() || pairs.any_belts();
    range.end_single = single_.size();
    range.end_double = double_.size();
    ranges_.push_back(range);
    row_count_ += static_cast<int>(color.size());
}

/// At most so many rows, so that no list grows while it is filled.
template <class F>
void ContactSolver<F>::make_room_for_rows(const ColorLists& colors, const ContactStore& contacts)
{
    std::size_t singles = 0;
    std::size_t doubles = 0;
    for (int color = 0; color < color_count; ++color)
    {
        const std::size_t lanes = color == overflow_color ? 1 : lane_width<F>;
        std::size_t with_one = 0;
        for (const std::uint32_t slot : colors.list(color)) with_one += contacts.manifolds[slot].count == 1;
        singles += (with_one + lanes - 1) / lanes;
        doubles += (colors.list(color).size() - with_one + lanes - 1) / lanes;
    }
    single_.reserve(singles);
    double_.reserve(doubles);
    ranges_.reserve(color_count);
}

template <class F>
void ContactSolver<F>::build(const ColorLists& colors, const BodyStore& bodies, const ContactStore& contacts,
                             const ContactConstants& constants)
{
    single_.clear();
    double_.clear();
    ranges_.clear();
    make_room_for_rows(colors, contacts);
    row_count_ = 0;
    any_bounces_ = any_belts_ = false;
    carry_share_ = constants.carry_share;
    settled_within_ = constants.settled_within;
    pass_ = {F(constants.inv_h), F(constants.push_out_speed), F(constants.restitution_threshold), F(1.25f * constants.dt), F(constants.h)};

    build_color(colors.list(overflow_color), 1, bodies, contacts, constants);
    for (int color = 0; color < overflow_color; ++color) build_color(colors.list(color), lane_width<F>, bodies, contacts, constants);
}

template <class F>
template <class Kernel>
void ContactSolver<F>::for_each_row(std::span<BodyMotion> motions, Kernel&& kernel)
{
    const auto run = [&](auto& row)
    {
        BodyLanes<F> a = gather<F>(motions, row.body_a);
        BodyLanes<F> b = gather<F>(motions, row.body_b);
        kernel(row, a, b);
        scatter<F>(motions, row.pushed_a, a);
        scatter<F>(motions, row.pushed_b, b);
    };
    for (const ColorRange& range : ranges_)
    {
        for (std::size_t i = range.first_single; i < range.end_single; ++i) run(single_[i]);
        for (std::size_t i = range.first_double; i < range.end_double; ++i) run(double_[i]);
    }
}

template <class F>
void ContactSolver<F>::warm_start(std::span<BodyMotion> motions)
{
    for_each_row(motions, [](auto& row, auto& a, auto& b) { detail::warm_start(row, a, b); });
}

template <class F>
void ContactSolver<F>::solve(std::span<BodyMotion> motions)
{
    for_each_row(motions, [this](auto& row, auto& a, auto& b) { detail::solve(row, pass_, a, b); });
}

template <class F>
void ContactSolver<F>::relax(std::span<BodyMotion> motions)
{
    for_each_row(motions, [this](auto& row, auto& a, auto& b) { detail::relax(row, pass_, a, b); });
}

/// How the bodies of a row fall along its normals.
template <class F, int N>
FreeFall<F> free_fall_of(const ContactRow<F, N>& row, std::span<const BodyWatch> watches, std::span<const Vec2> accelerations)
{
    LaneVec<F> acceleration = {F(0), F(0)};
    LaneVec<F> set_back = {F(0), F(0)};
    for (int i = 0; i < lane_width<F>; ++i)
    {
        const std::uint32_t a = row.body_a[static_cast<std::size_t>(i)];
        const std::uint32_t b = row.body_b[static_cast<std::size_t>(i)];
        set_lane(acceleration, i, accelerations[b] - accelerations[a]);
        set_lane(set_back, i, watches[b].set_back - watches[a].set_back);
    }
    return {dot(acceleration, row.n), dot(set_back, row.n)};
}

/// An impact goes on from pair to pair. After the first round only rows whose bodies have been struck since their last visit can bounce.
template <class F>
void ContactSolver<F>::bounce(std::span<BodyMotion> motions, std::span<const BodyWatch> watches, std::span<const Vec2> accelerations)
{
    if (!any_bounces_) return;
    constexpr std::uint32_t most_rounds = 16; // the passes take what is left then
    struck_.assign(motions.size(), 0);        // the last round, from 1, in which a body was struck
    bool goes_on = true;
    for (std::uint32_t round = 1; goes_on && round <= most_rounds; ++round)
    {
        goes_on = false;
        const auto is_struck = [&](std::uint32_t body) { return body != 0 && struck_[body] + 1 >= round && struck_[body] > 0; };
        const auto run = [&](auto& row)
        {
            bool may = round == 1 && row.may_bounce;
            for (std::size_t i = 0; i < lane_width<F>; ++i) may = may || is_struck(row.pushed_a[i]) || is_struck(row.pushed_b[i]);
            if (!may) return;
            BodyLanes<F> a = gather<F>(motions, row.body_a);
            BodyLanes<F> b = gather<F>(motions, row.body_b);
            const F bounced = detail::bounce(row, pass_, a, b, free_fall_of(row, watches, accelerations));
            BodyIndices<F> to_a = {};
            BodyIndices<F> to_b = {};
            for (int i = 0; i < lane_width<F>; ++i)
            {
                const auto at = static_cast<std::size_t>(i);
                if (!(lane(bounced, i) > 0)) continue;
                struck_[to_a[at] = row.pushed_a[at]] = round;
                struck_[to_b[at] = row.pushed_b[at]] = round;
                goes_on = true;
            }
            scatter<F>(motions, to_a, a);
            scatter<F>(motions, to_b, b);
        };
        for (const ColorRange& range : ranges_)
        {
            for (std::size_t i = range.first_single; i < range.end_single; ++i) run(single_[i]);
            for (std::size_t i = range.first_double; i < range.end_double; ++i) run(double_[i]);
        }
    }
}

/// Calls action(row, lane, contact slot) for every lane that holds a contact.
template <class F>
template <class Action>
void ContactSolver<F>::for_each_contact(Action&& action) const
{
    const auto visit = [&](const auto& row)
    {
        for (int i = 0; i < lane_width<F>; ++i)
            if (const std::uint32_t slot = row.contact[static_cast<std::size_t>(i)]; slot != null_index) action(row, i, slot);
    };
    for (const auto& row : single_) visit(row);
    for (const auto& row : double_) visit(row);
}

template <class F>
void ContactSolver<F>::store_impulses(ContactStore& contacts, std::span<BodyWatch> watches) const
{
    for_each_contact([&](const auto& row, int i, std::uint32_t slot)
    {
        ContactManifold& manifold = contacts.manifolds[slot];
        manifold.rolling_impulse = lane(row.rolling_lambda, i);
        manifold.total_rolling = lane(row.rolling_total, i);
        // The mean of the points: followed one by one, they would amplify a tower's rocking.
        float load = 0;
        for (std::size_t p = 0; p < row.points.size(); ++p)
        {
            ContactPointState& point = manifold.points[p];
            point.normal_impulse = lane(row.points[p].lambda_n, i);
            point.tangent_impulse = lane(row.points[p].lambda_t, i);
            point.total_normal = lane(row.points[p].total_n, i);
            point.total_tangent = lane(row.points[p].total_t, i);
            point.normal_velocity = lane(row.points[p].normal_velocity, i);
            load += point.normal_impulse / static_cast<float>(row.points.size());
        }
        const float carried = lane(row.carried, i);
        const float missing = carried_part * load - carried;
        manifold.carried_impulse = carried + carry_share_ * missing;

        // How far the spring of the contact is from where the whole correction would hold it.
        const float stiffness = lane(row.points[0].normal_mass, i) * lane(row.mass_scale, i) * lane(row.bias_rate, i);
        if (lane(row.impulse_scale, i) * missing <= settled_within_ * stiffness) return;
        for (const std::uint32_t body : {row.pushed_a[static_cast<std::size_t>(i)], row.pushed_b[static_cast<std::size_t>(i)]})
            if (body != 0) watches[body].rest_time = 0;
    });
}

/// A belt is at work while what it carries moves along it, be it slower than the belt; under a body that is held fast it is not.
template <class F>
void ContactSolver<F>::mark_driven(std::span<const BodyMotion> motions, std::span<BodyWatch> watches) const
{
    if (!any_belts_) return;
    for_each_contact([&](const auto& row, int i, std::uint32_t)
    {
        const float belt = lane(row.tangent_speed, i);
        if (belt == 0) return;
        const BodyLanes<F> a = gather<F>(motions, row.body_a);
        const BodyLanes<F> b = gather<F>(motions, row.body_b);
        for (const PointRow<F>& point : row.points)
        {
            const float vt = lane(dot(relative_velocity(point, a, b), right_perp(row.n)), i);
            if (lane(point.total_n, i) <= 0 || !is_at_work(vt, belt)) continue;
            for (const std::uint32_t body : {row.pushed_a[static_cast<std::size_t>(i)], row.pushed_b[static_cast<std::size_t>(i)]})
                if (body != 0) watches[body].is_driven = true;
        }
    });
}

template <class F>
void ContactSolver<F>::show(std::span<const BodyMotion> motions, std::span<ContactManifold> manifolds, bool is_within_substep) const
{
    const F pending = F(is_within_substep ? 1.0f : 0.0f);
    for_each_contact([&](const auto& row, int i, std::uint32_t slot)
    {
        const BodyLanes<F> a = gather<F>(motions, row.body_a);
        const BodyLanes<F> b = gather<F>(motions, row.body_b);
        ContactManifold& manifold = manifolds[slot];
        manifold.total_rolling = lane(row.rolling_total + pending * row.rolling_lambda, i);
        for (std::size_t p = 0; p < row.points.size(); ++p)
        {
            const PointRow<F>& from = row.points[p];
            ContactPointState& point = manifold.points[p];
            const LaneVec<F> way = (a.dp + rotate(a.dq, from.r_a) - from.r_a) + (b.dp + rotate(b.dq, from.r_b) - from.r_b);
            point.position += 0.5f * Vec2{lane(way.x, i), lane(way.y, i)}; // halfway between the surfaces
            point.separation = lane(separation(row, from, a, b), i);
            point.total_normal = lane(from.total_n + pending * from.lambda_n, i);
            point.total_tangent = lane(from.total_t + pending * from.lambda_t, i);
            point.normal_velocity = lane(from.normal_velocity, i);
        }
    });
}

} // namespace carom::detail
