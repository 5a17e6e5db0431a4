// Semi-implicit Euler, substep by substep.
#include "solver/rows/integrate.hpp"

#include <algorithm>

namespace carom::detail
{

namespace
{

Vec2 acceleration_of(const BodyMass& mass, const BodyDrive& drive, Vec2 g)
{
    return {drive.gravity_scale.x * g.x + mass.inv_mass.x * drive.force.x, drive.gravity_scale.y * g.y + mass.inv_mass.y * drive.force.y};
}

} // namespace

void free_accelerations(std::span<const BodyMass> masses, std::span<const BodyDrive> drives, Vec2 gravity, std::span<const Vec2> fields,
                        std::span<Vec2> accelerations)
{
    for (std::size_t i = 1; i < masses.size(); ++i)
        accelerations[i] = acceleration_of(masses[i], drives[i], fields.empty() ? gravity : gravity + fields[i]);
}

void integrate_velocities(std::span<BodyMotion> motions, std::span<const BodyMass> masses, std::span<const BodyDrive> drives, Vec2 gravity,
                          std::span<const Vec2> fields, float h)
{
    for (std::size_t i = 1; i < motions.size(); ++i)
    {
        BodyMotion& body = motions[i];
        const BodyMass& mass = masses[i];
        const BodyDrive& drive = drives[i];
        const Vec2 a = acceleration_of(mass, drive, fields.empty() ? gravity : gravity + fields[i]);
        body.v = (1 / (1 + h * drive.linear_damping)) * (body.v + h * a);
        body.w = (1 / (1 + h * drive.angular_damping)) * (body.w + h * mass.inv_inertia * drive.torque);
    }
}

Rot turned(Rot q, float turn)
{
    // With t = tan(turn / 2), (1 - t^2, 2 t) / (1 + t^2) is the exact rotation, and t = x + x^3 / 3 + 2 x^5 / 15 + ... at x = turn / 2. The
    // length stays 1 whatever t is, so that a fast spin loses accuracy, never unit length.
    const float x = 0.5f * turn;
    const float x2 = x * x;
    constexpr float half_turn = 1e9f; // t beyond it is a turn by pi already, and its square must not overflow
    const float t = std::clamp(x + x * x2 * (1 / 3.0f + x2 * (2 / 15.0f)), -half_turn, half_turn);
    const float inv = 1 / (1 + t * t);
    return Rot{(1 - t * t) * inv, 2 * t * inv} * q;
}

void integrate_positions(std::span<BodyMotion> motions, float h)
{
    for (std::size_t i = 1; i < motions.size(); ++i)
    {
        BodyMotion& body = motions[i];
        body.dp += h * body.v;
        body.dq = turned(body.dq, h * body.w);
    }
}

} // namespace carom::detail
