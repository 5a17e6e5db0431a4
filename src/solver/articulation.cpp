// The numbers: building A, eliminating it, and solving with it. In double precision, since a chain's impulses differ by its mass ratio.
#include "solver/articulation.hpp"

namespace carom::detail
{

namespace
{

constexpr std::size_t n = max_rigid_rows;

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
std::array<double, n * n> inverse(std::array<double, n * n> d)
{
    std::array<double, n * n> inv = {};
    for (std::size_t i = 0; i < n; ++i)
    {
        if (!(d[n * i + i] > 0)) continue;
        inv[n * i + i] = 1;
        const double p = 1 / d[n * i + i];
        for (std::size_t c = 0; c < n; ++c) d[n * i + c] *= p, inv[n * i + c] *= p;
        for (std::size_t r = 0; r < n; ++r)
        {
            if (r == i) continue;
            const double f = d[n * r + i];
            for (std::size_t c = 0; c < n; ++c) d[n * r + c] -= f * d[n * i + c], inv[n * r + c] -= f * inv[n * i + c];
        }
    }
    return inv;
}

} // namespace

void Articulation::factor()
{
    for (Block& block : blocks_) block = {};
    for (const Coupling& c : couplings_)
    {
        const ArticulatedJoint& row = joints[c.row_joint];
        const ArticulatedJoint& column = joints[c.column_joint];
        for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i)
            for (std::size_t k = 0; k < static_cast<std::size_t>(column.count); ++k)
                blocks_[c.block][n * i + k] += couple(row, i, c.row_is_b, column, k, c.column_is_b);
    }
    for (std::size_t k = 0; k < columns_.size(); ++k)
    {
        ArticulatedJoint& joint = joints[columns_[k].joint];
        diagonal_[k] = {};
        for (std::size_t i = 0; i < static_cast<std::size_t>(joint.count); ++i)
        {
            for (std::size_t c = 0; c < static_cast<std::size_t>(joint.count); ++c)
                diagonal_[k][n * i + c] = couple(joint, i, false, joint, c, false) + couple(joint, i, true, joint, c, true);
            joint.softness[i] = softness_[joint.component] * diagonal_[k][n * i + i];
            diagonal_[k][n * i + i] += joint.softness[i];
        }
    }

    for (std::size_t k = 0; k < columns_.size(); ++k)
    {
        const Column& column = columns_[k];
        diagonal_[k] = inverse(diagonal_[k]);
        std::uint32_t target = column.targets_begin;
        for (std::uint32_t f = column.front_begin; f < column.front_end; ++f)
        {
            const Block a = blocks_[f];
            Block w = {};
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t c = 0; c < n; ++c)
                    for (std::size_t l = 0; l < n; ++l) w[n * i + c] += a[n * i + l] * diagonal_[k][n * l + c];
            blocks_[f] = w;
            // Every block that pairs this joint of the front with itself and with those before it, whose blocks hold A D^-1 by now.
            const auto subtract = [&](Block& to, const Block& other)
            {
                for (std::size_t i = 0; i < n; ++i)
                    for (std::size_t c = 0; c < n; ++c)
                        for (std::size_t l = 0; l < n; ++l) to[n * i + c] -= a[n * i + l] * other[n * c + l];
            };
            for (std::uint32_t e = column.front_begin; e < f; ++e) subtract(blocks_[targets_[target++]], blocks_[e]);
            subtract(diagonal_[place_[front_[f]]], w);
        }
    }
}

void Articulation::solve()
{
    const auto at = [this](std::size_t column) -> std::array<double, n>& { return joints[columns_[column].joint].rhs; };
    for (std::size_t k = 0; k < columns_.size(); ++k)
    {
        const std::array<double, n> y = at(k);
        for (std::uint32_t f = columns_[k].front_begin; f < columns_[k].front_end; ++f)
        {
            std::array<double, n>& x = joints[front_[f]].rhs;
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t c = 0; c < n; ++c) x[i] -= blocks_[f][n * i + c] * y[c];
        }
    }
    for (std::size_t k = columns_.size(); k-- > 0;)
    {
        const std::array<double, n> y = at(k);
        std::array<double, n> x = {};
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t c = 0; c < n; ++c) x[i] += diagonal_[k][n * i + c] * y[c];
        for (std::uint32_t f = columns_[k].front_begin; f < columns_[k].front_end; ++f)
        {
            const std::array<double, n>& z = joints[front_[f]].rhs;
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t c = 0; c < n; ++c) x[c] -= blocks_[f][n * i + c] * z[i];
        }
        at(k) = x;
    }
}

void Articulation::solve_consistent()
{
    // With y = (A + S)^-1 rhs, rhs - S y = A y is what can be had.
    wanted_.resize(joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i) wanted_[i] = joints[i].rhs;
    solve();
    for (std::size_t i = 0; i < joints.size(); ++i)
        for (std::size_t k = 0; k < n; ++k)
            joints[i].rhs[k] = joints[i].is_in ? wanted_[i][k] - joints[i].softness[k] * joints[i].rhs[k] : 0;
    solve();
}

} // namespace carom::detail
