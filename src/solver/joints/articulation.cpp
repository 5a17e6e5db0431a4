// The numbers: building A, eliminating it, and solving with it. In double precision, since a chain's impulses differ by its mass ratio.
#include "solver/joints/articulation.hpp"

namespace carom::detail
{

namespace
{

/// Row by row.
template <std::size_t Rows>
using Block = std::array<double, Rows * Rows>;

/// Blocks, as they lie in a list of numbers.
template <std::size_t Rows>
Block<Rows>* blocks_in(std::pmr::vector<double>& numbers)
{
    static_assert(sizeof(Block<Rows>) == Rows * Rows * sizeof(double));
    return reinterpret_cast<Block<Rows>*>(numbers.data());
}

/// J_i M^-1 J_k^T of one body that two joints share. Impulses act on a joint's A with the opposite sign.
double couple(const ArticulatedJoint& row, std::size_t i, bool row_is_b, const ArticulatedJoint& column, std::size_t k, bool column_is_b)
{
    const Vec2 inv_mass = row_is_b ? row.inv_mass_b : row.inv_mass_a;
    const float inv_inertia = row_is_b ? row.inv_inertia_b : row.inv_inertia_a;
    const Jacobian<float>& p = row.j[i];
    const Jacobian<float>& q = column.j[k];
    const LaneVec<float>& u = row_is_b ? p.l_b : p.l_a;
    const LaneVec<float>& v = column_is_b ? q.l_b : q.l_a;
    const double s = static_cast<double>(row_is_b ? p.s_b : p.s_a) * static_cast<double>(column_is_b ? q.s_b : q.s_a);
    const double x = static_cast<double>(u.x) * static_cast<double>(v.x);
    const double y = static_cast<double>(u.y) * static_cast<double>(v.y);
    const double sum = static_cast<double>(inv_mass.x) * x + static_cast<double>(inv_mass.y) * y + static_cast<double>(inv_inertia) * s;
    return row_is_b == column_is_b ? sum : -sum;
}

/// D^-1 by elimination of unit columns; rows that can push nothing give zero rows.
template <std::size_t Rows>
Block<Rows> inverse(Block<Rows> d)
{
    Block<Rows> inv = {};
    for (std::size_t i = 0; i < Rows; ++i)
    {
        if (!(d[Rows * i + i] > 0)) continue;
        inv[Rows * i + i] = 1;
        const double p = 1 / d[Rows * i + i];
        for (std::size_t c = 0; c < Rows; ++c) d[Rows * i + c] *= p, inv[Rows * i + c] *= p;
        for (std::size_t r = 0; r < Rows; ++r)
        {
            if (r == i) continue;
            const double f = d[Rows * r + i];
            for (std::size_t c = 0; c < Rows; ++c) d[Rows * r + c] -= f * d[Rows * i + c], inv[Rows * r + c] -= f * inv[Rows * i + c];
        }
    }
    return inv;
}

/// x -= B y
template <std::size_t Rows>
void subtract_product(std::array<double, Rows>& x, const Block<Rows>& block, const std::array<double, Rows>& y)
{
    for (std::size_t i = 0; i < Rows; ++i)
        for (std::size_t c = 0; c < Rows; ++c) x[i] -= block[Rows * i + c] * y[c];
}

/// x -= B^T y
template <std::size_t Rows>
void subtract_transposed(std::array<double, Rows>& x, const Block<Rows>& block, const std::array<double, Rows>& y)
{
    for (std::size_t i = 0; i < Rows; ++i)
        for (std::size_t c = 0; c < Rows; ++c) x[c] -= block[Rows * i + c] * y[i];
}

} // namespace

void Articulation::factor()
{
    switch (rows_)
    {
    case 1: return factor_blocks<1>();
    case 2: return factor_blocks<2>();
    default: return factor_blocks<3>();
    }
}

template <std::size_t Rows>
void Articulation::factor_blocks()
{
    fill_blocks<Rows>();
    eliminate_blocks<Rows>();
}

/// Writes A.
template <std::size_t Rows>
void Articulation::fill_blocks()
{
    blocks_.assign(front_.size() * Rows * Rows, 0);
    diagonal_.assign(columns_.size() * Rows * Rows, 0);
    Block<Rows>* const blocks = blocks_in<Rows>(blocks_);
    Block<Rows>* const diagonal = blocks_in<Rows>(diagonal_);
    for (const Coupling& c : couplings_)
    {
        const ArticulatedJoint& row = joints[c.row_joint];
        const ArticulatedJoint& column = joints[c.column_joint];
        for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i)
            for (std::size_t k = 0; k < static_cast<std::size_t>(column.count); ++k)
                blocks[c.block][Rows * i + k] += couple(row, i, c.row_is_b, column, k, c.column_is_b);
    }
    for (std::size_t k = 0; k < columns_.size(); ++k)
    {
        ArticulatedJoint& joint = joints[columns_[k].joint];
        for (std::size_t i = 0; i < static_cast<std::size_t>(joint.count); ++i)
        {
            for (std::size_t c = 0; c < static_cast<std::size_t>(joint.count); ++c)
                diagonal[k][Rows * i + c] = couple(joint, i, false, joint, c, false) + couple(joint, i, true, joint, c, true);
            joint.softness[i] = softness_[joint.component] * diagonal[k][Rows * i + i];
            diagonal[k][Rows * i + i] += joint.softness[i];
        }
    }
}

/// A becomes L D L^T. A pin has two rows, and a net of pins a third of the products that three would need.
template <std::size_t Rows>
void Articulation::eliminate_blocks()
{
    Block<Rows>* const blocks = blocks_in<Rows>(blocks_);
    Block<Rows>* const diagonal = blocks_in<Rows>(diagonal_);
    for (std::size_t k = 0; k < columns_.size(); ++k)
    {
        const Column& column = columns_[k];
        diagonal[k] = inverse<Rows>(diagonal[k]);
        std::uint32_t target = column.targets_begin;
        for (std::uint32_t f = column.front_begin; f < column.front_end; ++f)
        {
            const Block<Rows> a = blocks[f];
            Block<Rows> w = {};
            for (std::size_t i = 0; i < Rows; ++i)
                for (std::size_t c = 0; c < Rows; ++c)
                    for (std::size_t l = 0; l < Rows; ++l) w[Rows * i + c] += a[Rows * i + l] * diagonal[k][Rows * l + c];
            blocks[f] = w;
            // Every block that pairs this joint of the front with itself and with those before it, whose blocks hold A D^-1 by now.
            const auto subtract = [&](Block<Rows>& to, const Block<Rows>& other)
            {
                for (std::size_t i = 0; i < Rows; ++i)
                    for (std::size_t c = 0; c < Rows; ++c)
                        for (std::size_t l = 0; l < Rows; ++l) to[Rows * i + c] -= a[Rows * i + l] * other[Rows * c + l];
            };
            for (std::uint32_t e = column.front_begin; e < f; ++e) subtract(blocks[targets_[target++]], blocks[e]);
            subtract(diagonal[front_places_[f]], w);
        }
    }
}

void Articulation::solve()
{
    switch (rows_)
    {
    case 1: return substitute<1>();
    case 2: return substitute<2>();
    default: return substitute<3>();
    }
}

/// Forward through L, then back through D and L^T, on a compact copy of the right-hand sides.
template <std::size_t Rows>
void Articulation::substitute()
{
    values_.resize(columns_.size() * Rows);
    const Block<Rows>* const blocks = blocks_in<Rows>(blocks_);
    const Block<Rows>* const diagonal = blocks_in<Rows>(diagonal_);
    auto* const x = reinterpret_cast<std::array<double, Rows>*>(values_.data());
    for (std::size_t k = 0; k < columns_.size(); ++k)
        for (std::size_t i = 0; i < Rows; ++i) x[k][i] = joints[columns_[k].joint].rhs[i];
    for (std::size_t k = 0; k < columns_.size(); ++k)
        for (std::uint32_t f = columns_[k].front_begin; f < columns_[k].front_end; ++f)
            subtract_product<Rows>(x[front_places_[f]], blocks[f], x[k]);
    for (std::size_t k = columns_.size(); k-- > 0;)
    {
        std::array<double, Rows> sum = {};
        for (std::size_t i = 0; i < Rows; ++i)
            for (std::size_t c = 0; c < Rows; ++c) sum[i] += diagonal[k][Rows * i + c] * x[k][c];
        for (std::uint32_t f = columns_[k].front_begin; f < columns_[k].front_end; ++f)
            subtract_transposed<Rows>(sum, blocks[f], x[front_places_[f]]);
        x[k] = sum;
    }
    for (std::size_t k = 0; k < columns_.size(); ++k)
    {
        joints[columns_[k].joint].rhs = {};
        for (std::size_t i = 0; i < Rows; ++i) joints[columns_[k].joint].rhs[i] = x[k][i];
    }
}

void Articulation::solve_consistent()
{
    // With y = (A + S)^-1 rhs, rhs - S y = A y is what can be had.
    wanted_.resize(joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i) wanted_[i] = joints[i].rhs;
    solve();
    for (std::size_t i = 0; i < joints.size(); ++i)
        for (std::size_t k = 0; k < max_rigid_rows; ++k)
            joints[i].rhs[k] = joints[i].is_in ? wanted_[i][k] - joints[i].softness[k] * joints[i].rhs[k] : 0;
    solve();
}

} // namespace carom::detail
