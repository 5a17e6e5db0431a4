// Equal mechanisms side by side, one in each lane: bodies and joints that hang together, with all rigid rows solved at once, exactly. That is what makes a
// long chain hold a heavy load.
//
// Row by row, an impulse travels one joint a pass: a chain of 100 links under 100 times a link's weight needs thousands of passes. Together
// the rows are one linear system, where J and M are those of all joints and bodies:
//   (A + S) change = -(J v + curvature + bias) - S lambda,   A = J M^-1 J^T
// A is nearly empty: two joints are coupled when they share a body that can move. Elimination block by block (L D L^T), a block for each joint, costs a
// chain or a tree no more than a few passes. Elimination (solver/joints/elimination.hpp) says in which order. Numbers are in double precision,
// since a chain's impulses differ by its mass ratio.
//
// In a loop of joints rows may say the same twice, as in a net of pins, or contradict each other. Each is a very stiff spring rather than rigid:
// that is S. In a chain or a tree they can't, and S is only what rounding asks for, so that a rope carries any load.
#pragma once

#include "solver/kernels/joint_kernels.hpp"
#include "solver/kernels/motion_kernels.hpp"

namespace carom::detail
{

/// An elimination: the joint, and where the joints stand that it couples: its front.
struct EliminationColumn
{
    std::uint32_t joint;
    std::uint32_t front_begin;
    std::uint32_t front_end;
    std::uint32_t targets_begin; ///< for each pair of the front the block that it changes
};

/// Two joints of one body: the block of A that couples them.
struct JointCoupling
{
    std::uint32_t row_joint; ///< eliminated later
    std::uint32_t column_joint;
    bool row_is_b; ///< whether the body is B of that joint
    bool column_is_b;
    std::uint32_t block;
};

/// The bodies of a joint among those of the mechanism.
struct JointEnds
{
    std::uint32_t a;
    std::uint32_t b;

    friend bool operator==(const JointEnds&, const JointEnds&) = default;
};

/// How mechanisms of one kind hang together, and in which order their joints are eliminated.
struct MechanismPlan
{
    const JointEnds* ends; ///< by joint
    std::uint32_t joint_count;
    std::uint32_t body_count;
    int block_rows; ///< rigid rows of the joint that has most: 1 to 3
    const EliminationColumn* columns;
    std::uint32_t front_count;
    const std::uint32_t* front_columns; ///< beside each joint of a front, its column
    const std::uint32_t* targets;
    const JointCoupling* couplings;
    std::uint32_t coupling_count;
};

/// Mechanisms of one kind, and their rows.
struct MechanismGroup
{
    const MechanismPlan* plan;
    char* rows;                   ///< JointRow<F>s
    const std::uint32_t* offsets; ///< by joint: where its row begins [bytes]
    const std::uint32_t* bodies;  ///< LaneIndices<F> by body: motion indices
    const std::uint32_t* pushed;  ///< the same where a velocity can change, else 0
    double* numbers;              ///< what Mechanisms names; first the softness of rows, as a share of their diagonal of A
    float* motions;               ///< scratch: BodyLanes<F>, then CorrectionLanes<F>, by body
};

/// Joints that are to close faster than this [length units/s], [rad/s] are corrected apart from what they carry: 4 mm at 240 substeps a second. A push
/// through the velocity, taken back where the body has come to, leaves what the joints at that place do not hold.
inline constexpr float gentle_bias = 0.2f;
/// Most speed at which a body is corrected [length units/s], and most turn in a substep [rad].
inline constexpr float most_correction = 2 * max_bias;
inline constexpr float most_correction_turn = 0.1f;

/// How correcting would change a body's velocity.
template <class F>
struct CorrectionLanes
{
    LaneVec<F> v;
    F w;
};

/// Row by row.
template <class F, std::size_t Rows>
using Block = LaneList<DoubleOf<F>, Rows * Rows>;

template <class F, std::size_t Rows>
using BlockVector = LaneList<DoubleOf<F>, Rows>;

/// A group with its parts by name.
template <class F, std::size_t Rows>
struct Mechanisms
{
    explicit Mechanisms(const MechanismGroup& g)
        : plan(*g.plan),
          group(g),
          bodies(reinterpret_cast<const LaneIndices<F>*>(g.bodies)),
          pushed(reinterpret_cast<const LaneIndices<F>*>(g.pushed)),
          motions(reinterpret_cast<BodyLanes<F>*>(g.motions)),
          corrections(reinterpret_cast<CorrectionLanes<F>*>(motions + plan.body_count)),
          softness_share(reinterpret_cast<DoubleOf<F>*>(g.numbers)),
          diagonal(reinterpret_cast<Block<F, Rows>*>(softness_share + 1)),
          blocks(diagonal + plan.joint_count),
          values(reinterpret_cast<BlockVector<F, Rows>*>(blocks + plan.front_count)),
          softness(values + plan.joint_count),
          wanted(softness + plan.joint_count)
    {
    }

    JointRow<F>& row(std::uint32_t joint) const { return *reinterpret_cast<JointRow<F>*>(group.rows + group.offsets[joint]); }
    BodyLanes<F>& a(std::uint32_t joint) const { return motions[plan.ends[joint].a]; }
    BodyLanes<F>& b(std::uint32_t joint) const { return motions[plan.ends[joint].b]; }

    const MechanismPlan& plan;
    const MechanismGroup& group;
    const LaneIndices<F>* bodies;
    const LaneIndices<F>* pushed;
    BodyLanes<F>* motions;           ///< by body
    CorrectionLanes<F>* corrections; ///< by body
    DoubleOf<F>* softness_share;
    Block<F, Rows>* diagonal;       ///< by column; its inverse after eliminate()
    Block<F, Rows>* blocks;         ///< beside each joint of a front: A, then A D^-1
    BlockVector<F, Rows>* values;   ///< by column: velocities to bring about, then the impulses that do it
    BlockVector<F, Rows>* softness; ///< by column: S
    BlockVector<F, Rows>* wanted;   ///< by column: scratch of solve_consistent()
};

/// J_i M^-1 J_k^T of one body that two joints share. Impulses act on a joint's A with the opposite sign.
template <class F>
DoubleOf<F> couple(const JointRow<F>& row, std::size_t i, bool row_is_b, const JointRow<F>& column, std::size_t k, bool column_is_b)
{
    const LaneVec<F>& inv_mass = row_is_b ? row.inv_mass_b : row.inv_mass_a;
    const F& inv_inertia = row_is_b ? row.inv_inertia_b : row.inv_inertia_a;
    const Jacobian<F>& p = row.rigid[i];
    const Jacobian<F>& q = column.rigid[k];
    const LaneVec<F>& u = row_is_b ? p.l_b : p.l_a;
    const LaneVec<F>& v = column_is_b ? q.l_b : q.l_a;
    const DoubleOf<F> s = to_double(row_is_b ? p.s_b : p.s_a) * to_double(column_is_b ? q.s_b : q.s_a);
    const DoubleOf<F> x = to_double(u.x) * to_double(v.x);
    const DoubleOf<F> y = to_double(u.y) * to_double(v.y);
    const DoubleOf<F> sum = to_double(inv_mass.x) * x + to_double(inv_mass.y) * y + to_double(inv_inertia) * s;
    return row_is_b == column_is_b ? sum : -sum;
}

/// Writes A + S.
template <class F, std::size_t Rows>
void fill_blocks(const Mechanisms<F, Rows>& m)
{
    using D = DoubleOf<F>;
    for (std::uint32_t f = 0; f < m.plan.front_count; ++f)
        for (D& number : m.blocks[f]) number = D(0.0);
    for (std::uint32_t c = 0; c < m.plan.coupling_count; ++c)
    {
        const JointCoupling& of = m.plan.couplings[c];
        const JointRow<F>& row = m.row(of.row_joint);
        const JointRow<F>& column = m.row(of.column_joint);
        Block<F, Rows>& block = m.blocks[of.block];
        for (std::size_t i = 0; i < row.rigid_count; ++i)
            for (std::size_t k = 0; k < column.rigid_count; ++k)
                block[Rows * i + k] = block[Rows * i + k] + couple(row, i, of.row_is_b, column, k, of.column_is_b);
    }
    for (std::uint32_t k = 0; k < m.plan.joint_count; ++k)
    {
        const JointRow<F>& row = m.row(m.plan.columns[k].joint);
        Block<F, Rows>& block = m.diagonal[k];
        for (D& number : block) number = D(0.0);
        for (D& number : m.softness[k]) number = D(0.0);
        for (std::size_t i = 0; i < row.rigid_count; ++i)
        {
            for (std::size_t c = 0; c < row.rigid_count; ++c)
                block[Rows * i + c] = couple(row, i, false, row, c, false) + couple(row, i, true, row, c, true);
            m.softness[k][i] = *m.softness_share * block[Rows * i + i];
            block[Rows * i + i] = block[Rows * i + i] + m.softness[k][i];
        }
    }
}

/// D^-1 by elimination of unit columns; rows that can push nothing give zero rows.
template <class F, std::size_t Rows>
Block<F, Rows> inverse(Block<F, Rows> d)
{
    using D = DoubleOf<F>;
    Block<F, Rows> inv;
    for (D& number : inv) number = D(0.0);
    for (std::size_t i = 0; i < Rows; ++i)
    {
        const auto can_push = d[Rows * i + i] > D(0.0);
        inv[Rows * i + i] = select(can_push, D(1.0), D(0.0));
        const D p = select(can_push, D(1.0) / select(can_push, d[Rows * i + i], D(1.0)), D(1.0));
        for (std::size_t c = 0; c < Rows; ++c)
        {
            d[Rows * i + c] = d[Rows * i + c] * p;
            inv[Rows * i + c] = inv[Rows * i + c] * p;
        }
        for (std::size_t r = 0; r < Rows; ++r)
        {
            if (r == i) continue;
            const D f = select(can_push, d[Rows * r + i], D(0.0));
            for (std::size_t c = 0; c < Rows; ++c)
            {
                d[Rows * r + c] = d[Rows * r + c] - f * d[Rows * i + c];
                inv[Rows * r + c] = inv[Rows * r + c] - f * inv[Rows * i + c];
            }
        }
    }
    return inv;
}

/// A + S becomes L D L^T.
template <class F, std::size_t Rows>
void eliminate(const Mechanisms<F, Rows>& m)
{
    for (std::uint32_t k = 0; k < m.plan.joint_count; ++k)
    {
        const EliminationColumn& column = m.plan.columns[k];
        const Block<F, Rows> inv = m.diagonal[k] = inverse<F, Rows>(m.diagonal[k]);
        std::uint32_t target = column.targets_begin;
        for (std::uint32_t f = column.front_begin; f < column.front_end; ++f)
        {
            const Block<F, Rows> a = m.blocks[f];
            Block<F, Rows> w;
            for (std::size_t i = 0; i < Rows; ++i)
                for (std::size_t c = 0; c < Rows; ++c)
                {
                    w[Rows * i + c] = a[Rows * i] * inv[c];
                    for (std::size_t l = 1; l < Rows; ++l) w[Rows * i + c] = w[Rows * i + c] + a[Rows * i + l] * inv[Rows * l + c];
                }
            m.blocks[f] = w;
            // Every block that pairs this joint of the front with itself and with those before it, whose blocks hold A D^-1 by now.
            const auto subtract = [&](Block<F, Rows>& from, const Block<F, Rows>& other)
            {
                for (std::size_t i = 0; i < Rows; ++i)
                    for (std::size_t c = 0; c < Rows; ++c)
                        for (std::size_t l = 0; l < Rows; ++l)
                            from[Rows * i + c] = from[Rows * i + c] - a[Rows * i + l] * other[Rows * c + l];
            };
            for (std::uint32_t e = column.front_begin; e < f; ++e) subtract(m.blocks[m.plan.targets[target++]], m.blocks[e]);
            subtract(m.diagonal[m.plan.front_columns[f]], w);
        }
    }
}

/// (A + S) x = values, in place: forward through L, then back through D and L^T.
template <class F, std::size_t Rows>
void substitute(const Mechanisms<F, Rows>& m)
{
    for (std::uint32_t k = 0; k < m.plan.joint_count; ++k)
        for (std::uint32_t f = m.plan.columns[k].front_begin; f < m.plan.columns[k].front_end; ++f)
        {
            BlockVector<F, Rows>& x = m.values[m.plan.front_columns[f]];
            for (std::size_t i = 0; i < Rows; ++i)
                for (std::size_t c = 0; c < Rows; ++c) x[i] = x[i] - m.blocks[f][Rows * i + c] * m.values[k][c];
        }
    for (std::uint32_t k = m.plan.joint_count; k-- > 0;)
    {
        BlockVector<F, Rows> sum;
        for (std::size_t i = 0; i < Rows; ++i)
        {
            sum[i] = m.diagonal[k][Rows * i] * m.values[k][0];
            for (std::size_t c = 1; c < Rows; ++c) sum[i] = sum[i] + m.diagonal[k][Rows * i + c] * m.values[k][c];
        }
        for (std::uint32_t f = m.plan.columns[k].front_begin; f < m.plan.columns[k].front_end; ++f)
        {
            const BlockVector<F, Rows>& y = m.values[m.plan.front_columns[f]];
            for (std::size_t i = 0; i < Rows; ++i)
                for (std::size_t c = 0; c < Rows; ++c) sum[c] = sum[c] - m.blocks[f][Rows * i + c] * y[i];
        }
        m.values[k] = sum;
    }
}

/// Solves for that part of the values which the rows can bring about together. Of a contradiction only S would be left to resist, and its huge
/// impulses, without effect here, would throw the bodies about where the Jacobians have changed.
template <class F, std::size_t Rows>
void solve_consistent(const Mechanisms<F, Rows>& m)
{
    // With y = (A + S)^-1 values, values - S y = A y is what can be had.
    for (std::uint32_t k = 0; k < m.plan.joint_count; ++k) m.wanted[k] = m.values[k];
    substitute(m);
    for (std::uint32_t k = 0; k < m.plan.joint_count; ++k)
        for (std::size_t i = 0; i < Rows; ++i) m.values[k][i] = m.wanted[k][i] - m.softness[k][i] * m.values[k][i];
    substitute(m);
}

/// Velocities to bring about.
/// @param far_off 1 in lanes whose errors are corrected apart, else 0
template <bool WithBias, class F, std::size_t Rows>
void set_wanted_velocities(const Mechanisms<F, Rows>& m, const JointConstants<F>& k, const F& far_off)
{
    using D = DoubleOf<F>;
    for (std::uint32_t column = 0; column < m.plan.joint_count; ++column)
    {
        const std::uint32_t joint = m.plan.columns[column].joint;
        JointRow<F>& row = m.row(joint);
        if constexpr (WithBias) bend(row, m.a(joint), m.b(joint), k);
        for (std::size_t i = 0; i < Rows; ++i)
        {
            m.values[column][i] = D(0.0);
            if (i >= row.rigid_count) continue;
            F rate = velocity(row.rigid[i], m.a(joint), m.b(joint));
            if constexpr (WithBias) rate = rate + row.curvature[i] + select(far_off > F(0), F(0), bias_of(row, i, k));
            m.values[column][i] = -to_double(rate) - m.softness[column][i] * to_double(row.lambda[i]);
        }
    }
}

/// Applies the impulses of the last solution.
template <class F, std::size_t Rows>
void apply_impulses(const Mechanisms<F, Rows>& m)
{
    for (std::uint32_t column = 0; column < m.plan.joint_count; ++column)
    {
        const std::uint32_t joint = m.plan.columns[column].joint;
        JointRow<F>& row = m.row(joint);
        for (std::size_t i = 0; i < row.rigid_count; ++i)
        {
            const F change = to_single(m.values[column][i]);
            row.lambda[i] = row.lambda[i] + change;
            apply(row, row.rigid[i], change, m.a(joint), m.b(joint));
        }
    }
}

/// 1 in lanes whose joints are to close faster than gentle_bias, else 0: what one mechanism is off does not show in another.
template <class F, std::size_t Rows>
F find_far_off(const Mechanisms<F, Rows>& m, const JointConstants<F>& k)
{
    F worst = F(0);
    for (std::uint32_t joint = 0; joint < m.plan.joint_count; ++joint)
    {
        const JointRow<F>& row = m.row(joint);
        for (std::size_t i = 0; i < row.rigid_count; ++i)
        {
            const F bias = bias_of(row, i, k) * (F(max_bias) / most_bias(row.rigid[i], k));
            worst = lane_max(worst, lane_max(bias, F(0) - bias));
        }
    }
    return select(worst > F(gentle_bias), F(1), F(0));
}

/// What the impulses of the last solution would do to the bodies.
template <class F, std::size_t Rows>
void find_corrections(const Mechanisms<F, Rows>& m)
{
    for (std::uint32_t body = 0; body < m.plan.body_count; ++body) m.corrections[body] = {{F(0), F(0)}, F(0)};
    for (std::uint32_t column = 0; column < m.plan.joint_count; ++column)
    {
        const std::uint32_t joint = m.plan.columns[column].joint;
        const JointRow<F>& row = m.row(joint);
        CorrectionLanes<F>& a = m.corrections[m.plan.ends[joint].a];
        CorrectionLanes<F>& b = m.corrections[m.plan.ends[joint].b];
        for (std::size_t i = 0; i < row.rigid_count; ++i)
        {
            const Jacobian<F>& j = row.rigid[i];
            const F lambda = to_single(m.values[column][i]);
            a.v = a.v - scale(row.inv_mass_a, j.l_a) * lambda;
            a.w = a.w - row.inv_inertia_a * j.s_a * lambda;
            b.v = b.v + scale(row.inv_mass_b, j.l_b) * lambda;
            b.w = b.w + row.inv_inertia_b * j.s_b * lambda;
        }
    }
}

/// Moves joints that are far off back into place, and leaves velocities as they are. Where joints contradict each other the equations ask for
/// a leap: each mechanism goes that way in proportion, and not much faster than its joints are to close.
template <class F, std::size_t Rows>
void correct(const Mechanisms<F, Rows>& m, const JointConstants<F>& k, const F& far_off)
{
    using D = DoubleOf<F>;
    for (std::uint32_t column = 0; column < m.plan.joint_count; ++column)
    {
        const JointRow<F>& row = m.row(m.plan.columns[column].joint);
        for (std::size_t i = 0; i < Rows; ++i) m.values[column][i] = i < row.rigid_count ? -to_double(bias_of(row, i, k)) : D(0.0);
    }
    solve_consistent(m);
    find_corrections(m);

    const F most_speed = F(most_correction) * k.length_unit;
    const F most_turn = F(most_correction_turn);
    F share = F(1);
    for (std::uint32_t body = 0; body < m.plan.body_count; ++body)
    {
        const CorrectionLanes<F>& c = m.corrections[body];
        const F turn = c.w * k.h;
        share = lane_min(share, most_speed / lane_max(lane_sqrt(dot(c.v, c.v)), most_speed));
        share = lane_min(share, most_turn / lane_max(lane_max(turn, F(0) - turn), most_turn));
    }
    const F part = k.h * share;
    const auto is_far = far_off > F(0);
    for (std::uint32_t body = 0; body < m.plan.body_count; ++body)
    {
        BodyLanes<F>& motion = m.motions[body];
        const LaneVec<F> dp = motion.dp + m.corrections[body].v * part;
        const LaneRot<F> dq = turned_by(motion.dq, part * m.corrections[body].w);
        motion.dp = {select(is_far, dp.x, motion.dp.x), select(is_far, dp.y, motion.dp.y)};
        motion.dq = {select(is_far, dq.c, motion.dq.c), select(is_far, dq.s, motion.dq.s)};
    }
}

template <class F, std::size_t Rows>
void gather_bodies(const Mechanisms<F, Rows>& m, const float* motions)
{
    for (std::uint32_t body = 0; body < m.plan.body_count; ++body) m.motions[body] = gather(motions, m.bodies[body]);
}

template <class F, std::size_t Rows>
void scatter_bodies(const Mechanisms<F, Rows>& m, float* motions)
{
    for (std::uint32_t body = 0; body < m.plan.body_count; ++body) scatter(motions, m.pushed[body], m.motions[body]);
}

/// Where correct() has put them.
template <class F, std::size_t Rows>
void scatter_places(const Mechanisms<F, Rows>& m, float* motions)
{
    for (std::uint32_t body = 0; body < m.plan.body_count; ++body)
        for (int i = 0; i < lane_width<F>; ++i)
        {
            const std::uint32_t index = m.pushed[body][static_cast<std::size_t>(i)];
            if (index == 0) continue;
            float* motion = motions + motion_floats * index;
            motion[3] = lane(m.motions[body].dp.x, i);
            motion[4] = lane(m.motions[body].dp.y, i);
            motion[5] = lane(m.motions[body].dq.c, i);
            motion[6] = lane(m.motions[body].dq.s, i);
        }
}

/// Jacobians where the bodies are, and what they make of A.
template <class F, std::size_t Rows>
void factor(const Mechanisms<F, Rows>& m)
{
    fill_blocks(m);
    eliminate(m);
}

/// Applies the impulses of the substep before.
template <class F, std::size_t Rows>
void warm_start(const Mechanisms<F, Rows>& m)
{
    for (std::uint32_t joint = 0; joint < m.plan.joint_count; ++joint) warm_start(m.row(joint), m.a(joint), m.b(joint));
}

/// What is soft or one-sided first, joint by joint; then all that is rigid. From the last joint to the first, where relax() goes from the first to the
/// last: in one direction alone the ends of limbs drive each other on, and ragdolls that lie still stay awake (12 of 100 piles, now 4).
template <class F, std::size_t Rows>
F solve(const Mechanisms<F, Rows>& m, const JointConstants<F>& k)
{
    for (std::uint32_t joint = m.plan.joint_count; joint-- > 0;)
    {
        JointRow<F>& row = m.row(joint);
        if (row.control_count == 0 && !row.has_drive) continue;
        if (row.has_ends) bend(row, m.a(joint), m.b(joint), k); // ends read the curvature of their coordinate
        solve_controls<true>(row, k, m.a(joint), m.b(joint));
    }
    const F far_off = find_far_off(m, k);
    set_wanted_velocities<true>(m, k, far_off);
    solve_consistent(m);
    apply_impulses(m);
    if (any(far_off > F(0))) correct(m, k, far_off);
    return far_off;
}

/// Linearises anew where the bodies have come to, and takes back what the bias pushed.
template <class F, std::size_t Rows>
void relax(const Mechanisms<F, Rows>& m, const JointConstants<F>& k)
{
    for (std::uint32_t joint = 0; joint < m.plan.joint_count; ++joint)
    {
        JointRow<F>& row = m.row(joint);
        linearise(row, m.a(joint), m.b(joint));
        solve_controls<false>(row, k, m.a(joint), m.b(joint));
    }
    factor(m);
    set_wanted_velocities<false>(m, k, F(0));
    substitute(m);
    apply_impulses(m);
    for (std::uint32_t joint = 0; joint < m.plan.joint_count; ++joint) sum_up(m.row(joint));
}

} // namespace carom::detail
