// Between contacts and their rows: fills the rows, hands them to the passes, and takes the results out again.
#include "solver/rows/contact_solver.hpp"

#include "math/lane_array.hpp"
#include "solver/rows/body_lanes.hpp"
#include "solver/rows/fill_rows.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace carom::detail
{

namespace
{

/// The rows of one colour.
struct ColorRange
{
    std::size_t first_single;
    std::size_t end_single;
    std::size_t first_double;
    std::size_t end_double;
};

/// The rows of one colour and one number of points that can bounce.
struct BouncyRange
{
    BouncePass pass;
    void* rows;
    std::size_t first; ///< in the list of bouncy rows
    std::size_t count;
};

/// One lane of a row, as a row of one lane. Rows of every width hold the same members in the same order, each of 4 bytes a lane, and then a flag.
template <class F, int N>
ContactRow<float, N> lane_of(const ContactRow<F, N>& row, int i)
{
    using One = ContactRow<float, N>;
    using Wide = ContactRow<F, N>;
    constexpr std::size_t members = offsetof(One, may_bounce) / 4;
    constexpr std::size_t member_bytes = sizeof(F);
    static_assert(offsetof(Wide, may_bounce) == members * member_bytes);
    One one = {};
    for (std::size_t m = 0; m < members; ++m)
        std::memcpy(reinterpret_cast<std::byte*>(&one) + 4 * m,
                    reinterpret_cast<const std::byte*>(&row) + m * member_bytes + 4 * static_cast<std::size_t>(i), 4);
    return one;
}

/// Contacts of one point and of two have rows of their own, so that neither carries what it does not use.
/// @tparam F lanes as they lie in memory, as many as the passes take
template <class F>
class WideContactSolver final : public ContactSolver
{
public:
    WideContactSolver(const SolverPasses& passes, std::pmr::memory_resource& memory)
        : passes_(passes),
          single_(memory),
          double_(memory),
          memory_(memory),
          ranges_(&memory),
          bouncy_(memory),
          bouncy_ranges_(&memory)
    {
    }

    void build(const ColorLists& colors, const BodyStore& bodies, const ContactStore& contacts, const ContactConstants& constants) override;
    bool any_bounces() const override { return any_bounces_; }
    void bounce(std::span<BodyMotion> motions, std::span<const BodyWatch> watches, std::span<const Vec2> accelerations) override;
    void warm_start(std::span<BodyMotion> motions) override { run(passes_.single.warm_start, passes_.pairs.warm_start, motions); }
    void solve(std::span<BodyMotion> motions) override { run(passes_.single.solve, passes_.pairs.solve, motions); }
    void relax(std::span<BodyMotion> motions) override { run(passes_.single.relax, passes_.pairs.relax, motions); }
    void store_impulses(ContactStore& contacts, std::span<BodyWatch> watches) const override;
    void mark_driven(std::span<const BodyMotion> motions, std::span<BodyWatch> watches) const override;
    void show(std::span<const BodyMotion> motions, std::span<Manifold> manifolds, bool is_within_substep) const override;

private:
    void run(ContactPass single, ContactPass pairs, std::span<BodyMotion> motions);
    template <class Action>
    void for_each_contact(Action&& action) const;
    void list_bouncy_rows();
    void make_room_for_rows(const ColorLists& colors);
    void build_color(const ColorLists& colors, int color, const RowSource& source);
    template <class Row>
    void fill(RowList<Row>& rows, FillPass pass, const RowContacts& contacts, const RowSource& source);

    const SolverPasses& passes_;
    RowList<ContactRow<F, 1>> single_;
    RowList<ContactRow<F, 2>> double_;
    std::pmr::memory_resource& memory_;
    std::pmr::vector<ColorRange> ranges_;
    RowList<BouncyRow<F>> bouncy_;
    std::pmr::vector<BouncyRange> bouncy_ranges_;
    PassConstants<float> constants_ = {};
    float carry_share_ = 0;
    float calm_share_ = 0;
    float settled_within_ = 0; ///< Tolerances::settled_within [m]
    bool any_bounces_ = false;
    bool any_belts_ = false; ///< whether a surface has a tangent speed
};

/// How many rows hold so many contacts.
std::size_t rows_for(std::size_t contacts, std::size_t lanes) { return (contacts + lanes - 1) / lanes; }

/// Lanes of a row that contacts of a colour may share.
template <class F>
std::size_t lanes_of_color(int color)
{
    return color == overflow_color ? 1 : lane_width<F>;
}

template <class F>
template <class Row>
void WideContactSolver<F>::fill(RowList<Row>& rows, FillPass pass, const RowContacts& contacts, const RowSource& source)
{
    const RowNeeds needs = pass(rows.add(rows_for(contacts.count, contacts.lanes)), contacts, source);
    any_bounces_ = any_bounces_ || needs.any_bounces;
    any_belts_ = any_belts_ || needs.any_belts;
}

template <class F>
void WideContactSolver<F>::build_color(const ColorLists& colors, int color, const RowSource& source)
{
    const std::span<const std::uint32_t> singles = colors.singles(color);
    const std::span<const std::uint32_t> doubles = colors.doubles(color);
    if (singles.empty() && doubles.empty()) return;
    const std::size_t lanes = lanes_of_color<F>(color);
    ColorRange range = {single_.size(), 0, double_.size(), 0};
    fill(single_, passes_.single.fill, {singles.data(), singles.size(), lanes}, source);
    fill(double_, passes_.pairs.fill, {doubles.data(), doubles.size(), lanes}, source);
    range.end_single = single_.size();
    range.end_double = double_.size();
    ranges_.push_back(range);
}

template <class F>
void WideContactSolver<F>::make_room_for_rows(const ColorLists& colors)
{
    std::size_t singles = 0;
    std::size_t doubles = 0;
    for (int color = 0; color < color_count; ++color)
    {
        singles += rows_for(colors.singles(color).size(), lanes_of_color<F>(color));
        doubles += rows_for(colors.doubles(color).size(), lanes_of_color<F>(color));
    }
    single_.renew(singles);
    double_.renew(doubles);
    ranges_.clear();
    ranges_.reserve(color_count);
}

template <class F>
void WideContactSolver<F>::build(const ColorLists& colors, const BodyStore& bodies, const ContactStore& contacts,
                                 const ContactConstants& constants)
{
    make_room_for_rows(colors);
    any_bounces_ = any_belts_ = false;
    carry_share_ = constants.carry_share;
    calm_share_ = constants.calm_share;
    settled_within_ = constants.settled_within;
    constants_ = {constants.inv_h, constants.push_out_speed, constants.restitution_threshold, 1.25f * constants.dt, constants.h};

    const RowSource source = source_of(bodies, contacts, constants, constants_);
    build_color(colors, overflow_color, source);
    for (int color = 0; color < overflow_color; ++color) build_color(colors, color, source);
}

template <class F>
void WideContactSolver<F>::run(ContactPass single, ContactPass pairs, std::span<BodyMotion> motions)
{
    for (const ColorRange& range : ranges_)
    {
        single(single_.data(), range.first_single, range.end_single, floats_of(motions), constants_);
        pairs(double_.data(), range.first_double, range.end_double, floats_of(motions), constants_);
    }
}

/// Lists the rows that can ever bounce, in the order of the passes.
template <class F>
void WideContactSolver<F>::list_bouncy_rows()
{
    bouncy_.renew(single_.size() + double_.size());
    bouncy_ranges_.clear();
    bouncy_ranges_.reserve(2 * ranges_.size());
    const auto list = [&](const ContactPasses& passes, void* rows, std::size_t begin, std::size_t end)
    {
        const std::size_t first = bouncy_.size();
        bouncy_.add(passes.list_bouncy(rows, begin, end, bouncy_.end()));
        if (bouncy_.size() > first) bouncy_ranges_.push_back({passes.bounce, rows, first, bouncy_.size() - first});
    };
    for (const ColorRange& range : ranges_)
    {
        list(passes_.single, single_.data(), range.first_single, range.end_single);
        list(passes_.pairs, double_.data(), range.first_double, range.end_double);
    }
}

/// An impact goes on from pair to pair.
template <class F>
void WideContactSolver<F>::bounce(std::span<BodyMotion> motions, std::span<const BodyWatch> watches, std::span<const Vec2> accelerations)
{
    if (!any_bounces_) return;
    constexpr int most_rounds = 16; // the passes take what is left then
    list_bouncy_rows();
    std::pmr::vector<float> struck(motions.size(), 0.0f, &memory_);
    std::pmr::vector<std::array<float, fall_floats>> falls(&memory_);
    falls.reserve(motions.size());
    for (std::size_t i = 0; i < motions.size(); ++i)
        falls.push_back({accelerations[i].x, accelerations[i].y, watches[i].set_back.x, watches[i].set_back.y});
    bool goes_on = true;
    for (int round = 1; goes_on && round <= most_rounds; ++round)
    {
        goes_on = false;
        const BounceRound now = {falls.front().data(), struck.data(), static_cast<float>(round)};
        for (const BouncyRange& range : bouncy_ranges_)
            goes_on = range.pass(range.rows, bouncy_.data() + range.first, range.count, floats_of(motions), constants_, now) || goes_on;
    }
}

/// Calls action(row, lane, contact slot) for every lane that holds a contact.
template <class F>
template <class Action>
void WideContactSolver<F>::for_each_contact(Action&& action) const
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
void WideContactSolver<F>::store_impulses(ContactStore& contacts, std::span<BodyWatch> watches) const
{
    if (single_.size() + double_.size() == 0) return;
    std::pmr::vector<float> is_calm(&memory_);
    is_calm.reserve(watches.size());
    is_calm.push_back(1);
    for (const BodyWatch& watch : watches.subspan(1)) is_calm.push_back(watch.rest_time > 0 ? 1.0f : 0.0f);
    const ResultTarget target = target_of(contacts, watches, is_calm, {carried_part, carry_share_, calm_share_, settled_within_});
    passes_.single.store(single_.begin(), single_.size(), target);
    passes_.pairs.store(double_.begin(), double_.size(), target);
}

/// A belt is at work while what it carries moves along it, be it slower than the belt; under a body that is held fast it is not.
template <class F>
void WideContactSolver<F>::mark_driven(std::span<const BodyMotion> motions, std::span<BodyWatch> watches) const
{
    if (!any_belts_) return;
    for_each_contact([&](const auto& wide, int i, std::uint32_t)
    {
        const float belt = lane(wide.tangent_speed, i);
        if (belt == 0) return;
        const auto row = lane_of(wide, i);
        const BodyLanes<float> a = gather(motions, row.body_a);
        const BodyLanes<float> b = gather(motions, row.body_b);
        for (const PointRow<float>& point : row.points)
        {
            const float vt = dot(relative_velocity(point, a, b), right_perp(row.n));
            if (point.total_n <= 0 || !is_at_work(vt, belt)) continue;
            for (const std::uint32_t body : {row.pushed_a[0], row.pushed_b[0]})
                if (body != 0) watches[body].is_driven = true;
        }
    });
}

template <class F>
void WideContactSolver<F>::show(std::span<const BodyMotion> motions, std::span<Manifold> manifolds, bool is_within_substep) const
{
    const float pending = is_within_substep ? 1.0f : 0.0f;
    for_each_contact([&](const auto& wide, int i, std::uint32_t slot)
    {
        const auto row = lane_of(wide, i);
        const BodyLanes<float> a = gather(motions, row.body_a);
        const BodyLanes<float> b = gather(motions, row.body_b);
        Manifold& manifold = manifolds[slot];
        manifold.rolling_impulse = row.rolling_total + pending * row.rolling_lambda;
        for (std::size_t p = 0; p < row.points.size(); ++p)
        {
            const PointRow<float>& from = row.points[p];
            ContactPoint& point = manifold.points[p];
            const LaneVec<float> way = (a.dp + rotate(a.dq, from.r_a) - from.r_a) + (b.dp + rotate(b.dq, from.r_b) - from.r_b);
            point.position += 0.5f * Vec2{way.x, way.y}; // halfway between the surfaces
            point.separation = separation(row, from, a, b);
            point.normal_impulse = from.total_n + pending * from.lambda_n;
            point.tangent_impulse = from.total_t + pending * from.lambda_t;
            point.approach_speed = -from.normal_velocity;
        }
    });
}

template <class F>
ContactSolverPtr make_wide(const SolverPasses& passes, std::pmr::memory_resource& arena)
{
    return ContactSolverPtr(std::pmr::polymorphic_allocator<>(&arena).new_object<WideContactSolver<F>>(passes, arena));
}

} // namespace

ContactSolverPtr make_contact_solver(const SolverPasses& passes, std::pmr::memory_resource& arena)
{
    switch (passes.lanes)
    {
    case 4: return make_wide<LaneArray<4>>(passes, arena);
    case 8: return make_wide<LaneArray<8>>(passes, arena);
    case 16: return make_wide<LaneArray<16>>(passes, arena);
    default: return make_wide<float>(passes, arena);
    }
}

} // namespace carom::detail
